// Instructions on strings: joining, formatting as the control shows values, comparing, elements of string arrays.
#pragma once

#include "dialects/interpreter/machine/variable_access.h"

namespace dripfeed::interpreter {

class StringOperations {
 public:
  StringOperations(const ir::Control& control, Storage& storage, VariableAccess& access, SharedData& shared,
                   RunReport& report)
      : storage_(storage),
        access_(access),
        shared_(shared),
        report_(report),
        unset_is_unknown_(control.semantics.unset_is_unknown) {}

  // Carries out a string instruction; false when the run has ended.
  bool execute(const Instruction& i, const CompiledProgram& program);

 private:
  bool to_number(const Instruction& i);
  bool load_element(const Instruction& i, const CompiledProgram& program);
  bool store_element(const Instruction& i, const CompiledProgram& program);
  bool fit(const Instruction& i);
  bool join_fails(const Instruction& i);
  bool to_axis(const Instruction& i);
  bool to_value(const Instruction& i);
  bool find(const Instruction& i);
  bool part(const Instruction& i);
  void append_number(std::string& to, double value, ir::ValueType type);

  Storage& storage_;
  VariableAccess& access_;
  SharedData& shared_;
  RunReport& report_;
  bool unset_is_unknown_;
  std::string scratch_;
};

constexpr bool is_string_opcode(Opcode op) { return op >= Opcode::string_copy && op <= Opcode::string_fit; }

}  // namespace dripfeed::interpreter
