// One row a function that stays in effect.
#include "dialects/facts/modal_facts.h"

#include <algorithm>
#include <string_view>

#include "dialects/ir/cycle.h"

namespace dripfeed::facts {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;

struct FunctionRow {
  Function function;
  Mode mode;
  std::string_view description;
};
constexpr FunctionRow kFunctions[] = {
    {Function::feed_per_min, Mode::feed, "feed per minute"},
    {Function::feed_per_rev, Mode::feed, "feed per revolution"},
    {Function::feed_inverse_time, Mode::feed, "inverse-time feed"},
    {Function::surface_speed_on, Mode::surface_speed, "constant surface speed"},
    {Function::surface_speed_off, Mode::surface_speed, "constant spindle speed"},
    {Function::unit_inch, Mode::unit, "inch"},
    {Function::unit_mm, Mode::unit, "millimetre"},
    {Function::absolute, Mode::distance, "absolute"},
    {Function::incremental, Mode::distance, "incremental"},
    {Function::plane_xy, Mode::plane, "the plane XY"},
    {Function::plane_zx, Mode::plane, "the plane ZX"},
    {Function::plane_yz, Mode::plane, "the plane YZ"},
    {Function::diameter_on, Mode::diameter, "diameter"},
    {Function::diameter_off, Mode::diameter, "radius"},
    {Function::diameter_absolute_only, Mode::diameter, "diameter where absolute"},
    {Function::drill, Mode::cycle, "a drilling cycle"},
    {Function::turning_cycle, Mode::cycle, "a turning cycle"},
    {Function::cycle_off, Mode::cycle, "no cycle"},
    {Function::comp_off, Mode::compensation, "no radius compensation"},
    {Function::comp_left, Mode::compensation, "radius compensation on the left"},
    {Function::comp_right, Mode::compensation, "radius compensation on the right"},
    {Function::work_offset, Mode::work_offset, "a work offset"},
    {Function::extended_offset, Mode::work_offset, "an additional work offset"},
    {Function::return_to_initial, Mode::return_level, "return to the initial level"},
    {Function::return_to_r, Mode::return_level, "return to the R level"},
    {Function::exact_stop_mode, Mode::path, "exact stop"},
    {Function::continuous_path, Mode::path, "continuous path"},
    {Function::spindle_cw, Mode::spindle, "the spindle clockwise"},
    {Function::spindle_ccw, Mode::spindle, "the spindle counterclockwise"},
    {Function::spindle_stop, Mode::spindle, "the spindle stopped"},
    {Function::spindle_orient, Mode::spindle, "the spindle oriented"},
    {Function::coolant_mist, Mode::coolant, "mist"},
    {Function::coolant_flood, Mode::coolant, "coolant"},
    {Function::coolant_off, Mode::coolant, "no coolant"},
    {Function::length_offset_plus, Mode::length, "a tool length"},
    {Function::length_offset_minus, Mode::length, "a subtracted tool length"},
    {Function::length_offset_off, Mode::length, "no tool length"},
    {Function::rotate, Mode::frame, "a rotation"},
    {Function::scale, Mode::frame, "a scaling"},
    {Function::mirror, Mode::frame, "a mirror image"},
    {Function::transformation, Mode::transformation, "a transformation"},
    {Function::pole_from_last, Mode::pole, "a pole"},
    {Function::pole_from_zero, Mode::pole, "a pole"},
    {Function::pole_from_pole, Mode::pole, "a pole"},
    {Function::polar_words_on, Mode::letters, "polar words"},
    {Function::polar_words_off, Mode::letters, "no polar words"},
};

// By function: its row, one more than its index; 0 for functions without one. Asked for each code of each block.
constexpr auto kRowOfFunction = [] {
  std::array<std::uint8_t, static_cast<std::size_t>(Function::count_)> rows{};
  for (std::size_t i = 0; i < std::size(kFunctions); ++i)
    rows[static_cast<std::size_t>(kFunctions[i].function)] = static_cast<std::uint8_t>(i + 1);
  return rows;
}();

const FunctionRow* row_of(Function function) {
  const std::uint8_t row = kRowOfFunction[static_cast<std::size_t>(function)];
  return row == 0 ? nullptr : &kFunctions[row - 1];
}

// Of codes that the control knows and nothing here interprets: what they take the place of.
struct GroupRow {
  ModalGroup group;
  Mode mode;
};
constexpr GroupRow kGroups[] = {
    {ModalGroup::plane, Mode::plane},       {ModalGroup::distance, Mode::distance},
    {ModalGroup::feed, Mode::feed},         {ModalGroup::unit, Mode::unit},
    {ModalGroup::comp, Mode::compensation}, {ModalGroup::length_offset, Mode::length},
    {ModalGroup::cycle, Mode::cycle},       {ModalGroup::return_level, Mode::return_level},
    {ModalGroup::exact_stop, Mode::path},   {ModalGroup::work_offset, Mode::work_offset},
    {ModalGroup::diameter, Mode::diameter}, {ModalGroup::surface_speed, Mode::surface_speed},
    {ModalGroup::spindle, Mode::spindle},   {ModalGroup::coolant, Mode::coolant},
    {ModalGroup::motion, Mode::motion},
};

constexpr bool is_motion(Function f) { return f >= Function::rapid && f <= Function::tap_retract; }

Function diameter_at_power_on(ir::DiameterMode mode) {
  if (mode == ir::DiameterMode::radius) return Function::diameter_off;
  return mode == ir::DiameterMode::diameter ? Function::diameter_on : Function::diameter_absolute_only;
}

template <class T, std::size_t kCount>
bool join_all(std::array<Known<T>, kCount>& facts, const std::array<Known<T>, kCount>& with) {
  bool less = false;
  for (std::size_t i = 0; i < kCount; ++i) less |= facts[i].join(with[i]);
  return less;
}

}  // namespace

