// Both runs are walked side by side, from the first motion of the line on.
#include "dialects/compile/restart/restart_proof.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/interpreter/machine/trace.h"

namespace dripfeed::compile {

namespace {

using ir::Motion;
using ir::MotionKind;

constexpr double kSame = 1e-9;  // of what is written with all its digits
constexpr double kSameFeed = 1e-3;
constexpr std::uint16_t bit(std::size_t axis) { return static_cast<std::uint16_t>(1U << axis); }
bool cuts(const Motion& m) { return ir::is_move(m.kind) && m.kind != MotionKind::rapid; }
bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance + kSame; }

class Comparison {
 public:
  explicit Comparison(const RestartProof& of)
      : of_(of), free_(of.begins_with_tool ? interpreter::kAllAxes : std::uint16_t{0}) {}

  std::string run(std::size_t& moves) {
    const auto& whole = of_.whole.motions;
    const auto& rest = of_.rest.motions;
    std::size_t a = of_.whole.first_motion(of_.whole.point->ordinal);
    std::size_t b = of_.rest.first_motion(of_.rest.point->ordinal);
    moves = 0;
    for (; a < whole.size() && b < rest.size(); ++a, ++b) {
      if (const std::string_view what = differs(whole[a], rest[b]); !what.empty())
        return fmt::format("line {}{} differs in {}", whole[a].place.line,
                           whole[a].place.program == 0 ? "" : " of a called program", what);
      if (ir::is_move(whole[a].kind)) ++moves;
    }
    if (a < whole.size()) return fmt::format("it ends before line {}", whole[a].place.line);
    if (b < rest.size()) return "it does not end where the program ends";
    return of_.whole.result.ended == of_.rest.result.ended ? "" : "it ends differently";
  }

 private:
  std::string_view differs(const Motion& a, const Motion& b) {
    if (a.kind != b.kind) return "the kind of move";
    if (!same_place(a.place, b.place)) return "the order of lines";
    if (a.number != b.number || !same_text(a, b)) return "a tool, an offset or a message";
    if (a.kind == MotionKind::dwell) return near(a.feed, b.feed, kSame) ? "" : "a dwell";
    if (a.kind == MotionKind::tool) return a.tool_offset == b.tool_offset ? "" : "the offset of the tool";
    if (!ir::is_move(a.kind)) return "";
    if (const std::string_view what = differs_in_modes(a, b); !what.empty()) return what;
    return differs_in_axes(a, b);
  }

  [[nodiscard]] bool same_place(const ir::Place& a, const ir::Place& b) const {
    if ((a.program == 0) != (b.program == 0)) return false;
    if (a.program == 0) return a.line - of_.whole_line == b.line - of_.rest_line;
    return a.line == b.line && of_.whole.names.programs[a.program] == of_.rest.names.programs[b.program];
  }

  [[nodiscard]] bool same_text(const Motion& a, const Motion& b) const {
    const auto text = [](const RestartRun& run, std::uint32_t index) {
      return index < run.names.strings.size() ? std::string_view(run.names.strings[index]) : std::string_view();
    };
    return text(of_.whole, a.text) == text(of_.rest, b.text);
  }

  [[nodiscard]] std::string_view differs_in_modes(const Motion& a, const Motion& b) const {
    if (a.plane != b.plane && (is_arc(a.kind) || a.comp != ir::CompSide::off)) return "the plane";
    if (a.comp != b.comp || a.tool_offset != b.tool_offset) return "the compensation";
    if (a.machine_coordinates != b.machine_coordinates) return "the coordinate system";
    if (a.exact_stop != b.exact_stop) return "the exact stop";
    if (cuts(a) && (a.feed_mode != b.feed_mode || !near(a.feed, b.feed, kSameFeed))) return "the feed";
    const bool loose = of_.begins_with_tool && !cuts(a);
    if (loose) return "";
    if (a.spindle != b.spindle || !near(a.spindle_rpm, b.spindle_rpm, kSameFeed) ||
        !near(a.surface_speed_m_min, b.surface_speed_m_min, kSameFeed))
      return "the spindle";
    if (a.coolant != b.coolant) return "the coolant";
    // A length acts in moves of the tool axis: one that stands at its reference point is not moved by it.
    constexpr std::uint16_t kToolAxis = bit(2);
    const bool acts = cuts(a) || (a.axes_commanded & kToolAxis) != 0;
    if (acts && (a.length_offset != b.length_offset || a.length_offset_number != b.length_offset_number))
      return "the length offset";
    return "";
  }

  std::string_view differs_in_axes(const Motion& a, const Motion& b) {
    if (a.axes_commanded != b.axes_commanded) return "the axes";
    const double tolerance = 2.0 * of_.rounding;
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
      const bool named = (a.axes_commanded & bit(axis)) != 0;
      const bool known = (a.axes_unknown & bit(axis)) == 0;
      const bool known_there = (b.axes_unknown & bit(axis)) == 0;
      const bool end_known = known || (named && (a.gaps & ir::kEndUnknown) == 0);
      const bool end_known_there = known_there || (named && (b.gaps & ir::kEndUnknown) == 0);
      if ((free_ & bit(axis)) != 0) {
        if (!named && !cuts(a)) continue;
        if (cuts(a) && known) return "where an axis stands that is not moved after the tool change";
        if (!named) continue;
        free_ &= static_cast<std::uint16_t>(~bit(axis));
      } else if (known && (!known_there || !near(a.start[axis], b.start[axis], tolerance))) {
        return "the start of a move";
      }
      if (end_known && (!end_known_there || !near(a.end[axis], b.end[axis], tolerance))) return "the end of a move";
    }
    if (!is_arc(a.kind)) return "";
    for (std::size_t i = 0; i < a.center.size(); ++i)
      if (!near(a.center[i], b.center[i], tolerance)) return "the centre of an arc";
    return "";
  }

  const RestartProof& of_;
  std::uint16_t free_;  // bit per axis: it stands elsewhere than in the whole program
};

}  // namespace

std::string RestartProof::difference(std::size_t& moves) const { return Comparison(*this).run(moves); }

}  // namespace dripfeed::compile
