// CYCLE81(RTP, RFP, SDIS, DP, DPR, …): which side SDIS lies on follows from RTP and RFP, so that these must be numbers
// where there is a clearance. Pecks that grow less, dwells in turns and the like are reported.
#include "dialects/macro_b/writer/called_hole.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "dialects/ir/called_cycle.h"

namespace dripfeed::macro_b {

namespace {

using ir::CycleValue;
using ir::DrillCycle;
using ir::ExpressionId;
using ir::Operator;

constexpr double kNotGiven = 1e29;  // no level that a program has

class HoleReader {
 public:
  HoleReader(ir::Program& program, const ir::Call& call)
      : program_(program), call_(call), name_(program.strings.at(call.name)) {}

  std::expected<Hole, std::string> read() {
    if (!is_drilling_cycle(call_)) return std::unexpected(name_.empty() ? std::string("a modal call") : name_);
    Hole hole{.name = name_, .cycle = call_.cycle->hole, .floats = call_.cycle->floats};
    std::string fault = screen();
    if (fault.empty()) fault = levels(hole);
    if (fault.empty()) fault = details(hole);
    if (fault.empty() && has(CycleValue::spindle)) fault = spindle(hole);
    if (fault.empty() && hole.cycle == DrillCycle::tap_right) fault = hole.floats ? floating(hole) : tap(hole);
    if (!fault.empty()) return std::unexpected(name_ + fault);
    return hole;
  }

 private:
  // Each gives what cannot be written, empty for nothing.

  // What the operator's screen states of the values (PGA, "Programming cycles externally").
  std::string screen() {
    const std::optional<double> geometry = number_or(CycleValue::screen_geometry, 0.0);
    const std::optional<double> plane = number_or(CycleValue::screen_plane, 0.0);
    const std::optional<double> kinds = number_or(CycleValue::screen_kinds, 0.0);
    if (!geometry || !plane || !kinds) return " with computed modes of its screen";
    kinds_ = static_cast<std::uint32_t>(std::abs(*kinds));
    if (digit(static_cast<std::uint32_t>(std::abs(*geometry)), kTens) == 1)
      return " with a depth to the shank of its tool, or by a diameter";
    // G17 is what a mill has; whether the program has it, the verification by running sees.
    return digit(static_cast<std::uint32_t>(std::abs(*plane)), 1) > 1 ? " in a plane of its own" : "";
  }

  std::string levels(Hole& hole) {
    hole.back = value(CycleValue::return_level);
    const ExpressionId reference = value(CycleValue::surface);
    if (hole.back == ExpressionId::none || reference == ExpressionId::none)
      return " without its retraction or reference plane";
    const std::optional<double> top = number(hole.back);
    const std::optional<double> surface = number(reference);
    const std::optional<double> clearance = number_or(CycleValue::clearance, 0.0);
    const double side = top && surface && *top < *surface ? -1.0 : 1.0;
    const bool side_matters = !clearance || *clearance != 0.0;
    if (side_matters && (!top || !surface)) return ", whose planes are computed: which side its clearance is on";
    if (!clearance) return " with a computed clearance";
    hole.level = surface ? constant(*surface + side * *clearance) : reference;
    if (!set_depth(hole, reference, side)) return " without a depth that is known";
    hole.constant = top && surface && number(hole.depth);
    return {};
  }

  // A depth below the surface goes before one in coordinates.
  bool set_depth(Hole& hole, ExpressionId reference, double side) {
    const std::optional<double> relative = number_or(CycleValue::depth_below_surface, 0.0);
    if (!relative) return false;
    if (*relative == 0.0) {
      hole.depth = value(CycleValue::depth);
      return hole.depth != ExpressionId::none;
    }
    const std::optional<double> surface = number(reference);
    if (!surface) return false;
    hole.depth = constant(*surface - side * std::abs(*relative));
    return true;
  }

  std::string details(Hole& hole) {
    const std::optional<double> dwell = number_or(CycleValue::dwell, 0.0);
    const bool in_turns = dwell && *dwell != 0.0 && digit(kinds_, kTens) == kTurns;
    if (!dwell || *dwell < 0.0 || in_turns) return " with a dwell in turns or a computed one";
    hole.dwell_s = *dwell;
    if (hole.cycle == DrillCycle::drill && hole.dwell_s != 0.0) hole.cycle = DrillCycle::drill_dwell;
    if (hole.cycle == DrillCycle::feed_out) {
      const std::optional<double> in = number_or(CycleValue::feed_in, 0.0);
      const std::optional<double> out = number_or(CycleValue::feed_out, 0.0);
      if (!in || !out) return " with a computed feed";
      hole.feed_in = *in;
      hole.feed_out = *out;
    }
    return hole.cycle == DrillCycle::deep_hole ? set_pecks(hole) : std::string();
  }

