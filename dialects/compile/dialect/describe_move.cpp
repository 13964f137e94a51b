// Kind, axes, feed; then the states that distinguish the two.
#include "dialects/compile/dialect/describe_move.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

std::string describe_move(const ir::Motion& m, const ir::Motion& other) {
  constexpr std::array kKinds = {"rapid", "line", "arc G2", "arc G3", "curve", "thread", "dwell"};
  static_assert(kKinds.size() == static_cast<std::size_t>(ir::MotionKind::dwell) + 1);
  std::string out = kKinds[static_cast<std::size_t>(m.kind)];
  const auto number = [](double value, bool bare) {
    std::string digits;
    text::append_word_number(digits, value, 4, bare);
    return digits;
  };
  if (m.kind == ir::MotionKind::dwell) return out + " " + number(m.feed, true) + " s";
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
    if ((axes_to_name(m) & (1U << axis)) != 0)
      out += fmt::format(" {}{}", ir::kAxisLetters[axis], number(m.end[axis], false));
  if (m.feed != 0.0) out += " F" + number(m.feed, true);
  constexpr std::array kComps = {" G40", " G41", " G42"};
  constexpr std::array kSpindles = {" M5", " M3", " M4"};
  constexpr std::array kCoolants = {" M9", " M7", " M8"};
  if (m.comp != other.comp) out += kComps[static_cast<std::size_t>(m.comp)];
  if (m.spindle != other.spindle) out += kSpindles[static_cast<std::size_t>(m.spindle)];
  if (m.spindle_rpm != other.spindle_rpm) out += " S" + number(m.spindle_rpm, true);
  if (m.coolant != other.coolant) out += kCoolants[static_cast<std::size_t>(m.coolant)];
  if (m.machine_coordinates) out += " in machine coordinates";
  return out;
}

}  // namespace dripfeed::compile
