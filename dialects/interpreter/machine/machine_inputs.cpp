// What a run takes from outside its program: definition files, a state, parameters and feed of a caller that is not
// there; and which inputs it lacked.
#include <algorithm>
#include <array>
#include <bitset>
#include <set>
#include <vector>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/machine/machine.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/ir/sections.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

std::string describe_value(double value, const ir::Semantics& semantics) {
  if (is_unknown(value, semantics)) return "not known";
  return is_vacant(value) ? "vacant" : text::format_shortest(value);
}

// The places that name a local variable which the text never sets, or sets only after it was named.
std::vector<const ir::Variable*> unset_arguments(const ir::Program& program) {
  constexpr std::uint32_t kHighestArgument = 33;
  const auto is_argument = [](const ir::Variable& v) {
    return v.bank == ir::Bank::hash && v.index == ir::ExpressionId::none && v.number <= kHighestArgument;
  };
  std::bitset<kHighestArgument + 1> is_set = 1;  // #0 is no argument
  std::array<std::uint32_t, kHighestArgument + 1> named_at;
  named_at.fill(~0U);
  for (const ir::Variable& variable : program.variables)
    if (is_argument(variable)) named_at[variable.number] = std::min(named_at[variable.number], variable.span.begin);
  for (const ir::Assign& assign : program.assigns) {
    const ir::Variable& target = program.at(assign.target);
    if (is_argument(target) && target.span.begin == named_at[target.number]) is_set.set(target.number);
  }
  std::vector<const ir::Variable*> found;
  for (const ir::Variable& variable : program.variables)
    if (is_argument(variable) && !is_set[variable.number]) found.push_back(&variable);
  return found;
}

}  // namespace

// Nothing in a subprogram ends a run; a text that was run while it was read has ended by its end or not at all.
bool Machine::takes_feed_from_caller(const CompiledProgram& main) const {
  if (!control_.semantics.unset_is_unknown) return false;
  if (main.source == nullptr) return report_.result().ended == Ended::text_end;
  if (control_.semantics.has_vacant) return is_called_by_others(main);
  const std::string& name = main.source->source.name();
  if (name.ends_with(".SPF") || name.ends_with(".spf")) return true;
  return std::ranges::none_of(main.source->statements, [](const ir::Statement& statement) {
    return statement.kind == ir::StatementKind::program_end;
  });
}

// A subprogram or macro of a '#' control, run by itself.
bool Machine::is_called_by_others(const CompiledProgram& main) const {
  if (main.source == nullptr) return false;
  return ir::is_subprogram(*main.source, ir::section_at(*main.source, main.section));
}

// Definition files declare the names that programs find in the control.
void Machine::define_shared_data() {
  for (const std::string& name : control_.definition_files)
    if (const ir::Program* definitions = finder_.find(name)) shared_.define(*definitions);
}

// A subprogram that is run by itself takes its parameters, its feed and its speed from a caller that is not there.
void Machine::set_inputs(const CompiledProgram& main) {
  for (const Parameter& parameter : main.parameters) {
    if (parameter.type == ir::ValueType::string)
      storage_.string_at(parameter.slot) = kUnknownText;
    else
      storage_.frame_at(parameter.slot) = parameter.by_reference ? Storage::refer_shared(shared_.nameless()) : kVacant;
  }
  state_.feed_unknown = state_.speed_unknown = main.has_procedure;
  if (!control_.semantics.has_vacant) return;
  if (!is_called_by_others(main)) return forget_arguments(main);
  for (std::uint32_t i = 0; i < storage_.local_count(); ++i) storage_.local_at(storage_.bases().local + i) = kUnknown;
  state_.feed_unknown = state_.speed_unknown = true;
  access_.forget_modes();
}

// Parameters that the main program names and no one has set by the end; those that it sets itself from what is not
// known are not inputs of their own on a control where every variable is one by number.
void Machine::name_unset_inputs(const CompiledProgram& main) {
  if (main.source == nullptr) return;
  const bool by_hash = control_.semantics.has_vacant;
  std::set<std::uint32_t> assigned;
  if (by_hash)
    for (const ir::Assign& assign : main.source->assigns)
      assigned.insert(main.source->variables[static_cast<std::uint32_t>(assign.target)].number);
  for (const ir::Variable& variable : main.source->variables) {
    if (variable.bank != (by_hash ? ir::Bank::hash : ir::Bank::r) || variable.index != ir::ExpressionId::none) continue;
    if (assigned.contains(variable.number)) continue;
    const Slot slot = variables_.find(variable.bank, variable.number);
    const bool is_numbered = slot.kind == SlotKind::global || (by_hash && slot.kind == SlotKind::local);
    if (!is_numbered || !is_unknown(access_.peek(variable.bank, variable.number).value_or(0.0), control_.semantics))
      continue;
    out_.place.program = 0;
    name_input(*main.source, variable);
  }
}

