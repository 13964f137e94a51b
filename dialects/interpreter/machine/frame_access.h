// Frames while a program runs: operators that make them, their parts, and the frames of the control: the programmable
// one, the settable ones in memory, and the settable one in effect (PGA, "Coordinate transformations (frames)").
#pragma once

#include <map>
#include <optional>
#include <set>

#include "dialects/interpreter/machine/run_report.h"
#include "dialects/interpreter/machine/storage.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/frame_value.h"
#include "dialects/interpreter/state/shared_data.h"

namespace dripfeed::interpreter {

class FrameAccess {
 public:
  // `name`: of the settable frames, as the control spells it. All must outlive it.
  FrameAccess(const BlockRules& rules, std::string_view name, Storage& storage, SharedData& shared, ModalState& state,
              RunReport& report)
      : rules_(rules), name_(name), storage_(storage), shared_(shared), state_(state), report_(report) {}

  // One of the frame opcodes; false when the run has ended.
  bool execute(const Instruction& i);

  // A part of a settable frame that the program has set as a whole.
  [[nodiscard]] std::optional<double> settable_part(const Indices& indices) const;
  void set_settable_part(const Indices& indices, double value);
  // Whether a code that selects an offset may have to do with known frames.
  [[nodiscard]] bool knows_settable() const {
    return !settable_.empty() || !half_known_.empty() || state_.modes.settable_known || base_waits_;
  }
  // G54 …: the settable frame in memory takes effect. Where both it and the one before are known, so is the position.
  void select(std::int32_t offset);

 private:
  bool make(const Instruction& i);
  bool load(const Instruction& i);
  bool store(const Instruction& i);
  bool give(const Instruction& i, const FrameValue& value);
  void lose(const Instruction& i, std::string what);
  void activate(const FrameValue* next);
  void activate_base(const FrameValue* next);
  void move_position(const FrameValue& from, const FrameValue& to);
  [[nodiscard]] FrameValue programmable() const;
  void set_programmable(const FrameValue& value);

  const BlockRules& rules_;
  std::string_view name_;
  Storage& storage_;
  SharedData& shared_;
  ModalState& state_;
  RunReport& report_;
  FrameValues values_;
  std::map<std::uint32_t, FrameValue> settable_;  // by number: 0 is G500, 1 G54 …
  std::set<std::uint32_t> half_known_;            // written in part, and not in effect yet
  std::optional<FrameValue> base_;                // the first base frame of the channel, where it is known
  std::optional<FrameValue> base_in_data_;
  bool base_waits_ = false;  // what is in memory takes effect with the next code that selects an offset
};

constexpr bool is_frame_opcode(Opcode op) { return op >= Opcode::frame_make && op <= Opcode::store_frame; }

}  // namespace dripfeed::interpreter
