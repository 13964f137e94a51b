// Answers by kind of value.
#include "dialects/interpreter/machine/system_values.h"

#include <cmath>

#include "dialects/interpreter/bytecode/variable_map.h"
#include "dialects/interpreter/machine/trace.h"
#include "dialects/interpreter/motion/polar.h"
#include "dialects/ir/axis_letters.h"

namespace dripfeed::interpreter {

namespace {

using ir::Function;
using ir::SystemValue;

std::uint64_t key_of(std::uint32_t row, std::uint32_t number) { return std::uint64_t{row} << 32 | number; }
std::uint32_t row_of(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 32); }
std::uint32_t number_of(std::uint64_t key) { return static_cast<std::uint32_t>(key); }

constexpr double kMsPerHour = 3.6e6;
constexpr bool is_rotary(std::size_t axis) { return axis >= 3 && axis <= 5; }

// #5201 external, #5221 G54 …; #7001 G54.1 P1 …, each 20 numbers after the one before.
constexpr std::uint32_t kFirstOffset = 5201;
constexpr std::uint32_t kFirstExtended = 7001;
constexpr std::uint32_t kOffsetStep = 20;
constexpr std::uint32_t number_of_offset(std::int32_t offset) {
  return offset > kExtendedOffset
             ? kFirstExtended + kOffsetStep * static_cast<std::uint32_t>(offset - kExtendedOffset - 1)
             : kFirstOffset + kOffsetStep * static_cast<std::uint32_t>(offset);
}
constexpr std::int32_t offset_of_number(std::uint32_t number) {
  return number >= kFirstExtended
             ? static_cast<std::int32_t>((number - kFirstExtended) / kOffsetStep) + kExtendedOffset + 1
             : static_cast<std::int32_t>((number - kFirstOffset) / kOffsetStep);
}

constexpr std::uint32_t kGroupNumbers = 100;  // #4001 and #4201 are of group 1

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

Function function_of(ir::LengthOffset offset) {
  if (offset == ir::LengthOffset::off) return Function::length_offset_off;
  return offset == ir::LengthOffset::plus ? Function::length_offset_plus : Function::length_offset_minus;
}

// A tool that the program has not named is the one from before it.
std::optional<double> number_of(const ir::Control& control, const Tool& tool, const ModalState& state, double number) {
  const bool may_be_older = control.semantics.unset_is_unknown && !state.tool_stated;
  return tool.name != kNoText || may_be_older ? std::nullopt : std::optional(number);
}

// Place of the active code in a G group of SINUMERIK, counted as its list of G functions does (PG, "G functions").
std::optional<double> index_in_group(std::uint32_t group, const ir::Control& control, const ModalState& state) {
  const Modes& modes = state.modes;
  constexpr std::uint32_t kMotion = 1;
  constexpr std::uint32_t kPlane = 6;
  constexpr std::uint32_t kComp = 7;
  constexpr std::uint32_t kOffset = 8;
  constexpr std::uint32_t kUnit = 13;
  constexpr std::uint32_t kDistance = 14;
  constexpr std::uint32_t kFeed = 15;
  constexpr std::uint32_t kDiameter = 29;
  // None of the control's groups: by them the texts of its cycles ask in what unit and plane they are called. 1 is mm.
  constexpr std::uint32_t kUnitOfCycle = 1013;
  constexpr std::uint32_t kPlaneOfCycle = 1006;
  if (group == kUnitOfCycle) return modes.inch ? 2.0 : 1.0;
  if (group == kPlaneOfCycle) return 1.0 + static_cast<double>(modes.plane);
  if (group == kMotion && modes.motion_given && modes.motion <= Function::arc_ccw)
    return 1.0 + static_cast<double>(modes.motion) - static_cast<double>(Function::rapid);
  const auto is_known = [&](ir::ModalGroup of) { return !may_be_older(control.semantics, state, of); };
  if (group == kPlane && is_known(ir::ModalGroup::plane)) return 1.0 + static_cast<double>(modes.plane);
  if (group == kComp && is_known(ir::ModalGroup::comp)) return 1.0 + static_cast<double>(modes.comp);
  if (group == kOffset && modes.work_offset >= 0) return 1.0 + static_cast<double>(modes.work_offset);
  if (group == kUnit && is_known(ir::ModalGroup::unit))
    return (modes.inch ? 1.0 : 2.0) + (modes.unit_of_feed ? 2.0 : 0.0);  // G70, G71, G700, G710
  if (group == kDistance && is_known(ir::ModalGroup::distance)) return modes.absolute ? 1.0 : 2.0;
  if (group == kFeed && is_known(ir::ModalGroup::feed)) {
    if (modes.surface_speed) return 4.0;
    return modes.feed_mode == ir::FeedMode::inverse_time ? 1.0 : modes.feed_mode == ir::FeedMode::per_min ? 2.0 : 3.0;
  }
  if (group == kDiameter && is_known(ir::ModalGroup::diameter)) return 1.0 + static_cast<double>(modes.diameter);
  return std::nullopt;
}

std::optional<double> programmed_speed(const ModalState& state) {
  if (state.speed_unknown) return std::nullopt;
  return state.modes.surface_speed ? state.surface_speed_m_min : state.rpm;
}

// Where the last measuring move ended.
std::optional<double> skip_position(const ir::Control& control, std::size_t place, const ModalState& state) {
  if (place >= ir::kAxisCount || (state.skipped_known >> place & 1U) == 0 || state.modes.has_matrix)
    return std::nullopt;
  double value = state.skipped[place] - state.modes.shift[place] - state.coordinate_shift[place];
  const auto kind = static_cast<ir::Axis>(place);
  if (kind == ir::Axis::x) value /= BlockRules(control).x_factor(state.modes, false);
  const bool rotary = kind == ir::Axis::a || kind == ir::Axis::b || kind == ir::Axis::c;
  return state.modes.inch && !rotary ? value / 25.4 : value;
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
    case ir::SystemValue::skip_position: return skip_position(control, indices[0], state);
    case ir::SystemValue::feed:
      if (state.feed_unknown) return std::nullopt;
      return state.modes.inch_feed ? state.feed / 25.4 : state.feed;
    case ir::SystemValue::spindle_speed:
      if (indices[0] > 1) return std::nullopt;  // another spindle
      return programmed_speed(state);
    case ir::SystemValue::tool_number:
      return number_of(control, state.tool, state, static_cast<double>(state.tool.number));
    case ir::SystemValue::selected_tool:
      return number_of(control, state.selected, state, static_cast<double>(state.selected.number));
    case ir::SystemValue::tool_edge: return number_of(control, Tool{}, state, static_cast<double>(state.tool.offset));
    case ir::SystemValue::spindle_direction:
      if (indices[0] > 1) return std::nullopt;
      return state.spindle == ir::SpindleState::clockwise ? 3.0
             : state.spindle == ir::SpindleState::stopped ? 5.0
                                                          : 4.0;
    case ir::SystemValue::constant: return static_cast<double>(row.first);
    case ir::SystemValue::active_code: return index_in_group(indices[0], control, state);
    case ir::SystemValue::not_modelled:
    case ir::SystemValue::programmable_frame:
    case ir::SystemValue::base_frame:
    case ir::SystemValue::base_frame_in_data:
    case ir::SystemValue::settable_frame:
    case ir::SystemValue::active_frame:
    case ir::SystemValue::total_frame:
    case ir::SystemValue::call_argument:
    case ir::SystemValue::call_argument_given:
    case ir::SystemValue::parameter_given:
    case ir::SystemValue::machine_position:
    case ir::SystemValue::work_offset_value:
    case ir::SystemValue::comp_number:
    case ir::SystemValue::length_number:
    case ir::SystemValue::block_number:
    case ir::SystemValue::program_number:
    case ir::SystemValue::clock_hours:
    case ir::SystemValue::clock_ms:
    case ir::SystemValue::changing:
    case ir::SystemValue::tool_type:
    case ir::SystemValue::tool_length:
    case ir::SystemValue::tool_radius: break;
  }
  return std::nullopt;
}

