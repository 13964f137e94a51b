// Programs, rendering, checks.
#include <memory>

#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/records.h"
#include "server/json/requests.h"
#include "server/json/verdict_records.h"

namespace dripfeed::http {

namespace {

// ?revision=, or 0 for the newest.
std::expected<store::Revision, Response> revision_of(const Request& request) {
  const auto given = request.query.find("revision");
  if (given == request.query.end()) return 0;
  return id_of(given->second);
}

Response program_response(const app::Result<store::Program>& program) {
  if (!program) return problem_response(program.error());
  return with_revision(created(fmt::format("/api/v1/programs/{}", program->id), json::program(*program)),
                       program->newest.revision);
}

app::Waiter waiter_of_render(const Call& call, const app::RenderOrder& order) {
  const std::string subject =
      order.part.empty() ? fmt::format("family/{}", order.family) : fmt::format("part/{}", order.part);
  return waiter_of(call, "render", subject, order.machine);
}

}  // namespace

store::Result<store::ProgramRevision> find_revision(store::Store& store, store::Id program, store::Revision revision) {
  if (revision != 0) return store.programs().get_revision(program, revision);
  auto newest = store.programs().get(program);
  if (!newest) return std::unexpected(newest.error());
  if (newest->newest.revision == 0)
    return std::unexpected(store::Error{store::ErrorCode::not_found, fmt::format("program/{} is deleted", program)});
  return std::move(newest->newest);
}

app::Result<StoredText> load_text(store::Store& store, store::Id id, store::Revision wanted, std::uint64_t most) {
  auto program = app::lift(store.programs().get(id));
  if (!program) return std::unexpected(program.error());
  const auto revision = app::lift(find_revision(store, id, wanted));
  if (!revision) return std::unexpected(revision.error());
  if (revision->bytes > most)
    return app::fail(app::ErrorCode::invalid,
                     fmt::format("program {} has {} bytes, more than the {} that are read for this", program->name,
                                 revision->bytes, most));
  auto text = app::lift(store::read_whole(store.contents(), revision->sha256, most));
  if (!text) return std::unexpected(text.error());
  return StoredText{.name = std::move(program->name),
                    .dialect = std::move(program->dialect),
                    .folder = std::move(program->folder),
                    .revision = revision->revision,
                    .text = std::move(*text)};
}

Response list_programs(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  store::ProgramFilter filter;
  if (const auto name = call.request.query.find("name"); name != call.request.query.end()) filter.name = name->second;
  if (const auto part = call.request.query.find("part"); part != call.request.query.end()) filter.part = part->second;
  filter.tag = query_text(call.request, "tag");
  filter.folder = query_text(call.request, "folder");
  const auto shelf = shelf_of(call.request);
  if (!shelf) return shelf.error();
  filter.shelf = *shelf;
  return list_response(call.api.application().store().programs().list(*page, filter),
                       [](const store::Program& p) { return json::program(p); });
}

Response add_program(const Call& call) {
  const auto body = json::read_program_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::Programs& programs = call.api.application().programs();
  const auto text = programs.keep_text(body->dialect, body->text);
  if (!text) return problem_response(text.error());
  return call.commit([&] { return program_response(programs.add(body->name, body->dialect, *text, call.user)); });
}

Response get_program(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto program = call.api.application().store().programs().get(*id);
  if (!program) return problem_response(app::from_store(program.error()));
  return with_revision(json_response(200, json::program(*program)), program->newest.revision);
}

Response get_program_text(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto wanted = revision_of(call.request);
  if (!wanted) return wanted.error();
  store::Store& store = call.api.application().store();
  const auto revision = find_revision(store, *id, *wanted);
  if (!revision) return problem_response(app::from_store(revision.error()));
  Response response;
  response.content_type = "text/plain; charset=utf-8";
  const auto offset = std::make_shared<std::uint64_t>(0);
  response.source = [&contents = store.contents(), sha256 = revision->sha256,
                     offset](std::span<char> into) -> std::expected<std::size_t, std::string> {
    const auto count = contents.read(sha256, *offset, into);
    if (!count) return std::unexpected(store::message_of(count.error()));
    *offset += *count;
    return *count;
  };
  return with_revision(std::move(response), revision->revision);
}

Response get_program_lines(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto wanted = revision_of(call.request);
  if (!wanted) return wanted.error();
  const auto from = number_of(call.request, "from", 1, 1, INT64_MAX / 2);
  if (!from) return from.error();
  const auto count = number_of(call.request, "count", 50, 1, app::LineReading::kMost);
  if (!count) return count.error();
  app::Application& app = call.api.application();
  const auto revision = find_revision(app.store(), *id, *wanted);
  if (!revision) return problem_response(app::from_store(revision.error()));
  const auto found = app.line_reading().lines(*revision, *from, static_cast<std::uint32_t>(*count));
  if (!found) return problem_response(found.error());
  return with_revision(json_response(200, json::program_lines(*from, *found)), revision->revision);
}

Response list_revisions(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto page = page_of(call.request);
  if (!page) return page.error();
  store::Programs& programs = call.api.application().store().programs();
  if (const auto known = programs.get(*id); !known) return problem_response(app::from_store(known.error()));
  return list_response(programs.revisions(*id, *page),
                       [](const store::ProgramRevision& r) { return json::program_revision(r); });
}

Response add_revision(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto expected = expected_revision(call.request);
  if (!expected) return expected.error();
  const auto body = json::read_text_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::Programs& programs = call.api.application().programs();
  const auto text = programs.keep_text(body->text);
  if (!text) return problem_response(text.error());
  return call.commit([&] { return program_response(programs.add_revision(*id, *expected, *text, call.user)); });
}

Response render(const Call& call) {
  const auto order = json::read_render_body(call.request.body);
  if (!order) return problem_response(order.error());
  app::Application& app = call.api.application();
  const auto rendered = app.programs().render(*order, call.user, waiter_of_render(call, *order));
  if (!rendered) return problem_response(rendered.error());
  const store::Origin& origin = rendered->program.newest.origin;
  const auto family = app.store().families().get(origin.family, origin.family_revision);
  if (!family) return problem_response(app::from_store(family.error()));
  return created(fmt::format("/api/v1/programs/{}", rendered->program.id),
                 json::rendered(*rendered, text::Source(family->name, family->text)));
}

Response preview(const Call& call) {
  const auto order = json::read_render_body(call.request.body);
  if (!order) return problem_response(order.error());
  const auto previewed = call.api.application().programs().preview(*order, waiter_of_render(call, *order));
  if (!previewed) return problem_response(previewed.error());
  return json_response(200, json::preview(*previewed));
}

Response preview_verdict(const Call& call) {
  const auto order = json::read_render_body(call.request.body);
  if (!order) return problem_response(order.error());
  const auto done = call.api.application().programs().judge(*order, waiter_of_render(call, *order));
  if (!done) return problem_response(done.error());
  return json_response(200, json::preview_verdict(*done));
}

Response list_checks(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  const auto program = id_in(call.request, "program");
  if (!program) return program.error();
  store::VerdictFilter filter;
  filter.program = *program;
  if (const auto machine = call.request.query.find("machine"); machine != call.request.query.end())
    filter.machine = machine->second;
  return list_response(call.api.application().store().verdicts().list(*page, filter),
                       [](const store::Verdict& v) { return json::verdict_summary(v); });
}

Response add_check(const Call& call) {
  const auto order = json::read_check_body(call.request.body);
  if (!order) return problem_response(order.error());
  const auto verdict = call.api.application().checking().check(
      *order, call.user, waiter_of(call, "check", fmt::format("program/{}", order->program), order->machine));
  if (!verdict) return problem_response(verdict.error());
  return created(fmt::format("/api/v1/checks/{}", verdict->id), json::verdict(*verdict));
}

Response get_check(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto verdict = call.api.application().store().verdicts().get(*id);
  if (!verdict) return problem_response(app::from_store(verdict.error()));
  return json_response(200, json::verdict(*verdict));
}

Response waive_check(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_waiver_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  const auto verdict = app.store().verdicts().waive(*id, *body, {std::string(call.user), app.clock().wall_ms()});
  if (!verdict) return problem_response(app::from_store(verdict.error()));
  return created(fmt::format("/api/v1/checks/{}", verdict->id), json::verdict(*verdict));
}

}  // namespace dripfeed::http
