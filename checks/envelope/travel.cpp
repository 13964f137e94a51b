// The zero changes with the work offset, the length with tool and code; both are looked up then, not at each move.
#include "checks/envelope/travel.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::envelope {

namespace {

constexpr double kTravelSlack = 1e-6;  // mm or degrees: rounding, not a limit
// Index of the axis that a plane leaves out, by ir::Plane: xy, zx, yz.
constexpr std::array<std::size_t, 3> kNormals = {2, 1, 0};

// "tool 4", or as programs call it.
std::string title_of(const checks::Machine& machine, std::int32_t number) {
  const checks::Tool* tool = checks::find_tool(machine, number);
  return tool == nullptr || tool->name.empty() ? fmt::format("tool {}", number)
                                               : fmt::format("tool \"{}\"", tool->name);
}

}  // namespace

std::string figure(double value) {
  std::string out;
  text::append_word_number(out, value, 4, true);
  return out;
}

Travel::Travel(const Settings& settings, Report& report) : settings_(settings), report_(report) {
  for (const checks::MachineAxis& axis : settings_.machine.axes) axes_[static_cast<std::size_t>(axis.axis)] = &axis;
  select_offset(settings_.work_offset);
  offset_named_ = false;
}

void Travel::select_offset(std::int32_t number) {
  offset_ = number;
  offset_named_ = true;
  reported_zero_ = 0;
  zero_ = {};
  zero_unknown_ = 0;
  if (number == 0) return;  // none: machine coordinates
  const checks::WorkOffset* known = checks::find_work_offset(settings_.machine, number);
  for (std::size_t i = 0; i < zero_.size(); ++i) {
    std::optional<double> zero = settings_.machine.origin[i];
    if (known != nullptr && known->zero[i]) zero = known->zero[i];
    zero_[i] = zero.value_or(0.0);
    if (!zero) zero_unknown_ = static_cast<std::uint16_t>(zero_unknown_ | 1U << i);
  }
}

// A tool by a name that the profile does not have has the number 0.
void Travel::select_tool(const ir::Motion& tool) { tool_ = tool.number; }

void Travel::begin(const ir::Motion& move) {
  const bool changed = (move.gaps & ir::kLengthsChanged) != 0;
  const LengthKey key{move.length_offset, move.length_offset_number, move.plane, changed, tool_};
  if (key == key_) return;
  key_ = key;
  find_length(move.place.line);
}

// G43 H and T0606 name the row of the control's table, D an edge of the tool in the spindle; next to D the number 0
// stands for the edge that the control takes when none is named, the first one.
const checks::Tool* Travel::tool_of_length() const {
  const std::vector<checks::Tool>& tools = settings_.machine.tools;
  const auto edge = static_cast<std::int32_t>(key_.number == 0 ? 1 : key_.number);
  const auto found = std::ranges::find_if(tools, [&](const checks::Tool& one) {
    if (!settings_.d_selects_edge) return one.offset == key_.number;
    return one.number == tool_ && one.offset == edge;
  });
  return found == tools.end() ? nullptr : &*found;
}

std::string Travel::name_of_length() const {
  if (settings_.d_selects_edge && tool_ == 0) return "the length of a tool that is called by its name";
  if (settings_.d_selects_edge)
    return fmt::format("the length of {} edge {}", title_of(settings_.machine, tool_),
                       key_.number == 0 ? 1 : key_.number);
  return fmt::format("the tool length of offset {}", key_.number);
}

void Travel::find_length(std::uint32_t line) {
  length_ = {};
  reported_length_ = 0;
  const bool none = !settings_.d_selects_edge && key_.number == 0;  // H0
  if (key_.offset == ir::LengthOffset::off || none) return;
  const checks::Tool* tool = key_.changed ? nullptr : tool_of_length();
  if (tool != nullptr && settings_.d_selects_edge && key_.number == 0)
    report_.not_checked.add(
        fmt::format("{} is called without D: its edge 1 is taken to be in effect", title_of(settings_.machine, tool_)),
        line);
  const double sign = key_.offset == ir::LengthOffset::plus ? 1.0 : -1.0;
  const auto add = [&](std::size_t axis, const std::optional<double>& mm) {
    length_.mm[axis] = sign * mm.value_or(0.0);
    if (!mm) length_.unknown = static_cast<std::uint16_t>(length_.unknown | 1U << axis);
  };
  const std::optional<double> missing;
  if (settings_.machine.kind == ir::MachineKind::mill) {
    const std::size_t along = settings_.d_selects_edge ? kNormals[static_cast<std::size_t>(key_.plane)] : 2;
    add(along, tool == nullptr ? missing : tool->length_mm);
    length_.lengthens = sign > 0.0;
  } else {
    add(0, tool == nullptr ? missing : tool->length_x_mm);
    add(2, tool == nullptr ? missing : tool->length_z_mm);
  }
  if (length_.unknown != 0) length_.name = name_of_length();
  if (length_.unknown != 0 && key_.changed) report_.lost_place = true;
}

