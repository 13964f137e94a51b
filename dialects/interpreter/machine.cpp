// The dispatch loop. Its cases stand in the order of Opcode; each either works on registers or hands over.
#include "dialects/interpreter/machine.h"

#include <algorithm>
#include <utility>

#include "dialects/interpreter/compile.h"
#include "dialects/interpreter/jump_target.h"
#include "dialects/interpreter/unknown.h"
#include "dialects/interpreter/variable_listing.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using ir::Operator;
using text::DiagnosticId;

constexpr double truth(bool value) { return value ? 1.0 : 0.0; }

constexpr double kLastBlockNumber = 99999999.0;
constexpr double kLastAlarm = 99999999.0;
std::string block_number_name(double value) { return "N" + text::format_shortest(std::round(value_or_zero(value))); }

}  // namespace

Machine::Machine(const ir::Control& control, ProgramFinder& finder, ir::MotionSink& sink, const RunOptions& options)
    : control_(control),
      options_(options),
      names_(options.names != nullptr ? *options.names : own_names_),
      rules_(control),
      arithmetic_(control.semantics),
      variables_(control),
      context_{control, rules_, arithmetic_, variables_, options.limits, names_, shared_, options.observer != nullptr},
      programs_(context_, finder),
      storage_(variables_, shared_, control.semantics.has_vacant || control.semantics.unset_is_unknown ? kVacant : 0.0),
      state_(initial_state(control)),
      out_(sink),
      report_(control, options.limits, names_, out_),
      stack_(context_, programs_, storage_, state_, out_, report_),
      access_(control, arithmetic_, variables_, storage_, shared_, state_, report_),
      blocks_(control, rules_, arithmetic_, storage_, shared_, state_, out_, report_),
      strings_(control, storage_, access_, shared_, report_),
      shared_access_(control, storage_, access_, shared_, state_, report_),
      finder_(finder) {
  names_ = {};
}

RunResult Machine::run(const ir::Program& program) {
  define_shared_data();
  CompiledProgram& main = programs_.add(program, program.name);
  stack_.start(main);
  if (control_.semantics.unset_is_unknown) set_inputs(main);
  set_initial_values(main);
  execute(0);
  return finish(main);
}

RunResult Machine::finish(const CompiledProgram& main) {
  if (options_.observer != nullptr && executed_ > 0) tell_block();
  out_.flush();
  if (control_.semantics.unset_is_unknown) name_unset_inputs(main);
  if (!takes_feed_from_caller(main)) report_.say_no_feed();
  RunResult& result = report_.result();
  result.blocks = executed_;
  result.motions = out_.count();
  result.last = begun_;
  if (options_.want_variables) result.variables = list_variables(variables_, main, storage_, shared_);
  result.strings = names_.strings;
  result.programs = names_.programs;
  return std::move(result);
}

// Nothing in a subprogram ends a run; a text that was run while it was read has ended by its end or not at all.
bool Machine::takes_feed_from_caller(const CompiledProgram& main) const {
  if (!control_.semantics.unset_is_unknown) return false;
  if (main.source == nullptr) return report_.result().ended == Ended::text_end;
  const std::string& name = main.source->source.name();
  if (name.ends_with(".SPF") || name.ends_with(".spf")) return true;
  return std::ranges::none_of(main.source->statements, [](const ir::Statement& statement) {
    return statement.kind == ir::StatementKind::program_end;
  });
}

// Definition files declare the names that programs find in the control.
void Machine::define_shared_data() {
  for (const std::string& name : control_.definition_files)
    if (const ir::Program* definitions = finder_.find(name)) shared_.define(*definitions);
}

// A subprogram that is run by itself takes its parameters and its feed from a caller that is not there.
void Machine::set_inputs(const CompiledProgram& main) {
  for (const Parameter& parameter : main.parameters) {
    if (parameter.type == ir::ValueType::string)
      storage_.string_at(parameter.slot) = kUnknownText;
    else
      storage_.frame_at(parameter.slot) = parameter.by_reference ? Storage::refer_shared(shared_.nameless()) : kVacant;
  }
  state_.feed_unknown = main.has_procedure;
}

