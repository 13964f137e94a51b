// The nominal is made anew from the family revision and values that the text was rendered from, so that it is what was
// ordered, not what was printed.
#include "server/app/checking.h"

#include <charconv>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace dripfeed::app {

namespace {

store::Outcome outcome_of(checks::Verdict verdict) {
  switch (verdict) {
    case checks::Verdict::pass: return store::Outcome::pass;
    case checks::Verdict::warn: return store::Outcome::warn;
    case checks::Verdict::unknown: return store::Outcome::unknown;
    case checks::Verdict::fail: return store::Outcome::fail;
  }
  return store::Outcome::unknown;
}

// "profile 12-60,70-71", as programs.cpp writes it.
std::vector<family::LineRange> read_profile_lines(std::string_view facts) {
  std::vector<family::LineRange> ranges;
  constexpr std::string_view kHead = "profile ";
  if (!facts.starts_with(kHead)) return ranges;
  const char* at = facts.data() + kHead.size();
  const char* const end = facts.data() + facts.size();
  while (at < end) {
    family::LineRange range;
    const auto first = std::from_chars(at, end, range.first);
    if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '-') break;
    const auto last = std::from_chars(first.ptr + 1, end, range.last);
    if (last.ec != std::errc{}) break;
    ranges.push_back(range);
    at = last.ptr < end && *last.ptr == ',' ? last.ptr + 1 : end;
  }
  return ranges;
}

}  // namespace

Checking::Checking(store::Store& store, Catalog& catalog, Events& events, const Clock& clock,
                   const Documents& documents)
    : store_(store), catalog_(catalog), events_(events), clock_(clock), documents_(documents) {}

Result<void> Checking::add_geometry(const store::ProgramRevision& revision, Examination& examination) {
  const store::Origin& origin = revision.origin;
  if (origin.kind != store::OriginKind::rendered) return {};
  const auto family = lift(store_.families().get(origin.family, origin.family_revision));
  if (!family) return std::unexpected(family.error());
  const auto values = documents_.read_values(origin.values);
  if (!values) return std::unexpected(values.error());
  examination.geometry =
      compile::family_geometry(text::Source(family->name, family->text), overrides_of(*values)).geometry;
  examination.profile_lines = read_profile_lines(revision.facts);
  return {};
}

Result<store::Verdict> Checking::check(const CheckOrder& order, std::string_view actor) {
  const auto program = lift(store_.programs().get(order.program));
  if (!program) return std::unexpected(program.error());
  auto revision = order.revision == 0 ? Result<store::ProgramRevision>(program->newest)
                                      : lift(store_.programs().get_revision(order.program, order.revision));
  if (!revision) return std::unexpected(revision.error());
  const auto machine = lift(store_.machines().get(order.machine));
  if (!machine) return std::unexpected(machine.error());
  const auto profile = documents_.read_profile(machine->profile);
  if (!profile) return std::unexpected(profile.error());
  if (profile->control.dialect != program->dialect) {
    return fail(ErrorCode::invalid, fmt::format("program {} is {}, machine {} is {}", program->name, program->dialect,
                                                machine->name, profile->control.dialect));
  }
  const auto control = control_of(*profile);
  if (!control) return std::unexpected(control.error());
  auto text = lift(store::read_whole(store_.contents(), revision->sha256, kTextLimit));
  if (!text) return std::unexpected(text.error());

  Examination examination{
      .source = text::Source(program->name, std::move(*text)),
      .dialect = compile::find_dialect(program->dialect),
      .control = *control,
      .inferred = false,
      .profile = &*profile,
      .delivery = order.delivery == store::Delivery::drip ? ir::Delivery::drip : ir::Delivery::memory,
      .find_called = {},
      .geometry = {},
      .profile_lines = {}};
  const auto known = add_geometry(*revision, examination);
  if (!known) return std::unexpected(known.error());
  const CheckReport report = examine(examination);

  const store::NewVerdict row{.program = program->id,
                              .revision = revision->revision,
                              .machine = machine->name,
                              .machine_revision = machine->revision,
                              .delivery = order.delivery,
                              .outcome = outcome_of(report.verdict),
                              .report = documents_.write_report(report)};
  auto verdict = lift(store_.verdicts().add(row, {std::string(actor), clock_.wall_ms()}));
  if (!verdict) return std::unexpected(verdict.error());
  events_.publish({.id = 0,
                   .kind = EventKind::verdict,
                   .machine = machine->name,
                   .job = {},
                   .verdict = verdict->id,
                   .outcome = verdict->of.outcome,
                   .text = program->name});
  return verdict;
}

}  // namespace dripfeed::app
