// Instructions on data of the control: global user data and named system variables, as numbers and as texts. What is
// not known is an input of the run: the report names it, and it stays not known.
#pragma once

#include <optional>

#include "dialects/interpreter/machine/frame_access.h"
#include "dialects/interpreter/machine/variable_access.h"
#include "dialects/interpreter/state/shared_data.h"

namespace dripfeed::interpreter {

class SharedAccess {
 public:
  SharedAccess(const ir::Control& control, Storage& storage, VariableAccess& access, SharedData& shared,
               FrameAccess& frames, ModalState& state, RunReport& report)
      : control_(control),
        storage_(storage),
        access_(access),
        shared_(shared),
        frames_(frames),
        state_(state),
        report_(report) {}

  // Carries out the instruction; false when the run has ended.
  bool execute(const Instruction& i);

 private:
  enum class IndexState : std::uint8_t { known, unknown, failed };
  // The indices of the instruction, within the dimensions that a definition file states.
  IndexState find_indices(const Instruction& i, std::uint32_t id, std::uint32_t registers, Indices& indices);
  bool load(const Instruction& i);
  bool store(const Instruction& i);
  bool load_text(const Instruction& i);
  bool store_text(const Instruction& i);
  bool refer(const Instruction& i);
  [[nodiscard]] std::optional<double> call_argument(const ir::SystemVariableRow& row, const Indices& indices) const;
  [[nodiscard]] std::optional<double> tool_figure(const ir::SystemVariableRow& row, const Indices& indices) const;
  [[nodiscard]] std::optional<double> active_figure(const ir::SystemVariableRow& row, const Indices& indices) const;
  // Of a system variable that the modal state or the machine's tools answer.
  [[nodiscard]] std::optional<double> answer(const Instruction& i, const Indices& indices) const;
  bool may_write(const Instruction& i);
  // Of a tool, at these indices; nullptr: it is not known which or what.
  void take_tool_data(const Instruction& i, const Indices* indices);
  [[nodiscard]] bool is_changed_by_control(const Instruction& i) const;
  void report_input(std::string name);

  const ir::Control& control_;
  Storage& storage_;
  VariableAccess& access_;
  SharedData& shared_;
  FrameAccess& frames_;
  ModalState& state_;
  RunReport& report_;
};

constexpr bool is_shared_opcode(Opcode op) { return op >= Opcode::load_shared && op <= Opcode::refer_shared; }

}  // namespace dripfeed::interpreter
