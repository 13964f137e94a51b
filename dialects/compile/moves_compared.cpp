// The translation is run, too, and must move as the source did, from its first block to its last. Within a cycle that
// both controls have, a rapid may stop on its way, chips may be broken by another speed back and a tap be said as a
// thread: the passes that translate cycles know why. A tap that is said as a tap has the same lead, at the same speed;
// how a spindle turns that its position is given for, a run does not say.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "dialects/compile/motion_codes.h"
#include "dialects/compile/moves_in_place.h"

namespace dripfeed::compile {

namespace {

using Place = std::array<double, ir::kAxisCount>;

struct PlacedMove {
  std::uint32_t line = 0;  // of the source
  ir::Motion motion;
};

// Dwells, and moves that lead somewhere.
bool matters(const ir::Motion& m) {
  if (m.kind == ir::MotionKind::dwell) return m.feed > 0.0;
  return ir::is_move(m.kind) && (m.start != m.end || is_arc(m.kind) || (m.axes_unknown & m.axes_commanded) != 0);
}

// Whether the end of the first rapid lies on the straight way that both go.
bool only_stops(const ir::Motion& first, const ir::Motion& second) {
  if (first.kind != ir::MotionKind::rapid || second.kind != ir::MotionKind::rapid) return false;
  if (first.machine_coordinates || second.machine_coordinates || first.axes_unknown != 0 || second.axes_unknown != 0)
    return false;
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
      if (!matters(m)) continue;
      if (!out.empty() && only_stops(out.back().motion, m)) {
        m.start = out.back().motion.start;
        out.pop_back();
      }
      out.push_back({line, m});
    }
  }
  return out;
}

class Comparison {
 public:
  Comparison(const ir::Control& from, const ir::Control& to)
      : x_factor_(diameter(to) / diameter(from)),
        tolerance_mm_(1.1 * std::pow(10.0, -std::min(from.limits.linear_decimals, to.limits.linear_decimals))) {}

  // `of_cycle`: both are moves of a cycle that is said by another cycle.
  [[nodiscard]] bool same(const ir::Motion& a, const ir::Motion& b, bool of_cycle) const {
    if (a.kind == ir::MotionKind::dwell) return b.kind == a.kind && alike(a.feed, b.feed);
    const bool chord = a.kind == ir::MotionKind::spline && b.kind == ir::MotionKind::linear;
    if (a.kind != b.kind && !chord && !(of_cycle && may_stand_for(a.kind, b.kind))) return false;
    if (a.machine_coordinates != b.machine_coordinates || a.comp != b.comp || a.coolant != b.coolant) return false;
    if (!same_end(a, b)) return false;
    if (a.kind != b.kind && !chord) return true;
    const bool has_center = is_arc(a.kind) || a.kind == ir::MotionKind::thread;
    if (has_center && !std::ranges::equal(a.center, b.center, [&](double x, double y) { return near(x, y); }))
      return false;
    const bool same_speed = alike(a.spindle_rpm, b.spindle_rpm) && alike(a.surface_speed_m_min, b.surface_speed_m_min);
    if (a.spindle != b.spindle || !same_speed) return false;
    return a.kind == ir::MotionKind::rapid || (alike(a.feed, b.feed) && a.feed_mode == b.feed_mode);
  }

  // Both are moves of one tap.
  [[nodiscard]] bool same_of_tap(const ir::Motion& a, const ir::Motion& b) const {
    using enum ir::MotionKind;
    const bool cut = a.kind == linear || a.kind == thread;
    if (!cut) {
      const bool same_kind = a.kind == b.kind && (a.kind == rapid || a.kind == dwell);
      return same_kind && (a.kind == dwell ? alike(a.feed, b.feed) : a.comp == b.comp && same_end(a, b));
    }
    if ((b.kind != linear && b.kind != thread) || a.comp != b.comp || a.coolant != b.coolant || !same_end(a, b))
      return false;
    const bool floats = a.kind == linear && b.kind == linear;
    const double lead = lead_mm(a);
    return alike(a.spindle_rpm, b.spindle_rpm) && (!floats || a.spindle == b.spindle) &&
           std::abs(lead - lead_mm(b)) <= kLeadShare * std::abs(lead);
  }

