// A lathe's side is judged by where the tool retracts after its cuts, before the line and after it.
#include "dialects/compile/restart/restart_approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "dialects/interpreter/machine/trace.h"
#include "dialects/ir/axis_letters.h"

namespace dripfeed::compile {

namespace {

using interpreter::ModalState;
using ir::Function;
using ir::Motion;
using ir::MotionKind;
using text::DiagnosticId;

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr double kSame_mm = 1e-6;
constexpr std::uint16_t bit(std::size_t axis) { return static_cast<std::uint16_t>(1U << axis); }

bool cuts(const Motion& m) { return ir::is_move(m.kind) && m.kind != MotionKind::rapid; }
bool is_known(const Motion& m, std::size_t axis) { return (m.axes_unknown & bit(axis)) == 0; }
// In the work offset, and where it is known that the axis ends.
bool ends_at(const Motion& m, std::size_t axis) {
  if (m.machine_coordinates || !ir::is_move(m.kind)) return false;
  const bool commanded = (m.axes_commanded & bit(axis)) != 0;
  return commanded ? (m.gaps & ir::kEndUnknown) == 0 : is_known(m, axis);
}

class Approach {
 public:
  explicit Approach(RestartDraft& draft)
      : draft_(draft),
        state_(draft.point.state),
        words_(draft.words),
        at_(draft.run.first_motion(draft.point.ordinal)) {
    while (begin_ > 0 && !changes_tool(begin_ - 1)) --begin_;
    while (end_ < moves().size() && !changes_tool(end_)) ++end_;
  }

  std::optional<RestartRefusal> write() {
    if (begins_with_tool_change(draft_)) {
      draft_.assumptions.emplace_back(
          "The line begins with a tool change: its first rapid moves begin where the tool was taken clear.");
    } else {
      if (auto refused = look_at_unknown_axes()) return refused;
      if (auto refused = draft_.turns() ? lathe() : mill()) return refused;
    }
    restore_modes();
    return std::nullopt;
  }

 private:
  [[nodiscard]] const std::vector<Motion>& moves() const { return draft_.run.motions; }
  [[nodiscard]] bool known(std::size_t axis) const { return (state_.unknown & bit(axis)) == 0; }
  [[nodiscard]] bool has_axis(std::size_t axis) const {
    return draft_.control.axes.find(ir::kAxisLetters[axis]) != std::string::npos;
  }
  [[nodiscard]] std::string axis(std::size_t axis, double value) const { return words_.axis(axis, value); }
  [[nodiscard]] std::string axis(std::size_t axis) const { return words_.axis(axis, state_.position[axis]); }

  // T0101 and T0100 are one tool.
  [[nodiscard]] bool changes_tool(std::size_t i) const {
    const Motion& m = moves()[i];
    return m.kind == MotionKind::tool && (m.number != state_.tool.number || m.text != state_.tool.name || i < at_);
  }

  // The last move before the line, nullptr: there is none.
  [[nodiscard]] const Motion* last_move() const {
    for (std::size_t i = at_; i-- > 0;)
      if (ir::is_move(moves()[i].kind)) return &moves()[i];
    return nullptr;
  }
  [[nodiscard]] bool came_at_rapid() const {
    const Motion* last = last_move();
    return last == nullptr || last->kind == MotionKind::rapid;
  }

  // An axis that is not known here may stay so until the rest itself says where it goes, but not while something is
  // cut.
  std::optional<RestartRefusal> look_at_unknown_axes() {
    std::uint16_t used = 0;
    for (const Motion& m : moves())
      if (ir::is_move(m.kind)) used |= m.axes_commanded;
    auto open = static_cast<std::uint16_t>(state_.unknown & used);
    for (std::size_t i = at_; i < moves().size() && open != 0; ++i) {
      const Motion& m = moves()[i];
      if (!ir::is_move(m.kind)) continue;
      const auto stays = static_cast<std::uint16_t>(open & ~((m.gaps & ir::kEndUnknown) == 0 ? m.axes_commanded : 0));
      for (std::size_t one = 0; one < ir::kAxisCount; ++one)
        if (cuts(m) && (stays & bit(one)) != 0)
          return RestartRefusal{DiagnosticId::restart_unknown,
                                fmt::format("the position of {} is", ir::kAxisLetters[one])};
      open = stays;
    }
    return std::nullopt;
  }

