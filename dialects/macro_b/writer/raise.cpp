// The order of the steps, and the statements that are neither blocks nor structures.
#include "dialects/macro_b/writer/raise.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/macro_b/writer/complete.h"
#include "dialects/macro_b/writer/drill_levels.h"
#include "dialects/macro_b/writer/flatten.h"
#include "dialects/macro_b/writer/global_data.h"
#include "dialects/macro_b/writer/place_globals.h"
#include "dialects/macro_b/writer/print.h"
#include "dialects/macro_b/writer/raise_block.h"
#include "dialects/macro_b/writer/raise_drilling.h"
#include "dialects/macro_b/writer/raise_frames.h"
#include "dialects/macro_b/writer/raise_parameters.h"
#include "dialects/macro_b/writer/raise_passed.h"
#include "dialects/macro_b/writer/write_other_forms.h"
#include "dialects/passes/allocation.h"
#include "dialects/passes/foreign_variables.h"
#include "dialects/passes/labels.h"
#include "dialects/passes/outside_values.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/safe_start.h"
#include "dialects/passes/structures.h"
#include "dialects/passes/walk.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::StatementKind;

constexpr double kHighestAlarm = 200.0;      // of #3000 = n
constexpr double kForeignAlarms = 65'000.0;  // user alarms of controls that count from there

