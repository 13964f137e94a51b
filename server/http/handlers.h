// The handlers, by the thing that they are about. Each reads its request, makes one call of the application or the
// store, and writes the answer.
#pragma once

#include <expected>

#include "server/app/ports/workplace.h"
#include "server/http/router.h"
#include "store/store.h"

namespace dripfeed::http {

// handlers_site.cpp
Response get_health(const Call& call);
Response get_openapi(const Call& call);
Response get_page(const Call& call);
Response get_asset(const Call& call);
Response get_docs(const Call& call);
Response get_docs_page(const Call& call);
Response get_session(const Call& call);
Response open_session(const Call& call);
Response get_sign_in_provider(const Call& call);
Response begin_provider_sign_in(const Call& call);
Response open_provider_session(const Call& call);
Response close_session(const Call& call);
Response get_events(const Call& call);

// handlers_orders.cpp
Response list_orders(const Call& call);
Response add_order(const Call& call);
Response get_order(const Call& call);
Response change_order(const Call& call);
Response move_order(const Call& call);
Response report_parts(const Call& call);

// handlers_people.cpp
Response list_users(const Call& call);
Response add_user(const Call& call);
Response get_user(const Call& call);
Response change_user(const Call& call);
Response unlock_user(const Call& call);
Response set_password(const Call& call);
Response set_pin(const Call& call);
Response remove_password(const Call& call);
Response remove_pin(const Call& call);
Response change_own_password(const Call& call);
Response list_tokens(const Call& call);
Response add_token(const Call& call);
Response get_token(const Call& call);
Response revoke_token(const Call& call);
Response list_groups(const Call& call);
Response put_group(const Call& call);
Response remove_group(const Call& call);
Response list_audit(const Call& call);

// metrics_server.cpp
Response get_metrics(const Call& call);

// handlers_catalog.cpp
Response list_machines(const Call& call);
Response add_machine(const Call& call);
Response get_machine(const Call& call);
Response change_machine(const Call& call);
Response get_utilisation(const Call& call);
Response get_history_sums(const Call& call);
Response get_stop_reasons(const Call& call);
Response list_job_stop_reasons(const Call& call);
Response add_stop_reason(const Call& call);
Response get_wire(const Call& call);
Response test_line(const Call& call);
Response confirm_reset(const Call& call);
Response list_nodes(const Call& call);
Response hand_over_machine(const Call& call);
Response take_over_machine(const Call& call);
Response list_families(const Call& call);
Response add_family(const Call& call);
Response get_family(const Call& call);
Response change_family(const Call& call);
Response list_parts(const Call& call);
Response add_part(const Call& call);
Response get_part(const Call& call);
Response change_part(const Call& call);

// handlers_programs.cpp
Response list_programs(const Call& call);
Response add_program(const Call& call);
Response get_program(const Call& call);
Response get_program_text(const Call& call);
Response get_program_lines(const Call& call);
Response list_revisions(const Call& call);
Response add_revision(const Call& call);
Response render(const Call& call);
Response preview(const Call& call);
Response preview_verdict(const Call& call);
Response list_checks(const Call& call);
Response add_check(const Call& call);
Response get_check(const Call& call);
Response waive_check(const Call& call);

// handlers_compare.cpp
Response compare_programs(const Call& call);
Response compare_text(const Call& call);

// handlers_editing.cpp
Response diagnose(const Call& call);
Response convert(const Call& call);
Response optimize(const Call& call);
Response rewrite(const Call& call);
Response import_programs(const Call& call);
Response split_text(const Call& call);
Response statistics_of_text(const Call& call);
Response get_dialect_words(const Call& call);

// handlers_library.cpp
Response label_program(const Call& call);
Response archive_program(const Call& call);
Response fetch_back_program(const Call& call);
Response delete_program(const Call& call);
Response search_programs(const Call& call);
Response get_program_uses(const Call& call);

// handlers_attachments.cpp
Response list_attachments(const Call& call);
Response add_attachment(const Call& call);
Response get_attachment(const Call& call);
Response get_attachment_content(const Call& call);
Response remove_attachment(const Call& call);

// handlers_measures.cpp
Response measure_accuracy(const Call& call);
Response measure_gouge(const Call& call);
Response measure_timing(const Call& call);
Response sweep_family(const Call& call);

// handlers_restarts.cpp
Response preview_restart(const Call& call);
Response make_restart(const Call& call);

// handlers_store.cpp
Response get_store(const Call& call);
Response verify_store(const Call& call);
Response list_backups(const Call& call);
Response add_backup(const Call& call);
Response remove_backup(const Call& call);

// handlers_work.cpp
Response list_work(const Call& call);
Response cancel_work(const Call& call);
// Who waits for heavy work: the client, and the server while it runs. `subject`: what it is about, "program/7".
app::Waiter waiter_of(const Call& call, std::string_view kind, std::string subject, std::string_view machine);

// ?shelf=, in_use where it is not given; or 422.
std::expected<store::Shelf, Response> shelf_of(const Request& request);

// This revision of a program, or the newest one for 0.
store::Result<store::ProgramRevision> find_revision(store::Store& store, store::Id program, store::Revision revision);

// The text of a revision, 0: of the newest one. Errors: invalid: it has more bytes than `most`.
struct StoredText {
  std::string name;
  std::string dialect;
  std::string folder;
  store::Revision revision = 0;
  std::string text;
};
app::Result<StoredText> load_text(store::Store& store, store::Id program, store::Revision revision, std::uint64_t most);

// handlers_paths.cpp
Response path_of_text(const Call& call);
Response stock_of_text(const Call& call);
Response get_program_path(const Call& call);
Response get_program_picture(const Call& call);
Response get_program_stock(const Call& call);

// handlers_jobs.cpp
Response list_releases(const Call& call);
Response add_release(const Call& call);
Response get_release(const Call& call);
Response move_release(const Call& call);
Response sign_off_release(const Call& call);
Response list_jobs(const Call& call);
Response add_job(const Call& call);
Response get_job(const Call& call);
Response get_job_forecast(const Call& call);
Response arm_job(const Call& call);
Response schedule_job(const Call& call);
Response hold_job(const Call& call);
Response end_hold_of_job(const Call& call);
Response retry_job(const Call& call);
Response confirm_job_end(const Call& call);
Response add_choice(const Call& call);
Response move_job(const Call& call);
Response stop_job(const Call& call);
Response cancel_job(const Call& call);
Response resume_job(const Call& call);
Response get_ledger(const Call& call);

// handlers_alarms.cpp
Response list_alarms(const Call& call);
Response get_alarm(const Call& call);
Response acknowledge_alarm(const Call& call);
Response shelve_alarm(const Call& call);
Response unshelve_alarm(const Call& call);

// handlers_webhooks.cpp
Response list_event_types(const Call& call);
Response list_webhooks(const Call& call);
Response add_webhook(const Call& call);
Response get_webhook(const Call& call);
Response change_webhook(const Call& call);
Response remove_webhook(const Call& call);
Response rotate_webhook(const Call& call);
Response ping_webhook(const Call& call);
Response list_deliveries(const Call& call);
Response replay_delivery(const Call& call);
Response replay_deliveries(const Call& call);

// handlers_mtconnect.cpp
Response mtconnect_probe(const Call& call);
Response mtconnect_current(const Call& call);
Response mtconnect_sample(const Call& call);
Response mtconnect_assets(const Call& call);

// handlers_receipts.cpp
Response list_receipts(const Call& call);
Response get_receipt(const Call& call);
Response get_receipt_text(const Call& call);
Response explain_receipt(const Call& call);
Response accept_receipt(const Call& call);
Response discard_receipt(const Call& call);
Response list_requests(const Call& call);

}  // namespace dripfeed::http
