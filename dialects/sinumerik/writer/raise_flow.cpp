// Jumps get the word that says where their target lies; called programs get names that SINUMERIK can call; alarms get
// numbers of the user's range; what only the other control understands cannot stay.
#include <algorithm>
#include <cctype>

#include "dialects/facts/flow_graph.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/walk.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;

constexpr double kFirstUserAlarm = 65'000.0;
constexpr double kLastUserAlarm = 69'999.0;

void raise_jump(const Raising& raising, std::uint32_t i) {
  ir::Program& program = raising.program;
  const ir::Statement& s = program.statements[i];
  ir::Jump& jump = program.jumps[s.payload];
  if (jump.computed != ir::ExpressionId::none)
    return raising.cannot(passes::computed("a jump to a computed block number"), s.span);
  const std::uint32_t target = facts::target_of(program, i);
  if (target == ir::kNoIndex) {
    if (!jump.tolerant)
      raising.report(text::DiagnosticId::jump_target_missing, s.span, {"N" + std::to_string(jump.number)});
    return;
  }
  const ir::JumpSearch wanted = target > i ? ir::JumpSearch::forward : ir::JumpSearch::backward;
  if (jump.search == wanted) return;
  jump.search = wanted;
  // GOTOB takes the nearest label above; a number that stands twice may lead elsewhere.
  if (facts::target_of(program, i) != target)
    raising.cannot(passes::of_call("a jump to a block number that stands twice"), s.span);
}

constexpr std::uint32_t kLastLocal = 33;

bool uses_locals(const ir::Program& program) {
  return std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    return std::ranges::any_of(passes::variables_of(program, s), [&](const passes::VariableUseAt& use) {
      const ir::Variable& v = program.at(use.variable);
      return v.bank == ir::Bank::hash && v.number >= 1 && v.number <= kLastLocal;
    });
  });
}

// O9010 is not a name here, L9010 is. R parameters are the same in both; a macro has local variables of its own.
void raise_call(const Raising& raising, const ir::Statement& s, bool locals) {
  ir::Program& program = raising.program;
  ir::Call& call = program.calls[s.payload];
  if (call.number != ir::ExpressionId::none)
    return raising.cannot(passes::computed("a call of a computed program number"), s.span);
  if (call.start != ir::ExpressionId::none)
    return raising.cannot(passes::of_call("a call from a block of the program on"), s.span);
  if (call.first_label != ir::ExpressionId::none)
    return raising.cannot(passes::of_call("a call of a part of a program"), s.span);
  if (call.in_other_language) return raising.cannot(passes::of_call("a call in ISO mode (ISOCALL)"), s.span);
  if (call.kind == ir::CallKind::macro && locals)
    return raising.cannot(
        passes::together("a macro call together with local variables (#1 to #33), which it would overwrite here,"),
        s.span);
  if (s.kind == StatementKind::modal_call && call.repeats != ir::ExpressionId::none)
    return raising.cannot(passes::of_call("a modal call that is repeated"), s.span);
  const std::string name(program.strings.at(call.name));
  if (name.size() > 1 && to_upper(name.front()) == 'O' && is_digit(name[1]))
    call.name = program.strings.add("L" + name.substr(1));
  call.kind = ir::CallKind::subprogram;
}

void raise_alarm(const Raising& raising, const ir::Statement& s) {
  ir::Message& alarm = raising.program.messages[s.payload];
  if (alarm.number == ir::ExpressionId::none) return;
  const ir::Expression number = raising.program.at(alarm.number);
  if (number.op != ir::Operator::constant)
    return raising.cannot(passes::computed("an alarm with a computed number"), s.span);
  const double own = number.value < kFirstUserAlarm ? kFirstUserAlarm + number.value : number.value;
  if (own > kLastUserAlarm) return raising.cannot(passes::of_call("an alarm above 69999"), s.span);
  alarm.number = raising.program.add_constant(own, number.span, false);
}

// M99 alone is M17.
void raise_return(const Raising& raising, std::uint32_t i) { raising.program.statements[i].payload = ir::kNoIndex; }

// M99 P100 is RET("N100").
void raise_return_to(const Raising& raising, const ir::Statement& s) {
  ir::Program& program = raising.program;
  ir::Jump& jump = program.jumps[s.payload];
  if (raising.is_own()) return;
  if (jump.number == ir::kNoIndex)
    return raising.cannot(passes::computed("a return to a computed block of the caller"), s.span);
  ir::Expression target;
  target.op = ir::Operator::string;
  target.string = program.strings.add("N" + std::to_string(jump.number));
  jump.computed = program.add(target);
  jump.number = ir::kNoIndex;
}

// Output to a device is lost without harm to the part.
void leave_out_output(const Raising& raising, std::uint32_t i) {
  ir::Statement& s = raising.program.statements[i];
  raising.cannot(passes::of_value("output to a device"), s.span);
  raising.diagnostics.back().severity = text::Severity::warning;
  s.kind = StatementKind::empty;
  s.payload = ir::kNoIndex;
}

}  // namespace

void raise_flow(const Raising& raising) {
  ir::Program& program = raising.program;
  const bool locals = uses_locals(program);
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement s = program.statements[i];
    if (s.kind == StatementKind::go_to) raise_jump(raising, i);
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) raise_call(raising, s, locals);
    if (s.kind == StatementKind::alarm) raise_alarm(raising, s);
    if (s.kind == StatementKind::return_to) raise_return_to(raising, s);
    if (s.kind == StatementKind::subprogram_return) raise_return(raising, i);
    // Printed as its own word, not as what was written for it.
    if (s.kind == StatementKind::modal_call_end) program.statements[i].span = {};
    if (s.kind == StatementKind::output) leave_out_output(raising, i);
    if (s.kind == StatementKind::repeat_section || s.kind == StatementKind::execute_text)
      raising.cannot(passes::of_call("this block"), s.span);
    if (s.kind == StatementKind::native) {
      const ir::Native& native = program.natives[s.payload];
      const std::string name(program.strings.at(native.name));
      raising.cannot(passes::of_call(name.empty() ? std::string("this block") : name), s.span);
      // What neither moves nor changes state is lost without harm, and said.
      if (native.effects_known && !native.writes && !native.paces)
        raising.diagnostics.back().severity = text::Severity::warning;
      program.statements[i].kind = StatementKind::empty;
      program.statements[i].payload = ir::kNoIndex;
    }
  }
}

}  // namespace dripfeed::sinumerik
