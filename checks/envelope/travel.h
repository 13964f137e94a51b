// Travel in machine coordinates: the programmed tip, the work offset that it is counted from, and the tool
// length between the tip and the slide. Where one of them is not known the report states that, and nothing is claimed.
//
//     slide = programmed tip (half of a diameter) + zero of the work offset + tool length
//
// The programmed tip is in the active work offset; G53 leaves out the zero, and on controls without D the length, too.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "checks/envelope/report.h"

namespace dripfeed::envelope {

class Travel {
 public:
  Travel(const Settings& settings, Report& report);
  void select_offset(std::int32_t number);
  void select_tool(const ir::Motion& tool);
  // Before the places of a move: which zero and length count there.
  void begin(const ir::Motion& move);
  // One place of that move, along one axis, in the frame of the motion and in radius values.
  void check(const ir::Motion& move, ir::Axis axis, double value);
  // Radius where the axis is programmed in diameters.
  [[nodiscard]] double slide(std::size_t axis, double programmed) const {
    return axes_[axis] != nullptr && axes_[axis]->is_diameter ? 0.5 * programmed : programmed;
  }
  [[nodiscard]] const checks::MachineAxis* axis(std::size_t index) const { return axes_[index]; }

 private:
  // Of the tool in effect; `unknown`: bit per axis along which it has a length that is not known.
  struct Length {
    std::array<double, ir::kAxisCount> mm{};
    std::uint16_t unknown = 0;
    bool lengthens = false;  // what is not known is above 0: the slide is farther up than without it
    std::string name;        // "the length of H3"
  };
  // What the length depends on.
  struct LengthKey {
    ir::LengthOffset offset = ir::LengthOffset::off;
    std::uint16_t number = 0;
    ir::Plane plane = ir::Plane::xy;
    bool changed = false;
    std::int32_t tool = 0;
    friend bool operator==(const LengthKey&, const LengthKey&) = default;
  };

  void find_length(std::uint32_t line);
  [[nodiscard]] const checks::Tool* tool_of_length() const;
  [[nodiscard]] std::string name_of_length() const;
  template <class Sentence>
  void report_once(std::uint16_t& reported, std::size_t axis, std::uint32_t line, Sentence&& sentence);
  [[nodiscard]] bool knows_zero(const ir::Motion& move, std::size_t axis);
  void exceed(const ir::Motion& move, std::size_t axis, double at, bool is_below);

  const Settings& settings_;
  Report& report_;
  std::array<const checks::MachineAxis*, ir::kAxisCount> axes_{};
  std::array<double, ir::kAxisCount> zero_{};
  std::uint16_t zero_unknown_ = 0;        // bit per axis
  std::uint16_t reported_zero_ = 0;       // bit per axis: for the offset in effect
  std::uint16_t reported_changed_ = 0;    // … that the program changed it
  std::uint16_t reported_frame_ = 0;      // … that the machine's kinematics put it elsewhere
  std::uint16_t reported_end_ = 0;        // … that an increment began at an unknown place
  std::uint16_t reported_no_axis_ = 0;    // … that the profile has no such axis
  std::uint16_t reported_no_travel_ = 0;  // … that the profile has the axis, and no end of it
  std::uint16_t reported_length_ = 0;     // … that the length in effect is not known
  std::int32_t offset_ = 1;
  bool offset_named_ = false;
  std::int32_t tool_ = 0;
  LengthKey key_;
  Length length_;
};

}  // namespace dripfeed::envelope
