// Whether a motion of a program and one of its translation are the same, as far as the printed decimals and the cycles
// of the two controls permit.
#pragma once

#include <cstdint>

#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"

namespace dripfeed::compile {

// The first cut after a rapid, and what else a cycle does.
enum class CyclePart : std::uint8_t { none, entry, other };

// The translation's control, or a setting of it, decides where `b` ends, and `a` is known.
bool leaves_end_open(const ir::Motion& a, const ir::Motion& b);

class SameMotion {
 public:
  // `inch`: one of the two may be written in inches.
  SameMotion(const ir::Control& from, const ir::Control& to, bool inch);

  // `part`: of a cycle that another cycle stands for, where both are moves of one.
  [[nodiscard]] bool same(const ir::Motion& a, const ir::Motion& b, CyclePart part) const;

  // A straight move, no longer than the control rounds.
  [[nodiscard]] bool stays(const ir::Motion& m) const;

  // Both are moves of one tap.
  [[nodiscard]] bool same_of_tap(const ir::Motion& a, const ir::Motion& b) const;

 private:
  [[nodiscard]] bool same_end(const ir::Motion& a, const ir::Motion& b) const;
  [[nodiscard]] bool near(double a, double b) const;

  double x_factor_;
  double tolerance_mm_;
};

}  // namespace dripfeed::compile
