// Releases, jobs and their ledgers.
#include <array>
#include <optional>

#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/orders.h"
#include "server/json/records.h"
#include "server/json/requests.h"
#include "server/json/verdict_records.h"

namespace dripfeed::http {

namespace {

Response release_response(unsigned status, const store::Result<store::Release>& release) {
  if (!release) return problem_response(app::from_store(release.error()));
  if (status == 201) return created(fmt::format("/api/v1/releases/{}", release->id), json::release(*release));
  return json_response(status, json::release(*release));
}

Response job_response(const app::Result<store::Job>& job) {
  if (!job) return problem_response(job.error());
  return json_response(200, json::job(*job));
}

std::optional<store::JobState> job_state_named(std::string_view name) {
  for (std::size_t i = 0; i < store::kJobStates; ++i) {
    if (store::name_of(static_cast<store::JobState>(i)) == name) return static_cast<store::JobState>(i);
  }
  return std::nullopt;
}

// Who wrote a program hands it in; whether it goes to a machine is another's to say.
bool hands_in(const store::Release& release, const store::ReleaseMove& move) {
  return release.state == store::ReleaseState::draft && move.to == store::ReleaseState::in_review;
}

}  // namespace

Response list_releases(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  const auto program = id_in(call.request, "program");
  if (!program) return program.error();
  const store::ReleaseFilter filter{.program = *program, .machine = query_text(call.request, "machine")};
  return list_response(call.api.application().store().releases().list(*page, filter),
                       [](const store::Release& r) { return json::release(r); });
}

Response add_release(const Call& call) {
  const auto body = json::read_release_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  const auto text = find_revision(app.store(), body->program, body->revision);
  if (!text) return problem_response(app::from_store(text.error()));
  if (const auto machine = app.store().machines().get(body->machine); !machine)
    return problem_response(app::from_store(machine.error()));
  const store::NewRelease release{
      .program = body->program, .revision = text->revision, .machine = body->machine, .delivery = body->delivery};
  return release_response(201, app.store().releases().add(release, {std::string(call.user), app.clock().wall_ms()}));
}

Response get_release(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return release_response(200, call.api.application().store().releases().get(*id));
}

Response move_release(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto move = json::read_transition_body(call.request.body);
  if (!move) return problem_response(move.error());
  app::Application& app = call.api.application();
  const auto release = app.store().releases().get(*id);
  if (!release) return problem_response(app::from_store(release.error()));
  if (call.right < Right::approver && !hands_in(*release, *move))
    return problem_response(403, "this needs the role approver: a programmer hands a draft in for review");
  if (move->to == store::ReleaseState::proving || move->to == store::ReleaseState::approved)
    if (const auto same = app.jobs().refuse_changed_calls(*release); !same) return problem_response(same.error());
  return release_response(200,
                          app.store().releases().move(*id, *move, {std::string(call.user), app.clock().wall_ms()}));
}

Response list_jobs(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  const auto order = id_in(call.request, "order");
  if (!order) return order.error();
  store::JobFilter filter{.machine = query_text(call.request, "machine"), .state = std::nullopt};
  filter.order = *order;
  const auto choice = id_in(call.request, "choice");
  if (!choice) return choice.error();
  filter.choice = *choice;
  if (const std::string state = query_text(call.request, "state"); !state.empty()) {
    filter.state = job_state_named(state);
    if (!filter.state) return problem_response(422, fmt::format("\"{}\" is not a state of a job", state));
  }
  return list_response(call.api.application().store().jobs().list(*page, filter),
                       [](const store::Job& j) { return json::job(j); });
}

Response sign_off_release(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_sign_off_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  return release_response(
      200, app.store().releases().sign_off(*id, body->note, {std::string(call.user), app.clock().wall_ms()}));
}

namespace {

Response queue_job(const Call& call, store::Id release, const app::JobPlan& plan) {
  app::Jobs& jobs = call.api.application().jobs();
  std::optional<store::Job> added;
  bool is_text_known = true;
  const auto add = [&] {
    const auto job = jobs.add_known(release, call.user, plan);
    if (!job) return problem_response(job.error());
    is_text_known = job->has_value();
    if (!is_text_known) return problem_response(503, std::string(app::Jobs::kMachineChanges));
    added = *job;
    return created(fmt::format("/api/v1/jobs/{}", added->id), json::job(*added));
  };
  Response response = call.commit(add);
  if (!is_text_known) {
    if (const auto read = jobs.read_text(release); !read) return problem_response(read.error());
    response = call.commit(add);
  }
  if (added && response.status == 201) jobs.announce(*added);
  return response;
}

}  // namespace

Response add_job(const Call& call) {
  const auto body = json::read_job_body(call.request.body);
  if (!body) return problem_response(body.error());
  return queue_job(call, body->release, body->plan);
}

Response retry_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto old = call.api.application().store().jobs().get(*id);
  if (!old) return problem_response(app::from_store(old.error()));
  return queue_job(call, old->release, {.order = old->order, .end_check = old->end_check, .retry_of = old->id});
}