 private:
  static constexpr double kLeadShare = 2e-4;  // a lead has four decimals
  static double lead_mm(const ir::Motion& m) {
    const bool by_time = m.kind == ir::MotionKind::linear && m.feed_mode == ir::FeedMode::per_min;
    return by_time ? m.feed / m.spindle_rpm : m.feed;
  }
  static double diameter(const ir::Control& c) {
    return c.semantics.power_on_diameter == ir::DiameterMode::radius ? 1.0 : 2.0;
  }
  // A tap and its thread; the way back between two pecks.
  static bool may_stand_for(ir::MotionKind a, ir::MotionKind b) {
    using enum ir::MotionKind;
    return (a == linear && (b == thread || b == rapid)) || (b == linear && (a == thread || a == rapid));
  }
  [[nodiscard]] bool same_end(const ir::Motion& a, const ir::Motion& b) const {
    const std::uint16_t unknown = a.axes_unknown | b.axes_unknown;
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
      const bool named = ((a.axes_commanded | b.axes_commanded) & (1U << axis)) != 0;
      if (!named && (unknown & (1U << axis)) != 0) continue;
      if (!near(axis == 0 ? a.end[axis] * x_factor_ : a.end[axis], b.end[axis])) return false;
    }
    return true;
  }
  [[nodiscard]] bool near(double a, double b) const { return std::abs(a - b) <= tolerance_mm_; }
  static bool alike(double a, double b) { return std::abs(a - b) <= 1e-3 * std::max(std::abs(a), std::abs(b)); }

  double x_factor_;
  double tolerance_mm_;
};

}  // namespace

std::vector<text::Diagnostic> MovesInPlace::compare(const ir::Program& translation,
                                                    const std::vector<std::uint32_t>& origin_lines) const {
  if (owners_.empty() && !as_read_) return {};
  for (std::size_t setting = 0; setting < runs_.size(); ++setting) {
    const std::optional<std::uint32_t> line = first_difference(translation, origin_lines, setting);
    if (!line) continue;
    const auto span = spans_.find(*line);
    const std::string_view what = owners_.empty() ? "what moves here in a program with ISO mode"
                                                  : "what moves here beside statements that are written as their moves";
    return {text::make_diagnostic(text::DiagnosticId::cannot_translate,
                                  span == spans_.end() ? text::Span{} : span->second, {std::string(what), to_.title})};
  }
  return {};
}

std::optional<std::uint32_t> MovesInPlace::first_difference(const ir::Program& translation,
                                                            const std::vector<std::uint32_t>& origin_lines,
                                                            std::size_t setting) const {
  ProgramLibrary standard(to_, [](std::string_view) { return std::nullopt; });
  interpreter::RunOptions options;
  options.limits = kRunLimits;
  options.skip_switches = settings_[setting];
  const RecordedRun run = record(translation, to_, standard, options, {}, {});
  const auto wanted = moves_of(runs_[setting], [](std::uint32_t line) { return line; });
  const auto made = moves_of(
      run, [&](std::uint32_t line) { return line == 0 || line > origin_lines.size() ? 0 : origin_lines[line - 1]; });
  const Comparison comparison(from_, to_);
  const auto tap_line = [&](std::uint32_t line) {
    const auto at = tap_lines_.find(line);
    return at == tap_lines_.end() ? 0U : at->second;
  };
  const std::size_t shorter = std::min(wanted.size(), made.size());
  for (std::size_t i = 0; i < shorter; ++i) {
    const std::uint32_t tap = tap_line(wanted[i].line);
    if (tap != 0 && tap == tap_line(made[i].line)) {
      if (!comparison.same_of_tap(wanted[i].motion, made[i].motion)) return wanted[i].line;
      continue;
    }
    const bool of_cycle = cycles_.contains(wanted[i].line) && made[i].line == wanted[i].line;
    if (!comparison.same(wanted[i].motion, made[i].motion, of_cycle)) return wanted[i].line;
  }
  if (wanted.size() != made.size()) return wanted.size() > shorter ? wanted[shorter].line : made[shorter].line;
  if (run.is_whole && run.result.ended == interpreter::Ended::end) return std::nullopt;
  return owners_.empty() ? wanted.empty() ? 1 : wanted.back().line : owners_.front();
}

}  // namespace dripfeed::compile
