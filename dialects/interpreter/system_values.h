// System variables that the modal state can answer. What only the machine knows is not made up: it was written before,
// came with the start values, or is reported as not known.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "dialects/interpreter/block_rules.h"
#include "dialects/ir/control.h"

namespace dripfeed::interpreter {

class SystemValues {
 public:
  explicit SystemValues(const ir::Control& control) : control_(control) {}

  // `row` of the control's table (kNoRow without one); `number` of a numbered variable, index of a named one. Nothing
  // when it is not known.
  [[nodiscard]] std::optional<double> read(std::uint32_t row, std::uint32_t number, const ModalState& state) const;
  void write(std::uint32_t row, std::uint32_t number, double value);

 private:
  [[nodiscard]] std::optional<double> end_position(std::uint32_t axis, const ModalState& state) const;
  [[nodiscard]] std::optional<double> active_code(std::uint32_t group, const ModalState& state) const;

  const ir::Control& control_;
  std::unordered_map<std::uint64_t, double> written_;
};

}  // namespace dripfeed::interpreter