// What the main program reads and nobody has set by the end.
void Machine::name_unset_inputs(const CompiledProgram& main) {
  if (main.source == nullptr) return;
  const ir::Program& source = *main.source;
  for (const ir::Variable& variable : source.variables) {
    if (variable.bank != ir::Bank::r || variable.index != ir::ExpressionId::none) continue;
    const Slot slot = variables_.find(variable.bank, variable.number);
    if (slot.kind != SlotKind::global || !is_vacant(storage_.global_at(slot.index))) continue;
    out_.place.program = 0;
    out_.place.line = source.source.position(variable.span.begin).line;
    report_.count({.name = variable_name(variable.bank, variable.number), .is_input = true});
  }
}

void Machine::set_initial_values(const CompiledProgram& main) {
  for (const InitialValue& value : options_.initial_values) {
    if (value.name.empty()) {
      access_.set_initial(value);
      continue;
    }
    if (main.source == nullptr) continue;  // a stream declares no names
    const ir::Program& source = *main.source;
    bool declared = false;
    for (std::size_t s = 0; s < source.symbols.size(); ++s) {
      const ir::Symbol& symbol = source.symbols[s];
      if (symbol.is_global || symbol.type == ir::ValueType::string || symbol.dimension1 > 0 ||
          source.strings.at(symbol.name) != value.name)
        continue;
      declared = true;
      double& to = storage_.frame_at(main.symbols[s].slot);
      (symbol.by_reference ? storage_.at_reference(to) : to) = arithmetic_.convert(symbol.type, value.value).value;
    }
    if (!declared) shared_.set(value.name, value.value);
  }
}

void Machine::execute(std::uint32_t next) {
  const Instruction* code = stack_.program().code.data();
  const double limit = arithmetic_.limit();
  const auto reg = [this](std::uint32_t operand) -> double& { return storage_.reg(operand); };
  // Stores a result that is in range; the rest (vacant operands, overflow, division by zero) goes the long way.
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
      case Opcode::equal: reg(i.a) = truth(Arithmetic::equal_exact(reg(i.b), reg(i.c))); break;
      case Opcode::not_equal: reg(i.a) = truth(!Arithmetic::equal_exact(reg(i.b), reg(i.c))); break;
      case Opcode::less: reg(i.a) = truth(value_or_zero(reg(i.b)) < value_or_zero(reg(i.c))); break;
      case Opcode::less_equal: reg(i.a) = truth(value_or_zero(reg(i.b)) <= value_or_zero(reg(i.c))); break;
      case Opcode::greater: reg(i.a) = truth(value_or_zero(reg(i.b)) > value_or_zero(reg(i.c))); break;
      case Opcode::greater_equal: reg(i.a) = truth(value_or_zero(reg(i.b)) >= value_or_zero(reg(i.c))); break;
      case Opcode::unary: goes_on = unary(i, static_cast<Operator>(i.extra)); break;
      case Opcode::binary: goes_on = binary(i, static_cast<Operator>(i.extra)); break;
      case Opcode::load_number: goes_on = access_.load_number(i); break;
      case Opcode::store_number: goes_on = access_.store_number(i); break;
      case Opcode::load_element: goes_on = access_.load_element(i, stack_.program()); break;
      case Opcode::store_element: goes_on = access_.store_element(i, stack_.program()); break;
      case Opcode::convert: goes_on = convert(i); break;
      case Opcode::block:
        if (executed_ == options_.limits.blocks) [[unlikely]]
          goes_on = report_.fail_limit(i, "blocks");
        else
          begin_block(i);
        break;
      case Opcode::jump: next = i.a; break;
      case Opcode::jump_back:
        next = i.a;
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
      case Opcode::jump_number:
      case Opcode::jump_text:
      case Opcode::repeat_section:
      case Opcode::section_end:
      case Opcode::execute_text:
      case Opcode::call:
      case Opcode::skip_given:
      case Opcode::back:
      case Opcode::back_to:
      case Opcode::program_end:
      case Opcode::text_end:
      case Opcode::message:
      case Opcode::alarm:
      case Opcode::fail:
      case Opcode::report:
      case Opcode::tell:
      case Opcode::tell_number:
      case Opcode::tell_element:
        goes_on = execute_rare(i, next);
        code = stack_.program().code.data();
        break;
    }
  }
}

