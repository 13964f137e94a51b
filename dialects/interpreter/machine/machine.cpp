// The dispatch loop. Its cases stand in the order of Opcode; each either works on registers or hands over.
#include "dialects/interpreter/machine/machine.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/block/initial_state.h"
#include "dialects/interpreter/machine/variable_listing.h"
#include "dialects/interpreter/motion/spline_block.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using ir::Operator;
using text::DiagnosticId;

// A block that makes more is a cycle: its steps count as passes of a loop.
constexpr std::uint64_t kMotionsOfABlock = 16;

constexpr double truth(bool value) { return value ? 1.0 : 0.0; }

// What may not stand in the shape of a cycle.
constexpr bool leaves_shape(Opcode op) {
  return op == Opcode::call || op == Opcode::back || op == Opcode::back_to || op == Opcode::program_end ||
         op == Opcode::text_end || op == Opcode::modal_call || op == Opcode::foreign_part;
}

}  // namespace

Machine::Machine(const ir::Control& control, ProgramFinder& finder, ir::MotionSink& sink, const RunOptions& options)
    : control_(control),
      options_(options),
      names_(options.names != nullptr ? *options.names : own_names_),
      own_rules_(control),
      rules_(own_rules_),
      arithmetic_(control.semantics),
      variables_(control),
      context_{control,
               own_rules_,
               arithmetic_,
               variables_,
               options.limits,
               names_,
               shared_,
               options.observer == nullptr ? Changes::none : options.changes,
               options.skip_switches,
               options.stretches},
      programs_(context_, finder),
      storage_(variables_, shared_, control.semantics),
      state_(initial_state(control)),
      budget_(options),
      out_(sink, budget_),
      report_(control, options.limits, names_, out_),
      stack_(context_, programs_, storage_, rules_, state_, out_, report_),
      access_(control, arithmetic_, variables_, storage_, shared_, state_, report_),
      frames_(rules_, ir::name_of_system(control, ir::SystemValue::settable_frame), storage_, shared_, state_, report_),
      blocks_(control, rules_, arithmetic_, storage_, access_, shared_, frames_, state_, out_, report_),
      strings_(control, storage_, access_, shared_, report_),
      shared_access_(control, storage_, access_, shared_, frames_, state_, report_),
      finder_(finder) {
  names_ = {};
  state_.announced.every_order = options.every_order;
}

RunResult Machine::run(const ir::Program& program) {
  define_shared_data();
  CompiledProgram& main = programs_.add(program, program.name);
  stack_.start(main);
  if (control_.semantics.unset_is_unknown) set_inputs(main);
  set_initial_values(main);
  run_from(0);
  return finish(main);
}

// The fence of what emitters throw.
void Machine::run_from(std::uint32_t next) {
  try {
    execute(next);
  } catch (const BudgetUsedUp& used) {
    end_by_budget(used);
  }
}

// What was begun is given up: a corner or a curve that waits for its end, the shape of a cycle.
void Machine::end_by_budget(const BudgetUsedUp& used) {
  out_.let_go();
  state_.spline.active = false;
  const CompiledProgram& program = stack_.program();
  const auto is_running = [&](const Instruction& i) { return i.op == Opcode::block && i.a == begun_.line; };
  const auto at = std::ranges::find_if(program.code, is_running);
  report_.fail_limit(at == program.code.end() ? program.code.front() : *at, used.what);
}

RunResult Machine::finish(const CompiledProgram& main) {
  budget_.close();
  if (options_.observer != nullptr && executed_ > 0) report_block();
  if (state_.spline.active) end_spline(rules_, state_, out_);
  out_.flush();
  if (control_.semantics.unset_is_unknown) name_unset_inputs(main);
  if (report_.result().ended == Ended::alarm) {
    note_values_at_alarm();
    name_missing_arguments();
  }
  if (!takes_feed_from_caller(main)) report_.report_no_feed();
  RunResult& result = report_.result();
  result.blocks = executed_;
  result.motions = out_.count();
  result.last = begun_;
  if (options_.want_variables) result.variables = list_variables(variables_, main, storage_, shared_);
  result.strings = names_.strings;
  result.programs = names_.programs;
  return std::move(result);
}

