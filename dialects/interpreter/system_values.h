// System variables that the modal state can answer. What only the machine knows is not made up: it was written before,
// came with the start values, or is reported as not known.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "dialects/interpreter/block_rules.h"
#include "dialects/interpreter/shared_data.h"
#include "dialects/ir/control.h"

namespace dripfeed::interpreter {

// What the modal state answers for a system variable that has a name; nothing when it is not known. Axes are indexed by
// their number in the trace.
std::optional<double> answer_system(const ir::Control& control, const ir::SystemVariableRow& row,
                                    const Indices& indices, const ModalState& state);

class SystemValues {
 public:
  explicit SystemValues(const ir::Control& control) : control_(control) {}

  // `row` of the control's table (kNoRow without one); `number` of a numbered variable, index of a named one. Nothing
  // when it is not known.
  [[nodiscard]] std::optional<double> read(std::uint32_t row, std::uint32_t number, const ModalState& state) const;
  void write(std::uint32_t row, std::uint32_t number, double value);

 private:
  [[nodiscard]] std::optional<double> active_code(std::uint32_t group, const ModalState& state) const;

  const ir::Control& control_;
  std::unordered_map<std::uint64_t, double> written_;
};

}  // namespace dripfeed::interpreter
