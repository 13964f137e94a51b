// Writes one program's code while it is compiled: instructions with their spans, constants kept once, temporaries by
// stack discipline, failures and reports. What to write is left to the compilers of statements, blocks and expressions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/interpreter/bytecode/bytecode.h"
#include "dialects/interpreter/bytecode/variable_map.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/shared_data.h"

namespace dripfeed::interpreter {

// What every part of the compiler reads.
struct CompileContext {
  const ir::Control& control;
  const BlockRules& rules;
  const Arithmetic& arithmetic;
  const VariableMap& variables;
  const Limits& limits;
  RunNames& names;
  SharedData& shared;
  Changes reported = Changes::none;  // write `report` instructions for them
  std::uint32_t skip_switches = 0;   // as RunOptions
  const ir::PlainStretches* stretches = nullptr;
  [[nodiscard]] bool skips(std::uint8_t level) const { return level != 0 && (skip_switches >> level & 1U) != 0; }
};

class CodeBuilder {
 public:
  CodeBuilder(CompiledProgram& out, const CompileContext& context);

  [[nodiscard]] CompiledProgram& out() { return out_; }
  [[nodiscard]] const CompileContext& context() const { return context_; }
  [[nodiscard]] const ir::Program& source() const { return *out_.source; }
  // nullptr for none: a reader may leave out what it could not read.
  [[nodiscard]] const ir::Expression* find(ir::ExpressionId id) const {
    return id == ir::ExpressionId::none ? nullptr : &source().at(id);
  }
  // The number that an expression writes, with its sign; nullptr when it is no plain number.
  [[nodiscard]] const ir::Expression* find_literal(ir::ExpressionId id) const;

  // Makes room for what a program of plain blocks needs, so that a long one is not copied while it grows.
  void reserve(std::uint32_t statements);
  // Appends and returns the instruction's index.
  std::uint32_t emit(Opcode op, text::Span span, std::uint32_t a = 0, std::uint32_t b = 0, std::uint32_t c = 0,
                     std::uint8_t extra = 0);
  [[nodiscard]] std::uint32_t here() const { return static_cast<std::uint32_t>(out_.code.size()); }
  Instruction& at(std::uint32_t index) { return out_.code[index]; }

  Operand constant(double value);
  Operand text_constant(std::string_view text);

  // A fresh register of the frame. Taken registers are given back all at once, to a mark.
  Operand take();
  Operand take_string();
  struct Mark {
    std::uint32_t numbers;
    std::uint32_t strings;
  };
  [[nodiscard]] Mark mark() const { return {next_number_, next_string_}; }
  void release(Mark mark) { next_number_ = mark.numbers, next_string_ = mark.strings; }

  // An instruction that raises that alarm when it is reached.
  std::uint32_t emit_failure(text::Span span, text::DiagnosticId id, std::vector<std::string> arguments = {},
                             ir::AlarmDetail detail = ir::AlarmDetail::none);
  std::uint32_t add_failure(text::DiagnosticId id, std::vector<std::string> arguments,
                            ir::AlarmDetail detail = ir::AlarmDetail::none);
  // Index of a report, once a name.
  std::uint32_t add_report(std::string_view name, ir::Function function, bool effects_known);
  // Index in RunNames::variables.
  std::uint32_t variable_name_index(std::string_view name);

  Work work;  // of the block that is being compiled

 private:
  CompiledProgram& out_;
  const CompileContext& context_;
  std::uint32_t next_number_;
  std::uint32_t next_string_;
  std::unordered_map<std::uint64_t, Operand> constants_;
  std::unordered_map<std::string, Operand> texts_;
  std::unordered_map<std::string, std::uint32_t> reports_;
};

}  // namespace dripfeed::interpreter
