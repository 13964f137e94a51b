// By the main program of the text alone: a subprogram's header sets what the subprogram needs.
#include "dialects/compile/native/header_constants.h"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "dialects/compile/native/native_flow.h"
#include "dialects/compile/native/native_targets.h"
#include "dialects/compile/native/native_variable.h"
#include "dialects/compile/translate/carry_comments.h"
#include "dialects/facts/calls.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

class HeaderReader {
 public:
  HeaderReader(const ir::Program& program, const ir::Control& control) : program_(program), control_(control) {}

  std::vector<HeaderConstant> read() {
    const ir::Section main = main_section(program_);
    bool moved = false;
    for (std::uint32_t i = main.first; i < main.last; ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.payload == ir::kNoIndex) continue;
      moved = moved || moves(s);
      if (s.kind == StatementKind::assign && !moved) assignment(i);
      if (s.kind == StatementKind::define) definition(i);
      if (facts::is_call(s.kind)) call(i);
    }
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool moves(const ir::Statement& s) const {
    if (s.kind != StatementKind::block) return false;
    const auto words = program_.words_of(program_.blocks[s.payload]);
    return std::ranges::any_of(words, [](const ir::Word& word) { return ir::is_axis(word.address); });
  }

  void add(HeaderConstant one, std::uint32_t statement, ir::ExpressionId value) {
    if (value == ir::ExpressionId::none || !is_number(value)) return;
    if (!seen_.insert(one.target).second) return;
    one.statement = statement;
    one.line = program_.statements[statement].line;
    out_.push_back(std::move(one));
  }

  // Also one that find_target() refuses, 1EX2: whoever looks for it gets the reason.
  [[nodiscard]] bool is_number(ir::ExpressionId value) const {
    const ir::Expression& e = program_.at(value);
    return e.op == ir::Operator::constant ||
           (e.op == ir::Operator::negate && program_.at(e.a).op == ir::Operator::constant);
  }

  void assignment(std::uint32_t i) {
    const ir::Assign& assign = program_.assigns[program_.statements[i].payload];
    const ir::Variable& v = program_.at(assign.target);
    if (v.index != ir::ExpressionId::none || v.bank == ir::Bank::system) return;
    HeaderConstant one;
    one.variable = v;
    if (v.bank == ir::Bank::named) {
      name_by(v.symbol, one);
    } else {
      const ir::VariableRange* range = ir::find_variable(control_, v.bank, v.number);
      if (range != nullptr && range->use == ir::VariableUse::system) return;
      one.target = fmt::format("{}{}", v.bank == ir::Bank::r ? "R" : "#", v.number);
      one.name = one.target;
    }
    add(std::move(one), i, assign.value);
  }

  void name_by(ir::SymbolId symbol, HeaderConstant& one) const {
    one.name = program_.strings.at(program_.at(symbol).name);
    one.target = text::upper_case(one.name);
    one.has_own_name = true;
  }

  void definition(std::uint32_t i) {
    const ir::Structure& all = program_.structures[program_.statements[i].payload];
    for (std::uint32_t k = all.first_symbol; k < all.first_symbol + all.symbol_count; ++k) {
      const ir::Symbol& symbol = program_.symbols[k];
      const bool number = symbol.type == ir::ValueType::integer || symbol.type == ir::ValueType::real;
      if (!number || symbol.dimension1 != 0) continue;
      HeaderConstant one;
      one.variable.bank = ir::Bank::named;
      one.variable.symbol = static_cast<ir::SymbolId>(k);
      name_by(one.variable.symbol, one);
      add(std::move(one), i, symbol.initial);
    }
  }

  void call(std::uint32_t i) {
    const ir::Call& c = program_.calls[program_.statements[i].payload];
    const ir::Structure* head = procedure_named(program_, c.name);
    for (std::uint32_t k = 0; head != nullptr && k < std::min(c.argument_count, head->symbol_count); ++k) {
      HeaderConstant one;
      one.variable.bank = ir::Bank::named;
      one.variable.symbol = static_cast<ir::SymbolId>(head->first_symbol + k);
      name_by(one.variable.symbol, one);
      one.target = fmt::format("{}.{}", program_.strings.at(c.name), one.target);
      add(std::move(one), i, program_.arguments[c.first_argument + k].value);
    }
  }

  const ir::Program& program_;
  const ir::Control& control_;
  std::set<std::string> seen_;
  std::vector<HeaderConstant> out_;
};

// Numbers that the statement sets or passes on.
std::uint32_t numbers_of(const ir::Program& program, const ir::Statement& s) {
  if (s.kind == StatementKind::assign) return 1;
  if (s.payload == ir::kNoIndex) return 0;
  if (s.kind == StatementKind::define) return program.structures[s.payload].symbol_count;
  return facts::is_call(s.kind) ? program.calls[s.payload].argument_count : 0;
}

using Tokens = std::vector<ir::Token>::const_iterator;

// Of the first token at or after the offset.
Tokens token_at(const ir::Program& program, std::uint32_t offset) {
  return std::ranges::lower_bound(program.tokens, offset, {}, [](const ir::Token& one) { return one.span.begin; });
}

// The token of the comment after the offset, in its line; the end of all without one.
Tokens comment_after(const ir::Program& program, std::uint32_t offset) {
  for (Tokens token = token_at(program, offset); token != program.tokens.end(); ++token) {
    if (token->kind == ir::TokenKind::eob) break;
    if (token->kind == ir::TokenKind::comment) return token;
  }
  return program.tokens.end();
}

}  // namespace

std::vector<HeaderConstant> header_constants(const ir::Program& program, const ir::Control& control) {
  return HeaderReader(program, control).read();
}

std::string_view comment_on_line(const ir::Program& program, std::uint32_t offset) {
  const Tokens comment = comment_after(program, offset);
  if (comment == program.tokens.end()) return {};
  Tokens first = comment;
  while (first != program.tokens.begin()) {
    const ir::TokenKind before = std::prev(first)->kind;
    if (before == ir::TokenKind::eob || before == ir::TokenKind::comment) break;
    --first;
  }
  std::uint32_t numbers = 0;
  for (const ir::Statement& s : program.statements)
    if (s.span.begin >= first->span.begin && s.span.begin < comment->span.begin) numbers += numbers_of(program, s);
  return numbers > 1 ? std::string_view{} : comment_at(program, offset);
}

std::string_view comment_at(const ir::Program& program, std::uint32_t offset) {
  const Tokens comment = comment_after(program, offset);
  return comment == program.tokens.end() ? std::string_view{}
                                         : text_of_comment(comment->span.in(program.source.text()));
}

}  // namespace dripfeed::compile