  // CYCLE86(…, SDIR, RPA, RPO, RPAP, POSS).
  std::string spindle(Hole& hole) {
    const std::optional<double> direction = number_or(CycleValue::spindle, 0.0);
    if (!direction || (*direction != 3.0 && *direction != 4.0)) return " without the direction of its spindle";
    hole.spindle = static_cast<int>(*direction);
    hole.holds = hole.cycle == DrillCycle::manual_out;
    hole.orients = hole.cycle == DrillCycle::stop_out;
    if (!hole.orients) return {};
    const std::optional<double> first = number_or(CycleValue::shift_first, 0.0);
    const std::optional<double> second = number_or(CycleValue::shift_second, 0.0);
    const std::optional<double> lift = number_or(CycleValue::lift, 0.0);
    if (!first || !second || !lift) return " with a computed shift";
    if (number_or(CycleValue::spindle_angle, 0.0) != 0.0) return " with an angle of its spindle";
    hole.shift_first = *first;
    hole.shift_second = *second;
    hole.lift = *lift;
    return {};
  }

  // CYCLE84(…, SDAC, MPIT, PIT, POSS, SST, SST1, …): in and out at one speed.
  std::string tap(Hole& hole) {
    const std::optional<double> after = number_or(CycleValue::spindle_after, 0.0);
    const std::optional<double> nominal = number_or(CycleValue::thread_size, 0.0);
    const std::optional<double> lead = number_or(CycleValue::lead, 0.0);
    const std::optional<double> angle = number_or(CycleValue::spindle_angle, 0.0);
    const std::optional<double> speed = number_or(CycleValue::speed, 0.0);
    const std::optional<double> out = number_or(CycleValue::speed_back, 0.0);
    if (!after || !nominal || !lead || !angle || !speed || !out) return " with computed values of its thread";
    if (*nominal != 0.0 || *lead == 0.0) return " without the lead of its thread (PIT)";
    if (*angle != 0.0) return " with an angle of its spindle";
    if (*speed <= 0.0 || (*out != 0.0 && *out != *speed)) return " without one speed in and out";
    if (has_own_axis() || has_more()) return " with pecks, an axis or a unit of its own";
    hole.cycle = *lead < 0.0 ? DrillCycle::tap_left : DrillCycle::tap_right;
    hole.lead = std::abs(*lead);
    hole.speed = *speed;
    hole.after = *after == 3.0 || *after == 4.0 ? static_cast<int>(*after) : 5;  // otherwise it stands
    return {};
  }

  // CYCLE840(…, DTB, SDR, SDAC, ENC, MPIT, PIT, …): by the lead (ENC 0, 20), or at the feed in effect (ENC 1). Without
  // a dwell where the encoder is used.
  std::string floating(Hole& hole) {
    const std::optional<double> reversed = number_or(CycleValue::spindle_back, 0.0);
    const std::optional<double> after = number_or(CycleValue::spindle_after, 0.0);
    const std::optional<double> encoder = number_or(CycleValue::encoder, 0.0);
    const std::optional<double> nominal = number_or(CycleValue::thread_size, 0.0);
    const std::optional<double> lead = number_or(CycleValue::lead, 0.0);
    if (!reversed || !after || !encoder || !nominal || !lead) return " with computed values of its thread";
    if (*after != 3.0 && *after != 4.0 && *after != 5.0) return " without what its spindle does after it (SDAC)";
    if (*reversed != 0.0 && *reversed != 3.0 && *reversed != 4.0) return " with that direction of its spindle (SDR)";
    const bool by_lead = *encoder != 1.0;
    if (by_lead && (*nominal != 0.0 || *lead == 0.0)) return " without the lead of its thread (PIT)";
    if (has_own_axis() || has_more()) return " with an axis or a unit of its own";
    if (*encoder == 0.0) hole.dwell_s = 0.0;
    hole.lead = by_lead ? std::abs(*lead) : 0.0;
    hole.reversed = static_cast<int>(*reversed);
    hole.after = static_cast<int>(*after);
    return {};
  }

