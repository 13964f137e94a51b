// Where the machine goes on: jumps, calls and returns, the shapes of cycles, and the ends of a program.
#include <algorithm>
#include <utility>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/bytecode/compile.h"
#include "dialects/interpreter/bytecode/jump_target.h"
#include "dialects/interpreter/cycles/repetitive.h"
#include "dialects/interpreter/machine/machine.h"
#include "dialects/interpreter/motion/events.h"
#include "dialects/ir/alarm_details.h"
#include "dialects/ir/sections.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using text::DiagnosticId;

constexpr std::size_t kMotionsOfAShape = 100'000;
constexpr const char* kAcross = "a jump between blocks of the control's two languages";
constexpr double kLastBlockNumber = 99999999.0;
// In the text that the running piece is one of: it has pieces in another language.
bool has_pieces(const CompiledProgram& program) { return program.is_foreign || !program.source->foreign_parts.empty(); }
std::string block_number_name(double value) { return "N" + text::format_shortest(std::round(value_or_zero(value))); }

}  // namespace

bool Machine::follow(Flow flow, const Instruction& i, std::uint32_t& next) {
  return flow == Flow::program_end ? end_program(i, next) : go_back(i, next);
}

// Not known is taken as not fulfilled. A loop that waits for an input would never end so: from the hundredth time
// on the condition is taken as fulfilled every other time. A loop that ends by its condition ends at once.
bool Machine::decide_unknown(const Instruction& i) {
  if (!is_unknown(storage_.reg(i.a), control_.semantics)) return false;
  constexpr std::uint32_t kPatience = 100;
  constexpr std::uint32_t kMostUndecided = 100'000;
  // So many guesses say nothing more: the next pass of a loop is the last.
  if (++undecided_count_ == kMostUndecided) {
    passes_ = options_.limits.loop_passes;
    report_.end_guesses();
  }
  report_.count({.name = "a condition on a value that is not known"});
  report_.take_uncertain_path();
  if (i.extra == 1) return true;
  const std::uint32_t times = ++undecided_[&i];
  return times >= kPatience && times % 2 == 0;
}