void Machine::execute(std::uint32_t next) {
  const Instruction* code = stack_.program().code.data();
  const double limit = arithmetic_.limit();
  const auto reg = [this](std::uint32_t operand) -> double& { return storage_.reg(operand); };
  // Stores a result that is in range; the rest (vacant operands, overflow, division by zero) takes the slow path.
  const auto put = [&](const Instruction& i, double value, Operator op) {
    if (std::abs(value) <= limit) [[likely]] {
      reg(i.a) = value;
      return true;
    }
    return binary(i, op);
  };
  const auto put_unary = [&](const Instruction& i, bool defined, auto function, Operator op) {
    if (!defined) return unary(i, op);
    reg(i.a) = function(reg(i.b));
    return true;
  };
  const auto compare = [&](const Instruction& i, auto holds, Operator op) {
    const double a = reg(i.b);
    const double b = reg(i.c);
    if (is_vacant(a) || is_vacant(b)) [[unlikely]]
      return binary(i, op);
    reg(i.a) = truth(holds(a, b));
    return true;
  };
  bool goes_on = true;
  while (goes_on) {
    const Instruction& i = code[next++];
    switch (i.op) {
      case Opcode::copy: reg(i.a) = reg(i.b); break;
      case Opcode::add: goes_on = put(i, reg(i.b) + reg(i.c), Operator::add); break;
      case Opcode::subtract: goes_on = put(i, reg(i.b) - reg(i.c), Operator::subtract); break;
      case Opcode::multiply: goes_on = put(i, reg(i.b) * reg(i.c), Operator::multiply); break;
      case Opcode::divide: goes_on = put(i, reg(i.b) / reg(i.c), Operator::divide); break;
      case Opcode::sin: goes_on = put_unary(i, !is_vacant(reg(i.b)), sine_deg, Operator::sin); break;
      case Opcode::cos: goes_on = put_unary(i, !is_vacant(reg(i.b)), cosine_deg, Operator::cos); break;
      case Opcode::sqrt:
        goes_on = put_unary(i, reg(i.b) >= 0.0, [](double value) { return std::sqrt(value); }, Operator::sqrt);
        break;
      case Opcode::equal: goes_on = compare(i, std::equal_to<>(), Operator::equal); break;
      case Opcode::not_equal: goes_on = compare(i, std::not_equal_to<>(), Operator::not_equal); break;
      case Opcode::less: goes_on = compare(i, std::less<>(), Operator::less); break;
      case Opcode::less_equal: goes_on = compare(i, std::less_equal<>(), Operator::less_equal); break;
      case Opcode::greater: goes_on = compare(i, std::greater<>(), Operator::greater); break;
      case Opcode::greater_equal: goes_on = compare(i, std::greater_equal<>(), Operator::greater_equal); break;
      case Opcode::unary: goes_on = unary(i, static_cast<Operator>(i.extra)); break;
      case Opcode::binary: goes_on = binary(i, static_cast<Operator>(i.extra)); break;
      case Opcode::load_number: goes_on = access_.load_number(i); break;
      case Opcode::store_number: goes_on = access_.store_number(i); break;
      case Opcode::load_element: goes_on = access_.load_element(i, stack_.program()); break;
      case Opcode::store_element: goes_on = access_.store_element(i, stack_.program()); break;
      case Opcode::load_of_row: goes_on = access_.load_of_row(i, stack_.program()); break;
      case Opcode::store_in_row: goes_on = access_.store_in_row(i, stack_.program()); break;
      case Opcode::convert: goes_on = convert(i); break;
      case Opcode::block:
        if (executed_ == options_.limits.blocks) [[unlikely]]
          goes_on = report_.fail_limit(i, "blocks");
        else if (shape_.active()) [[unlikely]]
          goes_on = shape_block(i, next);
        else
          begin_block(i);
        break;
      case Opcode::jump:
        next = i.a;
        out_.work.jumps += i.c;
        break;
      case Opcode::jump_back:
        next = i.a;
        out_.work.jumps += i.c;
        budget_.take_step();
        if (++passes_ > options_.limits.loop_passes) [[unlikely]]
          goes_on = report_.fail_limit(i, "loop passes");
        else if (last_jump_ == &i && decisions_ == 0) [[unlikely]]
          goes_on = end_endless(i);
        last_jump_ = &i;
        decisions_ = 0;
        break;
      case Opcode::branch_false:
        ++decisions_;
        if (!is_true(reg(i.a)) && !(is_vacant(reg(i.a)) && decide_unknown(i))) next = i.b;
        break;
      case Opcode::apply: {
        const std::optional<Flow> flow = blocks_.run(i, stack_.program());
        goes_on = flow.has_value() && (*flow == Flow::next || follow(*flow, i, next));
        if (goes_on && blocks_.made() > kMotionsOfABlock) [[unlikely]]
          goes_on = count_steps(i, blocks_.made());
        if (goes_on && blocks_.needs_shape()) [[unlikely]]
          goes_on = begin_shape(i, next);
        if (goes_on && blocks_.moved() && stack_.has_modal() && *flow == Flow::next) [[unlikely]]
          goes_on = call_modal(i, next);
        code = stack_.program().code.data();
        break;
      }
      case Opcode::integer_quotient:
      case Opcode::bound:
      case Opcode::negate_word:
      case Opcode::count:
      case Opcode::fill_array:
      case Opcode::load_reference:
      case Opcode::store_reference:
      case Opcode::refer:
      case Opcode::refer_number:
      case Opcode::refer_element:
      case Opcode::load_system:
      case Opcode::store_system:
      case Opcode::load_shared:
      case Opcode::store_shared:
      case Opcode::load_shared_text:
      case Opcode::store_shared_text:
      case Opcode::refer_shared:
      case Opcode::string_copy:
      case Opcode::string_join:
      case Opcode::string_from_number:
      case Opcode::string_to_number:
      case Opcode::string_is_number:
      case Opcode::string_to_axis:
      case Opcode::string_to_value:
      case Opcode::string_find:
      case Opcode::string_part:
      case Opcode::axis_name:
      case Opcode::string_length:
      case Opcode::string_upper:
      case Opcode::string_lower:
      case Opcode::string_equal:
      case Opcode::string_load_element:
      case Opcode::string_store_element:
      case Opcode::string_fit:
      case Opcode::frame_make:
      case Opcode::frame_chain:
      case Opcode::frame_part:
      case Opcode::frame_set_part:
      case Opcode::load_frame:
      case Opcode::store_frame:
      case Opcode::jump_number:
      case Opcode::jump_text:
      case Opcode::repeat_section:
      case Opcode::section_end:
      case Opcode::execute_text:
      case Opcode::foreign_part:
      case Opcode::plain_stretch:
      case Opcode::call:
      case Opcode::modal_call:
      case Opcode::modal_end:
      case Opcode::passes:
      case Opcode::output:
      case Opcode::skip_given:
      case Opcode::load_given:
      case Opcode::back:
      case Opcode::back_to:
      case Opcode::program_end:
      case Opcode::text_end:
      case Opcode::message:
      case Opcode::alarm:
      case Opcode::fail:
      case Opcode::report:
      case Opcode::report_variable:
      case Opcode::report_number:
      case Opcode::report_element:
        goes_on = execute_rare(i, next);
        code = stack_.program().code.data();
        break;
    }
  }
}

