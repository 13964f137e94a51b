// A small control for the tests of what the '#'-variable controls share, and reading with it.
#pragma once

#include <array>
#include <string>

#include "dialects/ir/stage.h"
#include "dialects/macro_b/reader/lex.h"
#include "dialects/macro_b/reader/parse.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

inline const Grammar& test_grammar() {
  static const Grammar kGrammar = {.keywords = common_keywords()};
  return kGrammar;
}

inline ir::Control test_control() {
  using ir::CodeRow;
  using ir::Function;
  using ir::ModalGroup;
  static constexpr auto kG = std::to_array<CodeRow>({
      {"G00", 0, Function::rapid, 0, ModalGroup::motion, ""},
      {"G01", 10, Function::linear, 0, ModalGroup::motion, ""},
      {"G54", 540, Function::work_offset, 1, ModalGroup::work_offset, ""},
      {"G54.1", 541, Function::extended_offset, 0, ModalGroup::work_offset, ""},
      {"G81", 810, Function::not_modelled, 0, ModalGroup::cycle, ""},
  });
  static constexpr auto kM = std::to_array<CodeRow>({
      {"M00", 0, Function::program_stop, 0, ModalGroup::flow, ""},
      {"M03", 30, Function::spindle_cw, 0, ModalGroup::spindle, ""},
      {"M30", 300, Function::program_end_rewind, 0, ModalGroup::flow, ""},
      {"M99", 990, Function::subprogram_end, 0, ModalGroup::flow, ""},
  });
  ir::Control control;
  control.dialect = "test";
  control.title = "test";
  control.g_codes = kG;
  control.m_codes = kM;
  control.variables = {{ir::Bank::hash, 1, 33, ir::VariableUse::local, true},
                       {ir::Bank::hash, 100, 199, ir::VariableUse::common, true}};
  return control;
}

inline ir::ReadResult read_text(std::string text, const ir::Control& control = test_control()) {
  ir::ReadResult result;
  result.program.source = text::Source("test.nc", std::move(text));
  lex(result.program.source.text(), test_grammar(), result.program.tokens);
  const auto end = static_cast<std::uint32_t>(result.program.source.text().size());
  result.program.tokens.push_back({ir::TokenKind::eob, {end, end}});
  Parser(result.program, control, test_grammar(), result.diagnostics).run();
  result.program.tokens.pop_back();
  return result;
}

}  // namespace dripfeed::macro_b