std::optional<Mode> mode_of(const ir::Code& code) {
  if (is_motion(code.function)) return code.group == ModalGroup::non_modal ? std::nullopt : std::optional(Mode::motion);
  if (const FunctionRow* const row = row_of(code.function)) return row->mode;
  if (code.function != Function::not_modelled) return std::nullopt;
  const auto* const group = std::ranges::find(kGroups, code.group, &GroupRow::group);
  return group == std::end(kGroups) ? std::nullopt : std::optional(group->mode);
}

Setting power_on(Mode mode, const ir::Control& control) {
  const ir::Semantics& s = control.semantics;
  switch (mode) {
    case Mode::feed: return {s.power_on_feed};
    case Mode::surface_speed: return {Function::surface_speed_off};
    case Mode::unit: return {s.power_on_unit};
    case Mode::distance: return {s.power_on_distance};
    case Mode::plane: return {s.power_on_plane};
    case Mode::diameter: return {diameter_at_power_on(s.power_on_diameter)};
    case Mode::motion: return {s.power_on_known ? s.power_on_motion : Function::none};
    case Mode::cycle: return {Function::cycle_off};
    case Mode::compensation: return {Function::comp_off};
    case Mode::hole_end:
    case Mode::return_level: return {Function::return_to_initial};
    case Mode::path: return {Function::continuous_path};
    case Mode::spindle: return {Function::spindle_stop};
    case Mode::coolant: return {Function::coolant_off};
    case Mode::length: return {Function::length_offset_off};
    case Mode::letters: return {Function::polar_words_off};
    case Mode::work_offset:
    case Mode::frame:
    case Mode::modal_call:
    case Mode::transformation:
    case Mode::pole:
    case Mode::thread_data:
    case Mode::peck_data:
    case Mode::count_: break;
  }
  return {};
}

std::optional<Number> axis_of(Address address) {
  switch (address) {
    case Address::x: return Number::x;
    case Address::y: return Number::y;
    case Address::z: return Number::z;
    case Address::a: return Number::a;
    case Address::b: return Number::b;
    case Address::c: return Number::c;
    case Address::u: return Number::u;
    case Address::v: return Number::v;
    case Address::w: return Number::w;
    default: return std::nullopt;
  }
}

std::string_view description_of(const Setting& setting) {
  const FunctionRow* const row = row_of(setting.function);
  return row == nullptr ? ir::name_of(setting.function) : row->description;
}

ToolLength tool_length(const Facts& facts) {
  constexpr Setting kOff{.function = Function::length_offset_off};
  const Known<Setting>& length = facts[Mode::length];
  const Known<double>& number = facts[Number::length_number];
  if (length.is(kOff) || number.is(0.0)) return ToolLength::off;
  return length.may_be(kOff) || number.may_be(0.0) ? ToolLength::unknown : ToolLength::on;
}

void Facts::forget_all(std::uint32_t changer) {
  for (Known<Setting>& mode : modes) mode.forget(changer);
  for (Known<double>& number : numbers) number.forget(changer);
  for (Known<Written>& word : kept) word.forget(changer);
}

void Facts::forget_positions(std::uint32_t changer) {
  for (auto i = static_cast<std::size_t>(kFirstAxis); i < kNumbers; ++i) numbers[i].forget(changer);
  for (const Kept name : {Kept::at_x, Kept::at_y, Kept::at_z}) (*this)[name].forget(changer);
}

bool Facts::join(const Facts& with) {
  const std::array less = {join_all(modes, with.modes), join_all(numbers, with.numbers), join_all(kept, with.kept)};
  return std::ranges::find(less, true) != less.end();
}

}  // namespace dripfeed::facts
