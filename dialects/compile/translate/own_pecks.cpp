// A value that is computed may be any.
#include "dialects/compile/translate/own_pecks.h"

#include <cmath>
#include <optional>

#include "dialects/ir/called_cycle.h"
#include "dialects/passes/round_positions.h"

namespace dripfeed::compile {

namespace {

using ir::CycleValue;

constexpr double kInch_mm = 25.4;
constexpr double kUsualRetract_mm = 1.0;  // where a cycle that breaks chips states none
constexpr double kPercent = 100.0;

class Pecks {
 public:
  Pecks(const ir::Program& program, const ir::Call& call, const ir::Control& to)
      : program_(program), call_(call), to_(to) {}

  [[nodiscard]] bool are_own() const {
    if (is_one_stroke()) return false;
    const bool differ = !is_0(CycleValue::dwell) || !is_0(CycleValue::first_dwell) || !is_0(CycleValue::clearance);
    return differ || grow_less() || !has_one_feed() || !is_entered_alike();
  }

 private:
  [[nodiscard]] bool is_one_stroke() const {
    const auto stroke = distance(CycleValue::first_peck, CycleValue::first_peck_level);
    const auto whole = distance(CycleValue::depth_below_surface, CycleValue::depth);
    return stroke && whole && *stroke > 0.0 && *stroke >= *whole;
  }
  // Below the surface: as it is stated, or by a level.
  [[nodiscard]] std::optional<double> distance(CycleValue stated, CycleValue level) const {
    const std::optional<double> given = number(stated);
    if (!given) return std::nullopt;
    if (*given != 0.0) return std::abs(*given);
    const std::optional<double> surface = number(CycleValue::surface);
    if (!surface || value(level) == ir::ExpressionId::none || !number(level)) return std::nullopt;
    return std::abs(*surface - *number(level));
  }
  // Less is taken off each, or each is a part of the one before it: 1 is all of it.
  [[nodiscard]] bool grow_less() const {
    const std::optional<double> less = number(CycleValue::less_each_peck);
    return !less || (*less != 0.0 && (*less != -1.0 || !is_0(CycleValue::least_peck)));
  }
  [[nodiscard]] bool has_one_feed() const {
    const std::optional<double> factor = number(CycleValue::first_peck_feed);
    return factor && (*factor == 0.0 || *factor == 1.0 || *factor == kPercent);
  }
  [[nodiscard]] bool is_entered_alike() const {
    const std::optional<double> kind = number(CycleValue::removes_chips);
    if (!kind) return false;
    if (*kind != 0.0) return is_length(CycleValue::peck_clearance, to_.semantics.peck_clearance_mm);
    const std::optional<double> retract = number(CycleValue::peck_retract);
    if (retract && *retract <= 0.0) return kUsualRetract_mm == to_.semantics.chip_break_retract_mm;
    return is_length(CycleValue::peck_retract, to_.semantics.chip_break_retract_mm);
  }
  // In mm or in inches.
  [[nodiscard]] bool is_length(CycleValue which, double wanted_mm) const {
    const std::optional<double> given = number(which);
    if (!given) return false;
    const double least_mm = passes::least_increment_mm(to_, true);
    return *given == wanted_mm || std::abs(*given * kInch_mm - wanted_mm) < least_mm;
  }

  [[nodiscard]] bool is_0(CycleValue which) const { return number(which) == 0.0; }
  [[nodiscard]] ir::ExpressionId value(CycleValue which) const { return ir::value_of(program_, call_, which); }
  // 0 where it is left out; nothing where it is computed.
  [[nodiscard]] std::optional<double> number(CycleValue which) const {
    return value(which) == ir::ExpressionId::none ? 0.0 : ir::number_of(program_, call_, which);
  }

  const ir::Program& program_;
  const ir::Call& call_;
  const ir::Control& to_;
};

}  // namespace

bool has_own_pecks(const ir::Program& program, const ir::Call& call, const ir::Control& to) {
  return call.cycle->hole == ir::DrillCycle::deep_hole && Pecks(program, call, to).are_own();
}

}  // namespace dripfeed::compile
