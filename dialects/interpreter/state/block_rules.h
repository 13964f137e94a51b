// What of a control decides how a block is understood, brought into the form that `apply` needs: which address is which
// axis, how lengths are scaled, when a tool is taken.
#pragma once

#include <array>
#include <cstdint>

#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/ir/control.h"

namespace dripfeed::interpreter {

// The largest coordinate that eight or nine digits of thousandths count, mm.
inline constexpr double kMostCounted = 999'999.999;

struct AxisWord {
  ir::Axis axis = ir::Axis::x;
  bool incremental = false;  // U of a lathe
  bool rotary = false;
};

class BlockRules {
 public:
  explicit BlockRules(const ir::Control& control);

  ir::Semantics semantics;
  std::uint64_t axis_addresses = 0;  // addresses that name an axis of the control
  std::uint64_t coordinates = 0;     // of these: where it is to go in G90, and nothing else
  std::array<AxisWord, kAddressCount> axis_words{};
  std::uint64_t foreign_axes = 0;  // axis letters that the control has no axis for
  std::uint64_t counting = 0;      // addresses whose constants without a point count least increments
  bool x_is_diameter = false;      // the control's X is a diameter, whatever mode is programmed
  bool surface_by_x = false;       // a surface speed is that at the diameter in X, where its block names no axis
  bool corner_letters = false;     // R, I and K of a straight block are its corner (lathes)
  // What the control stops at with an alarm; how the others go on is not known.
  bool corner_alarm = false;        // a chamfer or rounding that is longer than a move next to it
  bool angle_alarm = false;         // two lines by their angles that do not meet, or no end of the second
  bool end_of_angle_alarm = false;  // an end that the angle does not lead to
  bool taper_alarm = false;         // a turning cycle whose taper is longer than its move
  bool coordinate_alarm = false;    // a computed coordinate of more than kMostCounted
  bool tool_at_once = false;        // T takes effect without M6
  bool other_language = false;      // of the control: SINUMERIK's ISO mode
  double increments_per_mm = 1000.0;
  double increments_per_degree = 1000.0;

  // The word's value in mm, as written otherwise (no diameter, no shift).
  [[nodiscard]] double length_mm(const PlainBlock& block, ir::Address address, bool inch) const {
    double value = block.at(address);
    if ((block.in_increments & bit_of(address)) != 0) value /= inch ? increments_per_mm * 10.0 : increments_per_mm;
    return inch ? value * 25.4 : value;
  }
  [[nodiscard]] double angle_deg(const PlainBlock& block, ir::Address address) const {
    const double value = block.at(address);
    return (block.in_increments & bit_of(address)) != 0 ? value / increments_per_degree : value;
  }
  // What a programmed X is multiplied with to give the value that is kept.
  [[nodiscard]] double x_factor(const Modes& modes, bool incremental) const {
    const bool as_diameter = modes.diameter == ir::DiameterMode::diameter ||
                             (modes.diameter == ir::DiameterMode::diameter_absolute_only && !incremental);
    return as_diameter ? (x_is_diameter ? 1.0 : 0.5) : (x_is_diameter ? 2.0 : 1.0);
  }
};

}  // namespace dripfeed::interpreter
