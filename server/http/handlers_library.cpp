// Finding programs and filing them: words, tags, folders, the archive, and where a program is used.
#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/records.h"
#include "server/json/requests.h"

namespace dripfeed::http {

namespace {

Response program_response(const store::Result<store::Program>& program) {
  if (!program) return problem_response(app::from_store(program.error()));
  return with_revision(json_response(200, json::program(*program)), program->newest.revision);
}

Response no_library() { return problem_response(503, "programs cannot be searched: the log states why"); }

using MoveProgram = store::Result<store::Program> (store::Programs::*)(store::Id, std::string_view,
                                                                       const store::Stamp&);

Response move_program(const Call& call, MoveProgram move) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_reason_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  return program_response((call.api.application().store().programs().*move)(*id, body->reason, stamp_of(call)));
}

}  // namespace

std::expected<store::Shelf, Response> shelf_of(const Request& request) {
  const std::string given = query_text(request, "shelf");
  if (given.empty()) return store::Shelf::in_use;
  if (const auto shelf = store::named<store::Shelf>(given)) return *shelf;
  return std::unexpected(problem_response(422, "shelf must be in_use, archived or all"));
}

Response label_program(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto labels = json::read_labels_body(call.request.body);
  if (!labels) return problem_response(labels.error());
  return program_response(call.api.application().store().programs().label(*id, *labels, stamp_of(call)));
}

Response archive_program(const Call& call) { return move_program(call, &store::Programs::archive); }
Response fetch_back_program(const Call& call) { return move_program(call, &store::Programs::fetch_back); }

Response delete_program(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_reason_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  constexpr std::int64_t kDay_ms = std::int64_t{24} * 3600 * 1000;
  app::Application& app = call.api.application();
  const store::Stamp by = stamp_of(call);
  const std::int64_t until_ms = by.at_ms - kDay_ms * app.limits().delete_after_days;
  return program_response(app.store().programs().erase(*id, until_ms, body->reason, by));
}

Response search_programs(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  const auto shelf = shelf_of(call.request);
  if (!shelf) return shelf.error();
  if (*shelf == store::Shelf::archived) return problem_response(422, "a search takes shelf in_use or all");
  app::Application& app = call.api.application();
  if (app.library() == nullptr) return no_library();
  store::Library& library = app.library()->library();
  const auto waiting = app.library()->waiting();
  if (!waiting) return problem_response(waiting.error());
  const auto state = app::lift(library.state());
  if (!state) return problem_response(state.error());
  const auto found = library.search(query_text(call.request, "q"), *page, *shelf == store::Shelf::all);
  if (!found) return problem_response(app::from_store(found.error()));
  std::vector<json::SearchHit> hits;
  for (const store::LibraryHit& hit : found->items) {
    auto program = app.store().programs().get(hit.program);
    if (program && !program->is_deleted()) hits.push_back({.hit = hit, .program = std::move(*program)});
  }
  return json_response(200, json::search_result(hits, found->next, *state, *waiting));
}

Response get_program_uses(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  app::Application& app = call.api.application();
  if (app.library() == nullptr) return no_library();
  const auto uses = app::uses_of(app.store(), *app.library(), *id);
  if (!uses) return problem_response(uses.error());
  return json_response(200, json::program_uses(*uses));
}

}  // namespace dripfeed::http
