// Two tables by the beginning of a route's pattern. A route that no row names is set up, and acts on no machine.
#include "server/http/rights.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "server/http/api.h"
#include "server/json/orders.h"
#include "server/json/requests.h"

namespace dripfeed::http {

namespace {

struct ScopeRow {
  std::string_view begin;  // of the pattern
  std::string_view scope;
};
// The first row that fits counts.
constexpr std::array kScopeRows = {
    ScopeRow{"/api/v1/session", "line"},
    ScopeRow{"/api/v1/machines/{name}/confirm-reset", "line"},
    ScopeRow{"/api/v1/machines/{name}/line-test", "line"},
    ScopeRow{"/api/v1/alarms", "line"},
    ScopeRow{"/api/v1/jobs/{id}/arm", "line"},
    ScopeRow{"/api/v1/jobs/{id}/stop", "line"},  // and its reasons
    ScopeRow{"/api/v1/jobs/{id}/cancel", "line"},
    ScopeRow{"/api/v1/jobs/{id}/resume", "line"},
    ScopeRow{"/api/v1/jobs/{id}/confirm-end", "line"},
    ScopeRow{"/api/v1/jobs", "queue"},
    ScopeRow{"/api/v1/groups/{name}/jobs", "queue"},
    ScopeRow{"/api/v1/orders", "queue"},
    ScopeRow{"/api/v1/releases", "releases"},
    ScopeRow{"/api/v1/checks/{id}/waivers", "releases"},
    ScopeRow{"/api/v1/checks", "checks"},
    ScopeRow{"/api/v1/render", "checks"},
    ScopeRow{"/api/v1/preview", "checks"},
    ScopeRow{"/api/v1/diagnose", "checks"},
    ScopeRow{"/api/v1/convert", "checks"},
    ScopeRow{"/api/v1/optimize", "checks"},
    ScopeRow{"/api/v1/rewrite", "checks"},
    ScopeRow{"/api/v1/path", "checks"},
    ScopeRow{"/api/v1/stock", "checks"},
    ScopeRow{"/api/v1/statistics", "checks"},
    ScopeRow{"/api/v1/accuracy", "checks"},
    ScopeRow{"/api/v1/gouge", "checks"},
    ScopeRow{"/api/v1/timing", "checks"},
    ScopeRow{"/api/v1/sweep", "checks"},
    ScopeRow{"/api/v1/work", "checks"},
    ScopeRow{"/api/v1/programs/{id}/compare", "checks"},
    ScopeRow{"/api/v1/programs", "library"},
    ScopeRow{"/api/v1/imports", "library"},
    ScopeRow{"/api/v1/split", "library"},
    ScopeRow{"/api/v1/families", "library"},
    ScopeRow{"/api/v1/parts", "library"},
    ScopeRow{"/api/v1/receipts", "library"},
    ScopeRow{"/api/v1/attachments", "library"},
};

enum class Acts : std::uint8_t {
  anywhere,  // whoever may do it on one machine may do it on all
  machine_in_path,
  group_in_path,
  job,
  release,
  verdict,
  alarm,
  receipt,
  machine_in_body,
  release_in_body,
};

struct ActRow {
  Method method;
  std::string_view begin;
  Acts on;
};
// The first row that fits counts.
constexpr std::array kActRows = {
    ActRow{Method::post, "/api/v1/machines/{name}", Acts::machine_in_path},
    ActRow{Method::put, "/api/v1/machines/{name}", Acts::machine_in_path},
    ActRow{Method::post, "/api/v1/jobs/{id}/stop-reasons", Acts::job},
    ActRow{Method::post, "/api/v1/jobs/{id}/stop", Acts::anywhere},
    ActRow{Method::post, "/api/v1/jobs/{id}/arm", Acts::job},
    ActRow{Method::post, "/api/v1/jobs/{id}/move", Acts::job},
    ActRow{Method::post, "/api/v1/jobs/{id}/schedule", Acts::job},
    ActRow{Method::post, "/api/v1/jobs/{id}/hold", Acts::job},
    ActRow{Method::post, "/api/v1/jobs/{id}/end-hold", Acts::job},
    ActRow{Method::post, "/api/v1/jobs/{id}/retry", Acts::job},
    ActRow{Method::post, "/api/v1/jobs/{id}/confirm-end", Acts::job},
    ActRow{Method::post, "/api/v1/groups/{name}/jobs", Acts::group_in_path},
    ActRow{Method::post, "/api/v1/jobs/{id}/cancel", Acts::job},
    ActRow{Method::post, "/api/v1/jobs/{id}/resume", Acts::job},
    ActRow{Method::post, "/api/v1/jobs", Acts::release_in_body},
    ActRow{Method::post, "/api/v1/releases/{id}", Acts::release},
    ActRow{Method::post, "/api/v1/releases", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/checks/{id}", Acts::verdict},
    ActRow{Method::post, "/api/v1/checks", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/render", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/preview", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/accuracy", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/gouge", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/timing", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/sweep", Acts::machine_in_body},
    // Of a text alone where the body names no machine: whoever may do it on one machine.
    ActRow{Method::post, "/api/v1/diagnose", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/path", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/stock", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/convert", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/optimize", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/rewrite", Acts::anywhere},
    ActRow{Method::post, "/api/v1/statistics", Acts::machine_in_body},
    ActRow{Method::post, "/api/v1/alarms/{id}", Acts::alarm},
    ActRow{Method::post, "/api/v1/receipts/{id}", Acts::receipt},
};
const ActRow* act_of(const Route& route) {
  const auto* const row = std::ranges::find_if(
      kActRows, [&](const ActRow& one) { return one.method == route.method && route.pattern.starts_with(one.begin); });
  return row == kActRows.end() ? nullptr : row;
}

template <class Row, class Machine>
std::optional<std::string> machine_in(const store::Result<Row>& row, const Machine& machine) {
  return row ? std::optional<std::string>(machine(*row)) : std::nullopt;
}

std::optional<std::string> machine_of_release(store::Store& store, store::Id id) {
  return machine_in(store.releases().get(id), [](const store::Release& one) { return one.of.machine; });
}

std::optional<std::string> machine_by_id(store::Store& store, Acts on, store::Id id) {
  switch (on) {
    case Acts::job: return machine_in(store.jobs().get(id), [](const store::Job& one) { return one.machine; });
    case Acts::release: return machine_of_release(store, id);
    case Acts::verdict:
      return machine_in(store.verdicts().get(id), [](const store::Verdict& one) { return one.of.machine; });
    case Acts::alarm: return machine_in(store.alarms().get(id), [](const store::Alarm& one) { return one.machine; });
    case Acts::receipt:
      return machine_in(store.receipts().get(id), [](const store::Receipt& one) { return one.of.machine; });
    case Acts::anywhere:
    case Acts::machine_in_path:
    case Acts::group_in_path:
    case Acts::machine_in_body:
    case Acts::release_in_body: break;
  }
  return std::nullopt;
}

}  // namespace

std::string_view scope_of(const Route& route) {
  const auto* const row =
      std::ranges::find_if(kScopeRows, [&](const ScopeRow& one) { return route.pattern.starts_with(one.begin); });
  return row == kScopeRows.end() ? "setup" : row->scope;
}

bool allows(std::string_view scope, const Route& route) {
  if (scope.empty() || route.method == Method::get) return true;
  const std::vector<std::string_view> words = words_in(scope);
  return std::ranges::find(words, scope_of(route)) != words.end();
}

std::string_view unknown_scope(std::string_view scope) {
  for (const std::string_view word : words_in(scope))
    if (std::ranges::find(kScopes, word) == std::end(kScopes)) return word;
  return {};
}

namespace {

std::optional<std::string> machine_of(const ActRow& row, const Call& call) {
  if (row.on == Acts::machine_in_path) return call.parameters[0];
  if (row.on == Acts::machine_in_body) return json::machine_in_body(call.request.body);
  store::Store& store = call.api.application().store();
  if (row.on == Acts::release_in_body) {
    const auto body = json::read_job_body(call.request.body);
    return body ? machine_of_release(store, body->release) : std::nullopt;
  }
  const auto id = id_of(call.parameters[0]);
  return id ? machine_by_id(store, row.on, *id) : std::nullopt;
}

}  // namespace

namespace {

Right right_on(const Caller& caller, const std::string& machine) {
  const auto found = caller.on_machines.find(machine);
  return found == caller.on_machines.end() ? caller.right : found->second;
}

// The best of its machines: the handler asks for each one.
Right right_in_group(const Call& call, const Caller& caller) {
  const auto groups = call.api.application().store().users().groups();
  Right best = caller.right;
  if (!groups) return best;
  for (const store::MachineGroup& group : *groups) {
    if (group.name != call.parameters[0]) continue;
    for (const std::string& machine : group.machines) best = std::max(best, right_on(caller, machine));
  }
  return best;
}

}  // namespace

Right reach(const Route& route, const Caller& caller) {
  Right best = caller.right;
  if (act_of(route) == nullptr) return best;
  for (const auto& [machine, right] : caller.on_machines) best = std::max(best, right);
  return best;
}

Right right_for(const Route& route, const Call& call, const Caller& caller) {
  const ActRow* row = act_of(route);
  if (row == nullptr || caller.on_machines.empty()) return caller.right;
  if (row->on == Acts::group_in_path) return right_in_group(call, caller);
  const auto machine = row->on == Acts::anywhere ? std::nullopt : machine_of(*row, call);
  if (!machine) return reach(route, caller);
  return right_on(caller, *machine);
}

}  // namespace dripfeed::http
