// A call opens the new registers while the caller's are still in force, passes the arguments across, and then switches.
#include "dialects/interpreter/machine/call_stack.h"

#include <algorithm>
#include <cmath>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/bytecode/jump_target.h"
#include "dialects/interpreter/motion/events.h"
#include "dialects/interpreter/state/axis_names.h"
#include "dialects/ir/alarm_details.h"
#include "dialects/ir/repetition.h"
#include "dialects/ir/sections.h"
#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

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
  if (program_->rules != entered_rules_) enter_language();
  if (!program_->keeps_place) out_.place.program = program_->index;
}

// What a modal cycle or call of one language does in the other no manual at hand says.
void CallStack::enter_language() {
  const bool cycle = state_.drilling.active || state_.turning.active || has_modal();
  if (entered_rules_ != nullptr && program_->rules->semantics.incremental_letters_uvw && !state_.modes.absolute)
    report_.count({.name = "increments (G91) where the control's other language has them by U and W"});
  if (entered_rules_ != nullptr && (cycle || state_.modes.polar_words)) {
    report_.count({.name = cycle ? "a modal cycle or call that continues in the control's other language"
                                 : "polar words (G16) that go on in the control's other language"});
    state_.unknown = kAllAxes;
  }
  entered_rules_ = program_->rules;
  rules_ = *entered_rules_;
}