bool Machine::jump(const Instruction& i, std::uint32_t& next) {
  ++decisions_;
  const auto search = static_cast<ir::JumpSearch>(i.extra);
  const bool by_text = i.op == Opcode::jump_text;
  const double value = by_text ? 0.0 : storage_.reg(i.a);
  if (by_text ? is_unknown(storage_.text(i.a)) && control_.semantics.unset_is_unknown
              : is_unknown(value, control_.semantics)) {
    report_.count({.name = "a jump to a label that is not known"});
    report_.take_uncertain_path();
    return true;
  }
  const std::uint32_t to =
      by_text ? find_text(stack_.program(), storage_.text(i.a), next - 1, search)
              : find_number(stack_.program(), access_.whole_number(value, kLastBlockNumber), next - 1, search);
  if (to == kNoTarget) {
    if (has_pieces(stack_.program())) return report_.fail(i, DiagnosticId::not_interpreted, {kAcross});
    const bool passed_over = i.c == 1;
    return passed_over || report_.fail(i, DiagnosticId::jump_target_missing,
                                       {by_text ? storage_.text(i.a) : block_number_name(value)});
  }
  if (!by_text && enters_loop(next - 1, to))
    return report_.fail(i, DiagnosticId::jump_into_loop, {block_number_name(value)});
  if (to < next && ++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  next = to;
  ++out_.work.jumps;
  return true;
}

// Of a '#' control: a computed jump is looked at where it goes. The block that opens a loop may be jumped to.
bool Machine::enters_loop(std::uint32_t from, std::uint32_t to) {
  const CompiledProgram& program = stack_.program();
  if (program.source == nullptr || !control_.semantics.has_vacant) return false;
  const std::uint32_t begin = program.spans[from].begin;
  const std::uint32_t target = program.spans[to].begin;
  const ir::Section range = ir::section_at(*program.source, program.section);
  std::vector<std::uint32_t> open;  // where the insides of the open loops begin
  for (std::uint32_t s = range.first; s < range.last; ++s) {
    const ir::Statement& statement = program.source->statements[s];
    const bool opens =
        statement.kind == ir::StatementKind::while_begin || statement.kind == ir::StatementKind::loop_begin;
    const bool closes = statement.kind == ir::StatementKind::while_end || statement.kind == ir::StatementKind::loop_end;
    if (opens) open.push_back(statement.span.end);
    if (!closes || open.empty()) continue;
    const auto is_inside = [&](std::uint32_t at) { return at >= open.back() && at < statement.span.end; };
    if (is_inside(target) && !is_inside(begin)) return true;
    open.pop_back();
  }
  return false;
}

// The first time it goes back as often as it says; each time that it is reached again counts.
bool Machine::repeat_section(const Instruction& i, std::uint32_t& next) {
  while (!sections_.empty() && sections_.back().depth > stack_.depth()) sections_.pop_back();
  const bool again = !sections_.empty() && sections_.back().depth == stack_.depth() && sections_.back().id == i.c;
  if (!again) {
    const double times = storage_.reg(i.b);
    if (is_vacant(times)) report_.count({.name = "a number of repetitions that is not known"});
    sections_.push_back({stack_.depth(), i.c, is_vacant(times) ? 1.0 : arithmetic_.round(times)});
  } else {
    sections_.back().left -= 1.0;
  }
  if (sections_.back().left < 1.0) {
    sections_.pop_back();
    return true;
  }
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  next = i.a;
  ++out_.work.jumps;
  return true;
}

void Machine::end_section(const Instruction& i, std::uint32_t& next) {
  while (!sections_.empty() && sections_.back().depth > stack_.depth()) sections_.pop_back();
  if (!sections_.empty() && sections_.back().depth == stack_.depth() && sections_.back().id == i.c) next = i.a;
}

// Texts are read and compiled once for each program that has them.
bool Machine::execute_text(const Instruction& i, std::uint32_t& next) {
  const std::string text = storage_.text(i.a);
  const auto give_up = [&](std::string name) {
    report_.count({.name = std::move(name)});
    state_.unknown = kAllAxes;
    return true;
  };
  if (is_unknown(text)) return give_up("EXECSTRING of a text that is not known");
  CompiledProgram& host = stack_.program();
  Text& known = texts_[{&host, text}];
  if (known.source == nullptr) {
    if (texts_.size() > options_.limits.texts) return report_.fail_limit(i, "texts that are executed");
    known.source = finder_.read_text(text);
    if (known.source == nullptr) return give_up("EXECSTRING");
    known.code = compile_text(*known.source, host, context_);
  }
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  if (!stack_.enter_text(i, *known.code, next)) return false;
  next = 0;
  return true;
}

// Blocks that cannot be read are kept as written; they follow, and each says so.
bool Machine::enter_foreign_part(const Instruction& i, std::uint32_t& next) {
  CompiledProgram* part = programs_.foreign_part(stack_.program(), i.a);
  if (part == nullptr) return true;
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  if (!stack_.enter_part(i, *part, i.b)) return false;
  next = 0;
  return true;
}

// The same jump back twice, and nothing decided between: the program goes on so for ever.
bool Machine::end_endless(const Instruction& i) {
  report_.say(i, DiagnosticId::endless_loop);
  return report_.end(Ended::limit);
}

bool Machine::count_steps(const Instruction& i, std::uint64_t steps) {
  passes_ += steps;
  return passes_ <= options_.limits.loop_passes || report_.fail_limit(i, "loop passes");
}

// P of a call: 1 to 9999 (PGA, "Number of program repetitions").
bool Machine::check_passes(const Instruction& i) {
  constexpr double kMostPasses = 9999.0;
  const double times = storage_.reg(i.a);
  if (is_vacant(times) || (times >= 1.0 && times <= kMostPasses)) return true;
  return report_.fail(i, DiagnosticId::argument_out_of_domain, {"the number of passes", text::format_shortest(times)},
                      ir::kPasses);
}

// U of G71 to G73 leaves material on the side that the tool comes from: in a bore that is towards the centre.
void Machine::look_at_allowance(const Instruction& cycle) {
  constexpr double kSame_mm = 1e-6;
  if (!control_.semantics.unset_is_unknown || (state_.unknown & 1U) != 0) return;
  const double start = state_.position[0];
  double low = start;
  double high = start;
  for (const ir::Motion& motion : shape_.motions()) {
    low = std::min(low, motion.end[0]);
    high = std::max(high, motion.end[0]);
  }
  const double allowance = state_.repetitive.allowance_x_mm * (rules_.x_is_diameter ? 2.0 : 1.0);
  const bool is_bore = high > start + kSame_mm && low > start - kSame_mm;
  const bool is_outside = low < start - kSame_mm && high < start + kSame_mm;
  if ((is_bore && allowance > 0.0) || (is_outside && allowance < 0.0))
    report_.say(cycle, DiagnosticId::allowance_inside_part,
                {"U" + text::format_shortest(allowance) + " mm", is_bore ? "a bore" : "an outside contour"});
}

// A program that no one has here may be in the control's memory: what it does is not known, and the run goes on.
bool Machine::passes_over_missing(const Instruction& i) {
  if (!control_.semantics.unset_is_unknown || !control_.semantics.has_vacant) return false;
  const std::optional<std::string> name = stack_.missing_target(i);
  if (!name.has_value()) return false;
  if (missing_programs_.insert(*name).second) report_.say(i, DiagnosticId::call_target_missing, {*name});
  report_.count({.name = "the program " + *name + ", which was not found"});
  access_.forget_commons();
  blocks_.forget_tool();
  state_.unknown = kAllAxes;
  state_.feed_unknown = true;
  return true;
}

bool Machine::call(const Instruction& i, std::uint32_t& next) {
  if (stack_.is_unknown_call(i)) {
    report_.count({.name = "a call of a program that is not known"});
    state_.unknown = kAllAxes;
    return true;
  }
  if (passes_over_missing(i)) return true;
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  if (is_contour_cycle(i)) [[unlikely]]
    return begin_contour(i, next);
  if (is_milling_cycle(i)) [[unlikely]]
    return mill_cycle(i, next);
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
  // After roughing the program goes on after the shape: here with the cycle again.
  if (state_.repetitive.cycle != 0 && last < next - 1)
    return report_.fail(i, DiagnosticId::cycle_shape_invalid,
                        {"it stands before the cycle, which begins again after it without end"});
  // A corner that waits for a move must not be cut with the shape's first one.
  if (std::exchange(state_.corner, {}).kind != 0) out_.hold(false);
  shape_.begin(next - 1, last, next, state_, out_.place);
  if (!shape_.finishes()) out_.capture(&shape_.motions());
  next = first;
  return true;
}

bool Machine::shape_block(const Instruction& i, std::uint32_t& next) {
  if (shape_.ends_before(next - 1)) return end_shape(next);
  if (std::max(shape_.motions().size(), contour_.motions.size()) > kMotionsOfAShape)
    return report_.fail_limit(i, "motions of a shape");
  begin_block(i);
  return true;
}

bool Machine::end_shape(std::uint32_t& next) {
  if (contour_.active) {
    next = shape_.resume();
    shape_.end();
    return end_contour();
  }
  const Instruction& cycle = stack_.program().code[shape_.cycle()];
  BlockResult result;
  ShapeFault fault;
  out_.capture(nullptr);
  if (shape_.finishes()) {
    next = shape_.resume();
    shape_.finish(state_, out_);
  } else {
    next -= 1;  // the block after the shape
    const ir::Place place = std::exchange(out_.place, shape_.place());
    state_ = shape_.before();
    look_at_allowance(cycle);
    out_.hold(false);  // a corner at the shape's end
    const std::uint64_t before = out_.count();
    fault = cut_shape(shape_.motions(), rules_, state_, out_, result);
    if (!count_steps(cycle, out_.count() - before)) return false;
    out_.place = place;
  }
  shape_.end();
  if (fault.id == DiagnosticId::count_) return true;
  if (fault.is_doubtful) {
    report_.warn(cycle, fault.id, {fault.text, std::to_string(fault.line)},
                 "a parameter of the machine decides by how much a shape may go back (5145, 5146)");
    return true;
  }
  return report_.fail(cycle, fault.id,
                      fault.id == DiagnosticId::cycle_shape_not_monotonic
                          ? std::vector<std::string>{fault.text, std::to_string(fault.line)}
                          : std::vector<std::string>{fault.text});
}

bool Machine::begin_modal(const Instruction& i) {
  if (stack_.is_unknown_call(i)) {
    report_.count({.name = "a call of a program that is not known"});
    return true;
  }
  return passes_over_missing(i) || stack_.begin_modal(i, value_or_zero(storage_.reg(i.b)));
}

// Blocks of a contour are no moves of the program. Whether one is called by moves of a shape that G70 finishes is not
// known.
bool Machine::call_modal(const Instruction& i, std::uint32_t& next) {
  if (contour_.active) return true;
  if (shape_.active()) {
    report_.count({.name = "a modal call after moves of a shape"});
    return true;
  }
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  const auto begin = stack_.call_modal(i, next);
  next = begin.value_or(0);
  return begin.has_value();
}

bool Machine::leave_program(std::uint32_t& next) {
  next = stack_.go_back();
  const bool contour_ends = contour_.active && contour_.in_program && stack_.depth() == contour_.depth;
  return !contour_ends || end_contour();
}

// The end of a subprogram in the main program ends it; or it starts again without end, of which one pass is enough.
bool Machine::go_back(const Instruction& i, std::uint32_t& next) {
  const bool ends_part = i.b == 1;
  // M99 of ISO mode starts the main program again.
  if (stack_.in_foreign_part() && stack_.depth() == 2 && !ends_part) {
    report_.say(i, DiagnosticId::endless_loop);
    return report_.end(Ended::end);
  }
  if (stack_.in_foreign_part()) next = stack_.go_back();
  if (ends_part) return true;
  for (std::uint32_t further = i.a; further > 0 && !stack_.in_main(); --further) {
    if (!leave_program(next)) return false;
    if (stack_.in_foreign_part()) next = stack_.go_back();
  }
  if (!stack_.in_main()) return leave_program(next);
  const bool restarts = control_.semantics.return_in_main_restarts;
  if (restarts && !is_called_by_others(stack_.program()))
    report_.say(i, DiagnosticId::endless_loop);
  else if (!restarts)
    emit_event(ir::MotionKind::end, state_, out_);
  return report_.end(Ended::end);
}

bool Machine::go_back_to(const Instruction& i, std::uint32_t& next) {
  const bool by_text = i.extra == 1;
  if (by_text && stack_.in_main()) return go_back(i, next);
  const double value = by_text ? 0.0 : storage_.reg(i.a);
  const std::string text = by_text ? storage_.text(i.a) : std::string();
  // Of the main program, from a foreign part: to a block of that part.
  const bool stays = stack_.in_foreign_part() && stack_.depth() == 2;
  if (stack_.in_foreign_part() && !stays) next = stack_.go_back();
  for (std::uint32_t level = 0; level <= i.b && !stack_.in_main() && !stays; ++level) {
    if (level > 0 && stack_.in_foreign_part()) next = stack_.go_back();
    if (!stack_.in_main()) next = stack_.go_back();
  }
  if (by_text && is_unknown(text)) {
    report_.count({.name = "a return to a label that is not known"});
    return true;
  }
  // From here on the instruction is one of the caller: the call, or the return itself in the main program.
  const Instruction& from = stack_.program().code[next - 1];
  const std::uint32_t to = by_text ? find_text(stack_.program(), text, next - 1, ir::JumpSearch::both)
                                   : find_number(stack_.program(), access_.whole_number(value, kLastBlockNumber),
                                                 next - 1, ir::JumpSearch::both);
  if (to == kNoTarget && has_pieces(stack_.program()))
    return report_.fail(from, DiagnosticId::not_interpreted, {kAcross});
  if (to == kNoTarget)
    return report_.fail(from, DiagnosticId::jump_target_missing, {by_text ? text : block_number_name(value)},
                        ir::AlarmDetail::block_of_call);
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(from, "loop passes");
  next = to;
  return true;
}

bool Machine::end_program(const Instruction&, std::uint32_t& next) {
  const std::uint32_t line = out_.place.line;
  if (stack_.in_foreign_part()) next = stack_.go_back();
  if (!stack_.in_main() && control_.semantics.end_in_subprogram_returns) return leave_program(next);
  out_.place.line = line;
  emit_event(ir::MotionKind::end, state_, out_);
  return report_.end(Ended::end);
}

bool Machine::end_text(const Instruction& i) {
  if (i.b != kNothingMissing) report_.say(i, DiagnosticId::missing_program_end);
  return report_.end(Ended::text_end);
}

}  // namespace dripfeed::interpreter
