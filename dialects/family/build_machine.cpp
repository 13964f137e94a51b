// What the machine switches, and blocks of a control's own language.
#include <algorithm>

#include "dialects/family/builder.h"
#include "dialects/family/evaluate.h"
#include "dialects/ir/transformation_use.h"

namespace dripfeed::family {

using ir::ExpressionId;
using ir::Function;

bool Builder::sets(StepKind kind, Dimension dimension) const {
  return std::ranges::any_of(family_.steps,
                             [=](const Step& one) { return one.kind == kind && one.dimension == dimension; });
}

void Builder::work_offset(const Step& step) {
  const EmittedCode code{Function::work_offset, static_cast<std::int16_t>(step.number)};
  emit_.block(std::span(&code, 1), {});
}

void Builder::tool(const Step& step) {
  const std::vector<EmittedWord> which = {{ir::Address::t, emit_.constant(tool_number(bound_, step))},
                                          {ir::Address::d, emit_.constant(1.0)}};
  if (family_.machine == ir::MachineKind::lathe) {
    emit_.block(std::span<const EmittedCode>(), which);
  } else {
    emit_.block({Function::tool_change}, which);
  }
}

void Builder::spindle(const Step& step) {
  std::vector<EmittedWord> out = {{ir::Address::s, values_.copy(step.values[0])}};
  if (step.values[1] != ExpressionId::none) out.push_back({ir::Address::spindle_limit, values_.copy(step.values[1])});
  std::vector<EmittedCode> codes;
  if (step.dimension == kSurfaceSpeed) {
    codes.push_back({Function::surface_speed_on});
  } else if (uses_surface_speed_) {
    codes.push_back({Function::surface_speed_off});
  }
  if (step.direction != Function::none) codes.push_back({step.direction});
  emit_.block(codes, out);
}

void Builder::coolant(const Step& step) {
  static constexpr Function kCoolant[] = {Function::coolant_off, Function::coolant_mist, Function::coolant_flood};
  emit_.block({kCoolant[step.number]}, {});
}

void Builder::native(const Step& step) {
  const NativeVerb& verb = family_.natives[static_cast<std::size_t>(step.number)];
  const EmittedCode code{Function::machine_function, static_cast<std::int16_t>(kFirstNativeFunction + step.number)};
  emit_.block(std::span(&code, 1), {});
  if (verb.changes_motion) motion_ = Function::none;
  if (verb.changes_feed) feed_ = last_feed_;
}

void Builder::polar_begin() {
  transformation(ir::kFaceByY, {});
  emit_.block({Function::plane_xy}, {});
}

void Builder::polar_end() {
  emit_.block({Function::plane_zx}, {});
  transformation(ir::kTransformationEnds, {});
}

void Builder::cylinder_begin(const Step& step) {
  const double diameter = evaluate(family_.arena, step.values[0], bound_.values).value;
  transformation(ir::kCylinderByY, {{{ir::Address::r, emit_.constant(diameter)}}});
}

void Builder::transformation(std::int16_t use, std::span<const EmittedWord> words) {
  const EmittedCode code{Function::transformation, use};
  emit_.block(std::span(&code, 1), words);
  motion_ = Function::none;
}

void Builder::dwell(const Step& step) {
  const std::vector<EmittedWord> value = {{ir::Address::f, values_.copy(step.values[0])}};
  emit_.block({Function::dwell}, value);
}

}  // namespace dripfeed::family
