// Two revisions compared with each other, or one and what becomes of it. A worker does it: both are programs of other
// people.
#include <fmt/format.h>

#include "server/app/library/compare.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/reports.h"
#include "server/json/requests.h"
#include "server/json/workers.h"

namespace dripfeed::http {

namespace {

// Longest text that is compared.
constexpr std::uint64_t kTextLimit = std::uint64_t{64} << 20U;

struct Side {
  json::ComparedSide of;
  app::CompareOrder::Side text;
};

app::Result<Side> load(store::Store& store, store::Id id, store::Revision wanted) {
  auto stored = load_text(store, id, wanted, kTextLimit);
  if (!stored) return std::unexpected(stored.error());
  return Side{.of = {.program = id, .name = stored->name, .revision = stored->revision},
              .text = {.name = stored->name, .dialect = stored->dialect, .text = std::move(stored->text)}};
}

// A revision in the query; 0 where it is not given.
std::expected<std::uint64_t, Response> revision_in(const Request& request, const std::string& name) {
  return number_of(request, name, 0, 1, INT64_MAX);
}

Response answer(const Call& call, Side first, Side second, const std::string& machine) {
  app::CompareOrder order{.first = std::move(first.text), .second = std::move(second.text), .profile = {}};
  if (!machine.empty()) {
    auto found = app::lift(call.api.application().store().machines().get(machine));
    if (!found) return problem_response(found.error());
    order.profile = std::move(found->profile);
  }
  const auto done = call.api.workers().compare(
      order, waiter_of(call, "compare", fmt::format("program/{}", first.of.program), machine));
  if (!done) return problem_response(done.error());
  return json_response(200, json::comparison(*done, first.of, second.of));
}

}  // namespace

Response compare_programs(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto revision = revision_in(call.request, "revision");
  if (!revision) return revision.error();
  const auto with_revision = revision_in(call.request, "with_revision");
  if (!with_revision) return with_revision.error();
  const std::string with = query_text(call.request, "with");
  const auto other = with.empty() ? id : id_of(with);
  if (!other) return other.error();
  if (with.empty() && *with_revision == 0)
    return problem_response(422, "with (a program) or with_revision states what it is compared with");
  store::Store& store = call.api.application().store();
  auto first = load(store, *id, *revision);
  if (!first) return problem_response(first.error());
  auto second = load(store, *other, *with_revision);
  if (!second) return problem_response(second.error());
  return answer(call, std::move(*first), std::move(*second), query_text(call.request, "machine"));
}

Response compare_text(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  auto body = json::read_compare_text_body(call.request.body);
  if (!body) return problem_response(body.error());
  auto first = load(call.api.application().store(), *id, body->revision);
  if (!first) return problem_response(first.error());
  Side second{.of = {.program = *id, .name = first->of.name, .revision = 0},
              .text = {.name = first->text.name, .dialect = first->text.dialect, .text = std::move(body->text)}};
  return answer(call, std::move(*first), std::move(second), body->machine);
}

}  // namespace dripfeed::http
