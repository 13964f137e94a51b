// What a program says to people and devices: messages, lines of output, alarms; and what an observer receives.
#include <algorithm>

#include "dialects/interpreter/arithmetic/output_field.h"
#include "dialects/interpreter/machine/machine.h"
#include "dialects/interpreter/motion/events.h"

namespace dripfeed::interpreter {

namespace {

constexpr double kLastAlarm = 99999999.0;

}  // namespace

bool Machine::message(const Instruction& i) {
  static const std::string kNothing;
  const bool clears = static_cast<Operand>(i.a) == Operand::none;
  const std::uint32_t text = report_.text_index(clears ? kNothing : storage_.text(i.a));
  if (text == kNoText) return report_.fail_limit(i, "strings");
  emit_event(ir::MotionKind::message, state_, out_).text = text;
  return true;
}

// What goes to a device is reported as a message.
bool Machine::output(const Instruction& i) {
  const ir::Program& program = *stack_.program().source;
  const ir::Output& output = program.outputs[i.a];
  std::string line;
  std::uint32_t value = i.b;
  for (std::uint32_t n = 0; n < output.part_count; ++n, value = next_register(value)) {
    const ir::OutputPart& part = program.output_parts[output.first_part + n];
    line += program.strings.at(part.text);
    if (part.value != ir::ExpressionId::none)
      append_field(line, value_or_zero(storage_.reg(value)), part.whole_digits, part.decimals);
  }
  if (output.kind != ir::OutputKind::line) return true;
  const std::uint32_t text = report_.text_index(line);
  if (text == kNoText) return report_.fail_limit(i, "strings");
  emit_event(ir::MotionKind::message, state_, out_).text = text;
  return true;
}

bool Machine::user_alarm(const Instruction& i) {
  const bool numbered = static_cast<Operand>(i.a) != Operand::none;
  const auto number = numbered ? access_.whole_number(value_or_zero(storage_.reg(i.a)), kLastAlarm) : std::nullopt;
  const ir::Semantics& s = control_.semantics;
  const bool above = s.highest_user_alarm != 0 && number.has_value() && *number > s.highest_user_alarm;
  const std::uint32_t shown = !number.has_value() ? 0 : above ? s.user_alarm_base : *number + s.user_alarm_base;
  const bool has_text = static_cast<Operand>(i.b) != Operand::none;
  return report_.fail_user(i, shown, has_text ? std::string_view(storage_.text(i.b)) : std::string_view());
}

void Machine::report_variable(std::string_view name, double value) {
  const auto found = std::ranges::find(names_.variables, name);
  const auto index = static_cast<std::uint32_t>(found - names_.variables.begin());
  if (found == names_.variables.end()) names_.variables.emplace_back(name);
  changes_.push_back({.variable = index, .value = value});
}

void Machine::report_rare(const Instruction& i) {
  if (i.op == Opcode::report_variable) {
    changes_.push_back({i.b, storage_.reg(i.a)});
  } else if (i.op == Opcode::report_number) {
    const auto number = access_.whole_number(storage_.reg(i.a), 4294967294.0);
    if (number.has_value()) report_variable(variable_name(static_cast<ir::Bank>(i.extra), *number), storage_.reg(i.b));
  } else if (i.op == Opcode::report_element) {
    report_variable(access_.name_of_element(stack_.program(), i.a, i.b), storage_.reg(i.c));
  }
}

void Machine::report_block() {
  options_.observer->block(begun_, changes_);
  changes_.clear();
}

}  // namespace dripfeed::interpreter
