// Calls to instructions: arguments are computed once, then the call is made as often as it says.
#pragma once

#include <optional>
#include <vector>

#include "dialects/interpreter/bytecode/expression_compiler.h"

namespace dripfeed::interpreter {

class CallCompiler {
 public:
  CallCompiler(CodeBuilder& builder, ExpressionCompiler& expressions) : builder_(builder), expressions_(expressions) {}

  void compile(const ir::Call& call, text::Span span);
  // G66: the arguments are computed here, the calls are made later.
  void compile_modal(const ir::Call& call, text::Span span);

 private:
  // `keep`: in a register of its own, because the program that is called may change the variable before the next time.
  CallArgument compile_argument(const ir::Argument& argument, bool keep);
  // Index of the call site; nothing when its arguments are an alarm, which is then compiled.
  std::optional<std::uint32_t> compile_site(const ir::Call& call, text::Span span, bool keep);
  // Gives the letters of a macro call their local variables; false when a letter has none.
  bool number_arguments(const ir::Call& call, std::uint32_t first);
  // A register with the number of times that are left.
  Operand compile_repeats(const ir::Call& call, text::Span span);

  CodeBuilder& builder_;
  ExpressionCompiler& expressions_;
};

}  // namespace dripfeed::interpreter
