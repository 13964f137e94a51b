// The translation is run, too, and must move as the source did, from its first block to its last. Within a cycle that
// both controls have, a rapid may stop before its end, chips may be broken by another speed back and a tap be written
// as a thread: the passes that translate cycles know why. A tap that is written as a tap has the same lead, at the same
// speed; how a spindle turns that its position is given for, a run does not say.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

// The moves of a run one after the other: a long program's are not kept twice.
class MovesInOrder {
 public:
  // `origin_of`: the source's line for a line of the run.
  MovesInOrder(const RecordedRun& run, std::function<std::uint32_t(std::uint32_t)> origin_of)
      : run_(run), origin_of_(std::move(origin_of)), ahead_(read()) {
    next();
  }

  [[nodiscard]] bool ended() const { return !now_; }
  [[nodiscard]] const ir::Motion& motion() const { return now_->motion; }
  [[nodiscard]] std::uint32_t line() const { return now_->line; }
  // Of the last one, also where all have ended; 1 where there was none.
  [[nodiscard]] std::uint32_t last_line() const { return last_line_; }
  [[nodiscard]] bool is_after_rapid() const { return is_after_rapid_; }

  void next() {
    is_after_rapid_ = !now_ || now_->motion.kind == ir::MotionKind::rapid;
    now_ = std::exchange(ahead_, std::nullopt);
    if (!now_) return;
    last_line_ = now_->line;
    while ((ahead_ = read()) && only_stops(now_->motion, ahead_->motion)) {
      ahead_->motion.start = now_->motion.start;
      now_ = ahead_;
      last_line_ = now_->line;
    }
  }

 private:
  std::optional<PlacedMove> read() {
    for (; visit_ < run_.visits.size(); ++visit_, motion_ = 0) {
      const auto motions = run_.motions_of(run_.visits[visit_]);
      while (motion_ < motions.size()) {
        const ir::Motion& m = motions[motion_++];
        if (leads_somewhere(m)) return PlacedMove{origin_of_(run_.visits[visit_].line), m};
      }
    }
    return std::nullopt;
  }

  const RecordedRun& run_;
  std::function<std::uint32_t(std::uint32_t)> origin_of_;
  std::size_t visit_ = 0;
  std::size_t motion_ = 0;  // of the visit: the next one
  std::uint32_t last_line_ = 1;
  bool is_after_rapid_ = true;
  std::optional<PlacedMove> ahead_;
  std::optional<PlacedMove> now_;
};

// Why a run does not know where a move ends.
std::string what_is_open(const RecordedRun& run) {
  const auto& open = run.result.not_interpreted;
  const auto why = std::ranges::find(open, false, &interpreter::NotInterpreted::effects_known);
  return why == open.end() ? "a move whose end is not known" : why->name;
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
  MovesInOrder wanted(runs_[setting], [](std::uint32_t line) { return line; });
  MovesInOrder made(
      run, [&](std::uint32_t line) { return line == 0 || line > origin_lines.size() ? 0 : origin_lines[line - 1]; });
  const bool inch =
      to_.semantics.power_on_unit == ir::Function::unit_inch ||
      std::ranges::find(translation.codes, ir::Function::unit_inch, &ir::Code::function) != translation.codes.end();
  const SameMotion comparison(from_, to_, inch);
  const auto tap_line = [&](std::uint32_t line) {
    const auto at = tap_lines_.find(line);
    return at == tap_lines_.end() ? 0U : at->second;
  };
  const auto same = [&] {
    const std::uint32_t tap = tap_line(wanted.line());
    if (tap != 0 && tap == tap_line(made.line())) return comparison.same_of_tap(wanted.motion(), made.motion());
    const bool of_cycle = cycles_.contains(wanted.line()) && made.line() == wanted.line();
    const bool enters = wanted.motion().kind != ir::MotionKind::rapid && wanted.is_after_rapid();
    return comparison.same(wanted.motion(), made.motion(),
                           !of_cycle ? CyclePart::none
                           : enters  ? CyclePart::entry
                                     : CyclePart::other);
  };
  while (!wanted.ended() && !made.ended()) {
    if (same()) {
      wanted.next();
      made.next();
    } else if (comparison.stays(wanted.motion())) {
      wanted.next();  // as short as an increment of the control: rounded, it is none
    } else if (comparison.stays(made.motion())) {
      made.next();
    } else {
      const bool open = leaves_end_open(wanted.motion(), made.motion());
      return Difference{wanted.line(),
                        fmt::format("{}; in the translation {}", describe_move(wanted.motion(), made.motion()),
                                    open ? what_is_open(run) : describe_move(made.motion(), wanted.motion()))};
    }
  }
  while (!wanted.ended() && comparison.stays(wanted.motion())) wanted.next();
  while (!made.ended() && comparison.stays(made.motion())) made.next();
  if (!wanted.ended())
    return Difference{wanted.line(),
                      describe_move(wanted.motion(), wanted.motion()) + ", which the translation does not make"};
  if (!made.ended())
    return Difference{made.line(), "the translation also makes " + describe_move(made.motion(), made.motion())};
  const bool ended =
      run.result.ended == interpreter::Ended::end || (returns_ && run.result.ended == runs_[setting].result.ended);
  if (const auto lost = first_lost_write(translation, run, origin_lines, setting))
    return Difference{*lost, "the translation does not write what is written here"};
  if (run.is_whole && ended) return std::nullopt;
  return Difference{owners_.empty() ? wanted.last_line() : owners_.front(), "the translation does not reach its end"};
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
