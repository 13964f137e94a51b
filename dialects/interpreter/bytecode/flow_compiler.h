// Control flow to branches: structures by their partners, jumps by their labels. Targets that are not compiled yet are
// put down and set when all statements are.
#pragma once

#include <span>
#include <vector>

#include "dialects/interpreter/bytecode/expression_compiler.h"

namespace dripfeed::interpreter {

// Instructions of each statement: [begin, end).
struct StatementCode {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

class FlowCompiler {
 public:
  FlowCompiler(CodeBuilder& builder, ExpressionCompiler& expressions) : builder_(builder), expressions_(expressions) {}

  // Compiles the statement when it is of control flow; false when it is something else.
  bool compile(std::uint32_t statement);
  // A jump in a place of its own (M99 P100 jumps in the caller).
  void compile_return_jump(const ir::Jump& jump, text::Span span);
  // REPEAT: back to the first statement of the section; and the end of one, where it goes on at its REPEAT.
  void compile_section_begin(std::uint32_t first, Operand times, std::uint32_t section, text::Span span);
  void compile_section_end(std::uint32_t repeat, std::uint32_t section);
  // Sets all targets; `code` has the statements that were compiled, from `first` on. Fills the program's labels.
  void resolve(std::span<const StatementCode> code, std::uint32_t first);

 private:
  using Compile = void (FlowCompiler::*)(std::uint32_t);
  struct Row {
    ir::StatementKind kind;
    Compile compile;
    ir::StatementKind partner;  // what it needs to be closed or opened by; itself: nothing
    std::string_view name;
  };
  static const Row kRows[];
  static const Row* find_row(ir::StatementKind kind);

  enum class Edge : std::uint8_t { begin, after };
  struct Branch {
    std::uint32_t instruction = 0;
    std::uint32_t statement = 0;
    Edge edge = Edge::begin;
  };
  struct LabelJump {
    std::uint32_t instruction = 0;
    const ir::Jump* jump = nullptr;
  };

  void compile_jump(std::uint32_t index);
  void compile_if(std::uint32_t index);
  void compile_else(std::uint32_t index);
  void compile_nothing(std::uint32_t index);
  void compile_while(std::uint32_t index);
  void compile_while_end(std::uint32_t index);
  void compile_repeat_end(std::uint32_t index);
  void compile_for(std::uint32_t index);
  void compile_for_end(std::uint32_t index);
  void compile_loop_end(std::uint32_t index);

  [[nodiscard]] const ir::Statement& statement(std::uint32_t index) const;
  [[nodiscard]] const ir::Structure& structure(std::uint32_t index) const;
  // Branches to `to` unless the condition holds; no condition always holds.
  void branch_unless(ir::ExpressionId condition, text::Span span, std::uint32_t to, Edge edge);
  void jump_to(Opcode op, text::Span span, std::uint32_t to, Edge edge);
  Operand compile_for_test(const ir::Structure& loop, text::Span span);
  void resolve_branch(const Branch& branch, std::span<const StatementCode> code, std::uint32_t first);
  void resolve_jump(const LabelJump& jump);
  [[nodiscard]] const std::vector<std::uint32_t>* targets_of(const ir::Jump& jump) const;

  CodeBuilder& builder_;
  ExpressionCompiler& expressions_;
  std::vector<Branch> branches_;
  std::vector<LabelJump> jumps_;
};

}  // namespace dripfeed::interpreter
