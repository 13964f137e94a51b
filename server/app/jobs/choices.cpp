// What each machine says before the transaction stands with it: a machine that cannot take the program is left out, one
// that changes while the choice is made undoes all of it.
#include "server/app/jobs/choices.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

Result<std::vector<std::string>> machines_of(store::Store& store, const std::string& group) {
  const auto groups = lift(store.users().groups());
  if (!groups) return std::unexpected(groups.error());
  const auto found = std::ranges::find(*groups, group, &store::MachineGroup::name);
  if (found == groups->end()) return fail(ErrorCode::not_found, fmt::format("there is no group {}", group));
  return found->machines;
}

Result<std::string> text_of(store::Store& store, const ChoiceOrder& order) {
  const auto program = lift(store.programs().get(order.program));
  if (!program) return std::unexpected(program.error());
  if (order.revision == 0) return program->newest.sha256;
  const auto revision = lift(store.programs().get_revision(order.program, order.revision));
  if (!revision) return std::unexpected(revision.error());
  return revision->sha256;
}

// The release that lets this text go to the machine, or why there is none.
Result<store::Id> release_for(store::Store& store, Jobs& jobs, const ChoiceOrder& order, const std::string& sha256,
                              const std::string& machine, std::int64_t now_ms) {
  const auto clearance = lift(store.releases().released_for(sha256, machine, order.delivery, now_ms));
  if (!clearance) return std::unexpected(clearance.error());
  if (order.plan.order != 0) {
    const auto of = lift(store.orders().get(order.plan.order));
    if (!of) return std::unexpected(of.error());
    if (const std::string& only = of->of.plan.machine; !only.empty() && only != machine)
      return fail(ErrorCode::refused, fmt::format("order {} is for {}", of->id, only));
  }
  if (const auto ready = jobs.make_ready(clearance->release.id); !ready) return std::unexpected(ready.error());
  return clearance->release.id;
}

}  // namespace

Result<ChoiceParts> prepare_choice(store::Store& store, Jobs& jobs, const ChoiceOrder& order, std::int64_t now_ms,
                                   const std::function<bool(const std::string& machine)>& may) {
  const auto machines = machines_of(store, order.group);
  if (!machines) return std::unexpected(machines.error());
  const auto sha256 = text_of(store, order);
  if (!sha256) return std::unexpected(sha256.error());
  ChoiceParts parts;
  for (const std::string& machine : *machines) {
    const auto release = may(machine) ? release_for(store, jobs, order, *sha256, machine, now_ms)
                                      : fail(ErrorCode::refused, "the caller may queue nothing on this machine");
    if (release) {
      parts.releases.push_back(*release);
    } else {
      parts.left_out.push_back({.machine = machine, .why = release.error().text});
    }
  }
  if (!parts.releases.empty()) return parts;
  std::vector<ErrorPlace> places;
  places.reserve(parts.left_out.size());
  for (const LeftOut& one : parts.left_out)
    places.push_back({.pointer = {}, .line = 0, .column = 0, .text = fmt::format("{}: {}", one.machine, one.why)});
  return fail(ErrorCode::refused, fmt::format("no machine of group {} can take this program", order.group),
              std::move(places));
}

Result<Choice> add_choice(store::Store& store, Jobs& jobs, const ChoiceParts& parts, const JobPlan& plan,
                          std::string_view actor) {
  Choice choice{.id = 0, .jobs = {}, .left_out = parts.left_out};
  std::optional<Error> refused;
  const auto add_all = [&]() -> store::Result<void> {
    for (const store::Id release : parts.releases) {
      JobPlan one = plan;
      one.choice = choice.id;
      one.begins_choice = choice.id == 0;
      auto job = jobs.add_known(release, actor, one);
      if (job && !*job) job = fail(ErrorCode::unavailable, std::string(Jobs::kMachineChanges));
      if (!job) {
        refused = std::move(job.error());
        return std::unexpected(store::Error{store::ErrorCode::internal, "undone"});
      }
      choice.id = (*job)->choice;
      choice.jobs.push_back(std::move(**job));
    }
    return {};
  };
  const auto done = store.atomically(add_all);
  if (refused) return std::unexpected(std::move(*refused));
  if (!done) return std::unexpected(from_store(done.error()));
  return choice;
}

}  // namespace dripfeed::app
