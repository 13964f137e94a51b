// A program: its text, the tokens that tile it, the statements in order, and the arenas that they point into.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dialects/ir/expression.h"
#include "dialects/ir/statement.h"
#include "dialects/ir/token.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::ir {

// Strings of a program, each kept once: names, comments, message parts.
class StringTable {
 public:
  StringId add(std::string_view text);
  [[nodiscard]] StringId find(std::string_view text) const;  // none when it was never added
  [[nodiscard]] std::string_view at(StringId id) const;      // "" for none

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  std::vector<std::string> texts_;
  std::unordered_map<std::string, StringId, Hash, std::equal_to<>> ids_;
};

struct Program {
  bool is_standard = false;  // a cycle that the control brings along: what it does is done by the block that calls it
  bool is_data = false;      // declares data or sets it: the text's end is its end
  std::string name;          // "O0002", "TURNING_CYCLE", file name without folder; empty when unknown
  text::Source source;       // empty for a program that was built, not read
  std::vector<Token> tokens;
  std::vector<Statement> statements;

  std::vector<Block> blocks;
  std::vector<Code> codes;
  std::vector<Word> words;
  std::vector<Assign> assigns;
  std::vector<Jump> jumps;
  std::vector<Structure> structures;
  std::vector<Call> calls;
  std::vector<Argument> arguments;
  std::vector<Message> messages;
  std::vector<Native> natives;
  std::vector<Output> outputs;
  std::vector<OutputPart> output_parts;
  std::vector<Section> sections;  // empty: all statements are one program
  std::vector<Repeat> repeats;
  std::vector<ForeignPart> foreign_parts;  // in order
  std::vector<Expression> expressions;
  std::vector<Variable> variables;
  std::vector<Symbol> symbols;
  std::vector<Label> labels;
  StringTable strings;

  [[nodiscard]] const Expression& at(ExpressionId id) const { return expressions[static_cast<std::uint32_t>(id)]; }
  [[nodiscard]] const Variable& at(VariableId id) const { return variables[static_cast<std::uint32_t>(id)]; }
  [[nodiscard]] const Symbol& at(SymbolId id) const { return symbols[static_cast<std::uint32_t>(id)]; }
  [[nodiscard]] std::span<const Code> codes_of(const Block& b) const {
    return std::span(codes).subspan(b.first_code, b.code_count);
  }
  [[nodiscard]] std::span<const Word> words_of(const Block& b) const {
    return std::span(words).subspan(b.first_word, b.word_count);
  }
  [[nodiscard]] std::span<const Argument> arguments_of(const Call& c) const {
    return std::span(arguments).subspan(c.first_argument, c.argument_count);
  }

  // Each adds to its arena and returns where.
  ExpressionId add(const Expression& expression);
  VariableId add(const Variable& variable);
  SymbolId add(const Symbol& symbol);
  ExpressionId add_constant(double value, text::Span span = {}, bool has_point = true);
  ExpressionId add_operator(Operator op, ExpressionId a, ExpressionId b = ExpressionId::none, text::Span span = {});
  ExpressionId add_variable(const Variable& variable);
};

// The name of a program by a path as SINUMERIK writes it: "/_N_WKS_DIR/_N_X_WPD/_N_GROOVE_SPF" is GROOVE, as are
// "A:/parts/GROOVE.SPF" and "GROOVE".
std::string_view program_name_of_path(std::string_view path);

// How many operands an operator takes (0 for leaves).
int operand_count(Operator op);

// Whether the statement came from one of the program's parts in another language.
bool is_foreign(const Program& program, std::uint32_t statement);

// The tokens one after the other: the text of the program byte for byte, whatever it was read from.
std::string print_same(const Program& program);

// Sets Structure::partner of every opener and closer by matching them in order. What does not match keeps kNoIndex and
// is returned by statement index, for the dialect to report with its own alarm.
std::vector<std::uint32_t> match_structures(Program& program);

// Of the last statement in [first, last) that says something; empty without one.
text::Span span_of_last(const Program& program, std::uint32_t first, std::uint32_t last);

}  // namespace dripfeed::ir
