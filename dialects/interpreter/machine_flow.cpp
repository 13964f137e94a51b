// Where the machine goes on: jumps, calls and returns, the shapes of cycles, and the ends of a program.
#include <utility>

#include "dialects/interpreter/jump_target.h"
#include "dialects/interpreter/machine.h"
#include "dialects/interpreter/repetitive.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using text::DiagnosticId;

constexpr std::size_t kMotionsOfAShape = 100'000;
constexpr double kLastBlockNumber = 99999999.0;
std::string block_number_name(double value) { return "N" + text::format_shortest(std::round(value_or_zero(value))); }

}  // namespace

bool Machine::follow(Flow flow, const Instruction& i, std::uint32_t& next) {
  return flow == Flow::program_end ? end_program(i, next) : go_back(i, next);
}

bool Machine::jump(const Instruction& i, std::uint32_t& next) {
  const auto search = static_cast<ir::JumpSearch>(i.extra);
  const bool by_text = i.op == Opcode::jump_text;
  const double value = by_text ? 0.0 : storage_.reg(i.a);
  const std::uint32_t to =
      by_text ? find_text(stack_.program(), storage_.text(i.a), next - 1, search)
              : find_number(stack_.program(), access_.whole_number(value, kLastBlockNumber), next - 1, search);
  if (to == kNoTarget) {
    const bool passed_over = i.c == 1;
    return passed_over || report_.fail(i, DiagnosticId::jump_target_missing,
                                       {by_text ? storage_.text(i.a) : block_number_name(value)});
  }
  if (to < next && ++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  next = to;
  return true;
}

bool Machine::count_steps(const Instruction& i, std::uint64_t steps) {
  passes_ += steps;
  return passes_ <= options_.limits.loop_passes || report_.fail_limit(i, "loop passes");
}

bool Machine::call(const Instruction& i, std::uint32_t& next) {
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  const auto begin = stack_.call(i, next);
  next = begin.value_or(0);
  return begin.has_value();
}

// The blocks from ns to nf are run. For roughing their motions are kept and cut to afterwards, as if they had not been
// run; finishing is just that.
bool Machine::begin_shape(const Instruction& i, std::uint32_t& next) {
  const Repetitive& cycle = state_.repetitive;
  const std::uint32_t first = find_number(stack_.program(), cycle.first_block, next - 1, ir::JumpSearch::both);
  const std::uint32_t last =
      first == kNoTarget ? kNoTarget : find_number(stack_.program(), cycle.last_block, first, ir::JumpSearch::forward);
  if (first == kNoTarget || last == kNoTarget || shape_.active())
    return report_.fail(i, DiagnosticId::cycle_shape_missing,
                        {std::to_string(cycle.first_block), std::to_string(cycle.last_block)});
  shape_.begin(next - 1, last, next, state_, out_.place);
  if (!shape_.finishes()) out_.capture(&shape_.motions());
  next = first;
  return true;
}

bool Machine::shape_block(const Instruction& i, std::uint32_t& next) {
  if (shape_.ends_before(next - 1)) return end_shape(next);
  if (shape_.motions().size() > kMotionsOfAShape) return report_.fail_limit(i, "motions of a shape");
  begin_block(i);
  return true;
}

bool Machine::end_shape(std::uint32_t& next) {
  const Instruction& cycle = stack_.program().code[shape_.cycle()];
  BlockResult result;
  ShapeFault fault;
  out_.capture(nullptr);
  if (shape_.finishes()) {
    next = shape_.resume();
    shape_.finish(state_, out_);
  } else {
    next -= 1;  // the block behind the shape
    const ir::Place place = std::exchange(out_.place, shape_.place());
    state_ = shape_.before();
    const std::uint64_t before = out_.count();
    fault = cut_shape(shape_.motions(), rules_, state_, out_, result);
    if (!count_steps(cycle, out_.count() - before)) return false;
    out_.place = place;
  }
  shape_.end();
  if (fault.id == DiagnosticId::count_) return true;
  return report_.fail(cycle, fault.id,
                      fault.id == DiagnosticId::cycle_shape_not_monotonic
                          ? std::vector<std::string>{fault.text, std::to_string(fault.line)}
                          : std::vector<std::string>{fault.text});
}

bool Machine::call_modal(const Instruction& i, std::uint32_t& next) {
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  const auto begin = stack_.call_modal(i, next);
  next = begin.value_or(0);
  return begin.has_value();
}

// The end of a subprogram in the main program ends it; or it starts again without end, of which one pass is enough.
bool Machine::go_back(const Instruction& i, std::uint32_t& next) {
  if (!stack_.in_main()) {
    next = stack_.go_back();
    return true;
  }
  if (control_.semantics.return_in_main_restarts)
    report_.say(i, DiagnosticId::endless_loop);
  else
    emit_event(ir::MotionKind::end, state_, out_);
  return report_.end(Ended::end);
}

bool Machine::go_back_to(const Instruction& i, std::uint32_t& next) {
  const double value = storage_.reg(i.a);
  if (!stack_.in_main()) next = stack_.go_back();
  // From here on the instruction is one of the caller: the call, or the return itself in the main program.
  const Instruction& from = stack_.program().code[next - 1];
  const std::uint32_t to =
      find_number(stack_.program(), access_.whole_number(value, kLastBlockNumber), next - 1, ir::JumpSearch::both);
  if (to == kNoTarget) return report_.fail(from, DiagnosticId::jump_target_missing, {block_number_name(value)});
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(from, "loop passes");
  next = to;
  return true;
}

bool Machine::end_program(const Instruction&, std::uint32_t& next) {
  if (!stack_.in_main() && control_.semantics.end_in_subprogram_returns) {
    next = stack_.go_back();
    return true;
  }
  emit_event(ir::MotionKind::end, state_, out_);
  return report_.end(Ended::end);
}

bool Machine::end_text(const Instruction& i) {
  report_.say(i, DiagnosticId::missing_program_end);
  return report_.end(Ended::text_end);
}

}  // namespace dripfeed::interpreter