  std::optional<RestartRefusal> feed_to(std::size_t one) {
    if (state_.feed_unknown || state_.feed <= 0.0) return RestartRefusal{DiagnosticId::restart_unknown, "the feed is"};
    draft_.add({words_.code(Function::linear), axis(one), words_.feed(state_.feed)});
    motion_ = Function::linear;
    return std::nullopt;
  }

  void rapid(const std::vector<std::string>& words) {
    if (words.empty()) return;
    std::vector<std::string> block{words_.code(Function::rapid)};
    block.insert(block.end(), words.begin(), words.end());
    draft_.add(block);
    motion_ = Function::rapid;
  }

  // --- mill

  // Where the tool was last at rapid with this tool, but not below the start.
  [[nodiscard]] double clear_level() const {
    const double least = state_.position[kZ] + draft_.clearance_mm;
    for (std::size_t i = at_; i-- > begin_;) {
      const Motion& m = moves()[i];
      if (m.kind == MotionKind::rapid && ends_at(m, kZ)) return std::max(m.end[kZ], least);
    }
    return least;
  }

  [[nodiscard]] std::string length() const {
    const ir::Semantics& s = draft_.control.semantics;
    const bool by_tool = s.d_selects_edge || s.tool_word == ir::ToolWord::number_and_offset;
    if (state_.length_offset == ir::LengthOffset::off || by_tool) return {};
    const bool plus = state_.length_offset == ir::LengthOffset::plus;
    return words_.code(plus ? Function::length_offset_plus : Function::length_offset_minus) + " " +
           words_.count('H', state_.length_offset_number);
  }

  std::optional<RestartRefusal> mill() {
    std::vector<std::string> in_plane;
    for (std::size_t one = 0; one < ir::kAxisCount; ++one)
      if (one != kZ && has_axis(one) && known(one)) in_plane.push_back(axis(one));
    const bool deep = has_axis(kZ) && known(kZ);
    if (deep && !(known(kX) && known(1)))
      return RestartRefusal{DiagnosticId::restart_unknown, fmt::format("the position of {} is", known(kX) ? 'Y' : 'X')};
    rapid(in_plane);
    if (!deep) return std::nullopt;
    const bool at_rapid = came_at_rapid();
    const double level = at_rapid ? state_.position[kZ] : clear_level();
    rapid({length(), axis(kZ, level)});
    draft_.assumptions.emplace_back(
        "Z comes down last: nothing stands above the place where the line begins, such as the wall of an undercut.");
    if (at_rapid || level - state_.position[kZ] < kSame_mm) return std::nullopt;
    return feed_to(kZ);
  }

  // --- lathe

  [[nodiscard]] bool only_turns() const {
    std::uint16_t used = 0;
    for (std::size_t i = begin_; i < end_; ++i)
      if (ir::is_move(moves()[i].kind)) used |= moves()[i].axes_commanded;
    return (used & ~(bit(kX) | bit(kZ))) == 0;
  }

  struct Extent {
    double outer = std::numeric_limits<double>::lowest();
    double front = std::numeric_limits<double>::lowest();
    double clear = std::numeric_limits<double>::lowest();  // X where the tool goes to after a cut
    bool any = false;
    bool cut = false;      // the last move but rapids in Z
    bool inwards = false;  // after a cut the tool goes to a smaller X
  };
  static void take_retract(const Motion& m, Extent& out) {
    if (!out.cut || m.machine_coordinates || !is_known(m, kX) || std::abs(m.end[kX] - m.start[kX]) < kSame_mm) return;
    out.cut = false;
    out.inwards |= m.end[kX] < m.start[kX];
    out.clear = std::max(out.clear, m.end[kX]);
  }

