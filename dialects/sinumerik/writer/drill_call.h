// The call of a drilling cycle, or the moves of back boring, for what a modal cycle of another control says at a block.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dialects/ir/called_cycle.h"
#include "dialects/passes/refusal.h"
#include "dialects/sinumerik/writer/back_boring.h"
#include "dialects/sinumerik/writer/drill_state.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

inline constexpr std::string_view kTwoPaths = "two control-flow paths lead to this block and differ";
inline constexpr auto kBackBore = static_cast<std::int16_t>(ir::DrillCycle::back_bore);

bool turns_spindle(ir::Function function);

class DrillCall {
 public:
  // `before` and `after` the block; all must outlive it. The program's words must not grow meanwhile.
  DrillCall(const Raising& raising, text::Span span, const ir::Block& block, const DrillState& before,
            const DrillState& after);

  // A new call of the program, by its index. Nothing where there is none, which is reported; so below.
  std::optional<std::uint32_t> make();
  std::optional<BackBoring> back_boring();

 private:
  // RTP, RFP and DP.
  struct Levels {
    ir::ExpressionId back = ir::ExpressionId::none;
    ir::ExpressionId reference = ir::ExpressionId::none;
    ir::ExpressionId depth = ir::ExpressionId::none;
  };
  std::optional<Levels> levels();
  ir::ExpressionId initial_level();
  bool pecks(ir::DrillCycle cycle);
  bool tap(ir::DrillCycle cycle);
  ir::ExpressionId system_value(std::string_view name);
  bool stops(ir::DrillCycle cycle);
  // Off the wall, in the plane.
  struct Shift {
    ir::ExpressionId x = ir::ExpressionId::none;
    ir::ExpressionId y = ir::ExpressionId::none;
  };
  std::optional<Shift> shift_aside();
  bool fine_bore(ir::DrillCycle cycle);
  ir::ExpressionId seconds();
  std::optional<ir::ExpressionId> word(const Fact<ir::ExpressionId>& fact, std::string_view address);
  std::optional<ir::ExpressionId> carried(const Fact<ir::ExpressionId>& fact, std::string_view address);
  void put(ir::CycleValue which, ir::ExpressionId value);

  std::nullopt_t refuse(passes::Refusal what);
  void warn(passes::Refusal what);
  ir::ExpressionId constant(double value);
  ir::ExpressionId of(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b = ir::ExpressionId::none);
  ir::ExpressionId sum(ir::ExpressionId a, ir::ExpressionId b);

  const Raising& raising_;
  ir::Program& program_;
  text::Span span_;
  std::span<const ir::Word> own_;  // of the block
  const DrillState& before_;
  const DrillState& after_;
  bool inch_;
  const ir::CalledCycle* called_ = nullptr;
  std::vector<ir::ExpressionId> arguments_;
};

}  // namespace dripfeed::sinumerik