bool Machine::execute_rare(const Instruction& i, std::uint32_t& next) {
  if (is_string_opcode(i.op)) return strings_.execute(i, stack_.program());
  if (is_shared_opcode(i.op)) return shared_access_.execute(i);
  CompiledProgram& program = stack_.program();
  const auto reg = [this](std::uint32_t operand) -> double& { return storage_.reg(operand); };
  if (i.op == Opcode::integer_quotient)
    return settle(i, arithmetic_.integer_quotient(reg(i.b), reg(i.c)), "the quotient", reg(i.b));
  if (i.op == Opcode::bound)
    return settle(i, arithmetic_.bound(reg(i.b), reg(next_register(i.b)), reg(next_register(next_register(i.b)))),
                  "the bound", reg(i.b));
  if (i.op == Opcode::refer_number) return access_.refer_number(i);
  if (i.op == Opcode::refer_element) return access_.refer_element(i, program);
  if (i.op == Opcode::load_system) return access_.load_system(i);
  if (i.op == Opcode::store_system) return access_.store_system(i);
  if (i.op == Opcode::jump_number || i.op == Opcode::jump_text) return jump(i, next);
  if (i.op == Opcode::call) return call(i, next);
  if (i.op == Opcode::repeat_section) return repeat_section(i, next);
  if (i.op == Opcode::execute_text) return execute_text(i, next);
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
  if (i.op == Opcode::fail) return report_.fail(i, program.failures[i.a].id, program.failures[i.a].arguments);

  if (i.op == Opcode::negate_word)
    reg(i.a) = is_vacant(reg(i.b)) ? kVacant : -reg(i.b);
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
  else if (i.op == Opcode::section_end)
    end_section(i, next);
  else if (i.op == Opcode::report) {
    report_.count(program.reports[i.a]);
    if (i.b == 1) state_.unknown = kAllAxes;
  } else
    tell_rare(i);
  return true;
}

// --- arithmetic
// -------------------------------------------------------------------------------------------------------

bool Machine::unary(const Instruction& i, Operator op) {
  const double a = storage_.reg(i.b);
  return settle(i, arithmetic_.unary(op, a), describe(op), a);
}

bool Machine::binary(const Instruction& i, Operator op) {
  const double a = storage_.reg(i.b);
  return settle(i, arithmetic_.binary(op, a, storage_.reg(i.c)), describe(op), a);
}

bool Machine::settle(const Instruction& i, Outcome outcome, std::string_view function, double argument) {
  switch (outcome.fault) {
    case Fault::none: storage_.reg(i.a) = outcome.value; return true;
    case Fault::division_by_zero: return report_.fail(i, DiagnosticId::division_by_zero);
    case Fault::result_overflow: return report_.fail(i, DiagnosticId::result_overflow);
    case Fault::argument_out_of_domain: break;
  }
  return report_.fail(i, DiagnosticId::argument_out_of_domain,
                      {std::string(function), text::format_shortest(value_or_zero(argument))});
}

bool Machine::convert(const Instruction& i) {
  const double value = storage_.reg(i.b);
  return settle(i, arithmetic_.convert(static_cast<ir::ValueType>(i.extra), value), "the type", value);
}

// --- flow
// -------------------------------------------------------------------------------------------------------------

void Machine::begin_block(const Instruction& i) {
  if (options_.observer != nullptr && executed_ > 0) [[unlikely]]
    tell_block();
  if (!stack_.program().keeps_place) out_.place.line = i.a;
  out_.place.ordinal = executed_++;
  begun_ = out_.place;
  const Work& work = stack_.program().works[i.b];
  ++out_.work.blocks;
  if (i.b == 0) return;
  out_.work.number_reads += work.number_reads;
  out_.work.named_reads += work.named_reads;
  out_.work.operators += work.operators;
  out_.work.functions += work.functions;
}

bool Machine::follow(Flow flow, const Instruction& i, std::uint32_t& next) {
  return flow == Flow::program_end ? end_program(i, next) : go_back(i, next);
}

