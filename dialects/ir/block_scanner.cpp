// The list of functions that plain blocks may have.
#include "dialects/ir/block_scanner.h"

#include <array>

namespace dripfeed::ir {

namespace {

constexpr std::array kPlainFunctions = {
    Function::rapid,
    Function::linear,
    Function::arc_cw,
    Function::arc_ccw,
    Function::thread,
    Function::dwell,
    Function::exact_stop_once,
    Function::exact_stop_mode,
    Function::continuous_path,
    Function::plane_xy,
    Function::plane_zx,
    Function::plane_yz,
    Function::unit_inch,
    Function::unit_mm,
    Function::absolute,
    Function::incremental,
    Function::feed_per_min,
    Function::feed_per_rev,
    Function::feed_inverse_time,
    Function::diameter_on,
    Function::diameter_off,
    Function::diameter_absolute_only,
    Function::work_offset,
    Function::machine_coordinates,
    Function::local_shift,
    Function::set_coordinates,
    Function::reference_return,
    Function::comp_off,
    Function::comp_left,
    Function::comp_right,
    Function::length_offset_plus,
    Function::length_offset_minus,
    Function::length_offset_off,
    Function::tool_change,
    Function::surface_speed_on,
    Function::surface_speed_off,
    Function::spindle_cw,
    Function::spindle_ccw,
    Function::spindle_stop,
    Function::spindle_orient,
    Function::coolant_mist,
    Function::coolant_flood,
    Function::coolant_off,
    Function::program_stop,
    Function::optional_stop,
    Function::program_end,
    Function::program_end_rewind,
    Function::cycle_off,
    Function::no_effect,
};

constexpr auto kIsPlain = [] {
  std::array<bool, static_cast<std::size_t>(Function::count_)> plain{};
  for (const Function function : kPlainFunctions) plain[static_cast<std::size_t>(function)] = true;
  return plain;
}();

}  // namespace

bool is_plain(Function function) { return kIsPlain[static_cast<std::size_t>(function)]; }

}  // namespace dripfeed::ir
