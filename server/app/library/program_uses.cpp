// Lists are cut at their newest entries, and say so.
#include "server/app/library/program_uses.h"

#include <algorithm>
#include <map>
#include <utility>

namespace dripfeed::app {

namespace {

Result<void> add_parts(store::Store& store, store::Id program, ProgramUses& into) {
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    const auto revisions = lift(store.programs().revisions(program, page));
    if (!revisions) return std::unexpected(revisions.error());
    for (const store::ProgramRevision& one : revisions->items) {
      const bool known =
          std::ranges::find(into.parts, one.origin.part, &ProgramUses::OfPart::number) != into.parts.end();
      if (one.origin.part.empty() || known) continue;
      into.parts.push_back({one.origin.part, one.origin.part_revision, one.revision});
    }
    page.after = revisions->next;
  } while (!page.after.empty());
  return {};
}

Result<void> add_work(store::Store& store, store::Id program, ProgramUses& into) {
  const store::PageRequest page{.limit = ProgramUses::kMost, .after = {}};
  auto releases = lift(store.releases().list(page, {.program = program}));
  if (!releases) return std::unexpected(releases.error());
  auto jobs = lift(store.jobs().list(page, {.machine = {}, .state = {}, .program = program}));
  if (!jobs) return std::unexpected(jobs.error());
  std::map<std::string, ProgramUses::OfMachine> machines;
  for (const store::Release& one : releases->items) ++machines[one.of.machine].releases;
  for (const store::Job& one : jobs->items) ++machines[one.machine].jobs;
  for (auto& [name, one] : machines) {
    one.machine = name;
    into.machines.push_back(std::move(one));
  }
  into.has_more_releases = !releases->next.empty();
  into.has_more_jobs = !jobs->next.empty();
  into.releases = std::move(releases->items);
  into.jobs = std::move(jobs->items);
  return {};
}

Result<void> add_calls(store::Store& store, LibraryIndexer& indexer, const store::Program& program, ProgramUses& into) {
  store::Library& library = indexer.library();
  const auto callers = lift(library.callers_of(program.id));
  if (!callers) return std::unexpected(callers.error());
  for (const store::Caller& one : *callers) {
    if (into.callers.size() == ProgramUses::kMost) break;
    auto from = store.programs().get(one.program);
    if (from && from->dialect == program.dialect) into.callers.push_back({one.call, std::move(*from)});
  }
  auto known = lift(library.calls_of(program.id));
  if (!known) return std::unexpected(known.error());
  into.known = std::move(*known);
  for (const store::ProgramCall& call : into.known.calls) {
    if (into.calls.size() == ProgramUses::kMost) break;
    const auto named = lift(library.named(call.name));
    if (!named) return std::unexpected(named.error());
    ProgramUses::Called called{.call = call, .programs = {}};
    for (const store::Id id : *named) {
      auto to = store.programs().get(id);
      if (to && to->dialect == program.dialect && called.programs.size() < ProgramUses::kMost)
        called.programs.push_back(std::move(*to));
    }
    into.calls.push_back(std::move(called));
  }
  return {};
}

}  // namespace

Result<ProgramUses> uses_of(store::Store& store, LibraryIndexer& indexer, store::Id program) {
  const auto stored = lift(store.programs().get(program));
  if (!stored) return std::unexpected(stored.error());
  ProgramUses uses;
  if (auto added = add_parts(store, program, uses); !added) return std::unexpected(added.error());
  if (auto added = add_work(store, program, uses); !added) return std::unexpected(added.error());
  if (auto added = add_calls(store, indexer, *stored, uses); !added) return std::unexpected(added.error());
  const auto state = lift(indexer.library().state());
  if (!state) return std::unexpected(state.error());
  const auto waiting = indexer.waiting();
  if (!waiting) return std::unexpected(waiting.error());
  uses.unread = state->not_read;
  uses.waiting = *waiting;
  return uses;
}

}  // namespace dripfeed::app
