// A call opens the new registers while the caller's are still in force, passes the arguments across, and then switches.
#include "dialects/interpreter/call_stack.h"

#include <algorithm>

#include "dialects/interpreter/axis_names.h"
#include "dialects/interpreter/unknown.h"

namespace dripfeed::interpreter {

using text::DiagnosticId;

void CallStack::start(CompiledProgram& main) {
  frames_.reserve(context_.limits.call_depth + std::size_t{1});
  Frame& frame = frames_.emplace_back();
  frame.program = &main;
  storage_.open_frame(main, frame.bases);
  storage_.open_locals(frame.bases);
  enter(frame);
}

void CallStack::enter(Frame& frame) {
  program_ = frame.program;
  storage_.enter(*program_, frame.bases);
  report_.enter(*program_);
  if (!program_->keeps_place) out_.place.program = program_->index;
}

bool CallStack::is_unknown_call(const Instruction& i) const {
  const CallSite& site = program_->calls[i.a];
  return site.text != Operand::none && is_unknown(storage_.text(raw_of(site.text)));
}

bool CallStack::enter_text(const Instruction& i, CompiledProgram& text, std::uint32_t next) {
  if (frames_.size() > context_.limits.call_depth) return report_.fail_limit(i, "call depth");
  frames_.back().next = next;
  frames_.back().line = out_.place.line;
  Frame frame;
  frame.program = &text;
  frame.bases = frames_.back().bases;
  storage_.make_room(text, frame.bases);
  frames_.push_back(frame);
  enter(frames_.back());
  return true;
}

CompiledProgram* CallStack::find_program(const Instruction& i, CallSite& site) {
  if (site.text != Operand::none) {
    std::string name(ir::program_name_of_path(storage_.text(raw_of(site.text))));
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    CompiledProgram* target = programs_.find(name);
    if (target == nullptr) report_.fail(i, DiagnosticId::call_target_missing, {name});
    return target;
  }
  if (site.number == Operand::none) {
    if (site.target == nullptr) site.target = programs_.find(site.name);
    if (site.target == nullptr) report_.fail(i, DiagnosticId::call_target_missing, {site.name});
    return site.target;
  }
  const double number = context_.arithmetic.round(value_or_zero(storage_.reg(raw_of(site.number))));
  if (!(number >= 0.0 && number <= 99999999.0)) {
    report_.fail(i, DiagnosticId::call_target_missing, {"of that number"});
    return nullptr;
  }
  std::string digits = std::to_string(static_cast<std::uint32_t>(number));
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  CompiledProgram* target = programs_.find("O" + digits);
  if (target == nullptr) report_.fail(i, DiagnosticId::call_target_missing, {"O" + digits});
  return target;
}

// Nesting is the control's limit and an alarm; depth is the run's.
bool CallStack::has_room(const Instruction& i, const CallSite& site) {
  const bool macro = site.kind == ir::CallKind::macro;
  const auto subprograms = static_cast<std::uint32_t>(frames_.size() - 1) - macros_;
  const std::uint32_t depth = (macro ? macros_ : subprograms) + 1;
  const std::uint32_t nesting = macro ? context_.control.limits.macro_nesting : context_.control.limits.call_nesting;
  if (nesting > 0 && depth > nesting)
    return report_.fail(i, DiagnosticId::call_nesting_too_deep, {std::to_string(depth), std::to_string(nesting)});
  if (frames_.size() > context_.limits.call_depth) return report_.fail_limit(i, "call depth");
  return true;
}

bool CallStack::call(const Instruction& i, std::uint32_t next) {
  CallSite& site = program_->calls[i.a];
  if (!has_room(i, site)) return false;
  CompiledProgram* target = find_program(i, site);
  if (target == nullptr) return false;

  Frame& caller = frames_.back();
  caller.next = next;
  caller.line = out_.place.line;
  Frame frame;
  frame.program = target;
  frame.is_macro = site.kind == ir::CallKind::macro;
  frame.bases.frame = caller.bases.frame + program_->frame_slots;
  frame.bases.string = caller.bases.string + program_->string_slots;
  frame.bases.local = caller.bases.local + (frame.is_macro ? storage_.local_count() : 0);
  if (target->saves_modal) frame.modes = state_.modes;

  storage_.open_frame(*target, frame.bases);
  if (frame.is_macro) {
    storage_.open_locals(frame.bases);
    pass_locals(site, frame.bases);
    ++macros_;
  } else if (!pass_parameters(i, site, frame)) {
    return false;
  }
  frames_.push_back(frame);
  enter(frames_.back());
  return true;
}

void CallStack::pass_locals(const CallSite& site, const Bases& bases) {
  for (std::uint32_t n = site.first_argument; n < site.first_argument + site.argument_count; ++n) {
    const CallArgument& argument = program_->arguments[n];
    const Slot slot = context_.variables.find(ir::Bank::hash, argument.local);
    if (argument.value != Operand::none && slot.kind == SlotKind::local)
      storage_.local_at(bases.local + slot.index) = storage_.reg(raw_of(argument.value));
  }
}

bool CallStack::pass_parameters(const Instruction& i, const CallSite& site, Frame& frame) {
  const std::vector<Parameter>& parameters = frame.program->parameters;
  if (site.argument_count > parameters.size() || site.argument_count > kParametersAtMost)
    return report_.fail(i, DiagnosticId::wrong_argument_count,
                        {site.name, std::to_string(parameters.size()), std::to_string(site.argument_count)});
  for (std::uint32_t n = 0; n < parameters.size(); ++n) {
    const bool given = n < site.argument_count && program_->arguments[site.first_argument + n].value != Operand::none;
    if (given) {
      if (!pass_parameter(i, program_->arguments[site.first_argument + n], parameters[n], frame.bases)) return false;
      frame.given.set(n);
    } else if (parameters[n].by_reference) {
      return report_.fail(i, DiagnosticId::wrong_argument_count,
                          {site.name, std::to_string(parameters.size()), std::to_string(n)});
    }
  }
  return true;
}

bool CallStack::pass_parameter(const Instruction& i, const CallArgument& argument, const Parameter& parameter,
                               const Bases& bases) {
  const bool wants_string = parameter.type == ir::ValueType::string;
  if (wants_string && !argument.is_string && argument.text != Operand::none) {
    storage_.string_at(bases.string + parameter.slot) = storage_.text(raw_of(argument.text));
    return true;
  }
  if (parameter.type == ir::ValueType::axis && argument.is_string && !parameter.by_reference) {
    const std::string& name = storage_.text(raw_of(argument.value));
    storage_.frame_at(bases.frame + parameter.slot) = is_unknown(name) ? kVacant : axis_number(context_.shared, name);
    return true;
  }
  if (argument.is_string != wants_string)
    return report_.fail(i, DiagnosticId::wrong_type,
                        {"an argument", argument.is_string ? "STRING" : "REAL", wants_string ? "STRING" : "REAL"});
  if (wants_string) {
    storage_.string_at(bases.string + parameter.slot) = storage_.text(raw_of(argument.value));
    return true;
  }
  double& to = storage_.frame_at(bases.frame + parameter.slot);
  if (parameter.by_reference) {
    if (argument.reference == Operand::none)
      return report_.fail(i, DiagnosticId::wrong_type, {"an argument", "a value", "a variable (VAR)"});
    to = storage_.reg(raw_of(argument.reference));
    return true;
  }
  const Outcome converted = context_.arithmetic.convert(parameter.type, storage_.reg(raw_of(argument.value)));
  if (converted.fault != Fault::none) return report_.fail(i, DiagnosticId::result_overflow);
  to = converted.value;
  return true;
}

std::uint32_t CallStack::go_back() {
  const Frame left = frames_.back();
  frames_.pop_back();
  if (left.is_macro) --macros_;
  Frame& caller = frames_.back();
  enter(caller);
  out_.place.line = caller.line;
  if (left.program->saves_modal) {
    // Another offset again: how far the two are apart is not known.
    if (state_.modes.work_offset != left.modes.work_offset) state_.unknown = kAllAxes;
    state_.modes = left.modes;
    announce(state_, out_);
  }
  return caller.next;
}

}  // namespace dripfeed::interpreter