SystemValues::Key SystemValues::key_of_value(std::uint32_t row, std::uint32_t number) const {
  if (row >= control_.system_variables.size()) return {row, number};
  const ir::SystemVariableRow& entry = control_.system_variables[row];
  if (entry.extended_offset == 0) return {row, number};
  return {kExtendedOffsetRow, number_of_offset(kExtendedOffset + static_cast<std::int32_t>(entry.extended_offset)) +
                                  (number - entry.first)};
}

std::optional<double> SystemValues::read(std::uint32_t row, std::uint32_t number, const ModalState& state) const {
  const Key key = key_of_value(row, number);
  if (const auto found = written_.find(key_of(key.row, key.number)); found != written_.end()) return found->second;
  if (row >= control_.system_variables.size()) return std::nullopt;
  const ir::SystemVariableRow& entry = control_.system_variables[row];
  const std::uint32_t index = entry.name.empty() ? number - entry.first : number;
  switch (entry.kind) {
    case SystemValue::end_position:
      if (state.modes.has_matrix) return end_position(control_, place_of(index), state);
      return position(index, state.position, ~state.unknown & kAllAxes, state);
    case SystemValue::skip_position: return position(index, state.skipped, state.skipped_known, state);
    case SystemValue::machine_position: return machine_position(index, state);
    case SystemValue::feed:
      if (state.feed_unknown) return std::nullopt;
      return given(state.modes.inch_feed ? state.feed / 25.4 : state.feed);
    case SystemValue::spindle_speed: return programmed_speed(state).and_then([&](double s) { return given(s); });
    case SystemValue::tool_number: return given(static_cast<double>(state.tool.number));
    case SystemValue::comp_number: return given(state.comp_number);
    case SystemValue::length_number: return given(state.length_number);
    case SystemValue::active_code: return active_code(number % kGroupNumbers, state);
    case SystemValue::clock_ms:
      return value_of(milliseconds_, state.clock_ms, state).transform([](double ms) { return std::floor(ms); });
    case SystemValue::clock_hours: return value_of(hours_, state.clock_ms / kMsPerHour, state);
    case SystemValue::selected_tool:
    case SystemValue::tool_edge:
    case SystemValue::spindle_direction:
    case SystemValue::constant: return answer_system(control_, entry, {}, state);
    case SystemValue::not_modelled:
    case SystemValue::programmable_frame:
    case SystemValue::base_frame:
    case SystemValue::base_frame_in_data:
    case SystemValue::settable_frame:
    case SystemValue::active_frame:
    case SystemValue::total_frame:
    case SystemValue::call_argument:
    case SystemValue::call_argument_given:
    case SystemValue::parameter_given:
    case SystemValue::work_offset_value:
    case SystemValue::block_number:
    case SystemValue::program_number:
    case SystemValue::changing:
    case SystemValue::tool_type:
    case SystemValue::tool_length:
    case SystemValue::tool_radius: break;
  }
  return std::nullopt;
}