bool Machine::execute_rare(const Instruction& i, std::uint32_t& next) {
  if (is_string_opcode(i.op)) return strings_.execute(i, stack_.program());
  if (is_shared_opcode(i.op)) return shared_access_.execute(i);
  if (is_frame_opcode(i.op)) return frames_.execute(i);
  CompiledProgram& program = stack_.program();
  const auto reg = [this](std::uint32_t operand) -> double& { return storage_.reg(operand); };
  if (i.op == Opcode::integer_quotient)
    return take_outcome(i, arithmetic_.integer_quotient(reg(i.b), reg(i.c)), "the quotient", reg(i.b));
  if (i.op == Opcode::bound)
    return take_outcome(i, arithmetic_.bound(reg(i.b), reg(next_register(i.b)), reg(next_register(next_register(i.b)))),
                        "the bound", reg(i.b));
  if (i.op == Opcode::refer_number) return access_.refer_number(i);
  if (i.op == Opcode::refer_element) return access_.refer_element(i, program);
  if (i.op == Opcode::load_system) return access_.load_system(i);
  if (i.op == Opcode::store_system) return access_.store_system(i);
  if (i.op == Opcode::jump_number || i.op == Opcode::jump_text) return jump(i, next);
  if (shape_.active() && leaves_shape(i.op)) {
    // The text, or the part in another language, may end with the shape.
    const bool ends_text = i.op == Opcode::text_end || (i.op == Opcode::back && i.b == 1);
    if (ends_text && shape_.ends_before(next - 1)) return end_shape(next);
    return report_.fail(i, DiagnosticId::cycle_shape_invalid, {"a call, a return or the program's end stands in it"});
  }
  if (i.op == Opcode::call) return call(i, next);
  if (i.op == Opcode::modal_call) return begin_modal(i);
  if (i.op == Opcode::passes) return check_passes(i);
  if (i.op == Opcode::output) return output(i);
  if (i.op == Opcode::repeat_section) return repeat_section(i, next);
  if (i.op == Opcode::execute_text) return execute_text(i, next);
  if (i.op == Opcode::foreign_part) return enter_foreign_part(i, next);
  if (i.op == Opcode::plain_stretch) return run_stretch(i);
  if (i.op == Opcode::back) return go_back(i, next);
  if (i.op == Opcode::back_to) return go_back_to(i, next);
  if (i.op == Opcode::program_end) return end_program(i, next);
  if (i.op == Opcode::text_end && program.is_text) {
    next = stack_.go_back();
    return true;
  }
  if (i.op == Opcode::text_end) return end_text(i);
  if (i.op == Opcode::message) return message(i);
  if (i.op == Opcode::alarm) return user_alarm(i);
  if (i.op == Opcode::fail)
    return report_.fail(i, program.failures[i.a].id, program.failures[i.a].arguments, program.failures[i.a].detail);

  if (i.op == Opcode::negate_word)
    reg(i.a) = is_vacant(reg(i.b)) ? reg(i.b) : -reg(i.b);
  else if (i.op == Opcode::count)
    reg(i.a) = reg(i.b) / (state_.modes.inch ? rules_.increments_per_mm * 10.0 : rules_.increments_per_mm);
  else if (i.op == Opcode::fill_array)
    access_.fill_array(i, program);
  else if (i.op == Opcode::load_reference)
    reg(i.a) = storage_.at_reference(reg(i.b));
  else if (i.op == Opcode::store_reference)
    storage_.at_reference(reg(i.a)) = reg(i.b);
  else if (i.op == Opcode::refer)
    reg(i.a) = storage_.refer(space_of(static_cast<Operand>(i.b)), index_of(static_cast<Operand>(i.b)));
  else if (i.op == Opcode::skip_given)
    next = stack_.was_given(i.a) ? i.b : next;
  else if (i.op == Opcode::load_given)
    reg(i.a) = stack_.is_main() ? kVacant : static_cast<double>(stack_.was_given(i.b));
  else if (i.op == Opcode::modal_end)
    stack_.end_modal();
  else if (i.op == Opcode::section_end)
    end_section(i, next);
  else if (i.op == Opcode::report) {
    report_.count(program.reports[i.a]);
    if ((i.b & kReportMoves) != 0) state_.unknown = kAllAxes;
    if ((i.b & kReportShifts) != 0) state_.gaps |= ir::kFrameLost;
  } else
    report_rare(i);
  return true;
}

