// Calls against what EXTERN declares of the called program: how many arguments, which of them by reference, texts and
// numbers. Of other programs nothing is known here; a run that finds them says the rest.
#include <algorithm>

#include "dialects/sinumerik/reader/declared_programs.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

class Calls {
 public:
  explicit Calls(const Check& check) : check_(check) {}

  void run() {
    for (const ir::Statement& s : check_.program.statements)
      if (s.kind == StatementKind::declaration)
        if (auto procedure = declared_program(check_.program, s)) declare(std::move(*procedure), s.span);
    if (procedures_.empty()) return;
    for (const ir::Statement& s : check_.program.statements)
      if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call)
        call(check_.program.calls[s.payload], s.span);
  }

 private:
  // The same list once more says nothing new.
  void declare(DeclaredProgram procedure, text::Span span) {
    const auto found = std::ranges::find(procedures_, procedure.name, &DeclaredProgram::name);
    if (found == procedures_.end()) return procedures_.push_back(std::move(procedure));
    if (found->parameters != procedure.parameters)
      check_.report(DiagnosticId::name_defined_twice, span, {procedure.name}).alarm = "12480";
  }

  void call(const ir::Call& call, text::Span span) {
    if (call.name == ir::StringId::none || call.first_label != ir::ExpressionId::none || call.in_other_language) return;
    const std::string name(check_.program.strings.at(call.name));
    const auto found = std::ranges::find(procedures_, name, &DeclaredProgram::name);
    if (found == procedures_.end()) return;
    const std::vector<DeclaredParameter>& wanted = found->parameters;
    const auto given = check_.program.arguments_of(call);
    if (given.size() > wanted.size()) return count(name, wanted.size(), given.size(), span, "12340");
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const bool left_out = i >= given.size() || given[i].value == ir::ExpressionId::none;
      const auto has_value = [](const ir::Argument& a) { return a.value != ir::ExpressionId::none; };
      const auto values = static_cast<std::size_t>(std::ranges::count_if(given, has_value));
      if (left_out && wanted[i].by_reference) return count(name, wanted.size(), values, span, "12300");
      if (left_out && wanted[i].is_axis) return count(name, wanted.size(), values, span, "12310");
      if (!left_out) argument(wanted[i], given[i].value);
    }
  }

  void count(const std::string& name, std::size_t wanted, std::size_t given, text::Span span, std::string_view alarm) {
    check_.report(DiagnosticId::wrong_argument_count, span, {name, std::to_string(wanted), std::to_string(given)})
        .alarm = alarm;
  }

  void argument(const DeclaredParameter& wanted, ir::ExpressionId value) {
    const ir::Expression& e = check_.program.at(value);
    const std::string written(check_.text_of(e.span));
    if (wanted.by_reference && e.op != ir::Operator::variable)
      check_.report(DiagnosticId::wrong_type, e.span, {written, "a value", "a variable (VAR)"}).alarm = "12320";
    else if (wanted.by_reference && !wanted.is_string)
      dimensions(wanted, e, written);
    else if (!wanted.is_string && e.op == ir::Operator::string && written.starts_with('"'))
      check_.report(DiagnosticId::wrong_type, e.span, {written, "STRING", "a number"}).alarm = "12330";
    else if (wanted.is_string && e.op == ir::Operator::constant)
      check_.report(DiagnosticId::wrong_type, e.span, {written, "REAL", "STRING"}).alarm = "12330";
  }

  // VAR REAL[10] takes a whole array of as many dimensions, VAR REAL one variable.
  void dimensions(const DeclaredParameter& wanted, const ir::Expression& e, const std::string& written) {
    const ir::Variable& v = check_.program.at(e.variable);
    if (v.bank != ir::Bank::named || v.symbol == ir::SymbolId::none) return;
    const ir::Symbol& symbol = check_.program.at(v.symbol);
    if (symbol.span.empty() || symbol.is_parameter) return;
    std::uint32_t given = 0;
    if (v.index == ir::ExpressionId::none)
      for (const std::uint16_t size : {symbol.dimension1, symbol.dimension2, symbol.dimension3})
        given += size > 0 ? 1 : 0;
    if (given == wanted.dimensions) return;
    const auto shape = [](std::uint32_t n) {
      return n == 0 ? std::string("one variable") : std::to_string(n) + "-dimensional";
    };
    check_.report(DiagnosticId::wrong_type, e.span, {written, shape(given), shape(wanted.dimensions)}).alarm = "12360";
  }

  const Check& check_;
  std::vector<DeclaredProgram> procedures_;
};

}  // namespace

void check_calls(const Check& check) { Calls(check).run(); }

}  // namespace dripfeed::sinumerik
