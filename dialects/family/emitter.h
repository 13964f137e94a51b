// Statements of a built program, appended one by one; the program's arenas hold what they say.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include "dialects/ir/program.h"

namespace dripfeed::family {

struct EmittedCode {
  ir::Function function = ir::Function::none;
  std::int16_t argument = 0;
};

struct EmittedWord {
  ir::Address address = ir::Address::x;
  ir::ExpressionId value = ir::ExpressionId::none;
  ir::WordMode mode = ir::WordMode::as_modal;
};

class Emitter {
 public:
  explicit Emitter(ir::Program& program) : program_(program) {}

  // Line of the family's text that what follows comes from.
  void set_line(std::uint32_t line) { line_ = line; }

  void block(std::span<const EmittedCode> codes, std::span<const EmittedWord> words);
  // Functions without arguments.
  void block(std::initializer_list<ir::Function> functions, std::span<const EmittedWord> words);
  void assign(ir::SymbolId target, ir::ExpressionId value, ir::ExpressionId index = ir::ExpressionId::none);
  void open(ir::StatementKind kind, ir::ExpressionId condition);
  void close(ir::StatementKind kind);
  // An empty text clears the message.
  void message(std::string_view text);
  void program_end();
  void subprogram_return();

  // Expressions of the program. Each call makes a new node: nodes are never shared between statements.
  ir::ExpressionId constant(double value) { return program_.add_constant(value); }
  ir::ExpressionId variable(ir::SymbolId symbol, ir::ExpressionId index = ir::ExpressionId::none);
  ir::ExpressionId binary(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b) {
    return program_.add_operator(op, a, b);
  }
  // A symbol that no other name of the program has: `stem`, or stem2, stem3 …
  ir::SymbolId new_symbol(std::string_view stem);

 private:
  void statement(ir::StatementKind kind, std::size_t payload);

  ir::Program& program_;
  std::uint32_t line_ = 0;
};

// The modal group that a function belongs to, for those that families use.
ir::ModalGroup group_of(ir::Function function);

}  // namespace dripfeed::family