// Not known is taken as not fulfilled. A loop that waits for an input would never end that way: from the hundredth time
// on the condition is taken as fulfilled every other time. A loop that ends by its condition ends at once.
bool Machine::decide_unknown(const Instruction& i) {
  if (!control_.semantics.unset_is_unknown) return false;
  constexpr std::uint32_t kPatience = 100;
  report_.count({.name = "a condition on a value that is not known"});
  report_.take_uncertain_way();
  if (i.extra == 1) return true;
  const std::uint32_t times = ++undecided_[&i];
  return times >= kPatience && times % 2 == 0;
}

bool Machine::jump(const Instruction& i, std::uint32_t& next) {
  ++decisions_;
  const auto search = static_cast<ir::JumpSearch>(i.extra);
  const bool by_text = i.op == Opcode::jump_text;
  const double value = by_text ? 0.0 : storage_.reg(i.a);
  if (control_.semantics.unset_is_unknown && (by_text ? is_unknown(storage_.text(i.a)) : is_vacant(value))) {
    report_.count({.name = "a jump to a label that is not known"});
    return true;
  }
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
    known.source = finder_.read_text(text);
    if (known.source == nullptr) return give_up("EXECSTRING");
    known.code = compile_text(*known.source, host, context_);
  }
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  if (!stack_.enter_text(i, *known.code, next)) return false;
  next = 0;
  return true;
}

// The same jump back twice, and nothing decided between: the program goes on so for ever.
bool Machine::end_endless(const Instruction& i) {
  report_.say(i, DiagnosticId::endless_loop);
  return report_.end(Ended::limit);
}

bool Machine::call(const Instruction& i, std::uint32_t& next) {
  if (stack_.is_unknown_call(i)) {
    report_.count({.name = "a call of a program that is not known"});
    state_.unknown = kAllAxes;
    return true;
  }
  if (++passes_ > options_.limits.loop_passes) return report_.fail_limit(i, "loop passes");
  if (!stack_.call(i, next)) return false;
  next = 0;
  return true;
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

// --- messages and observers
// -------------------------------------------------------------------------------------------

bool Machine::message(const Instruction& i) {
  static const std::string kNothing;
  const bool clears = static_cast<Operand>(i.a) == Operand::none;
  const std::uint32_t text = report_.text_index(clears ? kNothing : storage_.text(i.a));
  if (text == kNoText) return report_.fail_limit(i, "strings");
  emit_event(ir::MotionKind::message, state_, out_).text = text;
  return true;
}

bool Machine::user_alarm(const Instruction& i) {
  const bool numbered = static_cast<Operand>(i.a) != Operand::none;
  const auto number = numbered ? access_.whole_number(value_or_zero(storage_.reg(i.a)), kLastAlarm) : std::nullopt;
  const std::uint32_t shown = number.has_value() ? *number + control_.semantics.user_alarm_base : 0;
  const bool has_text = static_cast<Operand>(i.b) != Operand::none;
  return report_.fail_user(i, shown, has_text ? std::string_view(storage_.text(i.b)) : std::string_view());
}

void Machine::tell(std::string_view name, double value) {
  const auto found = std::ranges::find(names_.variables, name);
  const auto index = static_cast<std::uint32_t>(found - names_.variables.begin());
  if (found == names_.variables.end()) names_.variables.emplace_back(name);
  changes_.push_back({.variable = index, .value = value});
}

void Machine::tell_rare(const Instruction& i) {
  if (i.op == Opcode::tell) {
    changes_.push_back({i.b, storage_.reg(i.a)});
  } else if (i.op == Opcode::tell_number) {
    const auto number = access_.whole_number(storage_.reg(i.a), 4294967294.0);
    if (number.has_value()) tell(variable_name(static_cast<ir::Bank>(i.extra), *number), storage_.reg(i.b));
  } else if (i.op == Opcode::tell_element) {
    tell(access_.name_of_element(stack_.program(), i.a, i.b), storage_.reg(i.c));
  }
}

void Machine::tell_block() {
  options_.observer->block(begun_, changes_);
  changes_.clear();
}

}  // namespace dripfeed::interpreter
