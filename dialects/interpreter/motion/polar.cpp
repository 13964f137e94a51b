// PG, "Path commands, travel commands with polar coordinates": AP is counted from the first axis of the plane, RP from
// the pole; both are modal. Without a pole it is the zero point of the workpiece.
#include "dialects/interpreter/motion/polar.h"

#include "dialects/interpreter/arithmetic/arithmetic.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;

constexpr std::array kLetters = {Address::x, Address::y, Address::z};
constexpr std::array kCenters = {Address::i, Address::j, Address::k};
constexpr std::uint64_t kPolarWords = bit_of(Address::polar_angle) | bit_of(Address::polar_radius);

double radius_value(const BlockRules& rules, std::size_t axis, double kept) {
  return axis == 0 && rules.x_is_diameter ? kept / 2.0 : kept;
}

// AP and RP of the block become the modal ones.
void take_words(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  if (block.has(Address::polar_angle)) {
    const double angle = block.at(Address::polar_angle);
    const bool adds = (block.incremental & bit_of(Address::polar_angle)) != 0;
    state.polar.angle_deg = adds ? state.polar.angle_deg + angle : angle;
  }
  if (block.has(Address::polar_radius)) {
    const double radius = rules.length_mm(block, Address::polar_radius, state.modes.inch);
    const bool adds = (block.incremental & bit_of(Address::polar_radius)) != 0;
    state.polar.radius_mm = adds ? state.polar.radius_mm + radius : radius;
  }
}

// A coordinate in radius geometry, mm, as the program would write it.
double written_value(const BlockRules& rules, const ModalState& state, std::size_t axis, double coordinate_mm) {
  double value = axis == 0 && rules.x_is_diameter ? coordinate_mm * 2.0 : coordinate_mm;
  if (axis == 0) value /= rules.x_factor(state.modes, false);
  return state.modes.inch ? value / 25.4 : value;
}

void put_absolute(PlainBlock& made, Address letter, double value) {
  made.set(letter, value);
  made.absolute |= bit_of(letter);
  made.incremental &= ~bit_of(letter);
  made.in_increments &= ~bit_of(letter);
}

// The plane's two coordinates of radius and angle, or none where these are not known.
void put_coordinates(PlainBlock& made, const BlockRules& rules, const ModalState& state, bool unknown) {
  const PlaneAxes axes = axes_of(state.modes.plane);
  const Vector& pole = state.polar.pole;
  const std::array<double, 2> at = {pole[axes.p] + state.polar.radius_mm * cosine_deg(state.polar.angle_deg),
                                    pole[axes.q] + state.polar.radius_mm * sine_deg(state.polar.angle_deg)};
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::size_t axis = i == 0 ? axes.p : axes.q;
    const Address letter = kLetters[axis];
    if (unknown) {
      made.present &= ~bit_of(letter);
      made.unknown |= bit_of(letter);
      continue;
    }
    put_coordinate(made, rules, state, axis, at[i]);
  }
}

}  // namespace

void put_coordinate(PlainBlock& made, const BlockRules& rules, const ModalState& state, std::size_t axis,
                    double coordinate_mm) {
  put_absolute(made, kLetters[axis], written_value(rules, state, axis, coordinate_mm));
}

void put_center(PlainBlock& made, const BlockRules& rules, const ModalState& state, std::size_t axis,
                double coordinate_mm) {
  put_absolute(made, kCenters[axis], written_value(rules, state, axis, coordinate_mm));
}

bool has_polar_words(const PlainBlock& block) { return ((block.present | block.unknown) & kPolarWords) != 0; }

Vector programmed_position(const BlockRules& rules, const ModalState& state) {
  Vector at{};
  for (std::size_t axis = 0; axis < at.size(); ++axis)
    at[axis] = radius_value(rules, axis, state.position[axis] - state.modes.shift[axis] - state.coordinate_shift[axis]);
  return state.modes.has_matrix ? multiply(inverse_of(state.modes.matrix), at) : at;
}

PlainBlock with_coordinates(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  PlainBlock made = block;
  take_words(block, rules, state);
  put_coordinates(made, rules, state, (block.unknown & kPolarWords) != 0);
  return made;
}

// PG, "Circular interpolation with polar coordinates": the pole is the centre, RP the radius.
PlainBlock with_center_at_pole(const PlainBlock& block, const BlockRules& rules, const ModalState& state) {
  constexpr std::uint64_t kArcWords = bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k) |
                                      bit_of(Address::arc_radius) | bit_of(Address::opening_angle);
  if (((block.present | block.unknown) & kArcWords) != 0) return block;
  PlainBlock made = block;
  const PlaneAxes axes = axes_of(state.modes.plane);
  for (const std::size_t axis : {axes.p, axes.q}) put_center(made, rules, state, axis, state.polar.pole[axis]);
  return made;
}

// Fanuc 0i-F B-64604EN-2, "Polar coordinate command".
PlainBlock with_coordinates_of_letters(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  const PlaneAxes axes = axes_of(state.modes.plane);
  const Address radius = kLetters[axes.p];
  const Address angle = kLetters[axes.q];
  const auto adds = [&](Address letter) { return !state.modes.absolute || (block.incremental & bit_of(letter)) != 0; };
  if (block.has(radius)) {
    state.polar.pole = adds(radius) ? programmed_position(rules, state) : Vector{};
    state.polar.radius_mm = rules.length_mm(block, radius, state.modes.inch);
  }
  if (block.has(angle)) {
    const double value = rules.angle_deg(block, angle);
    state.polar.angle_deg = adds(angle) ? state.polar.angle_deg + value : value;
  }
  PlainBlock made = block;
  put_coordinates(made, rules, state, (block.unknown & (bit_of(radius) | bit_of(angle))) != 0);
  return made;
}

void set_pole(const PlainBlock& block, const BlockRules& rules, ir::Function function, ModalState& state) {
  const Vector base = function == ir::Function::pole_from_last   ? programmed_position(rules, state)
                      : function == ir::Function::pole_from_pole ? state.polar.pole
                                                                 : Vector{};
  const PlaneAxes axes = axes_of(state.modes.plane);
  Vector pole = base;
  if (has_polar_words(block)) {
    take_words(block, rules, state);
    pole[axes.p] += state.polar.radius_mm * cosine_deg(state.polar.angle_deg);
    pole[axes.q] += state.polar.radius_mm * sine_deg(state.polar.angle_deg);
  }
  for (const std::size_t axis : {axes.p, axes.q}) {
    if (!block.has(kLetters[axis])) continue;
    double value = rules.length_mm(block, kLetters[axis], state.modes.inch);
    if (axis == 0) value = radius_value(rules, 0, value * rules.x_factor(state.modes, false));
    pole[axis] = base[axis] + value;
  }
  state.polar.pole = pole;
}

}  // namespace dripfeed::interpreter