// --- arithmetic

bool Machine::unary(const Instruction& i, Operator op) {
  const double a = storage_.reg(i.b);
  return take_outcome(i, arithmetic_.unary(op, a), describe(op), a);
}

bool Machine::binary(const Instruction& i, Operator op) {
  const double a = storage_.reg(i.b);
  return take_outcome(i, arithmetic_.binary(op, a, storage_.reg(i.c)), describe(op), a);
}

bool Machine::take_outcome(const Instruction& i, Outcome outcome, std::string_view function, double argument) {
  switch (outcome.fault) {
    case Fault::none: storage_.reg(i.a) = outcome.value; return true;
    case Fault::division_by_zero: return report_.fail(i, DiagnosticId::division_by_zero);
    case Fault::result_overflow: return report_.fail(i, DiagnosticId::result_overflow);
    case Fault::integer_overflow:
      return report_.fail(i, DiagnosticId::result_overflow, {}, ir::AlarmDetail::whole_numbers);
    case Fault::argument_out_of_domain: break;
  }
  return report_.fail(i, DiagnosticId::argument_out_of_domain,
                      {std::string(function), text::format_shortest(value_or_zero(argument))});
}

bool Machine::convert(const Instruction& i) {
  const double value = storage_.reg(i.b);
  const Outcome outcome = arithmetic_.convert(static_cast<ir::ValueType>(i.extra), value);
  if (outcome.fault == Fault::result_overflow)
    return report_.fail(i, DiagnosticId::result_overflow, {}, ir::AlarmDetail::whole_numbers);
  return take_outcome(i, outcome, "the type", value);
}

// --- flow

void Machine::begin_block(const Instruction& i) {
  if (options_.observer != nullptr && executed_ > 0) [[unlikely]]
    report_block();
  budget_.take_step();
  begin_place(stack_.program().keeps_place ? out_.place.line : i.a);
  if (options_.states != nullptr) [[unlikely]]
    show_state(*options_.states);
  state_.clock_ms += control_.cost.block_ms;
  if (i.b == 0)
    ++out_.work.blocks;
  else
    out_.work.add(stack_.program().works[i.b]);
}

void Machine::show_state(StateObserver& states) {
  const BlockBegin begin{.place = begun_,
                         .state = state_,
                         .in_main = stack_.in_main() && !shape_.active() && !contour_.active,
                         .modal_call = stack_.has_modal(),
                         .guessed = report_.took_uncertain_path()};
  if (states.begin(begin) && begin.in_main)
    states.variables(list_variables(variables_, stack_.program(), storage_, shared_));
}

}  // namespace dripfeed::interpreter