  // Equal pecks only: FDEP or FDPR is each of them, DAM takes nothing off.
  std::string set_pecks(Hole& hole) {
    const std::optional<double> first = number_or(CycleValue::first_peck_level, kNotGiven);
    const std::optional<double> each = number_or(CycleValue::first_peck, 0.0);
    const std::optional<double> less = number_or(CycleValue::less_each_peck, 0.0);
    const std::optional<double> kind = number_or(CycleValue::removes_chips, 0.0);
    const std::optional<double> last = number_or(CycleValue::last_dwell, 0.0);
    const std::optional<double> surface = number(value(CycleValue::surface));
    if (!first || !each || !less || !kind || !last || !surface) return " with computed pecks";
    if (has_own_axis()) return " with an axis of its own (AXN)";
    if (!are_alike(*less) || hole.dwell_s != 0.0 || !has_one_feed())
      return " with pecks that grow less, dwells or feeds of their own";
    if (*last != 0.0 && digit(kinds_, kHundreds) == kTurns) return " with a dwell in turns or a computed one";
    hole.peck = *each != 0.0 ? std::abs(*each) : *first < kNotGiven ? std::abs(*surface - *first) : 0.0;
    if (hole.peck <= 0.0) return " without a depth of its pecks";
    hole.breaks_chips = *kind == 0.0;
    hole.pecks_below_level = number_or(CycleValue::clearance, 0.0) != 0.0;
    hole.dwell_s = *last;
    return {};
  }

  // DAM takes nothing off, or is the factor 1, by itself or in percent, without a shortest stroke.
  [[nodiscard]] bool are_alike(double less) const {
    if (less == 0.0) return true;
    const bool percent = digit(kinds_, kHundredThousands) == kPercent;
    const double factor = percent ? std::abs(less) / 100.0 : less < 0.0 ? -less : 0.0;
    return factor == 1.0 && number_or(CycleValue::least_peck, 0.0) == 0.0;
  }
  // FRF: left out, a factor of 1, or 100 percent.
  [[nodiscard]] bool has_one_feed() const {
    const std::optional<double> factor = number_or(CycleValue::first_peck_feed, 1.0);
    return factor && (*factor == 0.0 || *factor == 1.0 || (*factor == 100.0 && kinds_ > 0));
  }
  static constexpr std::uint32_t kTens = 10;
  static constexpr std::uint32_t kHundreds = 100;
  static constexpr std::uint32_t kHundredThousands = 100'000;
  static constexpr std::uint32_t kTurns = 2;
  static constexpr std::uint32_t kPercent = 2;
  static std::uint32_t digit(std::uint32_t modes, std::uint32_t place) { return modes / place % 10; }

  // AXN: another one than that which stands on the plane.
  [[nodiscard]] bool has_own_axis() const {
    const std::optional<double> axis = number_or(CycleValue::axis, 0.0);
    return axis != 0.0 && axis != 3.0;
  }
  // Something after it that is not 0.
  [[nodiscard]] bool has_more() const {
    return std::ranges::any_of(ir::arguments_after(program_, call_, CycleValue::axis), [&](const ir::Argument& a) {
      return a.value != ExpressionId::none && number(a.value) != 0.0;
    });
  }
  [[nodiscard]] bool has(CycleValue which) const { return ir::place_of(*call_.cycle, which) != ir::kNoPlace; }
  [[nodiscard]] ExpressionId value(CycleValue which) const { return ir::value_of(program_, call_, which); }
  [[nodiscard]] std::optional<double> number(ExpressionId id) const { return constant_value(program_, id); }
  // Of a value that is left out: `otherwise`.
  [[nodiscard]] std::optional<double> number_or(CycleValue which, double otherwise) const {
    const ExpressionId id = value(which);
    return id == ExpressionId::none ? otherwise : number(id);
  }
  ExpressionId constant(double value) { return program_.add_constant(value, {}, true); }

  ir::Program& program_;
  const ir::Call call_;  // a copy: the program grows
  std::string name_;
  std::uint32_t kinds_ = 0;  // AM
};

}  // namespace

bool is_drilling_cycle(const ir::Call& call) { return ir::is_called(call, ir::CalledSort::hole); }

std::optional<double> constant_value(const ir::Program& program, ExpressionId id) {
  if (id == ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program.at(id);
  if (e.op == Operator::constant) return e.value;
  if (e.op == Operator::negate && program.at(e.a).op == Operator::constant) return -program.at(e.a).value;
  return std::nullopt;
}

std::expected<Hole, std::string> called_hole(ir::Program& program, const ir::Call& call) {
  return HoleReader(program, call).read();
}

}  // namespace dripfeed::macro_b
