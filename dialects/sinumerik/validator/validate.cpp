// The list of checks, and what they share.
#include "dialects/sinumerik/validator/validate.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "dialects/sinumerik/reader/one_per_name.h"
#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

text::Diagnostic& Check::report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) const {
  out.push_back(ir::diagnose(control, id, span, std::move(arguments)));
  return out.back();
}

void Check::report_if_machine(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) const {
  report(id, span, std::move(arguments)).severity =
      control.from_profile ? text::Severity::error : text::Severity::warning;
}

namespace {

// SPF is the ending of subprograms, whatever code ends them.
bool is_subprogram_file(std::string_view name) { return ends_with(name, ".SPF") || ends_with(name, ".CYC"); }

}  // namespace

bool has_code(const ir::Program& program, ir::Function function) {
  return std::ranges::find(program.codes, function, &ir::Code::function) != program.codes.end();
}

bool may_have_caller(const ir::Program& program) {
  if (is_data_file(program)) return true;
  for (const ir::Statement& s : program.statements) {
    if (s.kind == ir::StatementKind::procedure) return true;
    if (s.kind == ir::StatementKind::program_end) return is_subprogram_file(program.source.name());
  }
  return true;
}

namespace {

void check_in_effect(const Check& check) {
  // A text that leaves M6 to a parameter of the machine (MD22550) changes tools by T.
  const facts::Resolved facts(check.program, check.control, facts::ToolChange::as_the_text);
  StatementCheck checks[] = {modal_state_check(check, facts), tools_check(check, facts),
                             compensation_check(check, facts), leftovers_check(check, facts)};
  for (std::uint32_t i = 0; i < check.program.statements.size(); ++i)
    for (StatementCheck& each : checks) each(i);
}

}  // namespace

std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery) {
  std::vector<text::Diagnostic> found;
  const Check check{program, control, delivery, found};
  check_structures(check);
  check_labels(check);
  check_reachability(check);
  check_delivery(check);
  check_names(check);
  check_values(check);
  check_blocks(check);
  check_limits(check);
  check_calls(check);
  check_ranges(check);
  check_definitions(check);
  check_machine_functions(check);
  check_symbols(check);
  check_words(check);
  check_cycles(check);
  check_interpreted(check);
  check_in_effect(check);
  keep_one_per_name(program, found);
  std::ranges::sort(found, {}, [](const text::Diagnostic& d) { return std::tuple(d.span.begin, d.id, d.span.end); });
  return found;
}

}  // namespace dripfeed::sinumerik