// L100
bool is_l_number(std::string_view name) {
  return name.size() > 1 && name.front() == 'L' && name.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

class StatementRaiser {
 public:
  StatementRaiser(ir::Program& program, const ir::Control& from, const ir::Control& to,
                  std::vector<text::Diagnostic>& diagnostics)
      : program_(program),
        same_dialect_(from.dialect == to.dialect),
        from_numbers_(ir::has_numbered_variables(from)),
        out_(program),
        blocks_(program, from, to, out_, diagnostics) {}

  void run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      index_ = i;
      statement(program_.statements[i]);
    }
    out_.finish();
  }

 private:
  // By value: the list that it comes from is only read while the new one is written.
  void statement(const ir::Statement& s) {
    switch (s.kind) {
      case StatementKind::block: return blocks_.block(s, index_);
      case StatementKind::call: return call(s);
      case StatementKind::alarm: return alarm(s);
      case StatementKind::message: return message(s);
      case StatementKind::native: return native(s);
      case StatementKind::return_to: return return_to_caller(s);
      case StatementKind::modal_call: return call(s);
      case StatementKind::repeat_section: return blocks_.cannot(s, "a part that is repeated from another loop");
      case StatementKind::execute_text:
        return blocks_.cannot(s, passes::of_value("a text that is executed as a block"));
      case StatementKind::go_to: return jump(s);
      case StatementKind::program_end: return end(s);
      case StatementKind::procedure:  // its parameters are raised
      case StatementKind::declaration: return;
      case StatementKind::subprogram_return:
      case StatementKind::modal_call_end:
      case StatementKind::output:
      case StatementKind::empty:
      case StatementKind::assign:
      case StatementKind::define:
      case StatementKind::if_begin:
      case StatementKind::else_begin:
      case StatementKind::if_end:
      case StatementKind::while_begin:
      case StatementKind::while_end:
      case StatementKind::repeat_begin:
      case StatementKind::repeat_end:
      case StatementKind::for_begin:
      case StatementKind::for_end:
      case StatementKind::loop_begin:
      case StatementKind::loop_end: return out_.keep();
    }
  }

  void jump(const ir::Statement& s) {
    const ir::Jump& jump = program_.jumps[s.payload];
    const bool unbound = jump.label != ir::StringId::none;
    if (unbound && jump.tolerant) return;  // no such label: the program goes on
    if (jump.restart) return blocks_.cannot(s, passes::of_call("a jump to the start of the program"));
    // The value of a variable is a block number for all that have numbered variables; of others it is a text.
    if (jump.computed != ExpressionId::none && !from_numbers_)
      return blocks_.cannot(s, passes::computed("a calculated jump"));
    out_.keep();
  }

  // Block numbers of the caller are the same on all controls that have them.
  void return_to_caller(const ir::Statement& s) {
    const ir::Jump& jump = program_.jumps[s.payload];
    if (jump.label != ir::StringId::none)
      return blocks_.cannot(s, passes::of_call("a return to a label of the caller"));
    if (jump.levels != 1) return blocks_.cannot(s, passes::of_call("a return over several levels"));
    if (jump.computed != ExpressionId::none && !from_numbers_)
      return blocks_.cannot(s, passes::computed("a return to a calculated block"));
    out_.keep();
  }

  void call(const ir::Statement& s) {
    const ir::Call& call = program_.calls[s.payload];
    if (call.computed != ExpressionId::none)
      return blocks_.cannot(s, passes::computed("a call of a program whose name is computed"));
    if (call.in_other_language) return blocks_.cannot(s, passes::of_call("a call in ISO mode (ISOCALL)"));
    if (call.first_label != ExpressionId::none)
      return blocks_.cannot(s, passes::of_call("a call of a part of a program"));
    // Numbered subprograms of other controls keep their number: L100 is O0100.
    const std::string_view name = program_.strings.at(call.name);
    if (!same_dialect_ && is_l_number(name))
      program_.calls[s.payload].name = program_.strings.add("O" + std::string(name.substr(1)));
    out_.keep();
  }

  void alarm(const ir::Statement& s) {
    ir::Message& message = program_.messages[s.payload];
    const ExpressionId number = message.number;
    if (number != ExpressionId::none && program_.at(number).op == ir::Operator::string)
      return blocks_.cannot(s, "a text as the number of an alarm");
    if (!same_dialect_ && number != ExpressionId::none && program_.at(number).op == ir::Operator::constant) {
      const double value = program_.at(number).value;
      const double own = value >= kForeignAlarms ? std::fmod(value - kForeignAlarms, kHighestAlarm) : value;
      message.number = program_.add_constant(own > kHighestAlarm ? 1.0 : own, {}, false);
    }
    keep_written_text(s, message);
    out_.keep();
  }

  void message(const ir::Statement& s) {
    ir::Message& message = program_.messages[s.payload];
    if (message.text == ExpressionId::none && message.number == ExpressionId::none) return;  // clears the line
    keep_written_text(s, message);
    out_.keep();
  }

  // A comment shows no values: of a text that is put together while running the written parts stay.
  void keep_written_text(const ir::Statement& s, ir::Message& message) {
    if (message.text == ExpressionId::none || program_.at(message.text).op == ir::Operator::string) return;
    ir::Expression written;
    written.op = ir::Operator::string;
    written.string = program_.strings.add(written_parts(message.text));
    message.text = program_.add(written);
    blocks_.leave_out(s, passes::of_value("a value in a message"));
  }
  [[nodiscard]] std::string written_parts(ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    if (e.op == ir::Operator::string) return std::string(program_.strings.at(e.string));
    if (e.op == ir::Operator::concatenate) return written_parts(e.a) + written_parts(e.b);
    return "...";
  }

  void native(const ir::Statement& s) {
    const ir::Native& native = program_.natives[s.payload];
    if (same_dialect_ && s.tokens.first != s.tokens.last) return out_.keep();
    const std::string name(program_.strings.at(native.name));
    if (native.smooths || (native.effects_known && !native.writes && !native.paces)) return blocks_.leave_out(s, name);
    blocks_.cannot(s, name);
  }

  // The end's statement has a block that holds its code alone.
  void end(const ir::Statement& s) {
    ir::Function usual = ir::Function::program_end_rewind;
    if (s.payload != ir::kNoIndex && s.payload < program_.blocks.size()) {
      const auto codes = program_.codes_of(program_.blocks[s.payload]);
      if (codes.size() == 1 && codes.front().function == ir::Function::program_end) usual = codes.front().function;
    }
    ir::Block block;
    block.first_code = static_cast<std::uint32_t>(program_.codes.size());
    block.code_count = 1;
    block.first_word = static_cast<std::uint32_t>(program_.words.size());
    ir::Code code;
    code.function = usual;
    code.group = ir::ModalGroup::flow;
    code.letter = 'M';
    code.span = s.span;
    program_.codes.push_back(code);
    program_.blocks.push_back(block);
    out_.emit(s.kind, static_cast<std::uint32_t>(program_.blocks.size() - 1));
  }

  ir::Program& program_;
  bool same_dialect_;
  bool from_numbers_;
  std::uint32_t index_ = 0;
  passes::Rewrite out_;
  BlockRaiser blocks_;
};

