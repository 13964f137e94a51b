// Answers by kind of value.
#include "dialects/interpreter/system_values.h"

#include "dialects/interpreter/polar.h"
#include "dialects/interpreter/trace.h"
#include "dialects/interpreter/variable_map.h"

namespace dripfeed::interpreter {

namespace {

using ir::Function;

std::uint64_t key_of(std::uint32_t row, std::uint32_t number) { return std::uint64_t{row} << 32 | number; }

// Groups by the numbers that #4001 and its followers have; 0 is none.
constexpr ir::ModalGroup kGroups[] = {
    ir::ModalGroup::none, ir::ModalGroup::motion,        ir::ModalGroup::plane,       ir::ModalGroup::distance,
    ir::ModalGroup::none, ir::ModalGroup::feed,          ir::ModalGroup::unit,        ir::ModalGroup::comp,
    ir::ModalGroup::none, ir::ModalGroup::none,          ir::ModalGroup::none,        ir::ModalGroup::none,
    ir::ModalGroup::none, ir::ModalGroup::surface_speed, ir::ModalGroup::work_offset, ir::ModalGroup::exact_stop,
};

Function function_of(ir::ModalGroup group, const Modes& modes) {
  constexpr Function kPlanes[] = {Function::plane_xy, Function::plane_zx, Function::plane_yz};
  constexpr Function kFeeds[] = {Function::feed_per_min, Function::feed_per_rev, Function::feed_inverse_time};
  constexpr Function kComps[] = {Function::comp_off, Function::comp_left, Function::comp_right};
  if (group == ir::ModalGroup::motion) return modes.motion;
  if (group == ir::ModalGroup::plane) return kPlanes[static_cast<std::size_t>(modes.plane)];
  if (group == ir::ModalGroup::distance) return modes.absolute ? Function::absolute : Function::incremental;
  if (group == ir::ModalGroup::feed) return kFeeds[static_cast<std::size_t>(modes.feed_mode)];
  if (group == ir::ModalGroup::unit) return modes.inch ? Function::unit_inch : Function::unit_mm;
  if (group == ir::ModalGroup::comp) return kComps[static_cast<std::size_t>(modes.comp)];
  if (group == ir::ModalGroup::surface_speed)
    return modes.surface_speed ? Function::surface_speed_on : Function::surface_speed_off;
  if (group == ir::ModalGroup::exact_stop)
    return modes.exact_stop ? Function::exact_stop_mode : Function::continuous_path;
  return group == ir::ModalGroup::work_offset ? Function::work_offset : Function::none;
}

// Place of the active code in a G group of SINUMERIK, counted as its list of G functions does (PG, "G functions").
std::optional<double> index_in_group(std::uint32_t group, const Modes& modes) {
  constexpr std::uint32_t kMotion = 1;
  constexpr std::uint32_t kPlane = 6;
  constexpr std::uint32_t kComp = 7;
  constexpr std::uint32_t kOffset = 8;
  constexpr std::uint32_t kUnit = 13;
  constexpr std::uint32_t kDistance = 14;
  constexpr std::uint32_t kFeed = 15;
  constexpr std::uint32_t kDiameter = 29;
  if (group == kMotion && modes.motion_given && modes.motion <= Function::arc_ccw)
    return 1.0 + static_cast<double>(modes.motion) - static_cast<double>(Function::rapid);
  if (group == kPlane) return 1.0 + static_cast<double>(modes.plane);
  if (group == kComp) return 1.0 + static_cast<double>(modes.comp);
  if (group == kOffset && modes.work_offset >= 0) return 1.0 + static_cast<double>(modes.work_offset);
  if (group == kUnit && modes.inch) return modes.inch_feed ? 3.0 : 1.0;  // G71 and G710 cannot be told apart
  if (group == kDistance) return modes.absolute ? 1.0 : 2.0;
  if (group == kFeed) {
    if (modes.surface_speed) return 4.0;
    return modes.feed_mode == ir::FeedMode::inverse_time ? 1.0 : modes.feed_mode == ir::FeedMode::per_min ? 2.0 : 3.0;
  }
  if (group == kDiameter) return 1.0 + static_cast<double>(modes.diameter);
  return std::nullopt;
}

// Of the block before, in the unit and the coordinates of the program.
std::optional<double> end_position(const ir::Control& control, std::size_t place, const ModalState& state) {
  if (place >= ir::kAxisCount || (state.unknown >> place & 1U) != 0) return std::nullopt;
  double value = state.position[place] - state.modes.shift[place] - state.coordinate_shift[place];
  const BlockRules rules(control);
  if (state.modes.has_matrix && place < 3) {
    if ((state.unknown & 7U) != 0) return std::nullopt;
    value = programmed_position(rules, state)[place] * (place == 0 && rules.x_is_diameter ? 2.0 : 1.0);
  }
  const auto kind = static_cast<ir::Axis>(place);
  if (kind == ir::Axis::x) value /= rules.x_factor(state.modes, false);
  const bool rotary = kind == ir::Axis::a || kind == ir::Axis::b || kind == ir::Axis::c;
  return state.modes.inch && !rotary ? value / 25.4 : value;
}

}  // namespace

std::optional<double> answer_system(const ir::Control& control, const ir::SystemVariableRow& row,
                                    const Indices& indices, const ModalState& state) {
  switch (row.kind) {
    case ir::SystemValue::end_position: return end_position(control, indices[0], state);
    case ir::SystemValue::feed:
      if (state.feed_unknown) return std::nullopt;
      return state.modes.inch_feed ? state.feed / 25.4 : state.feed;
    case ir::SystemValue::spindle_speed:
      if (indices[0] > 1) return std::nullopt;  // another spindle
      return state.modes.surface_speed ? state.surface_speed_m_min : state.rpm;
    case ir::SystemValue::tool_number:
      return state.tool.name == kNoText ? std::optional(static_cast<double>(state.tool.number)) : std::nullopt;
    case ir::SystemValue::selected_tool:
      return state.selected.name == kNoText ? std::optional(static_cast<double>(state.selected.number)) : std::nullopt;
    case ir::SystemValue::tool_edge: return static_cast<double>(state.tool.offset);
    case ir::SystemValue::spindle_direction:
      if (indices[0] > 1) return std::nullopt;
      return state.spindle == ir::SpindleState::clockwise ? 3.0
             : state.spindle == ir::SpindleState::stopped ? 5.0
                                                          : 4.0;
    case ir::SystemValue::constant: return static_cast<double>(row.first);
    case ir::SystemValue::active_code: return index_in_group(indices[0], state.modes);
    case ir::SystemValue::not_modelled:
    case ir::SystemValue::machine_position:
    case ir::SystemValue::work_offset_value:
    case ir::SystemValue::clock_ms: break;
  }
  return std::nullopt;
}

std::optional<double> SystemValues::read(std::uint32_t row, std::uint32_t number, const ModalState& state) const {
  if (const auto found = written_.find(key_of(row, number)); found != written_.end()) return found->second;
  if (row >= control_.system_variables.size()) return std::nullopt;
  const ir::SystemVariableRow& entry = control_.system_variables[row];
  const std::uint32_t index = entry.name.empty() ? number - entry.first : number;
  switch (entry.kind) {
    case ir::SystemValue::end_position: {
      // Axes are counted as the control has them.
      if (index >= control_.axes.size()) return std::nullopt;
      const std::size_t place = kAxisLetters.find(control_.axes[index]);
      return place == std::string_view::npos ? std::nullopt : end_position(control_, place, state);
    }
    case ir::SystemValue::feed: return state.modes.inch_feed ? state.feed / 25.4 : state.feed;
    case ir::SystemValue::spindle_speed: return state.modes.surface_speed ? state.surface_speed_m_min : state.rpm;
    case ir::SystemValue::tool_number: return static_cast<double>(state.tool.number);
    case ir::SystemValue::active_code: return active_code(index + 1, state);
    case ir::SystemValue::selected_tool:
    case ir::SystemValue::tool_edge:
    case ir::SystemValue::spindle_direction:
    case ir::SystemValue::constant: return answer_system(control_, entry, {}, state);
    case ir::SystemValue::not_modelled:
    case ir::SystemValue::machine_position:
    case ir::SystemValue::work_offset_value:
    case ir::SystemValue::clock_ms: break;
  }
  return std::nullopt;
}

void SystemValues::write(std::uint32_t row, std::uint32_t number, double value) {
  written_[key_of(row, number)] = value;
}

std::optional<double> SystemValues::active_code(std::uint32_t group, const ModalState& state) const {
  if (group >= std::size(kGroups)) return std::nullopt;
  const Function function = function_of(kGroups[group], state.modes);
  if (function == Function::none) return std::nullopt;
  for (const ir::CodeRow& row : control_.g_codes) {
    const bool same = row.function == function && row.number10 >= 0;
    if (same && (function != Function::work_offset || row.argument == state.modes.work_offset))
      return static_cast<double>(row.number10) / 10.0;
  }
  return std::nullopt;
}

}  // namespace dripfeed::interpreter