std::optional<double> SystemValues::value_of(const Clock& clock, double counted, const ModalState& state) const {
  if (control_.semantics.unset_is_unknown && clock.untimed != state.untimed) return std::nullopt;
  return clock.from + counted;
}

// What was in effect before the program began is not known: 0 stands for "not named yet".
std::optional<double> SystemValues::given(double value) const {
  const bool may_be_older = control_.semantics.has_vacant && control_.semantics.unset_is_unknown;
  if (value == 0.0 && may_be_older) return std::nullopt;
  return value;
}

namespace {

// #2001 and #10001 and what follows them; their rows have no names.
bool entry_is_tool_offset(const ir::Control& control, std::uint32_t row, std::uint32_t number) {
  if (row == kExtendedOffsetRow) return false;
  if (row < control.system_variables.size()) {
    const ir::SystemVariableRow& entry = control.system_variables[row];
    if (!entry.name.empty() || entry.kind == SystemValue::work_offset_value) return false;
  }
  return (number >= 2001 && number <= 2999) || (number >= 10001 && number <= 19999);
}

// Of radii, too: memory A has one row for both, C those from #12001 on.
bool may_be_radius(std::uint32_t number) {
  constexpr std::uint32_t kLastOfLengths = 12'000;
  return number < 10'001 || number > kLastOfLengths;
}

// Common variables that are an option, and have no row.
bool may_be_common(std::uint32_t number) {
  constexpr std::uint32_t kFirstSystem = 1000;
  constexpr std::uint32_t kFirstBeyond = 900'000;
  return number < kFirstSystem || number >= kFirstBeyond;
}

// Not a number without a row, nor one whose row does not say that writing it changes nothing.
bool is_understood(const ir::Control& control, std::uint32_t row, std::uint32_t number) {
  if (row == kExtendedOffsetRow) return true;
  if (row >= control.system_variables.size()) return may_be_common(number);
  const ir::SystemVariableRow& entry = control.system_variables[row];
  return !entry.name.empty() || entry.inert || entry.kind != SystemValue::not_modelled;
}

}  // namespace