  // Of what this tool cuts, before the line and after it.
  [[nodiscard]] std::optional<Extent> extent() const {
    Extent out;
    for (std::size_t i = begin_; i < end_; ++i) {
      const Motion& m = moves()[i];
      if (!cuts(m)) {
        if (out.any && m.kind == MotionKind::rapid) take_retract(m, out);
        continue;
      }
      if (!ends_at(m, kX) || !ends_at(m, kZ) || !is_known(m, kX) || !is_known(m, kZ)) return std::nullopt;
      out.any = out.cut = true;
      out.outer = std::max({out.outer, m.start[kX], m.end[kX]});
      out.front = std::max({out.front, m.start[kZ], m.end[kZ]});
    }
    return out;
  }

  std::optional<RestartRefusal> lathe() {
    const bool x = known(kX);
    const bool z = known(kZ);
    if (!x && !z) return std::nullopt;
    const auto side = [](std::string_view why) {
      return RestartRefusal{DiagnosticId::restart_side_unknown, std::string(why)};
    };
    if (!x || !z) return side(fmt::format("the position of {} is not known", x ? "Z" : "X"));
    if (!only_turns()) return side("the tool moves other axes than X and Z");
    const std::optional<Extent> cut = extent();
    if (!cut) return side("where this tool cuts is not known");
    if (!cut->any) return side("this tool cuts nothing");
    const bool at_rapid = came_at_rapid();
    if (at_rapid && state_.position[kZ] >= cut->front - kSame_mm) return in_front();
    if (!cut->inwards && cut->clear >= cut->outer - kSame_mm) return outside(cut->clear, at_rapid);
    return side(
        "after its cuts the tool does not retract outwards, and it does not stand in front of all that it cuts");
  }

  std::optional<RestartRefusal> in_front() {
    rapid({axis(kX)});
    rapid({axis(kZ)});
    draft_.assumptions.emplace_back("X is moved first and then Z: the tool stands in front of all that it cuts.");
    return std::nullopt;
  }

  std::optional<RestartRefusal> outside(double clear, bool at_rapid) {
    const double here = state_.position[kX];
    rapid({axis(kZ)});
    draft_.assumptions.emplace_back("Z is moved first and then X: after its cuts the tool retracts outwards.");
    const double least = here + 2.0 * draft_.clearance_mm;
    rapid({axis(kX, at_rapid ? here : std::max(last_rapid_x(clear), least))});
    return at_rapid ? std::nullopt : feed_to(kX);
  }

  [[nodiscard]] double last_rapid_x(double otherwise) const {
    for (std::size_t i = at_; i-- > begin_;)
      if (moves()[i].kind == MotionKind::rapid && ends_at(moves()[i], kX)) return moves()[i].end[kX];
    return otherwise;
  }

  // --- what the line finds

  void restore_modes() {
    const interpreter::Modes& modes = state_.modes;
    std::vector<std::string> block;
    if (!draft_.turns() && modes.plane != ir::Plane::xy)
      block.push_back(words_.code(modes.plane == ir::Plane::zx ? Function::plane_zx : Function::plane_yz));
    if (modes.exact_stop) block.push_back(words_.code(Function::exact_stop_mode));
    if (modes.return_to_r && !draft_.turns()) block.push_back(words_.code(Function::return_to_r));
    if (!modes.absolute) block.push_back(words_.code(Function::incremental));
    const bool plain = modes.motion == Function::rapid || modes.motion == Function::linear;
    if (plain && modes.motion_given && modes.motion != motion_) block.push_back(words_.code(modes.motion));
    draft_.add(block);
  }

  RestartDraft& draft_;
  const ModalState& state_;
  const RestartWords& words_;
  std::size_t at_;           // first motion of the line
  std::size_t begin_ = at_;  // of the tool in use
  std::size_t end_ = at_;
  Function motion_ = Function::none;
};

}  // namespace

std::optional<RestartRefusal> write_approach(RestartDraft& draft) { return Approach(draft).write(); }

}  // namespace dripfeed::compile
