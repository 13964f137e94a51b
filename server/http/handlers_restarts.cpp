// A restart of a released text: shown first, then made of what was shown. Making it sends nothing: it becomes a release
// of its own, which an approver lets go for one transfer, and that becomes a job that a person arms.
#include <fmt/format.h>

#include "server/app/jobs/restarting.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/records.h"
#include "server/json/requests.h"
#include "store/hash/sha256.h"

namespace dripfeed::http {

namespace {

struct Made {
  store::Release of;
  app::StoredCase stored;
  json::DocumentWorkers::Restart restart;
};

// The text of the release, gone on in at the line.
app::Result<Made> make(const Call& call, store::Id id, const json::RestartBody& body) {
  app::Application& app = call.api.application();
  auto of = app::lift(app.store().releases().get(id));
  if (!of) return std::unexpected(of.error());
  const bool released = of->state == store::ReleaseState::proving || of->state == store::ReleaseState::approved;
  if (!released)
    return app::fail(app::ErrorCode::refused,
                     fmt::format("release {} is {}: nothing of it may be sent", of->id, store::name_of(of->state)));
  auto stored = app::load_case(
      app.store(), app.documents(),
      {.program = of->of.program, .revision = of->of.revision, .machine = of->of.machine, .delivery = of->of.delivery});
  if (!stored) return std::unexpected(stored.error());
  auto restart =
      call.api.workers().restart({.of = stored->order, .line = body.line, .clearance_mm = body.clearance_mm},
                                 waiter_of(call, "restart", fmt::format("program/{}", of->of.program), of->of.machine));
  if (!restart) return std::unexpected(restart.error());
  return Made{.of = std::move(*of), .stored = std::move(*stored), .restart = std::move(*restart)};
}

// In review where its verdict clears it, otherwise a draft.
app::Result<store::Release> hand_in(const Call& call, const Made& made, const store::Program& program,
                                    std::uint32_t line) {
  app::Application& app = call.api.application();
  const store::Stamp by{std::string(call.user), app.clock().wall_ms()};
  auto release = app::lift(app.store().releases().add({.program = program.id,
                                                       .revision = program.newest.revision,
                                                       .machine = made.of.of.machine,
                                                       .delivery = made.of.of.delivery,
                                                       .restart = {.release = made.of.id, .line = line}},
                                                      by));
  if (!release) return release;
  auto moved = app.store().releases().move(release->id,
                                           {.to = store::ReleaseState::in_review, .note = "the verdict clears it"}, by);
  return moved ? app::Result<store::Release>(std::move(*moved)) : release;
}

}  // namespace

Response preview_restart(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_restart_body(call.request.body, false);
  if (!body) return problem_response(body.error());
  auto made = make(call, *id, *body);
  if (!made) return problem_response(made.error());
  return json_response(200, std::move(made->restart.document));
}

Response make_restart(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_restart_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  const auto made = make(call, *id, *body);
  if (!made) return problem_response(made.error());
  if (!made->restart.is_possible)
    return problem_response(409, fmt::format("a restart at line {} is not possible: look at its preview", body->line));
  if (hash::sha256_hex(made->restart.text) != body->shown_sha256)
    return problem_response(409, "the restart is another text than was shown: look at it again");
  app::Application& app = call.api.application();
  const store::Program& of = made->stored.program;
  const auto text = app.programs().keep_text(of.dialect, made->restart.text);
  if (!text) return problem_response(text.error());
  const auto program =
      app.programs().add(fmt::format("{} from line {}", of.name, body->line), of.dialect, *text, call.user);
  if (!program) return problem_response(program.error());
  const auto verdict = app.checking().check(
      {.program = program->id,
       .revision = program->newest.revision,
       .machine = made->of.of.machine,
       .delivery = made->of.of.delivery},
      call.user, waiter_of(call, "check", fmt::format("program/{}", program->id), made->of.of.machine));
  if (!verdict) return problem_response(verdict.error());
  const auto release = hand_in(call, *made, *program, body->line);
  if (!release) return problem_response(release.error());
  return created(fmt::format("/api/v1/releases/{}", release->id), json::release(*release));
}

}  // namespace dripfeed::http