Response get_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return job_response(app::lift(call.api.application().store().jobs().get(*id)));
}

Response get_job_forecast(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  app::Application& app = call.api.application();
  const auto job = app.store().jobs().get(*id);
  if (!job) return problem_response(app::from_store(job.error()));
  const auto verdict = app.store().verdicts().newest(job->text_sha256, job->machine, job->delivery);
  if (!verdict) return problem_response(app::from_store(verdict.error()));
  const auto profile = app.catalog().profile(job->machine);
  return json_response(200,
                       json::job_forecast(*job, *verdict, profile ? profile->machine.buffer : checks::BufferSize{}));
}

Response arm_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto arming = json::read_arm_body(call.request.body);
  if (!arming) return problem_response(arming.error());
  app::Application& app = call.api.application();
  const auto job = app::lift(app.store().jobs().get(*id));
  if (!job) return problem_response(job.error());
  // These numbers hold the machine builder's own programs in many controls.
  const bool own_right = job->delivery == store::Delivery::memory && call.right < Right::admin;
  if (own_right && app.jobs().protects_number(job->text_sha256))
    return problem_response(403, "O8000 to O9999 are loaded by an admin");
  const bool is_early = !arming->early_reason.empty() && app.clock().wall_ms() < job->not_before_ms;
  if (is_early && call.right < Right::approver)
    return problem_response(403, "a job is armed before its time by an approver");
  // A reason of whoever was not asked for one is none, even where the time is changed meanwhile.
  const std::string_view early_reason = is_early ? std::string_view(arming->early_reason) : std::string_view();
  return job_response(app.jobs().arm(*id, arming->minutes, call.user, arming->rounds, early_reason));
}

Response schedule_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_schedule_body(call.request.body);
  if (!body) return problem_response(body.error());
  return job_response(call.api.application().jobs().schedule(*id, body->not_before_ms, call.user));
}

Response hold_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_reason_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  return job_response(call.api.application().jobs().hold(*id, body->reason, call.user));
}

Response end_hold_of_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return job_response(call.api.application().jobs().end_hold(*id, call.user));
}

Response confirm_job_end(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_end_body(call.request.body);
  if (!body) return problem_response(body.error());
  return job_response(call.api.application().jobs().confirm_end(*id, body->note, call.user));
}

namespace {

bool may_queue_on(const Call& call, const std::string& machine) {
  if (call.caller == nullptr) return false;
  const auto found = call.caller->on_machines.find(machine);
  return (found == call.caller->on_machines.end() ? call.caller->right : found->second) >= Right::operator_;
}

}  // namespace

Response add_choice(const Call& call) {
  auto order = json::read_choice_body(call.request.body);
  if (!order) return problem_response(order.error());
  order->group = call.parameters[0];
  app::Application& app = call.api.application();
  const auto parts = app::prepare_choice(app.store(), app.jobs(), *order, app.clock().wall_ms(),
                                         [&](const std::string& machine) { return may_queue_on(call, machine); });
  if (!parts) return problem_response(parts.error());
  std::vector<store::Job> added;
  Response response = call.commit([&] {
    const auto choice = app::add_choice(app.store(), app.jobs(), *parts, order->plan, call.user);
    if (!choice) return problem_response(choice.error());
    added = choice->jobs;
    return created(fmt::format("/api/v1/jobs?choice={}", choice->id), json::choice(*choice));
  });
  if (response.status == 201)
    for (const store::Job& job : added) app.jobs().announce(job);
  return response;
}

Response move_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto before = json::read_move_body(call.request.body);
  if (!before) return problem_response(before.error());
  return job_response(call.api.application().jobs().move_before(*id, before->before.value_or(0), call.user));
}

Response stop_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return job_response(call.api.application().jobs().stop(*id, call.user));
}

Response cancel_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  return job_response(call.api.application().jobs().cancel(*id, call.user));
}

Response resume_job(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_reason_body(call.request.body, false);
  if (!body) return problem_response(body.error());
  return job_response(call.api.application().jobs().resume(*id, body->reason, call.user));
}

Response get_ledger(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto page = page_of(call.request);
  if (!page) return page.error();
  store::Store& store = call.api.application().store();
  const auto job = store.jobs().get(*id);
  if (!job) return problem_response(app::from_store(job.error()));
  const auto rows = store.ledger().rows(*id, *page);
  if (!rows) return problem_response(app::from_store(rows.error()));
  const auto interval = store.ledger().interval(*id);
  if (!interval) return problem_response(app::from_store(interval.error()));
  return json_response(200, json::ledger(rows->items, rows->next, *interval, job->link.starts_with("modbus")));
}

}  // namespace dripfeed::http
