// The spindles that are not the main one. Which spindle is the main one may change, and each keeps its own speed.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "dialects/ir/motion.h"
#include "dialects/ir/other_spindle.h"

namespace dripfeed::interpreter {

struct OtherSpindle {
  ir::SpindleState state = ir::SpindleState::stopped;
  double rpm = 0.0;
  bool speed_unknown = false;
};

struct Spindles {
  std::uint8_t main = 1;                                        // its values are ModalState's
  std::array<OtherSpindle, ir::kMostSpindles + 1> by_number{};  // that of the main one is left over

  // One of them turns.
  [[nodiscard]] bool any_turns() const {
    return std::ranges::any_of(by_number, [this](const OtherSpindle& one) {
      return &one != &by_number[main] && one.state != ir::SpindleState::stopped;
    });
  }
};

}  // namespace dripfeed::interpreter