void append(std::vector<text::Diagnostic>& to, std::vector<text::Diagnostic> more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// System variables go by name on controls that have names for them; here they have numbers, and none is taken for
// another.
void check_system_variables(const ir::Program& program, const ir::Control& to,
                            std::vector<text::Diagnostic>& diagnostics) {
  for (const ir::Statement& statement : program.statements) {
    for (const passes::VariableUseAt& use : passes::variables_of(program, statement)) {
      const ir::Variable& v = program.at(use.variable);
      if (v.bank != ir::Bank::system) continue;
      const std::string written(v.span.in(program.source.text()));
      diagnostics.push_back(passes::diagnose(passes::of_value("the system variable " + written), v.span, to.title));
    }
  }
}

// What the program leaves to its control's power-on state is stated in front of it. Diameters are no mode here, and
// lathes whose letters say absolute or incremental have no code for it.
void state_power_on_modes(ir::Program& program, const ir::Control& from, const ir::Control& to,
                          std::vector<text::Diagnostic>& diagnostics) {
  passes::UnstatedModes unstated = passes::unstated_modes(program, from, false);
  std::vector<ir::Code> codes;
  for (const passes::UnstatedMode& mode : unstated.modes) {
    const ir::CodeRow* row = find_function(to, mode.function, 0);
    if (row == nullptr) continue;
    ir::Code code;
    code.function = mode.function;
    code.group = mode.group;
    code.letter = row->name.front();
    codes.push_back(code);
  }
  passes::insert_first(program, codes);
  append(diagnostics, std::move(unstated.diagnostics));
}

// What the printer has no words for: texts that are calculated with, operators that nothing above has replaced.
void refuse_unsayable(const ir::Program& program, const ir::Control& to, const Grammar& grammar,
                      std::vector<text::Diagnostic>& diagnostics) {
  for (const ir::Statement& s : program.statements) {
    const bool shows_text = s.kind == StatementKind::message || s.kind == StatementKind::alarm;
    const auto look = [&](ExpressionId id) {
      const ir::Operator op = program.at(id).op;
      if (can_print(grammar, op) || (shows_text && op == ir::Operator::string)) return;
      const std::string_view written = program.at(id).span.in(program.source.text());
      diagnostics.push_back(passes::diagnose(
          passes::of_value(written.empty() ? std::string("a part of an expression") : std::string(written)), s.span,
          to.title));
    };
    passes::for_each_root(
        program, s, [&](ExpressionId root) { passes::for_each_node(program, root, look); },
        [&](ir::VariableId target) { passes::for_each_node(program, program.at(target).index, look); });
  }
}

// R parameters keep what was set last; the variables that they become are empty until a person sets them.
void warn_of_outside_values(std::span<const passes::OutsideValue> outside,
                            std::span<const passes::AllocatedVariable> placed, const ir::Control& to,
                            std::vector<text::Diagnostic>& diagnostics) {
  for (const passes::OutsideValue& value : outside) {
    const auto place = std::ranges::find_if(placed, [&](const passes::AllocatedVariable& v) {
      return v.from_bank == ir::Bank::r && v.from_number <= value.number && value.number < v.from_number + v.count;
    });
    if (place == placed.end()) continue;
    const std::string what =
        fmt::format("the value of R{}, which nothing here sets before it is read (#{}, empty until it is set),",
                    value.number, place->number + value.number - place->from_number);
    diagnostics.push_back(passes::diagnose(what, value.span, to.title));
    diagnostics.back().severity = text::Severity::warning;
  }
}

// T="DRILL" is the number of the tool that the machine's profile has under that name. Others stay, and are refused.
void number_named_tools(ir::Program& program, const ir::Control& to) {
  if (!to.from_profile || to.tool_names.empty()) return;
  for (ir::Word& word : program.words) {
    if (word.address != ir::Address::t || word.value == ExpressionId::none) continue;
    const ir::Expression name = program.at(word.value);
    if (name.op != ir::Operator::string) continue;
    const std::int32_t number = ir::tool_of_name(to, program.strings.at(name.string));
    if (number != 0) word.value = program.add_constant(number, name.span);
  }
}

}  // namespace

ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to,
                      const Grammar& grammar) {
  ir::RaiseResult result{program, {}};
  ir::Program& p = result.program;
  PlacedGlobals globals;
  if (from.dialect != to.dialect) {
    number_named_tools(p, to);
    globals = place_globals(p, to);
    append(result.diagnostics, std::move(globals.diagnostics));
    state_power_on_modes(p, from, to, result.diagnostics);
  }
  append(result.diagnostics, complete_statements(p, to.title));
  if (from.dialect != to.dialect) append(result.diagnostics, raise_drilling(p, from, to));
  if (from.dialect != to.dialect) append(result.diagnostics, drill_levels(p, from, to));
  if (from.dialect != to.dialect) append(result.diagnostics, raise_frames(p, to));
  if (from.dialect != to.dialect) append(result.diagnostics, refuse_global_data(p, globals, to));
  const bool by_number = ir::has_numbered_variables(from);
  passes::AllocationRules rules;
  rules.reserved = std::move(globals.reserved);
  rules.kept = std::move(globals.unplaced);  // reported; no one else is to go without for them
  rules.fixed = std::move(globals.numbers);
  if (from.dialect != to.dialect && !by_number) {
    if (is_l_number(p.name)) p.name = fmt::format("O{:0>4}", p.name.substr(1));
    rules.shares = has_company(p);
    append(result.diagnostics, raise_calls(p, to));
    raise_passed(p, from);
    RaisedParameters parameters = raise_parameters(p, to);
    rules.fixed.merge(parameters.numbers);
    append(result.diagnostics, std::move(parameters.diagnostics));
  }
  passes::FreeNumbers numbers(p, grammar.highest_block_number);
  append(result.diagnostics, passes::number_labels(p, numbers));
  append(result.diagnostics, passes::lower_counted_loops(p, numbers).diagnostics);
  append(result.diagnostics, flatten_expressions(p, from, to, grammar, numbers));
  StatementRaiser(p, from, to, result.diagnostics).run();
  append(result.diagnostics, passes::lower_conditions(p, numbers).diagnostics);
  append(result.diagnostics, passes::lower_logic(p, numbers).diagnostics);
  append(result.diagnostics, passes::limit_loop_nesting(p, numbers, to.limits.loop_nesting).diagnostics);
  if (from.dialect != to.dialect && by_number) append(result.diagnostics, passes::translate_variables(p, from, to));
  const std::vector<passes::OutsideValue> outside = passes::outside_values(p, from, ir::Bank::r);
  passes::AllocationReport placed = passes::allocate_variables(p, from, to, ir::Bank::hash, rules);
  append(result.diagnostics, std::move(placed.diagnostics));
  result.placed = passes::placed_names(placed, ir::Bank::hash);
  if (!by_number) warn_of_outside_values(outside, placed.variables, to, result.diagnostics);
  check_system_variables(p, to, result.diagnostics);
  write_other_forms(p, to, grammar, result.diagnostics);
  if (!text::has_error(result.diagnostics)) refuse_unsayable(p, to, grammar, result.diagnostics);
  for (text::Diagnostic& d : result.diagnostics) d.alarm = ir::alarm_of(to, d.id);
  return result;
}

}  // namespace dripfeed::macro_b
