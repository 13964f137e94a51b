// ISO mode's own alarms (Diagnostics Manual, 12700 to 12740), and the one of them that needs the order of the blocks.
#include <string>
#include <vector>

#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/alarms.h"

namespace dripfeed::sinumerik {

namespace {

using ir::AlarmDetail;
using ir::Function;
using ir::StatementKind;
using enum text::DiagnosticId;

// Before those of Siemens mode, which hold for the rest.
constexpr ir::AlarmRow kIsoAlarms[] = {
    {syntax_error, "12710"},
    {address_without_value, "12710"},
    {unknown_address, "12710"},
    {unknown_name, "12710"},
    {missing_operand, "12710"},
    {missing_target, "12710"},
    {missing_bracket, "12710"},
    {unbalanced_bracket, "12710"},
    {value_without_address, "12710"},
    {missing_equals, "12710"},
    {invalid_character, "12710"},
    {expression_without_brackets, "12710"},
    {address_without_value, "12720", AlarmDetail::macro_program},
    {statement_not_alone, "12722", AlarmDetail::second_macro},
    {addresses_exclude, "12726", AlarmDetail::parallel_axes},
    {code_not_in_mode, "12740"},
};

// The modal cycle or macro that is in effect.
class ModalCalls {
 public:
  ModalCalls(const ir::Program& program, const ir::Control& control, std::vector<text::Diagnostic>& found)
      : program_(program), control_(control), found_(found) {}

  void statement(const ir::Statement& s) {
    if (s.kind == StatementKind::block) cycles(program_.blocks[s.payload]);
    if (s.kind == StatementKind::modal_call_end || s.kind == StatementKind::native) active_.clear();
    if (s.kind != StatementKind::modal_call) return;
    if (!active_.empty()) found_.push_back(ir::diagnose(control_, code_not_in_mode, s.span, {"G66", active_}));
    active_ = "G66";
  }

 private:
  void cycles(const ir::Block& block) {
    for (const ir::Code& code : program_.codes_of(block)) {
      if (code.function == Function::drill)
        active_ = std::string(code.span.in(program_.source.text()));
      else if ((code.function == Function::cycle_off || code.group == ir::ModalGroup::motion) && active_ != "G66")
        active_.clear();
    }
  }

  const ir::Program& program_;
  const ir::Control& control_;
  std::vector<text::Diagnostic>& found_;
  std::string active_;
};

}  // namespace

std::span<const ir::AlarmRow> iso_alarms() {
  static const std::vector<ir::AlarmRow> rows = [] {
    std::vector<ir::AlarmRow> all(std::begin(kIsoAlarms), std::end(kIsoAlarms));
    all.insert(all.end(), alarms().begin(), alarms().end());
    return all;
  }();
  return rows;
}

std::vector<text::Diagnostic> validate_iso(const ir::Program& program, const ir::Control& control) {
  std::vector<text::Diagnostic> found;
  ModalCalls calls(program, control, found);
  for (const ir::Statement& s : program.statements) calls.statement(s);
  return found;
}

}  // namespace dripfeed::sinumerik
