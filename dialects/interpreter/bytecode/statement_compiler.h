// Statements to instructions, in the order of the program, and the counting of blocks. Control flow, calls, blocks of
// words and expressions have compilers of their own.
#pragma once

#include <vector>

#include "dialects/interpreter/bytecode/block_compiler.h"
#include "dialects/interpreter/bytecode/call_compiler.h"
#include "dialects/interpreter/bytecode/flow_compiler.h"
#include "dialects/ir/repetition.h"

namespace dripfeed::interpreter {

class StatementCompiler {
 public:
  explicit StatementCompiler(CodeBuilder& builder);
  // All statements of the program, and what happens at the end of its text. It returns after that statement, too.
  void compile(std::uint32_t returns_after = ir::kNoIndex);
  // The statements [first, last), and a return from the foreign part that they are.
  void compile_part(std::uint32_t first, std::uint32_t last);

 private:
  using Compile = void (StatementCompiler::*)(const ir::Statement&);
  struct Row {
    ir::StatementKind kind;
    Compile compile;
  };
  static const Row kRows[];

  void compile_statements(std::uint32_t first, std::uint32_t last, std::uint32_t returns_after);
  // The stretches that run before a statement of the main program.
  void compile_stretches(std::uint32_t statement);
  // Around the statements that keep a foreign part as written.
  bool begin_foreign_part(std::uint32_t statement);
  void end_foreign_part(std::uint32_t statement);
  void compile_statement(std::uint32_t index);
  [[nodiscard]] bool is_left_out(const ir::Statement& statement) const;
  void compile_block(const ir::Statement& statement);
  void compile_assign(const ir::Statement& statement);
  void compile_define(const ir::Statement& statement);
  void compile_procedure(const ir::Statement& statement);
  void compile_call(const ir::Statement& statement);
  void compile_return(const ir::Statement& statement);
  void compile_return_to(const ir::Statement& statement);
  void compile_modal_call(const ir::Statement& statement);
  void compile_modal_call_end(const ir::Statement& statement);
  void compile_output(const ir::Statement& statement);
  void compile_program_end(const ir::Statement& statement);
  void compile_message(const ir::Statement& statement);
  void compile_alarm(const ir::Statement& statement);
  void compile_native(const ir::Statement& statement);
  void compile_repeat(const ir::Statement& statement);
  void compile_text(const ir::Statement& statement);
  void compile_nothing(const ir::Statement& statement);

  void begin_block(const ir::Statement& statement);
  // Puts down the work of the block that was compiled.
  void end_block();

  CodeBuilder& builder_;
  ExpressionCompiler expressions_;
  BlockCompiler blocks_;
  FlowCompiler flow_;
  CallCompiler calls_;
  std::uint32_t block_instruction_ = ir::kNoIndex;
  bool closes_round_ = false;        // the block is the end of a loop, and none for the control
  std::vector<StatementCode> code_;  // by statement, from the first that is compiled
  std::uint32_t next_part_ = 0;      // of the program's foreign ones
  std::uint32_t part_instruction_ = ir::kNoIndex;
  std::uint32_t next_stretch_ = 0;
  std::vector<ir::RepeatedPart> repeated_;  // their place here is their number
};

}  // namespace dripfeed::interpreter
