// The tests for what was left out come first in the program, so that everything after them reads numbers.
#include "dialects/macro_b/writer/raise_parameters.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/sections.h"
#include "dialects/passes/macro_arguments.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/walk.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

bool is_call(StatementKind kind) { return kind == StatementKind::call || kind == StatementKind::modal_call; }

bool changes_modes(const ir::Program& program) {
  return std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    if (is_call(s.kind) || s.kind == StatementKind::native) return true;
    if (s.kind != StatementKind::block) return false;
    return std::ranges::any_of(program.codes_of(program.blocks[s.payload]), [](const ir::Code& c) {
      return c.letter == 'G' && c.group != ir::ModalGroup::non_modal && c.group != ir::ModalGroup::none;
    });
  });
}

class Parameters {
 public:
  Parameters(ir::Program& program, const ir::Control& to) : program_(program), to_(to), out_(program) {}

  RaisedParameters run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      const ir::Statement s = program_.statements[i];
      if (s.kind == StatementKind::procedure && s.payload != ir::kNoIndex)
        head(s);
      else
        out_.keep();
    }
    out_.finish();
    return std::move(result_);
  }

 private:
  void head(const ir::Statement& s) {
    const ir::Structure structure = program_.structures[s.payload];
    if (structure.saves_modal && changes_modes(program_))
      cannot(passes::of_call("SAVE, which gives the caller its modes back,"), s.span);
    if (structure.symbol_count > passes::kArgumentLetters.size())
      return cannot(passes::of_call("a program with more than " + std::to_string(passes::kArgumentLetters.size()) +
                                    " parameters"),
                    s.span);
    for (std::uint32_t i = 0; i < structure.symbol_count; ++i)
      parameter(static_cast<ir::SymbolId>(structure.first_symbol + i), passes::kArgumentLetters[i].number);
    // Its label, and a line for the eye.
    out_.emit(StatementKind::empty, ir::kNoIndex);
  }

  void parameter(ir::SymbolId id, std::uint32_t number) {
    const ir::Symbol symbol = program_.at(id);
    const std::string name(program_.strings.at(symbol.name));
    const bool is_number = symbol.type == ir::ValueType::real || symbol.type == ir::ValueType::integer ||
                           symbol.type == ir::ValueType::boolean;
    if (symbol.by_reference)
      return cannot(passes::of_call("the parameter " + name + ", which gives a value back (VAR),"), symbol.span);
    if (symbol.dimension1 != 0)
      return cannot(passes::of_call("the parameter " + name + ", which is an array,"), symbol.span);
    if (!is_number) return cannot(passes::of_value("the parameter " + name + ", which is not a number,"), symbol.span);
    result_.numbers.emplace(id, number);

    ir::Variable raw;  // without a type: what the caller gave
    raw.bank = ir::Bank::hash;
    raw.number = number;
    ir::Variable typed;
    typed.bank = ir::Bank::named;
    typed.symbol = id;
    ir::Expression vacant;
    vacant.op = Operator::vacant;
    ir::Structure left_out;
    left_out.condition = program_.add_operator(Operator::equal, program_.add_variable(raw), program_.add(vacant));
    out_.emit_structure(StatementKind::if_begin, left_out);
    const ExpressionId initial =
        symbol.initial != ExpressionId::none ? symbol.initial : program_.add_constant(0.0, symbol.span);
    out_.emit_assign(program_.add(raw), initial);
    out_.emit_structure(StatementKind::if_end, {});
    // As the type takes it.
    const ExpressionId given = program_.add_variable(raw);
    if (symbol.type == ir::ValueType::integer)
      out_.emit_assign(program_.add(typed), program_.add_operator(Operator::round, given));
    if (symbol.type != ir::ValueType::boolean) return;
    ir::Structure holds;
    holds.condition = program_.add_operator(Operator::not_equal, given, program_.add_constant(0.0));
    out_.emit_structure(StatementKind::if_begin, holds);
    out_.emit_assign(program_.add(raw), program_.add_constant(1.0));
    out_.emit_structure(StatementKind::if_end, {});
  }

  void cannot(passes::Refusal what, text::Span span) {
    result_.diagnostics.push_back(passes::diagnose(std::move(what), span, to_.title));
  }

  ir::Program& program_;
  const ir::Control& to_;
  passes::Rewrite out_;
  RaisedParameters result_;
};

// Variables that a called program of the same level would share; global data lies where all programs find it.
bool has_own_variables(const ir::Program& program) {
  return std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    return std::ranges::any_of(passes::variables_of(program, s), [&](const passes::VariableUseAt& use) {
      const ir::Variable& v = program.at(use.variable);
      return v.bank == ir::Bank::named && (v.symbol == ir::SymbolId::none || !program.at(v.symbol).is_global);
    });
  });
}

class Calls {
 public:
  Calls(ir::Program& program, const ir::Control& to)
      : program_(program), to_(to), own_variables_(has_own_variables(program)) {}

  std::vector<text::Diagnostic> run() {
    for (const ir::Statement& s : program_.statements)
      if (is_call(s.kind)) call(s);
    return std::move(diagnostics_);
  }

 private:
  void call(const ir::Statement& s) {
    ir::Call& call = program_.calls[s.payload];
    const std::string name(program_.strings.at(call.name));
    if (call.cycle != nullptr) return cannot(name, s.span);
    if (call.argument_count > passes::kArgumentLetters.size())
      return cannot(
          passes::of_call("a call with more than " + std::to_string(passes::kArgumentLetters.size()) + " arguments"),
          s.span);
    bool given = false;
    for (std::uint32_t i = 0; i < call.argument_count; ++i) {
      ir::Argument& argument = program_.arguments[call.first_argument + i];
      if (argument.letter != 0) continue;
      argument.letter = passes::kArgumentLetters[i].letter;
      if (argument.value == ExpressionId::none) continue;
      given = true;
      const ir::Expression& e = program_.at(argument.value);
      if (e.op == Operator::string) cannot(passes::of_value("a text as an argument"), s.span);
      // Without a point it would count increments.
      if (e.op == Operator::constant) argument.value = program_.add_constant(e.value, e.span, true);
    }
    if ((given || own_variables_) && call.kind == ir::CallKind::subprogram) call.kind = ir::CallKind::macro;
  }

  void cannot(passes::Refusal what, text::Span span) {
    diagnostics_.push_back(passes::diagnose(std::move(what), span, to_.title));
  }

  ir::Program& program_;
  const ir::Control& to_;
  bool own_variables_;
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

RaisedParameters raise_parameters(ir::Program& program, const ir::Control& to) { return Parameters(program, to).run(); }

std::vector<text::Diagnostic> raise_calls(ir::Program& program, const ir::Control& to) {
  return Calls(program, to).run();
}

bool has_company(const ir::Program& program) {
  return std::ranges::any_of(program.statements, [](const ir::Statement& s) {
    return is_call(s.kind) || s.kind == StatementKind::procedure || ir::returns(s.kind);
  });
}

}  // namespace dripfeed::macro_b
