// Numbered parameters, and the names that the control gives values itself.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "dialects/linuxcnc/tables.h"

namespace dripfeed::linuxcnc {

namespace {

using ir::SystemValue;
using ir::VariableUse;

constexpr std::string_view kParameters = "LinuxCNC user manual, numbered parameters";

constexpr auto kSystem = std::to_array<ir::SystemVariableRow>({
    {"", 5061, 5069, SystemValue::skip_position, false, kParameters},
    {"", 5070, 5070, SystemValue::changing, false, kParameters},
    {"", 5161, 5199, SystemValue::not_modelled, true, kParameters},
    {"", 5210, 5220, SystemValue::not_modelled, true, kParameters},
    {"", 5221, 5400, SystemValue::work_offset_value, true, kParameters},
    {"", 5401, 5419, SystemValue::not_modelled, true, kParameters},
    {"", 5420, 5428, SystemValue::end_position, false, kParameters},
    {"", 5599, 5599, SystemValue::not_modelled, true, kParameters, true},
});

struct RangeRow {
  std::uint32_t first;
  std::uint32_t last;
  VariableUse use;
};
constexpr auto kRanges = std::to_array<RangeRow>({
    {1, 30, VariableUse::local},
    {31, 5060, VariableUse::permanent},
    {5061, 5070, VariableUse::system},
    {5071, 5160, VariableUse::permanent},
    {5161, 5199, VariableUse::system},
    {5200, 5209, VariableUse::permanent},
    {5210, 5428, VariableUse::system},
    {5429, 5598, VariableUse::permanent},
    {5599, 5599, VariableUse::system},
    {5600, 5601, VariableUse::permanent},
    {5997, 5998, VariableUse::common},  // #<_value> and #<_value_returned>
});

struct NamedPosition {
  std::string_view name;
  std::uint32_t number;
};
constexpr auto kPositions = std::to_array<NamedPosition>({
    {"_a", 5423},
    {"_b", 5424},
    {"_c", 5425},
    {"_u", 5426},
    {"_v", 5427},
    {"_value", 5997},
    {"_value_returned", 5998},
    {"_w", 5428},
    {"_x", 5420},
    {"_y", 5421},
    {"_z", 5422},
});
// Values that only the control has. A blank before and after each.
constexpr std::string_view kOwnNames =
    " _abs_a _abs_b _abs_c _abs_u _abs_v _abs_w _abs_x _abs_y _abs_z _absolute _adaptive_feed _call_level "
    "_ccomp _coord_system _current_pocket _current_tool _feed _feed_hold _feed_override _flood "
    "_ijk_absolute_mode _imperial _incremental _inverse_time _lathe_diameter_mode _lathe_radius_mode "
    "_metric _mist _motion_mode _plane _remap_level _retract_old_z _retract_r_plane _rpm _selected_pocket "
    "_selected_tool _speed_override _spindle_cw _spindle_css_mode _spindle_on _spindle_rpm_mode _task "
    "_tool_offset _units_per_minute _units_per_rev _vmajor _vminor ";

}  // namespace

std::uint32_t predefined(std::string_view name) {
  const auto row = std::ranges::find(kPositions, name, &NamedPosition::name);
  if (row != kPositions.end()) return row->number;
  const bool own =
      name.starts_with("_hal[") || name.starts_with("_ini[") || kOwnNames.contains(fmt::format(" {} ", name));
  return own ? kOnlyTheControlKnows : 0;
}

std::span<const ir::SystemVariableRow> system_variables() { return kSystem; }

std::vector<ir::VariableRange> variable_ranges() {
  std::vector<ir::VariableRange> ranges;
  ranges.reserve(kRanges.size());
  for (const RangeRow& r : kRanges) ranges.push_back({ir::Bank::hash, r.first, r.last, r.use, true});
  return ranges;
}

}  // namespace dripfeed::linuxcnc
