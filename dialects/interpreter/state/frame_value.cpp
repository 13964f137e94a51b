// A frame that was not mirrored is taken apart into turns and factors; the columns of its matrix have the factors'
// length.
#include "dialects/interpreter/state/frame_value.h"

#include <cmath>
#include <numbers>

#include "dialects/interpreter/arithmetic/arithmetic.h"

namespace dripfeed::interpreter {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

struct Turned {
  Vector angles_deg{};
  Vector factors{};
};

double column_length(const Matrix& m, std::size_t column) {
  return std::hypot(m[column], m[3 + column], m[6 + column]);
}

double determinant_of(const Matrix& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

std::optional<Turned> take_apart(const Matrix& m) {
  if (!(determinant_of(m) > 0.0)) return std::nullopt;
  Turned out;
  for (std::size_t axis = 0; axis < 3; ++axis) out.factors[axis] = column_length(m, axis);
  const double sine_y = -m[6] / out.factors[0];
  out.angles_deg[1] = std::asin(std::fmax(-1.0, std::fmin(1.0, sine_y))) * kDegrees;
  out.angles_deg[0] = std::atan2(m[7] / out.factors[1], m[8] / out.factors[2]) * kDegrees;
  out.angles_deg[2] = std::atan2(m[3], m[0]) * kDegrees;
  return out;
}

}  // namespace

FrameValue chain(const FrameValue& a, const FrameValue& b) {
  FrameValue out;
  out.matrix = multiply(a.matrix, b.matrix);
  const Vector moved = multiply(a.matrix, Vector{b.shift[0], b.shift[1], b.shift[2]});
  for (std::size_t axis = 0; axis < out.shift.size(); ++axis) {
    out.shift[axis] = a.shift[axis] + (axis < moved.size() ? moved[axis] : b.shift[axis]);
    out.fine[axis] = a.fine[axis] + b.fine[axis];
  }
  return out;
}

FrameValue inverse_of(const FrameValue& frame) {
  FrameValue out;
  out.matrix = inverse_of(frame.matrix);
  const Vector back = multiply(out.matrix, Vector{frame.shift[0], frame.shift[1], frame.shift[2]});
  for (std::size_t axis = 0; axis < out.shift.size(); ++axis)
    out.shift[axis] = axis < back.size() ? -back[axis] : -frame.shift[axis];
  return out;
}

std::optional<double> part_of(const FrameValue& frame, std::size_t axis, FramePart part) {
  if (axis >= frame.shift.size()) return std::nullopt;
  if (part == FramePart::translation) return frame.shift[axis] - frame.fine[axis];
  if (part == FramePart::fine) return frame.fine[axis];
  if (axis >= 3) return part == FramePart::scale ? 1.0 : 0.0;
  const auto turned = take_apart(frame.matrix);
  if (!turned.has_value()) return std::nullopt;
  if (part == FramePart::mirror) return 0.0;
  return part == FramePart::rotation ? turned->angles_deg[axis] : turned->factors[axis];
}

bool set_part(FrameValue& frame, std::size_t axis, FramePart part, double value) {
  if (axis >= frame.shift.size()) return false;
  if (part == FramePart::translation) {
    frame.shift[axis] = value + frame.fine[axis];
    return true;
  }
  if (part == FramePart::fine) {
    frame.shift[axis] += value - frame.fine[axis];
    frame.fine[axis] = value;
    return true;
  }
  auto turned = take_apart(frame.matrix);
  if (axis >= 3 || !turned.has_value()) return false;
  if (part == FramePart::rotation) turned->angles_deg[axis] = value;
  if (part == FramePart::scale) turned->factors[axis] = value;
  if (part == FramePart::mirror && value != 0.0) turned->factors[axis] = -turned->factors[axis];
  frame.matrix = multiply(rotation_of(turned->angles_deg), diagonal_of(turned->factors));
  return true;
}

double FrameValues::add(const FrameValue& value) {
  if (values_.size() >= kAtMost) return kVacant;
  values_.push_back(value);
  return static_cast<double>(values_.size() - 1);
}

const FrameValue* FrameValues::find(double number) const {
  const bool is_number = number >= 0.0 && number < static_cast<double>(values_.size());
  return is_number ? &values_[static_cast<std::size_t>(number)] : nullptr;
}

}  // namespace dripfeed::interpreter
