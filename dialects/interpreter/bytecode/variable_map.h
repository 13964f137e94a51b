// Which numbered variables a control has, and the slot in which each is kept. Names that a program declares are no
// business of this file: they get their slots where they are compiled.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/control.h"

namespace dripfeed::interpreter {

enum class SlotKind : std::uint8_t {
  none,    // the control has no such variable
  vacant,  // #0
  local,   // one set a macro level
  global,
  system,
};

struct Slot {
  SlotKind kind = SlotKind::none;
  bool writable = true;
  std::uint32_t index = 0;  // local, global: in its space; system: row of the control's table, kNoRow without one
};
inline constexpr std::uint32_t kNoRow = 0xFFFFFFFFU;

class VariableMap {
 public:
  // A control that declares no variables at all (the neutral one) has #1-#33, #100-#999 and R0-R999.
  explicit VariableMap(const ir::Control& control);

  [[nodiscard]] Slot find(ir::Bank bank, std::uint32_t number) const;
  [[nodiscard]] std::uint32_t global_count() const { return global_count_; }
  [[nodiscard]] std::uint32_t local_count() const { return local_count_; }

  struct Named {
    ir::Bank bank = ir::Bank::hash;
    std::uint32_t number = 0;
    SlotKind kind = SlotKind::global;
    std::uint32_t index = 0;
  };
  // All local and global variables, locals first, in the order of the control's ranges.
  [[nodiscard]] std::vector<Named> list() const;

  // Row of the control's table of system variables, kNoRow without one.
  [[nodiscard]] std::uint32_t system_row(std::uint32_t number) const;

 private:
  struct Range {
    ir::VariableRange range;
    std::uint32_t first_slot = 0;  // local, global
    bool is_hidden = false;        // no program names them
  };
  std::vector<Range> ranges_;
  const ir::Control& control_;
  std::span<const ir::SystemVariableRow> system_variables_;
  bool has_vacant_ = true;
  bool options_exist_ = false;  // a variable beyond the usual ranges is taken for one whose value is not known
  std::uint32_t global_count_ = 0;
  std::uint32_t local_count_ = 0;
};

// "#100", "R5"
std::string variable_name(ir::Bank bank, std::uint32_t number);

}  // namespace dripfeed::interpreter
