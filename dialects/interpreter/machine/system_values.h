// System variables that the modal state can answer. What only the machine knows is not made up: it was written before,
// came with the start values, or is reported as not known.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/shared_data.h"
#include "dialects/ir/control.h"

namespace dripfeed::interpreter {

// What the modal state answers for a system variable that has a name; nothing when it is not known. Axes are indexed by
// their number in the trace.
std::optional<double> answer_system(const ir::Control& control, const ir::SystemVariableRow& row,
                                    const Indices& indices, const ModalState& state);

// As a row: the offsets of G54.1, whatever numbers the control has them under; `number` is that of #7001 and on, for P
// beyond 48, too.
inline constexpr std::uint32_t kExtendedOffsetRow = 0xFFFF'FFFEU;

class SystemValues {
 public:
  explicit SystemValues(const ir::Control& control) : control_(control), rules_(control) {}

  // `row` of the control's table (kNoRow without one, kExtendedOffsetRow); `number` of a numbered variable, index of a
  // named one. Nothing when it is not known.
  [[nodiscard]] std::optional<double> read(std::uint32_t row, std::uint32_t number, const ModalState& state) const;
  // What the program writes. A work offset that is in effect moves the position that is counted from it. False when it
  // may be anything that moves go by: a parameter, a setting, an offset under a number that is not known here.
  bool write(std::uint32_t row, std::uint32_t number, double value, ModalState& state);
  // Before the start: the same, but that a skip position says where the probe will touch.
  void set_initial(std::uint32_t row, std::uint32_t number, double value, ModalState& state);

  // The control measured a tool: what was written of their offsets may be another value.
  void forget_tool_offsets();
  // The codes in effect are those of a caller that is not there.
  void forget_modes() { modes_unknown_ = true; }

 private:
  void start_with(std::uint32_t row, std::uint32_t number, double value, ModalState& state);
  // What a value is kept under: an offset of G54.1 may have two numbers (#7001 and #14001).
  struct Key {
    std::uint32_t row;
    std::uint32_t number;
  };
  [[nodiscard]] Key key_of_value(std::uint32_t row, std::uint32_t number) const;
  [[nodiscard]] std::optional<double> position(std::uint32_t axis, const AxisValues& of, std::uint16_t known,
                                               const ModalState& state) const;
  [[nodiscard]] std::optional<double> machine_position(std::uint32_t axis, const ModalState& state) const;
  [[nodiscard]] std::optional<double> offset_mm(std::int32_t offset, std::size_t axis, const ModalState& state) const;
  void move_offset(std::uint32_t number, double value, ModalState& state);
  [[nodiscard]] std::size_t place_of(std::uint32_t axis) const;
  [[nodiscard]] std::optional<double> given(double value) const;
  bool modes_unknown_ = false;
  [[nodiscard]] std::optional<double> active_code(std::uint32_t group, const ModalState& state) const;

  const ir::Control& control_;
  BlockRules rules_;
  // A clock that the program set: its value then less the time that is counted, and ModalState::untimed then.
  struct Clock {
    double from = 0.0;
    std::uint64_t untimed = UINT64_MAX;
  };
  // A check never takes a time for known that moves and the machine's functions have a part in.
  [[nodiscard]] std::optional<double> value_of(const Clock& clock, double counted, const ModalState& state) const;
  Clock milliseconds_;
  Clock hours_;
  std::unordered_map<std::uint64_t, double> written_;
};

}  // namespace dripfeed::interpreter
