// Axis letters, increments and the power-on state of a control.
#include "dialects/interpreter/state/block_rules.h"

#include <cmath>
#include <vector>

#include "dialects/ir/axis_letters.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Axis;

struct AxisLetter {
  Address address;
  Axis axis;
  char letter;
  bool rotary;
};
constexpr AxisLetter kAxisLetterRows[] = {
    {Address::x, Axis::x, 'X', false}, {Address::y, Axis::y, 'Y', false}, {Address::z, Axis::z, 'Z', false},
    {Address::a, Axis::a, 'A', true},  {Address::b, Axis::b, 'B', true},  {Address::c, Axis::c, 'C', true},
    {Address::u, Axis::u, 'U', false}, {Address::v, Axis::v, 'V', false}, {Address::w, Axis::w, 'W', false},
};
// U V W H as increments of X Y Z C, where these letters are no axes themselves.
constexpr AxisLetter kIncrementalRows[] = {
    {Address::u, Axis::x, 'U', false},
    {Address::v, Axis::y, 'V', false},
    {Address::w, Axis::z, 'W', false},
    {Address::h, Axis::c, 'H', true},
};
constexpr std::uint64_t kLengths = bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k) | bit_of(Address::r) |
                                   bit_of(Address::arc_radius) | bit_of(Address::f) | bit_of(Address::q) |
                                   bit_of(Address::chamfer) | bit_of(Address::rounding) | bit_of(Address::direct_angle);

// 1 / 0.001 is not quite 1000 in every binary; a whole number divides as the decimal would.
double reciprocal(double increment) {
  const double value = 1.0 / increment;
  const double whole = std::round(value);
  return std::abs(value - whole) < 1e-6 * value ? whole : value;
}

}  // namespace

BlockRules::BlockRules(const ir::Control& control)
    : semantics(control.semantics),
      x_is_diameter(control.kind == ir::MachineKind::lathe ||
                    (control.kind == ir::MachineKind::mill_turn &&
                     control.semantics.power_on_diameter != ir::DiameterMode::radius)),
      tool_at_once(control.kind == ir::MachineKind::lathe ||
                   control.semantics.tool_word == ir::ToolWord::number_and_offset),
      increments_per_mm(reciprocal(control.semantics.least_increment_mm)),
      increments_per_degree(reciprocal(control.semantics.least_increment_deg)) {
  const auto add = [this](const AxisLetter& row, bool incremental) {
    axis_addresses |= bit_of(row.address);
    if (!incremental) coordinates |= bit_of(row.address);
    axis_words[interpreter::index_of(row.address)] = {row.axis, incremental, row.rotary};
  };
  std::uint64_t letters = 0;
  for (const AxisLetter& row : kAxisLetterRows) {
    letters |= bit_of(row.address);
    if (control.axes.contains(row.letter)) add(row, false);
  }
  for (const AxisLetter& row : kIncrementalRows)
    if (ir::incremented_axis(control, row.letter)) add(row, true);
  foreign_axes = letters & ~axis_addresses;
  surface_by_x = control.kind != ir::MachineKind::mill;
  corner_letters = control.kind == ir::MachineKind::lathe && semantics.arc_radius_is_r;
  using text::DiagnosticId;
  corner_alarm = !ir::alarm_of(control, DiagnosticId::corner_too_large).empty();
  angle_alarm = !ir::alarm_of(control, DiagnosticId::angle_unsolved).empty();
  taper_alarm = ir::alarm_of(control, DiagnosticId::cycle_shape_invalid, ir::AlarmDetail::tapered) !=
                ir::alarm_of(control, DiagnosticId::cycle_shape_invalid);
  coordinate_alarm = ir::alarm_of(control, DiagnosticId::result_overflow, ir::AlarmDetail::position) !=
                     ir::alarm_of(control, DiagnosticId::result_overflow);
  end_of_angle_alarm = ir::alarm_of(control, DiagnosticId::angle_unsolved, ir::AlarmDetail::not_an_end) !=
                       ir::alarm_of(control, DiagnosticId::angle_unsolved);
  counting = bit_of(Address::p);  // a scaling factor counts the control's unit, whatever lengths do
  if (semantics.decimal_mode == ir::DecimalMode::least_increment) counting |= letters | axis_addresses | kLengths;
}

}  // namespace dripfeed::interpreter