bool SystemValues::write(std::uint32_t row, std::uint32_t number, double value, ModalState& state) {
  const Key key = key_of_value(row, number);
  const SystemValue kind = key.row == kExtendedOffsetRow            ? SystemValue::work_offset_value
                           : row < control_.system_variables.size() ? control_.system_variables[row].kind
                                                                    : SystemValue::not_modelled;
  if (kind == SystemValue::clock_ms) {
    milliseconds_ = {value - state.clock_ms, state.untimed};
  } else if (kind == SystemValue::clock_hours) {
    hours_ = {value - state.clock_ms / kMsPerHour, state.untimed};
  } else if (kind != SystemValue::changing) {
    if (kind == SystemValue::work_offset_value) {
      move_offset(key.number, value, state);
      state.gaps |= ir::kZerosChanged;
    }
    if (entry_is_tool_offset(control_, row, number)) {
      state.gaps |= ir::kLengthsChanged;
      if (may_be_radius(number)) state.gaps |= ir::kRadiiChanged;
    }
    written_[key_of(key.row, key.number)] = value;
  }
  const bool understood = is_understood(control_, row, number);
  if (!understood) state.gaps |= ir::kZerosChanged | ir::kLengthsChanged | ir::kRadiiChanged;
  return understood;
}

void SystemValues::forget_tool_offsets() {
  std::erase_if(written_, [&](const auto& one) {
    return entry_is_tool_offset(control_, row_of(one.first), number_of(one.first));
  });
}

// No one wrote it: what the machine's profile says counts on.
void SystemValues::start_with(std::uint32_t row, std::uint32_t number, double value, ModalState& state) {
  const std::uint8_t gaps = state.gaps;
  if (!write(row, number, value, state)) state.gaps = gaps;
}

void SystemValues::set_initial(std::uint32_t row, std::uint32_t number, double value, ModalState& state) {
  const bool in_table = row < control_.system_variables.size();
  if (!in_table || control_.system_variables[row].kind != SystemValue::skip_position)
    return start_with(row, number, value, state);
  const std::size_t place = place_of(number - control_.system_variables[row].first);
  if (place >= ir::kAxisCount) return;
  state.touch[place] = value;
  state.touch_known |= static_cast<std::uint16_t>(1U << place);
}

// Axes are counted as the control has them; kAxisCount: it has no such.
std::size_t SystemValues::place_of(std::uint32_t axis) const {
  if (axis >= control_.axes.size()) return ir::kAxisCount;
  const std::size_t place = ir::kAxisLetters.find(control_.axes[axis]);
  return place == std::string_view::npos ? ir::kAxisCount : place;
}