// A program that ends by M30 and reads local variables which it never sets: it is called as a macro after all, or they
// are empty by mistake. Where what is not given counts as unknown, neither is claimed.
void Machine::forget_arguments(const CompiledProgram& main) {
  if (!control_.semantics.unset_is_unknown || main.source == nullptr) return;
  for (const ir::Variable* variable : unset_arguments(*main.source)) {
    const Slot slot = variables_.find(variable->bank, variable->number);
    if (slot.kind == SlotKind::local) storage_.local_at(storage_.bases().local + slot.index) = kUnknown;
  }
}

// Where a macro ended by an alarm: the local variables that it names, never sets and was not given. Run by itself it
// has no caller to give them.
void Machine::name_missing_arguments() {
  const ir::Program* const source = stack_.program().source;
  if (source == nullptr) return;
  for (const ir::Variable* variable : unset_arguments(*source)) {
    const Slot slot = variables_.find(variable->bank, variable->number);
    if (slot.kind == SlotKind::local && is_vacant(storage_.local_at(storage_.bases().local + slot.index)))
      name_input(*source, *variable);
  }
}

// What the block of the alarm read: "GOTO#149" says little until one knows that #149 has no value.
void Machine::note_values_at_alarm() {
  const ir::Program* const source = stack_.program().source;
  std::vector<RunDiagnostic>& diagnostics = report_.result().diagnostics;
  if (source == nullptr || diagnostics.empty() || diagnostics.back().program != stack_.program().index) return;
  text::Diagnostic& alarm = diagnostics.back().diagnostic;
  const std::uint32_t line = source->source.position(alarm.span.begin).line;
  const auto is_target = [source](const ir::Variable& variable) {
    return std::ranges::any_of(source->assigns, [&](const ir::Assign& assign) {
      return &source->variables[static_cast<std::uint32_t>(assign.target)] == &variable;
    });
  };
  constexpr std::size_t kMostNamed = 8;
  std::set<std::string> named;
  text::DiagnosticNote note;
  for (const ir::Variable& variable : source->variables) {
    if (variable.bank != ir::Bank::hash && variable.bank != ir::Bank::r) continue;
    if (variable.index != ir::ExpressionId::none || source->source.position(variable.span.begin).line != line) continue;
    const std::optional<double> value = access_.peek(variable.bank, variable.number);
    const std::string name = variable_name(variable.bank, variable.number);
    if (!value.has_value() || is_target(variable) || named.size() == kMostNamed || !named.insert(name).second) continue;
    if (named.size() == 1) note.span = variable.span;
    note.text += named.size() == 1 ? "here " : ", ";
    note.text += name + " is " + describe_value(*value, control_.semantics);
  }
  if (!named.empty()) alarm.notes.push_back(std::move(note));
}

void Machine::name_input(const ir::Program& source, const ir::Variable& variable) {
  out_.place.line = source.source.position(variable.span.begin).line;
  report_.count({.name = variable_name(variable.bank, variable.number), .is_input = true});
}

// Where a probe touches in the next measuring move: the variable's name and its axis, "NAME[X]".
bool Machine::set_touch(const InitialValue& value) {
  const std::string head = std::string(ir::name_of_system(control_, ir::SystemValue::skip_position)) + "[";
  const bool names_axis = head.size() > 1 && value.name.starts_with(head) && value.name.size() == head.size() + 2;
  if (!names_axis) return false;
  const std::size_t place = ir::kAxisLetters.find(value.name[head.size()]);
  if (place >= ir::kAxisCount) return false;
  state_.touch[place] = value.value;
  state_.touch_known |= static_cast<std::uint16_t>(1U << place);
  return true;
}

void Machine::set_initial_values(const CompiledProgram& main) {
  for (const InitialValue& value : options_.initial_values) {
    if (value.name.empty()) {
      access_.set_initial(value);
      continue;
    }
    if (set_touch(value)) continue;
    if (main.source == nullptr) continue;  // a stream declares no names
    const ir::Program& source = *main.source;
    bool declared = false;
    for (std::size_t s = 0; s < main.symbols.size(); ++s) {
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

}  // namespace dripfeed::interpreter
