// What cannot run while the text is fed: the control has only its reload buffer, so loops and jumps back find nothing.
// A jump forward works as far as its target is in the buffer; IF, ELSE, ENDIF and calls work always.
#include "dialects/facts/flow_graph.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

std::string_view loop_word(StatementKind kind) {
  switch (kind) {
    case StatementKind::while_begin: return "WHILE";
    case StatementKind::repeat_begin: return "REPEAT";
    case StatementKind::for_begin: return "FOR";
    case StatementKind::loop_begin: return "LOOP";
    case StatementKind::empty:
    case StatementKind::block:
    case StatementKind::assign:
    case StatementKind::go_to:
    case StatementKind::if_begin:
    case StatementKind::else_begin:
    case StatementKind::if_end:
    case StatementKind::while_end:
    case StatementKind::repeat_end:
    case StatementKind::for_end:
    case StatementKind::loop_end:
    case StatementKind::define:
    case StatementKind::call:
    case StatementKind::procedure:
    case StatementKind::declaration:
    case StatementKind::subprogram_return:
    case StatementKind::return_to:
    case StatementKind::modal_call:
    case StatementKind::modal_call_end:
    case StatementKind::output:
    case StatementKind::program_end:
    case StatementKind::message:
    case StatementKind::alarm:
    case StatementKind::native:
    case StatementKind::execute_text: return {};
    case StatementKind::repeat_section: return "REPEAT";
  }
  return {};
}

void check_jump(const Check& check, std::uint32_t i) {
  const ir::Statement& s = check.program.statements[i];
  const ir::Jump& jump = check.program.jumps[s.payload];
  const std::uint32_t target = facts::target_of(check.program, i);
  // A target that is missing is reported as such.
  if (target == ir::kNoIndex && jump.computed == ir::ExpressionId::none) return;
  const bool forward = target != ir::kNoIndex ? target > i : jump.search == ir::JumpSearch::forward;
  text::Diagnostic& d =
      check.report(DiagnosticId::not_in_drip_mode, s.span, {forward ? "a jump forward" : "a jump back"});
  if (forward) d.severity = text::Severity::warning;
}

}  // namespace

void check_delivery(const Check& check) {
  if (check.delivery != ir::Delivery::drip) return;
  std::uint32_t last_line = 0;
  for (std::uint32_t i = 0; i < check.program.statements.size(); ++i) {
    const ir::Statement& s = check.program.statements[i];
    const bool first_of_line = s.line != last_line;
    if (const std::string_view word = loop_word(s.kind); !word.empty())
      check.report(DiagnosticId::not_in_drip_mode, s.span, {std::string(word)});
    if (s.kind == StatementKind::go_to && first_of_line) {
      check_jump(check, i);
      last_line = s.line;  // the branches of one CASE are reported once
    }
    if (s.kind == StatementKind::native) {
      const std::string_view name = check.native_name(s);
      if (name == "GOTOS" || name == "REPEAT" || name == "REPEATB")
        check.report(DiagnosticId::not_in_drip_mode, s.span, {std::string(name)});
    }
  }
}

}  // namespace dripfeed::sinumerik
