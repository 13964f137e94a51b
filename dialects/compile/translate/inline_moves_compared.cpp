// The translation is run, too, and must move as the source did, from its first block to its last. Within a cycle that
// both controls have, a rapid may stop before its end, chips may be broken by another speed back and a tap be written
// as a thread: the passes that translate cycles know why. A tap that is written as a tap has the same lead, at the same
// speed; how a spindle turns that its position is given for, a run does not say.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "dialects/compile/dialect/describe_move.h"
#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/compile/dialect/source_lines.h"
#include "dialects/compile/plain/lost_writes.h"
#include "dialects/compile/translate/inline_moves.h"
#include "dialects/compile/translate/same_motion.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::compile {

namespace {

using Place = std::array<double, ir::kAxisCount>;

struct PlacedMove {
  std::uint32_t line = 0;  // of the source
  ir::Motion motion;
};

// Whether the end of the first rapid lies on the straight line that both go.
bool only_stops(const ir::Motion& first, const ir::Motion& second) {
  if (first.kind != ir::MotionKind::rapid || second.kind != ir::MotionKind::rapid) return false;
  const std::uint16_t moved = first.axes_commanded | second.axes_commanded;
  if (first.machine_coordinates || second.machine_coordinates) return false;
  if (((first.axes_unknown | second.axes_unknown) & moved) != 0) return false;
  constexpr double kDetour_mm = 1e-6;
  const auto distance = [](const Place& a, const Place& b) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return std::sqrt(sum);
  };
  return distance(first.start, first.end) + distance(first.end, second.end) - distance(first.start, second.end) <=
         kDetour_mm;
}

// `origin_of`: the source's line for a line of the run.
template <class Origin>
std::vector<PlacedMove> moves_of(const RecordedRun& run, Origin&& origin_of) {
  std::vector<PlacedMove> out;
  for (const Visit& visit : run.visits) {
    const std::uint32_t line = origin_of(visit.line);
    for (ir::Motion m : run.motions_of(visit)) {
      if (!leads_somewhere(m)) continue;
      if (!out.empty() && only_stops(out.back().motion, m)) {
        m.start = out.back().motion.start;
        out.pop_back();
      }
      out.push_back({line, m});
    }
  }
  return out;
}

}  // namespace

std::vector<text::Diagnostic> InlineMoves::compare(const ir::Program& translation,
                                                   const std::vector<std::uint32_t>& origin_lines) const {
  if (runs_.empty()) return alarm_of(translation, origin_lines);
  for (std::size_t setting = 0; setting < runs_.size(); ++setting) {
    const std::optional<Difference> other = first_difference(translation, origin_lines, setting);
    if (!other) continue;
    const auto span = spans_.find(other->line);
    return {passes::diagnose(
        passes::differs(fmt::format("what moves here{} ({})",
                                    owners_.empty() ? "" : " together with statements that are written as their moves",
                                    other->what)),
        span == spans_.end() ? text::Span{} : span->second, to_.title)};
  }
  return {};
}

// Of a source whose run says nothing, the translation may still be one that the other control stops at for certain.
std::vector<text::Diagnostic> InlineMoves::alarm_of(const ir::Program& translation,
                                                    const std::vector<std::uint32_t>& origin_lines) const {
  ProgramLibrary standard(to_, [](std::string_view) { return std::nullopt; });
  ir::Control control = to_;
  control.semantics.unset_is_unknown = true;
  interpreter::RunOptions options;
  options.limits = limits_;
  const RecordedRun run = record(translation, control, standard, options, {}, {});
  // With a value that is not given it may never come to the block that stops, or calculate there.
  if (std::ranges::any_of(run.result.not_interpreted, &interpreter::NotInterpreted::is_input)) return {};
  for (const interpreter::RunDiagnostic& d : run.result.diagnostics) {
    constexpr std::array kElsewhere = {
        text::DiagnosticId::call_target_missing, text::DiagnosticId::limit_reached,
        text::DiagnosticId::user_alarm,          text::DiagnosticId::no_feed,
        text::DiagnosticId::division_by_zero,    text::DiagnosticId::argument_out_of_domain,
        text::DiagnosticId::result_overflow};
    const bool is_alarm = d.diagnostic.severity == text::Severity::error && d.program == 0;
    if (!is_alarm || std::ranges::find(kElsewhere, d.diagnostic.id) != kElsewhere.end()) continue;
    const std::uint32_t line = d.line > 0 && d.line <= origin_lines.size() ? origin_lines[d.line - 1] : 0;
    return {passes::diagnose(passes::differs("what stops here (" + text::message_of(d.diagnostic) + ")"),
                             span_of_line(source_, line), to_.title)};
  }
  return {};
}

