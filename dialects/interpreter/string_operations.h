// Instructions on strings: joining, formatting as the control shows values, comparing, elements of string arrays.
#pragma once

#include "dialects/interpreter/variable_access.h"

namespace dripfeed::interpreter {

class StringOperations {
 public:
  StringOperations(Storage& storage, VariableAccess& access, RunReport& report)
      : storage_(storage), access_(access), report_(report) {}

  // Carries out a string instruction; false when the run has ended.
  bool execute(const Instruction& i, const CompiledProgram& program);

 private:
  bool to_number(const Instruction& i);
  bool load_element(const Instruction& i, const CompiledProgram& program);
  bool store_element(const Instruction& i, const CompiledProgram& program);
  bool fit(const Instruction& i);
  void append_number(std::string& to, double value, ir::ValueType type);

  Storage& storage_;
  VariableAccess& access_;
  RunReport& report_;
  std::string scratch_;
};

constexpr bool is_string_opcode(Opcode op) { return op >= Opcode::string_copy && op <= Opcode::string_fit; }

}  // namespace dripfeed::interpreter
