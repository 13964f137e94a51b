// Frames as values of a program: what CTRANS, CROT, CSCALE, CMIRROR and chains of them give. Position = matrix ·
// programmed + shift for X Y Z in radius values, shift alone for the other axes; mm and degrees.
#pragma once

#include <optional>
#include <vector>

#include "dialects/interpreter/state/frame.h"
#include "dialects/ir/motion.h"

namespace dripfeed::interpreter {

struct FrameValue {
  std::array<double, ir::kAxisCount> shift{};  // coarse and fine together
  std::array<double, ir::kAxisCount> fine{};   // the part of it that G59 and FI name
  Matrix matrix = kIdentity;
  friend bool operator==(const FrameValue&, const FrameValue&) = default;
};

// The parts of a frame as programs number them: TR FI RT SC MI.
enum class FramePart : unsigned char { translation, fine, rotation, scale, mirror };
inline constexpr std::size_t kFrameParts = 5;

// A : B, the frame A and in it the frame B.
FrameValue chain(const FrameValue& a, const FrameValue& b);
// Of a frame whose matrix is not singular.
FrameValue inverse_of(const FrameValue& frame);

// Rotations are the angles of rotation_of. None where the frame does not say: a turn of an axis that has none, and the
// turns, factors and mirrors of a frame that was mirrored, because several of them make the same frame.
std::optional<double> part_of(const FrameValue& frame, std::size_t axis, FramePart part);
// False where the part cannot be set, for the same reasons.
bool set_part(FrameValue& frame, std::size_t axis, FramePart part, double value);

// Frames of a run, by number; they never change once they are there. 0 is the frame that does nothing.
class FrameValues {
 public:
  static constexpr std::size_t kAtMost = 1'000'000;
  // The number of the value; vacant when there are too many.
  double add(const FrameValue& value);
  // nullptr for what is no such number, a vacant one above all.
  [[nodiscard]] const FrameValue* find(double number) const;

 private:
  std::vector<FrameValue> values_ = {FrameValue{}};
};

}  // namespace dripfeed::interpreter