bool CallStack::is_unknown_call(const Instruction& i) const {
  const CallSite& site = program_->calls[i.a];
  if (site.number != Operand::none) return is_unknown(storage_.reg(raw_of(site.number)), context_.control.semantics);
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

bool CallStack::enter_part(const Instruction& i, CompiledProgram& part, std::uint32_t next) {
  if (frames_.size() > context_.limits.call_depth) return report_.fail_limit(i, "call depth");
  Frame& frame = push(part, next, false);
  frame.is_part = true;
  ++parts_;
  enter(frame);
  return true;
}

namespace {

// O1234, and no name of a file.
bool is_number_name(std::string_view name) {
  return name.size() > 1 && name.front() == 'O' && name.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

}  // namespace

CallStack::Target CallStack::look_up(CallSite& site) {
  if (site.itself) return {program_, {}};
  if (site.text != Operand::none) {
    const std::string name = text::upper_case(std::string(ir::program_name_of_path(storage_.text(raw_of(site.text)))));
    return {programs_.find(name, *program_, site.in_other_language), name};
  }
  if (site.number == Operand::none) {
    if (site.target == nullptr) site.target = programs_.find(site.name, *program_, site.in_other_language);
    const auto detail = is_number_name(site.name) ? ir::AlarmDetail::none : ir::AlarmDetail::by_name;
    return {site.target, site.name, detail};
  }
  const double number = context_.arithmetic.round(value_or_zero(storage_.reg(raw_of(site.number))));
  if (!(number >= 0.0 && number <= 99999999.0)) return {nullptr, "of that number"};
  std::string digits = std::to_string(static_cast<std::uint32_t>(number));
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  return {programs_.find("O" + digits, *program_, site.in_other_language), "O" + digits};
}

CompiledProgram* CallStack::find_program(const Instruction& i, CallSite& site) {
  const Target target = look_up(site);
  if (target.program == nullptr) report_.fail(i, DiagnosticId::call_target_missing, {target.name}, target.detail);
  return target.program;
}

std::optional<std::string> CallStack::missing_target(const Instruction& i) {
  Target target = look_up(program_->calls[i.a]);
  if (target.program != nullptr) return std::nullopt;
  return std::move(target.name);
}

// PGA, "Indirect subprogram call with specification of the calling program part": whether the block of the last label
// runs, as with REPEAT, it does not say.
std::optional<CallStack::Part> CallStack::find_part(const Instruction& i, const CallSite& site,
                                                    const CompiledProgram& whole) {
  const ir::Program& text = *whole.source;
  const ir::Section range = ir::section_at(text, whole.section);
  const std::string first_name = text::upper_case(storage_.text(raw_of(site.first_label)));
  const std::string last_name = text::upper_case(storage_.text(raw_of(site.last_label)));
  const auto first = ir::labelled_block(text, range, first_name);
  const auto last = ir::labelled_block(text, range, last_name);
  if (!first || !last || last->last < first->first) {
    const std::string& missing = first ? last_name : first_name;
    const std::string place = first && last ? " after " + first_name : "";
    report_.fail(i, DiagnosticId::jump_target_missing,
                 {is_unknown(missing) ? "of a text that is not known" : missing + place});
    return std::nullopt;
  }
  if (!text.symbols.empty())
    report_.count({.name = "the variables that a program defines before the part of it that is called"});
  if (!last->is_bare) report_.count({.name = "whether CALL BLOCK runs the block of its last label"});
  CompiledProgram& part = programs_.part_of(whole, last->last);
  return Part{&part, find_text(part, first_name, 0, ir::JumpSearch::both)};
}

// Nesting is the control's limit and an alarm; depth is the run's.
bool CallStack::has_room(const Instruction& i, bool macro) {
  const auto subprograms = static_cast<std::uint32_t>(frames_.size() - 1) - macros_ - parts_;
  // A control without macros of its own counts them with its subprograms (G65 in SINUMERIK's ISO mode).
  const bool together = !ir::has_numbered_variables(context_.control);
  const std::uint32_t depth = (together ? macros_ + subprograms : macro ? macros_ : subprograms) + 1;
  const std::uint32_t nesting =
      macro && !together ? context_.control.limits.macro_nesting : context_.control.limits.call_nesting;
  if (nesting > 0 && depth > nesting)
    return report_.fail(i, DiagnosticId::call_nesting_too_deep, {std::to_string(depth), std::to_string(nesting)},
                        macro ? ir::AlarmDetail::macro_call : ir::AlarmDetail::none);
  if (frames_.size() > context_.limits.call_depth) return report_.fail_limit(i, "call depth");
  return true;
}

// Opens the frame; it is entered when its arguments are there.
CallStack::Frame& CallStack::push(CompiledProgram& target, std::uint32_t next, bool is_macro) {
  Frame& caller = frames_.back();
  caller.next = next;
  caller.line = out_.place.line;
  Frame frame;
  frame.program = &target;
  frame.is_macro = is_macro;
  frame.bases.frame = caller.bases.frame + program_->frame_slots;
  frame.bases.string = caller.bases.string + program_->string_slots;
  frame.bases.local = caller.bases.local + (is_macro ? storage_.local_count() : 0);
  if (target.saves_modal) frame.modes = state_.modes;
  storage_.open_frame(target, frame.bases);
  if (is_macro) {
    storage_.open_locals(frame.bases);
    ++macros_;
  }
  frames_.push_back(frame);
  return frames_.back();
}

std::optional<std::uint32_t> CallStack::call(const Instruction& i, std::uint32_t next) {
  CallSite& site = program_->calls[i.a];
  const bool macro = site.kind == ir::CallKind::macro;
  if (!has_room(i, macro)) return std::nullopt;
  const bool external = site.kind == ir::CallKind::external;
  if (external && std::ranges::any_of(frames_, &Frame::is_external)) {
    report_.fail(i, DiagnosticId::call_nesting_too_deep, {"2", "1"}, ir::AlarmDetail::second_device);
    return std::nullopt;
  }
  CompiledProgram* target = find_program(i, site);
  if (target == nullptr) return std::nullopt;
  std::uint32_t begin = 0;
  if (site.start != Operand::none) {
    const double number = storage_.reg(raw_of(site.start));
    const double whole = is_vacant(number) ? -1.0 : context_.arithmetic.round(number);
    begin = whole < 0.0 || whole > 99999999.0
                ? kNoTarget
                : find_number(*target, static_cast<std::uint32_t>(whole), 0, ir::JumpSearch::both);
    if (begin == kNoTarget) {
      report_.fail(i, DiagnosticId::jump_target_missing, {"N" + text::format_shortest(value_or_zero(number))},
                   ir::AlarmDetail::block_of_call);
      return std::nullopt;
    }
  }
  if (site.first_label != Operand::none) {
    const std::optional<Part> part = find_part(i, site, *target);
    if (!part.has_value()) return std::nullopt;
    target = part->program;
    begin = part->begin;
  }
  if (macro) {
    pass_locals(site, push(*target, next, true).bases);
  } else {
    if (!has_parameters(i, site, *target)) return std::nullopt;
    read_values(site, passing_);
    Frame& pushed = push(*target, next, false);
    pushed.is_external = external;
    if (!pass_parameters(i, passing_, pushed)) return std::nullopt;
  }
  ++out_.work.calls;
  Frame& frame = frames_.back();
  enter(frame);
  return begin;
}

bool CallStack::enter_program(const Instruction& i, CompiledProgram& target, std::uint32_t next) {
  if (!has_room(i, false)) return false;
  enter(push(target, next, false));
  return true;
}

bool CallStack::begin_modal(const Instruction& i, double times) {
  CallSite& site = program_->calls[i.a];
  // G66 nests on the control: both would be called. How deep, and which first, is not carried out here. MCALL has one
  // level: a new call takes the place of the one before.
  if (modal_.has_value() && site.kind == ir::CallKind::macro)
    report_.count({.name = "a modal call (G66) inside another"});
  ModalCall modal;
  modal.kind = site.kind;
  modal.target = find_program(i, site);
  if (modal.target == nullptr) return false;
  if (site.kind == ir::CallKind::macro) {
    for (std::uint32_t n = site.first_argument; n < site.first_argument + site.argument_count; ++n) {
      const CallArgument& argument = program_->arguments[n];
      if (argument.value != Operand::none)
        modal.locals.emplace_back(argument.local, storage_.reg(raw_of(argument.value)));
    }
  } else {
    read_values(site, modal.arguments);
    if (!has_parameters(i, site, *modal.target)) return false;
  }
  modal.times = static_cast<std::uint32_t>(std::fmax(0.0, std::fmin(times, 99999999.0)));
  modal_ = std::move(modal);
  return true;
}

std::optional<std::uint32_t> CallStack::call_modal(const Instruction& i, std::uint32_t next) {
  if (modal_->times == 0) return next;
  const bool macro = modal_->kind == ir::CallKind::macro;
  if (!has_room(i, macro)) return std::nullopt;
  Frame& frame = push(*modal_->target, next, macro);
  ++out_.work.calls;
  frame.is_modal = true;
  frame.times_left = modal_->times - 1;
  ++modal_frames_;
  if (macro)
    set_locals(frame.bases);
  else if (!pass_parameters(i, modal_->arguments, frame))
    return std::nullopt;
  enter(frame);
  return 0;
}

void CallStack::set_locals(const Bases& bases) {
  for (const auto& [number, value] : modal_->locals) {
    const Slot slot = context_.variables.find(ir::Bank::hash, number);
    if (slot.kind == SlotKind::local) storage_.local_at(bases.local + slot.index) = value;
  }
}

void CallStack::pass_locals(const CallSite& site, const Bases& bases) {
  for (std::uint32_t n = site.first_argument; n < site.first_argument + site.argument_count; ++n) {
    const CallArgument& argument = program_->arguments[n];
    const Slot slot = context_.variables.find(ir::Bank::hash, argument.local);
    if (argument.value != Operand::none && slot.kind == SlotKind::local)
      storage_.local_at(bases.local + slot.index) = storage_.reg(raw_of(argument.value));
  }
}

void CallStack::read_values(const CallSite& site, std::vector<PassedValue>& values) const {
  values.assign(site.argument_count, {});
  for (std::uint32_t n = 0; n < site.argument_count; ++n) {
    const CallArgument& argument = program_->arguments[site.first_argument + n];
    if (argument.value == Operand::none) continue;
    PassedValue& value = values[n];
    value.given = true;
    value.is_string = argument.is_string;
    if (argument.is_string)
      value.text = storage_.text(raw_of(argument.value));
    else
      value.number = storage_.reg(raw_of(argument.value));
    if (!argument.is_string && argument.text != Operand::none) value.shared_text = storage_.text(raw_of(argument.text));
    if (argument.reference != Operand::none) value.reference = storage_.reg(raw_of(argument.reference));
  }
}

bool CallStack::has_parameters(const Instruction& i, const CallSite& site, const CompiledProgram& target) {
  const std::vector<Parameter>& parameters = target.parameters;
  const auto fail = [&](std::uint32_t given, ir::AlarmDetail detail) {
    return report_.fail(i, DiagnosticId::wrong_argument_count,
                        {site.name, std::to_string(parameters.size()), std::to_string(given)}, detail);
  };
  if (site.argument_count > parameters.size() || site.argument_count > kParametersAtMost)
    return fail(site.argument_count, ir::kTooManyPassed);
  for (std::uint32_t n = 0; n < parameters.size(); ++n) {
    const bool given = n < site.argument_count && program_->arguments[site.first_argument + n].value != Operand::none;
    const bool has_default = !parameters[n].by_reference && parameters[n].type != ir::ValueType::axis;
    if (!given && !has_default) return fail(n, ir::kLeftOut);
  }
  return true;
}

bool CallStack::pass_parameters(const Instruction& i, std::span<const PassedValue> values, Frame& frame) {
  const std::vector<Parameter>& parameters = frame.program->parameters;
  for (std::size_t n = 0; n < values.size() && n < parameters.size(); ++n) {
    if (!values[n].given) continue;
    if (!pass_parameter(i, values[n], parameters[n], n + 1, frame.bases)) return false;
    frame.given.set(n);
  }
  return true;
}

bool CallStack::pass_parameter(const Instruction& i, const PassedValue& value, const Parameter& parameter,
                               std::size_t number, const Bases& bases) {
  const bool wants_string = parameter.type == ir::ValueType::string;
  if (wants_string && value.shared_text.has_value()) {
    storage_.string_at(bases.string + parameter.slot) = *value.shared_text;
    return true;
  }
  if (parameter.type == ir::ValueType::axis && value.is_string && !parameter.by_reference) {
    storage_.frame_at(bases.frame + parameter.slot) =
        is_unknown(value.text) ? kVacant : axis_number(context_.shared, value.text);
    return true;
  }
  if (value.is_string != wants_string)
    return report_.fail(
        i, DiagnosticId::wrong_type,
        {"argument " + std::to_string(number), value.is_string ? "STRING" : "REAL", wants_string ? "STRING" : "REAL"},
        ir::kPassedValue);
  if (wants_string) {
    storage_.string_at(bases.string + parameter.slot) = value.text;
    return true;
  }
  double& to = storage_.frame_at(bases.frame + parameter.slot);
  if (parameter.by_reference) {
    if (!value.reference.has_value())
      return report_.fail(i, DiagnosticId::wrong_type,
                          {"argument " + std::to_string(number), "a value", "a variable (VAR)"}, ir::kPassedReference);
    to = *value.reference;
    return true;
  }
  const Outcome converted = context_.arithmetic.convert(parameter.type, value.number);
  if (converted.fault != Fault::none)
    return report_.fail(i, DiagnosticId::result_overflow, {}, ir::AlarmDetail::whole_numbers);
  to = converted.value;
  return true;
}

std::uint32_t CallStack::go_back() {
  if (Frame& top = frames_.back(); top.is_modal && top.times_left > 0 && modal_.has_value()) {
    --top.times_left;
    ++out_.work.calls;
    storage_.open_frame(*top.program, top.bases);
    if (top.is_macro) {
      storage_.open_locals(top.bases);
      set_locals(top.bases);
    } else {
      (void)pass_parameters({}, modal_->arguments, top);  // they fitted the first time
    }
    enter(top);
    return 0;
  }
  const Frame left = frames_.back();
  frames_.pop_back();
  if (left.is_macro) --macros_;
  if (left.is_part) --parts_;
  Frame& caller = frames_.back();
  enter(caller);
  if (left.is_modal) --modal_frames_;
  out_.place.line = caller.line;
  if (left.program->saves_modal) {
    // Another offset again: how far the two are apart is not known.
    const bool same_offset = state_.modes.work_offset == left.modes.work_offset &&
                             state_.modes.settable_known == left.modes.settable_known &&
                             state_.modes.settable == left.modes.settable;
    if (!same_offset) state_.unknown = kAllAxes;
    state_.modes = left.modes;
    announce(state_, out_);
  }
  return caller.next;
}

}  // namespace dripfeed::interpreter
