// Variables that an instruction reaches by a computed number, an index or a reference, and system variables. Each may
// be missing, protected or out of bounds: then the run ends with the control's alarm.
#pragma once

#include <optional>

#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/interpreter/block/data_setting.h"
#include "dialects/interpreter/machine/run_report.h"
#include "dialects/interpreter/machine/storage.h"
#include "dialects/interpreter/machine/system_values.h"

namespace dripfeed::interpreter {

class VariableAccess {
 public:
  VariableAccess(const ir::Control& control, const Arithmetic& arithmetic, const VariableMap& variables,
                 Storage& storage, SharedData& shared, ModalState& state, RunReport& report)
      : control_(control),
        arithmetic_(arithmetic),
        variables_(variables),
        storage_(storage),
        shared_(shared),
        state_(state),
        report_(report),
        system_(control) {}

  // Each is the instruction of that name; false when the run has ended.
  bool load_number(const Instruction& i);
  bool store_number(const Instruction& i);
  bool refer_number(const Instruction& i);
  bool load_element(const Instruction& i, const CompiledProgram& program);
  bool store_element(const Instruction& i, const CompiledProgram& program);
  bool refer_element(const Instruction& i, const CompiledProgram& program);
  bool load_of_row(const Instruction& i, const CompiledProgram& program);
  bool store_in_row(const Instruction& i, const CompiledProgram& program);
  void fill_array(const Instruction& i, const CompiledProgram& program);
  bool load_system(const Instruction& i);
  bool store_system(const Instruction& i);

  // Place in its stack of the element that two registers in a row index; nothing after an alarm.
  std::optional<std::uint32_t> find_element(const Instruction& i, const CompiledProgram& program, std::uint32_t array,
                                            std::uint32_t indices);
  void set_initial(const InitialValue& value);
  // A numbered system variable, as an assignment of the program would.
  void set_system(const DataValue& set);
  void forget_tool_offsets();
  // What a program may have set that was not run.
  void forget_commons();
  // The modes at the start are those of a caller that is not there.
  void forget_modes() { system_.forget_modes(); }
  // One of three registers in a row holds an index that is not known.
  bool has_unknown_index(std::uint32_t indices);
  [[nodiscard]] std::string name_of_element(const CompiledProgram& program, std::uint32_t array, std::uint32_t indices);
  // The value of a numbered variable, for a message; nothing where the control has none or does not say it.
  [[nodiscard]] std::optional<double> peek(ir::Bank bank, std::uint32_t number) const;
  // A whole number from 0 to `last`, rounded as the control does.
  [[nodiscard]] std::optional<std::uint32_t> whole_number(double value, double last) const;

 private:
  struct Found {
    Slot slot;
    std::uint32_t number = 0;
  };
  std::optional<Found> find(const Instruction& i, double number);
  double read_system(std::uint32_t row, std::uint32_t number);
  void write_system(std::uint32_t row, std::uint32_t number, double value);
  [[nodiscard]] std::string system_name(std::uint32_t row, std::uint32_t number) const;
  double& at(const Slot& slot);
  [[nodiscard]] bool is_unknown(double value) const { return interpreter::is_unknown(value, control_.semantics); }
  bool forget_bank(const Instruction& i);
  double* find_in_row(const Instruction& i, const CompiledProgram& program, std::uint32_t array, double index);
  void fill(const Array& array, double value);

  const ir::Control& control_;
  const Arithmetic& arithmetic_;
  const VariableMap& variables_;
  Storage& storage_;
  SharedData& shared_;
  ModalState& state_;
  RunReport& report_;
  SystemValues system_;
};

}  // namespace dripfeed::interpreter