// The sentence is made when it is reported: of most of a million blocks it has been.
template <class Sentence>
void Travel::report_once(std::uint16_t& reported, std::size_t axis, std::uint32_t line, Sentence&& sentence) {
  if ((reported >> axis & 1U) != 0) return;
  reported = static_cast<std::uint16_t>(reported | 1U << axis);
  report_.not_checked.add(sentence(), line);
}

bool Travel::knows_zero(const ir::Motion& move, std::size_t axis) {
  const std::uint32_t line = move.place.line;
  if ((move.gaps & ir::kFrameLost) != 0) {
    report_.lost_place = true;
    report_once(reported_frame_, axis, line, [&] {
      return fmt::format(
          "a plane is swivelled or a transformation is on, which the machine's kinematics decide: the travel of {} was "
          "not checked from there",
          ir::kAxisLetters[axis]);
    });
    return false;
  }
  if ((move.gaps & ir::kZerosChanged) != 0) {
    report_.lost_place = true;
    report_once(reported_changed_, axis, line, [&] {
      return fmt::format("the program changes coordinates or work offsets: the travel of {} was not checked from there",
                         ir::kAxisLetters[axis]);
    });
    return false;
  }
  if ((zero_unknown_ >> axis & 1U) != 0) {
    report_once(reported_zero_, axis, line, [&] {
      return fmt::format("work offset {} is not known for {}: its travel was not checked", offset_,
                         ir::kAxisLetters[axis]);
    });
    return false;
  }
  if (!offset_named_) {
    report_.not_checked.add(fmt::format("no work offset is named: {} is taken to be in effect", offset_), line);
    offset_named_ = true;
  }
  return true;
}

void Travel::check(const ir::Motion& move, ir::Axis axis, double value) {
  const auto i = static_cast<std::size_t>(axis);
  const checks::MachineAxis* known = axes_[i];
  if ((move.gaps & ir::kEndUnknown) != 0 && (move.axes_unknown >> i & 1U) != 0) {
    report_once(reported_end_, i, move.place.line, [&] {
      return fmt::format(
          "{} is at a position that is not known, and an increment moves it: its travel was not checked there",
          ir::kAxisLetters[i]);
    });
    return;
  }
  if (!move.machine_coordinates) report_.work[i].include(value);
  if (known == nullptr) {
    if (!settings_.machine.axes.empty())
      report_once(reported_no_axis_, i, move.place.line, [&] {
        return fmt::format("the machine's profile has no axis {}: its moves were not checked", ir::kAxisLetters[i]);
      });
    return;
  }
  const bool has_limits = known->min || known->max;
  if (!has_limits)
    report_once(reported_no_travel_, i, move.place.line,
                [&] { return fmt::format("the travel of {} is not known", ir::kAxisLetters[i]); });
  double at = value;
  if (!move.machine_coordinates) {
    const bool no_zero = (zero_unknown_ >> i & 1U) != 0 || (move.gaps & (ir::kZerosChanged | ir::kFrameLost)) != 0;
    if (has_limits ? !knows_zero(move, i) : no_zero) return;
    at += zero_[i];
  }
  const bool has_length = !move.machine_coordinates || settings_.d_selects_edge;
  const bool is_sure = !has_length || (length_.unknown >> i & 1U) == 0;
  if (has_length) at += length_.mm[i];
  if (is_sure) {
    report_.machine[i].include(at);
  } else if (has_limits) {
    report_once(reported_length_, i, move.place.line, [&] {
      return fmt::format("{} is not known: the travel of {} was checked without it", length_.name, ir::kAxisLetters[i]);
    });
  }
  const bool below = known->min && at < *known->min - kTravelSlack;
  const bool above = known->max && at > *known->max + kTravelSlack;
  if (below || above) exceed(move, i, at, below);
}

void Travel::exceed(const ir::Motion& move, std::size_t axis, double at, bool is_below) {
  const checks::MachineAxis& known = *axes_[axis];
  const double limit = is_below ? *known.min : *known.max;
  const auto bound = [](const std::optional<double>& end) { return end ? figure(*end) : std::string("anything"); };
  const auto travel = [&] { return fmt::format("{} to {}", bound(known.min), bound(known.max)); };
  const bool has_length = !move.machine_coordinates || settings_.d_selects_edge;
  const bool is_unknown = has_length && (length_.unknown >> axis & 1U) != 0;
  // A length that lifts the slide makes what is above the travel already only worse.
  if (is_unknown && (is_below || !length_.lengthens)) {
    report_.findings.add(text::DiagnosticId::travel_uncertain, move.place, at, limit, [&] {
      return std::vector<std::string>{std::string(1, ir::kAxisLetters[axis]), figure(at), length_.name, travel()};
    });
    return;
  }
  report_.findings.add(text::DiagnosticId::travel_exceeded, move.place, at, limit, [&] {
    return std::vector<std::string>{std::string(1, ir::kAxisLetters[axis]), figure(at), travel()};
  });
}

}  // namespace dripfeed::envelope
