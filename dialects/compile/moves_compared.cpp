// The translation is run, too: what was put in place of a statement, and what the blocks behind it make of it, must be
// the source's moves. Blocks that drill or turn by a cycle of both controls are not looked at: these may differ in
// where a rapid stops on its way.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "dialects/compile/motion_codes.h"
#include "dialects/compile/moves_in_place.h"

namespace dripfeed::compile {

namespace {

struct PlacedMove {
  std::uint32_t line = 0;  // of the source
  ir::Motion motion;
};

// Dwells, and moves that lead somewhere.
bool matters(const ir::Motion& m) {
  if (m.kind == ir::MotionKind::dwell) return true;
  return ir::is_move(m.kind) && (m.start != m.end || is_arc(m.kind) || (m.axes_unknown & m.axes_commanded) != 0);
}

// `origin_of`: the source's line for a line of the run.
template <class Origin>
std::vector<PlacedMove> moves_of(const RecordedRun& run, const std::vector<std::uint32_t>& lines, Origin&& origin_of) {
  std::vector<PlacedMove> out;
  for (const Visit& visit : run.visits) {
    const std::uint32_t line = origin_of(visit.line);
    if (!std::ranges::binary_search(lines, line)) continue;
    for (const ir::Motion& m : run.motions_of(visit))
      if (matters(m)) out.push_back({line, m});
  }
  return out;
}

class Comparison {
 public:
  Comparison(const ir::Control& from, const ir::Control& to)
      : x_factor_(diameter(to) / diameter(from)),
        tolerance_mm_(1.1 * std::pow(10.0, -std::min(from.limits.linear_decimals, to.limits.linear_decimals))) {}

  [[nodiscard]] bool same(const ir::Motion& a, const ir::Motion& b) const {
    if (a.kind == ir::MotionKind::dwell) return b.kind == a.kind && alike(a.feed, b.feed);
    if (a.kind != b.kind || a.machine_coordinates != b.machine_coordinates || a.comp != b.comp) return false;
    const std::uint16_t unknown = a.axes_unknown | b.axes_unknown;
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
      const bool named = ((a.axes_commanded | b.axes_commanded) & (1U << axis)) != 0;
      if (!named && (unknown & (1U << axis)) != 0) continue;
      const double end = axis == 0 ? a.end[axis] * x_factor_ : a.end[axis];
      if (!near(end, b.end[axis])) return false;
    }
    const bool has_center = is_arc(a.kind) || a.kind == ir::MotionKind::thread;
    if (has_center && !std::ranges::equal(a.center, b.center, [&](double x, double y) { return near(x, y); }))
      return false;
    const bool same_speed = alike(a.spindle_rpm, b.spindle_rpm) && alike(a.surface_speed_m_min, b.surface_speed_m_min);
    if (a.spindle != b.spindle || a.coolant != b.coolant || !same_speed) return false;
    return a.kind == ir::MotionKind::rapid || (alike(a.feed, b.feed) && a.feed_mode == b.feed_mode);
  }

 private:
  static double diameter(const ir::Control& c) {
    return c.semantics.power_on_diameter == ir::DiameterMode::radius ? 1.0 : 2.0;
  }
  [[nodiscard]] bool near(double a, double b) const { return std::abs(a - b) <= tolerance_mm_; }
  static bool alike(double a, double b) { return std::abs(a - b) <= 1e-3 * std::max(std::abs(a), std::abs(b)); }

  double x_factor_;
  double tolerance_mm_;
};

}  // namespace

std::vector<text::Diagnostic> MovesInPlace::compare(const ir::Program& translation,
                                                    const std::vector<std::uint32_t>& origin_lines) const {
  if (compared_.empty()) return {};
  for (std::size_t setting = 0; setting < runs_.size(); ++setting) {
    const std::optional<std::uint32_t> line = first_difference(translation, origin_lines, setting);
    if (!line) continue;
    const auto at = std::ranges::lower_bound(compared_, *line) - compared_.begin();
    return {text::make_diagnostic(text::DiagnosticId::cannot_translate, compared_spans_[static_cast<std::size_t>(at)],
                                  {"what moves here beside statements that are written as their moves", to_.title})};
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
  const auto wanted = moves_of(runs_[setting], compared_, [](std::uint32_t line) { return line; });
  const auto made = moves_of(run, compared_, [&](std::uint32_t line) {
    return line == 0 || line > origin_lines.size() ? 0 : origin_lines[line - 1];
  });
  const Comparison comparison(from_, to_);
  const std::size_t shorter = std::min(wanted.size(), made.size());
  for (std::size_t i = 0; i < shorter; ++i)
    if (wanted[i].line != made[i].line || !comparison.same(wanted[i].motion, made[i].motion)) return wanted[i].line;
  if (wanted.size() != made.size()) return wanted.size() > shorter ? wanted[shorter].line : made[shorter].line;
  if (run.is_whole && run.result.ended == interpreter::Ended::end) return std::nullopt;
  return compared_.back();
}

}  // namespace dripfeed::compile
