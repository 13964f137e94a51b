// CYCLE81(RTP, RFP, SDIS, DP, DPR, …): which side SDIS lies on follows from RTP and RFP, so that these must be numbers
// where there is a clearance. Pecks that grow less, dwells in turns and the like are told.
#include "dialects/macro_b/writer/called_hole.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace dripfeed::macro_b {

namespace {

using ir::DrillCycle;
using ir::ExpressionId;
using ir::Operator;

constexpr std::size_t kNowhere = 99;
constexpr double kNotGiven = 1e29;  // a default of the cycles' own texts

constexpr std::string_view kFloating = "CYCLE840";

// Which modal cycle a called one is, and where DTB stands.
struct CycleRow {
  std::string_view name;
  DrillCycle cycle;
  std::size_t dwell;
  std::size_t spindle = 0;  // where SDIR stands, 0: it has none
};
constexpr auto kCycles = std::to_array<CycleRow>({
    {"CYCLE81", DrillCycle::drill, 5},
    {"CYCLE82", DrillCycle::drill_dwell, 5},
    {"CYCLE83", DrillCycle::deep_hole, 8},
    {"CYCLE84", DrillCycle::tap_right, 5},
    {"CYCLE85", DrillCycle::feed_out, 5},
    {"CYCLE86", DrillCycle::stop_out, 5, 6},
    {"CYCLE87", DrillCycle::manual_out, kNowhere, 5},
    {"CYCLE88", DrillCycle::manual_out, 5, 6},
    {"CYCLE89", DrillCycle::feed_out_dwell, 5},
    {kFloating, DrillCycle::tap_right, 5},
});
class HoleReader {
 public:
  HoleReader(ir::Program& program, const ir::Call& call) : program_(program), name_(program.strings.at(call.name)) {
    arguments_.assign(program.arguments_of(call).begin(), program.arguments_of(call).end());
  }

  std::expected<Hole, std::string> read() {
    const auto* const row = std::ranges::find(kCycles, name_, &CycleRow::name);
    if (row == kCycles.end()) return std::unexpected(name_.empty() ? std::string("a modal call") : name_);
    Hole hole{.name = name_, .cycle = row->cycle};
    std::string fault = levels(hole);
    if (fault.empty()) fault = details(hole, row->dwell);
    if (fault.empty() && row->spindle != 0) fault = spindle(hole, row->spindle);
    if (fault.empty() && hole.cycle == DrillCycle::tap_right) fault = name_ == kFloating ? floating(hole) : tap(hole);
    if (!fault.empty()) return std::unexpected(name_ + fault);
    return hole;
  }

 private:
  // Each gives what cannot be said, empty for nothing.
  std::string levels(Hole& hole) {
    hole.back = argument(0);
    const ExpressionId reference = argument(1);
    if (hole.back == ExpressionId::none || reference == ExpressionId::none)
      return " without its retraction or reference plane";
    const std::optional<double> top = number(hole.back);
    const std::optional<double> surface = number(reference);
    const std::optional<double> clearance = number_at(2, 0.0);
    const double side = top && surface && *top < *surface ? -1.0 : 1.0;
    const bool side_matters = !clearance || *clearance != 0.0;
    if (side_matters && (!top || !surface)) return ", whose planes are computed: which side its clearance is on";
    if (!clearance) return " with a computed clearance";
    hole.level = surface ? constant(*surface + side * *clearance) : reference;
    if (!set_depth(hole, reference, side)) return " without a depth that is known";
    hole.constant = top && surface && number(hole.depth);
    return {};
  }

  bool set_depth(Hole& hole, ExpressionId reference, double side) {
    hole.depth = argument(3);
    if (hole.depth != ExpressionId::none) return true;
    const std::optional<double> relative = number(argument(4));
    const std::optional<double> surface = number(reference);
    if (!relative || !surface) return false;
    hole.depth = constant(*surface - side * std::abs(*relative));
    return true;
  }

  std::string details(Hole& hole, std::size_t dwell_place) {
    const std::optional<double> dwell = number_at(dwell_place, 0.0);
    if (!dwell || *dwell < 0.0) return " with a dwell in turns or a computed one";
    hole.dwell_s = *dwell;
    if (hole.cycle == DrillCycle::drill && hole.dwell_s != 0.0) hole.cycle = DrillCycle::drill_dwell;
    if (hole.cycle == DrillCycle::feed_out) {
      const std::optional<double> in = number_at(6, 0.0);
      const std::optional<double> out = number_at(7, 0.0);
      if (!in || !out) return " with a computed feed";
      hole.feed_in = *in;
      hole.feed_out = *out;
    }
    return hole.cycle == DrillCycle::deep_hole ? set_pecks(hole) : std::string();
  }

  // CYCLE86(…, SDIR, RPA, RPO, RPAP, POSS).
  std::string spindle(Hole& hole, std::size_t place) {
    const std::optional<double> direction = number_at(place, 0.0);
    if (!direction || (*direction != 3.0 && *direction != 4.0)) return " without the direction of its spindle";
    hole.spindle = static_cast<int>(*direction);
    hole.holds = hole.cycle == DrillCycle::manual_out;
    hole.orients = hole.cycle == DrillCycle::stop_out;
    if (!hole.orients) return {};
    const std::optional<double> first = number_at(place + 1, 0.0);
    const std::optional<double> second = number_at(place + 2, 0.0);
    const std::optional<double> lift = number_at(place + 3, 0.0);
    if (!first || !second || !lift) return " with a computed shift";
    if (number_at(place + 4, 0.0) != 0.0) return " with an angle of its spindle";
    hole.shift_first = *first;
    hole.shift_second = *second;
    hole.lift = *lift;
    return {};
  }

