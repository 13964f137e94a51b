// G90 and G92 (turning, threading) go round like this, G94 (facing) in reverse:
//
//          4 rapid
//   A <---------------+
//   | 1 rapid         ^ 3 feed, of threads rapid
//   v                 |
//   B --------------> C      2 feed, of threads by the lead; C is the block's X and Z
//
// B lies R (a radius) next to C's diameter. The chamfer at a thread's end is a parameter and is left out. (0i-F
// B-64604EN-1, canned cycle G90, G92, G94.)
#include "dialects/interpreter/cycles/turning.h"

#include <cmath>

#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/state/axis_words.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::MotionKind;

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr std::uint16_t kXBit = 1U << kX;
constexpr std::uint16_t kZBit = 1U << kZ;

class Turner {
 public:
  Turner(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out, BlockResult& result)
      : block_(block), rules_(rules), state_(state), out_(out), result_(result), t_(state.turning) {}

  void run() {
    take_words();
    if ((block_.present & (rules_.axis_addresses | bit_of(Address::r))) == 0 || !t_.has_x || !t_.has_z) return;
    if ((state_.unknown & (kXBit | kZBit)) != 0) {
      result_.notes |= kNoteLevelUnknown;
      return;
    }
    const double x = state_.position[kX];
    const double z = state_.position[kZ];
    if (rules_.taper_alarm && is_taper_too_long(x, z)) {
      result_.fault = text::DiagnosticId::cycle_shape_invalid;
      result_.reason = "the taper (R) is longer than its move";
      result_.detail = ir::AlarmDetail::tapered;
      return;
    }
    const MotionKind cut = t_.cycle == TurningCycle::thread ? MotionKind::thread : MotionKind::linear;
    if (t_.cycle == TurningCycle::along_x) {
      go(MotionKind::rapid, x, t_.z + t_.taper);
      go(cut, t_.x, t_.z);
      go(cut, t_.x, z);
    } else {
      go(MotionKind::rapid, t_.x + t_.taper * (rules_.x_is_diameter ? 2.0 : 1.0), z);
      go(cut, t_.x, t_.z);
      go(t_.cycle == TurningCycle::thread ? MotionKind::rapid : cut, x, t_.z);
    }
    go(MotionKind::rapid, x, z);
  }

 private:
  void take_words() {
    for_each_axis_word(
        block_, rules_, state_.modes, !state_.modes.absolute, [&](std::size_t axis, double value, bool incremental) {
          if (axis != kX && axis != kZ) return;
          const double from =
              incremental ? state_.position[axis] : state_.modes.shift[axis] + state_.coordinate_shift[axis];
          (axis == kX ? t_.x : t_.z) = from + value;
          (axis == kX ? t_.has_x : t_.has_z) = true;
        });
    // I of G90 and G92, K of G94: the taper on older controls.
    const Address old = t_.cycle == TurningCycle::along_x ? Address::k : Address::i;
    for (const Address address : {old, Address::r})
      if (block_.has(address)) t_.taper = rules_.length_mm(block_, address, state_.modes.inch);
  }

  // A taper that begins beyond the cycle's own start: R against the approach, and longer.
  [[nodiscard]] bool is_taper_too_long(double x, double z) const {
    const bool facing = t_.cycle == TurningCycle::along_x;
    const double approach = facing ? t_.z - z : (t_.x - x) / (rules_.x_is_diameter ? 2.0 : 1.0);
    return approach * t_.taper < 0.0 && std::abs(t_.taper) > std::abs(approach) + 1e-9;
  }

  void go(MotionKind kind, double x, double z) {
    Target target{.end = state_.position};
    if (x != state_.position[kX]) target.commanded |= kXBit;
    if (z != state_.position[kZ]) target.commanded |= kZBit;
    if (target.commanded == 0) return;
    target.end[kX] = x;
    target.end[kZ] = z;
    emit_move(kind, target, kind == MotionKind::rapid ? 0.0 : state_.feed, {}, state_, out_, result_);
  }

  const PlainBlock& block_;
  const BlockRules& rules_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  Turning& t_;
};

}  // namespace

void turn_once(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
               BlockResult& result) {
  Turner(block, rules, state, out, result).run();
}

}  // namespace dripfeed::interpreter