// Of the block before, in the unit and the coordinates of the program.
std::optional<double> SystemValues::position(std::uint32_t axis, const AxisValues& of, std::uint16_t known,
                                             const ModalState& state) const {
  const std::size_t place = place_of(axis);
  if (place >= ir::kAxisCount || (known >> place & 1U) == 0) return std::nullopt;
  double value = of[place] - state.modes.shift[place] - state.coordinate_shift[place];
  if (place == 0) value /= rules_.x_factor(state.modes, false);
  return state.modes.inch && !is_rotary(place) ? value / 25.4 : value;
}

// Known where the offset in effect was set by the program or before the start.
std::optional<double> SystemValues::machine_position(std::uint32_t axis, const ModalState& state) const {
  const std::size_t place = place_of(axis);
  if (place >= ir::kAxisCount || (state.unknown >> place & 1U) != 0) return std::nullopt;
  const auto offset = offset_mm(state.modes.work_offset, place, state);
  if (!offset) return std::nullopt;
  const double value = state.position[place] + *offset + offset_mm(0, place, state).value_or(0.0);
  return state.modes.inch && !is_rotary(place) ? value / 25.4 : value;
}

// 0 is the external offset.
std::optional<double> SystemValues::offset_mm(std::int32_t offset, std::size_t axis, const ModalState& state) const {
  const std::size_t index = control_.axes.find(ir::kAxisLetters[axis]);
  if (offset < 0 || index == std::string::npos) return std::nullopt;
  const std::uint32_t number = number_of_offset(offset) + static_cast<std::uint32_t>(index);
  const auto kept = [&](std::uint32_t row) -> std::optional<double> {
    const auto found = written_.find(key_of(row, number));
    // It may have been set to a value that is not known.
    if (found == written_.end() || !std::isfinite(found->second)) return std::nullopt;
    return state.modes.inch && !is_rotary(axis) ? found->second * 25.4 : found->second;
  };
  if (offset > kExtendedOffset) return kept(kExtendedOffsetRow);
  for (std::uint32_t row = 0; row < control_.system_variables.size(); ++row) {
    const ir::SystemVariableRow& entry = control_.system_variables[row];
    if (entry.name.empty() && number >= entry.first && number <= entry.last) return kept(row);
  }
  return std::nullopt;
}

// The machine stays where it is, so that the position counted from the offset changes by as much as the offset does.
void SystemValues::move_offset(std::uint32_t number, double value, ModalState& state) {
  const std::int32_t offset = offset_of_number(number);
  if (offset != 0 && offset != state.modes.work_offset) return;
  const std::uint32_t first = number_of_offset(offset);
  const std::size_t place = place_of(number - first);
  if (place >= ir::kAxisCount) return;
  if (const auto before = offset_mm(offset, place, state); before && std::isfinite(value)) {
    state.position[place] += *before - (state.modes.inch && !is_rotary(place) ? value * 25.4 : value);
  } else {
    state.unknown |= static_cast<std::uint16_t>(1U << place);
  }
}

std::optional<double> SystemValues::active_code(std::uint32_t group, const ModalState& state) const {
  constexpr std::uint32_t kLength = 8;
  if (group >= std::size(kGroups)) return std::nullopt;
  // Lathes number these otherwise, each control by its own rules.
  const bool otherwise = group == 2 || group == 13 || group == 15;
  if (control_.kind == ir::MachineKind::lathe && otherwise) return std::nullopt;
  const ir::ModalGroup of = group == kLength ? ir::ModalGroup::length_offset : kGroups[group];
  if (modes_unknown_ && !state.has_stated(of) && !(of == ir::ModalGroup::motion && state.modes.motion_given))
    return std::nullopt;
  const Function function =
      group == kLength ? function_of(state.length_offset) : function_of(kGroups[group], state.modes);
  if (function == Function::none) return std::nullopt;
  for (const ir::CodeRow& row : control_.g_codes) {
    const bool same = row.function == function && row.number10 >= 0;
    if (same && (function != Function::work_offset || row.argument == state.modes.work_offset))
      return static_cast<double>(row.number10) / 10.0;
  }
  return std::nullopt;
}

}  // namespace dripfeed::interpreter