std::optional<InlineMoves::Difference> InlineMoves::first_difference(const ir::Program& translation,
                                                                     const std::vector<std::uint32_t>& origin_lines,
                                                                     std::size_t setting) const {
  ProgramLibrary standard(to_, [](std::string_view) { return std::nullopt; });
  interpreter::RunOptions options;
  options.limits = limits_;
  options.skip_switches = settings_[setting];
  const RecordedRun run = record(translation, to_, standard, options, {}, {});
  const auto wanted = moves_of(runs_[setting], [](std::uint32_t line) { return line; });
  const auto made = moves_of(
      run, [&](std::uint32_t line) { return line == 0 || line > origin_lines.size() ? 0 : origin_lines[line - 1]; });
  const bool inch =
      to_.semantics.power_on_unit == ir::Function::unit_inch ||
      std::ranges::find(translation.codes, ir::Function::unit_inch, &ir::Code::function) != translation.codes.end();
  const SameMotion comparison(from_, to_, inch);
  const auto tap_line = [&](std::uint32_t line) {
    const auto at = tap_lines_.find(line);
    return at == tap_lines_.end() ? 0U : at->second;
  };
  std::size_t i = 0;
  std::size_t j = 0;
  const auto same = [&](const PlacedMove& a, const PlacedMove& b) {
    const std::uint32_t tap = tap_line(a.line);
    if (tap != 0 && tap == tap_line(b.line)) return comparison.same_of_tap(a.motion, b.motion);
    const bool of_cycle = cycles_.contains(a.line) && b.line == a.line;
    const bool enters =
        a.motion.kind != ir::MotionKind::rapid && (i == 0 || wanted[i - 1].motion.kind == ir::MotionKind::rapid);
    return comparison.same(a.motion, b.motion,
                           !of_cycle ? CyclePart::none
                           : enters  ? CyclePart::entry
                                     : CyclePart::other);
  };
  while (i < wanted.size() && j < made.size()) {
    if (same(wanted[i], made[j])) {
      ++i, ++j;
    } else if (comparison.stays(wanted[i].motion)) {
      ++i;  // as short as an increment of the control: rounded, it is none
    } else if (comparison.stays(made[j].motion)) {
      ++j;
    } else {
      return Difference{wanted[i].line,
                        fmt::format("{}; in the translation {}", describe_move(wanted[i].motion, made[j].motion),
                                    describe_move(made[j].motion, wanted[i].motion))};
    }
  }
  while (i < wanted.size() && comparison.stays(wanted[i].motion)) ++i;
  while (j < made.size() && comparison.stays(made[j].motion)) ++j;
  if (i < wanted.size())
    return Difference{wanted[i].line,
                      describe_move(wanted[i].motion, wanted[i].motion) + ", which the translation does not make"};
  if (j < made.size())
    return Difference{made[j].line, "the translation also makes " + describe_move(made[j].motion, made[j].motion)};
  const bool ended =
      run.result.ended == interpreter::Ended::end || (returns_ && run.result.ended == runs_[setting].result.ended);
  if (const auto lost = first_lost_write(translation, run, origin_lines, setting))
    return Difference{*lost, "the translation does not write what is written here"};
  if (run.is_whole && ended) return std::nullopt;
  const std::uint32_t last = wanted.empty() ? 1 : wanted.back().line;
  return Difference{owners_.empty() ? last : owners_.front(), "the translation does not reach its end"};
}

// In order; the translation may write more, to variables that it needs itself.
std::optional<std::uint32_t> InlineMoves::first_lost_write(const ir::Program& translation, const RecordedRun& run,
                                                           const std::vector<std::uint32_t>& origin_lines,
                                                           std::size_t setting) const {
  if (writes_.empty()) return std::nullopt;
  const auto lines_of = [](const RecordedRun& of, const std::map<std::uint32_t, std::size_t>& writes, auto&& origin) {
    std::vector<std::uint32_t> out;
    for (const Visit& visit : of.visits) {
      const auto at = writes.find(visit.line);
      if (at != writes.end()) out.insert(out.end(), at->second, origin(visit.line));
    }
    return out;
  };
  const auto wanted = lines_of(runs_[setting], writes_, [](std::uint32_t line) { return line; });
  const auto made = lines_of(run, writes_by_line(translation, to_), [&](std::uint32_t line) {
    return line <= origin_lines.size() ? origin_lines[line - 1] : 0;
  });
  auto at = made.begin();
  for (const std::uint32_t line : wanted) {
    at = std::find(at, made.end(), line);
    if (at == made.end()) return line;
    ++at;
  }
  return std::nullopt;
}

}  // namespace dripfeed::compile