  // CYCLE84(…, SDAC, MPIT, PIT, POSS, SST, SST1, …): one way in and out, at one speed.
  std::string tap(Hole& hole) {
    const std::optional<double> after = number_at(6, 0.0);
    const std::optional<double> nominal = number_at(7, 0.0);
    const std::optional<double> lead = number_at(8, 0.0);
    const std::optional<double> angle = number_at(9, 0.0);
    const std::optional<double> speed = number_at(10, 0.0);
    const std::optional<double> out = number_at(11, 0.0);
    if (!after || !nominal || !lead || !angle || !speed || !out) return " with computed values of its thread";
    if (*nominal != 0.0 || *lead == 0.0) return " without the lead of its thread (PIT)";
    if (*angle != 0.0) return " with an angle of its spindle";
    if (*speed <= 0.0 || (*out != 0.0 && *out != *speed)) return " without one speed in and out";
    if (has_own_axis(12) || has_more_than(13)) return " with pecks, an axis or a unit of its own";
    hole.cycle = *lead < 0.0 ? DrillCycle::tap_left : DrillCycle::tap_right;
    hole.lead = std::abs(*lead);
    hole.speed = *speed;
    hole.after = *after == 3.0 || *after == 4.0 ? static_cast<int>(*after) : 5;  // otherwise it stands
    return {};
  }

  // CYCLE840(…, DTB, SDR, SDAC, ENC, MPIT, PIT, …): by the lead (ENC 0, 20), or at the feed in effect (ENC 1). Without
  // a dwell where the encoder is used.
  std::string floating(Hole& hole) {
    const std::optional<double> reversed = number_at(6, 0.0);
    const std::optional<double> after = number_at(7, 0.0);
    const std::optional<double> encoder = number_at(8, 0.0);
    const std::optional<double> nominal = number_at(9, 0.0);
    const std::optional<double> lead = number_at(10, 0.0);
    if (!reversed || !after || !encoder || !nominal || !lead) return " with computed values of its thread";
    if (*after != 3.0 && *after != 4.0 && *after != 5.0) return " without what its spindle does after it (SDAC)";
    if (*reversed != 0.0 && *reversed != 3.0 && *reversed != 4.0) return " with that direction of its spindle (SDR)";
    const bool by_lead = *encoder != 1.0;
    if (by_lead && (*nominal != 0.0 || *lead == 0.0)) return " without the lead of its thread (PIT)";
    if (has_own_axis(11) || has_more_than(12)) return " with an axis or a unit of its own";
    if (*encoder == 0.0) hole.dwell_s = 0.0;
    hole.floats = true;
    hole.lead = by_lead ? std::abs(*lead) : 0.0;
    hole.reversed = static_cast<int>(*reversed);
    hole.after = static_cast<int>(*after);
    return {};
  }

  // Equal pecks only: FDEP or FDPR is each of them, DAM takes nothing off.
  std::string set_pecks(Hole& hole) {
    const std::optional<double> first = number_at(5, kNotGiven);
    const std::optional<double> each = number_at(6, 0.0);
    const std::optional<double> less = number_at(7, 0.0);
    const std::optional<double> kind = number_at(11, 0.0);
    const std::optional<double> last = number_at(15, 0.0);
    const std::optional<double> surface = number(argument(1));
    if (!first || !each || !less || !kind || !last || !surface) return " with computed pecks";
    if (has_own_axis(12)) return " with an axis of its own (AXN)";
    if (*less != 0.0 || hole.dwell_s != 0.0 || number_at(10, 1.0).value_or(0.0) != 1.0)
      return " with pecks that grow less, dwells or feeds of their own";
    hole.peck = *first < kNotGiven ? std::abs(*surface - *first) : std::abs(*each);
    if (hole.peck <= 0.0) return " without a depth of its pecks";
    hole.breaks_chips = *kind == 0.0;
    hole.pecks_below_level = number_at(2, 0.0) != 0.0;
    hole.dwell_s = *last;
    return {};
  }

  // AXN: another one than that which stands on the plane.
  [[nodiscard]] bool has_own_axis(std::size_t place) const {
    const std::optional<double> axis = number_at(place, 0.0);
    return axis != 0.0 && axis != 3.0;
  }
  // Something from `place` on that is not 0.
  [[nodiscard]] bool has_more_than(std::size_t place) const {
    for (; place < arguments_.size(); ++place)
      if (number_at(place, 0.0) != 0.0) return true;
    return false;
  }
  [[nodiscard]] ExpressionId argument(std::size_t place) const {
    return place < arguments_.size() ? arguments_[place].value : ExpressionId::none;
  }
  [[nodiscard]] std::optional<double> number(ExpressionId id) const { return constant_value(program_, id); }
  // Of an argument that is left out: `otherwise`.
  [[nodiscard]] std::optional<double> number_at(std::size_t place, double otherwise) const {
    return argument(place) == ExpressionId::none ? otherwise : number(argument(place));
  }
  ExpressionId constant(double value) { return program_.add_constant(value, {}, true); }

  ir::Program& program_;
  std::string name_;
  std::vector<ir::Argument> arguments_;
};

}  // namespace

bool is_drilling_cycle(std::string_view name) {
  return std::ranges::find(kCycles, name, &CycleRow::name) != kCycles.end();
}

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
