// CYCLE95, and milling along a contour: it is run first, as a subprogram or as the blocks between two labels, and
// nothing that it does is seen; then the cycle is cut.
#include <array>
#include <utility>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/bytecode/jump_target.h"
#include "dialects/interpreter/machine/machine.h"
#include "dialects/interpreter/motion/spline_block.h"
#include "dialects/interpreter/motion/transformed.h"
#include "dialects/ir/repetition.h"
#include "dialects/ir/sections.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::interpreter {

using text::DiagnosticId;

namespace {

constexpr std::size_t kFirstNumber = 1;
constexpr std::size_t kNumbers = 11;  // MID FALZ FALX FAL FF1 FF2 FF3 VARI DT DAM _VRT

}  // namespace

bool Machine::is_contour_cycle(const Instruction& i) const { return stack_.program().calls[i.a].cuts_contour; }

// Not interpreted: the axes may be anywhere after it.
bool Machine::leave_contour(std::string name) {
  report_.count({.name = std::move(name)});
  state_.unknown = kAllAxes;
  return true;
}

bool Machine::begin_contour(const Instruction& i, std::uint32_t& next) {
  const CompiledProgram& program = stack_.program();
  const CallSite& site = program.calls[i.a];
  if (contour_.active || shape_.active())
    return report_.fail(i, DiagnosticId::cycle_shape_invalid, {"a contour inside a contour"});
  std::array<double, kNumbers> numbers{};
  std::string name;
  for (std::uint32_t n = 0; n < site.argument_count; ++n) {
    const CallArgument& argument = program.arguments[site.first_argument + n];
    if (argument.value == Operand::none || n >= kFirstNumber + kNumbers) continue;
    if (argument.is_string != (n == 0))
      return report_.fail(
          i, DiagnosticId::wrong_type,
          {"argument " + std::to_string(n + 1), argument.is_string ? "STRING" : "REAL", n == 0 ? "STRING" : "REAL"});
    if (n == 0) {
      name = storage_.text(raw_of(argument.value));
      continue;
    }
    const double value = storage_.reg(raw_of(argument.value));
    if (is_vacant(value)) return leave_contour(site.name + " with an argument that is not known");
    numbers[n - kFirstNumber] = value;
  }
  if (name.empty() || is_unknown(name)) return leave_contour(site.name + " along a contour that is not known");
  const double mm = state_.modes.inch ? 25.4 : 1.0;
  const double feed_mm = state_.modes.inch_feed ? 25.4 : 1.0;
  contour_.cycle = {.depth_mm = numbers[0] * mm,
                    .allowance_z_mm = numbers[1] * mm,
                    .allowance_x_mm = numbers[2] * mm,
                    .allowance_mm = numbers[3] * mm,
                    .rough_feed = numbers[4] * feed_mm,
                    .relief_feed = numbers[5] * feed_mm,
                    .finish_feed = numbers[6] * feed_mm,
                    .kind = numbers[7] >= 0.0 && numbers[7] < 1000.0 ? static_cast<int>(numbers[7]) : 0,
                    .dwell_s = numbers[8],
                    .dwell_distance_mm = numbers[9] * mm,
                    .lift_mm = numbers[10] == 0.0 ? 1.0 : numbers[10] * mm};
  contour_.path.reset();
  return run_contour(i, name, next);
}

bool Machine::run_contour(const Instruction& i, const std::string& name, std::uint32_t& next) {
  // What waits for the next move must not be taken for one of the contour's.
  if (state_.spline.active) end_spline(rules_, state_, out_);
  if (std::exchange(state_.corner, {}).kind != 0) out_.hold(false);
  if (BlockResult none; state_.plane_corner.kind != 0) drop_plane_corner(state_, out_, none);
  contour_.call = &i;
  contour_.depth = stack_.depth();
  contour_.before = state_;
  contour_.place = out_.place;
  contour_.motions.clear();
  return name.contains(':') ? run_contour_labels(i, name, next) : run_contour_program(i, name, next);
}

bool Machine::run_contour_program(const Instruction& i, const std::string& written, std::uint32_t& next) {
  const std::string name = text::upper_case(ir::program_name_of_path(written));
  CompiledProgram* target = programs_.find(name, stack_.program());
  if (target == nullptr) return report_.fail(i, DiagnosticId::call_target_missing, {name});
  if (!target->parameters.empty())
    return report_.fail(i, DiagnosticId::wrong_argument_count, {name, std::to_string(target->parameters.size()), "0"});
  if (!stack_.enter_program(i, *target, next)) return false;
  contour_.active = contour_.in_program = true;
  out_.capture(&contour_.motions);
  next = 0;
  return true;
}

// "BEGIN:END": blocks of the calling program, from the one label's to the other's.
bool Machine::run_contour_labels(const Instruction& i, const std::string& name, std::uint32_t& next) {
  const std::size_t colon = name.find(':');
  const auto label = [&](const std::string& wanted) {
    return find_text(stack_.program(), wanted, next - 1, ir::JumpSearch::both);
  };
  const std::string end_name = text::upper_case(name.substr(colon + 1));
  const std::uint32_t first = label(text::upper_case(name.substr(0, colon)));
  const std::uint32_t last = label(end_name);
  if (first == kNoTarget || last == kNoTarget || last < first)
    return report_.fail(i, DiagnosticId::jump_target_missing, {name});
  state_.repetitive.cycle = 1;  // the shape is kept, not cut
  shape_.begin(next - 1, last, next, state_, out_.place);
  const ir::Program& source = *stack_.program().source;
  const auto end = ir::labelled_block(source, ir::section_at(source, stack_.program().section), end_name);
  if (end && end->is_bare) shape_.end_in_front_of_last();
  contour_.active = true;
  contour_.in_program = false;
  out_.capture(&contour_.motions);
  next = first;
  return true;
}

bool Machine::end_contour() {
  const Instruction& call = *contour_.call;
  contour_.active = false;
  out_.capture(nullptr);
  out_.hold(false);  // a corner at the contour's end
  state_ = contour_.before;
  out_.place = contour_.place;
  if (contour_.path) return end_path(call);
  BlockResult result;
  const std::uint64_t before = out_.count();
  const std::string& name = stack_.program().calls[call.a].name;
  ContourOutcome outcome = cut_contour(contour_.motions, contour_.cycle, rules_, state_, out_, result);
  if (!count_steps(call, out_.count() - before)) return false;
  if (outcome.alarm != 0) return report_.fail_user(call, outcome.alarm, name);
  return outcome.not_interpreted.empty() || leave_contour(name + " " + outcome.not_interpreted);
}

}  // namespace dripfeed::interpreter
