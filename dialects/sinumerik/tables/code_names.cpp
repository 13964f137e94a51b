// Tables of functions; offsets and M functions are counted.
#include "dialects/sinumerik/tables/code_names.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "dialects/ir/frame_use.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Function;

struct CodeName {
  Function function;
  std::string_view name;
};
// Functions with one name, whatever their argument.
constexpr auto kNames = std::to_array<CodeName>({
    {Function::rapid, "G0"},
    {Function::linear, "G1"},
    {Function::arc_cw, "G2"},
    {Function::arc_ccw, "G3"},
    {Function::thread, "G33"},
    {Function::tap, "G331"},
    {Function::tap_retract, "G332"},
    {Function::dwell, "G4"},
    {Function::exact_stop_once, "G9"},
    {Function::exact_stop_mode, "G60"},
    {Function::continuous_path, "G64"},
    {Function::plane_xy, "G17"},
    {Function::plane_zx, "G18"},
    {Function::plane_yz, "G19"},
    {Function::unit_inch, "G700"},
    {Function::unit_mm, "G710"},
    {Function::absolute, "G90"},
    {Function::incremental, "G91"},
    {Function::feed_per_min, "G94"},
    {Function::feed_per_rev, "G95"},
    {Function::feed_inverse_time, "G93"},
    {Function::diameter_on, "DIAMON"},
    {Function::diameter_off, "DIAMOF"},
    {Function::diameter_absolute_only, "DIAM90"},
    {Function::machine_coordinates, "SUPA"},
    {Function::local_shift, "TRANS"},
    {Function::local_shift_add, "ATRANS"},
    {Function::comp_off, "G40"},
    {Function::comp_left, "G41"},
    {Function::comp_right, "G42"},
    {Function::tool_change, "M6"},
    {Function::surface_speed_on, "G96"},
    {Function::surface_speed_off, "G97"},
    {Function::spindle_cw, "M3"},
    {Function::spindle_ccw, "M4"},
    {Function::spindle_stop, "M5"},
    {Function::spindle_orient, "M19"},
    {Function::coolant_mist, "M7"},
    {Function::coolant_flood, "M8"},
    {Function::coolant_off, "M9"},
    {Function::program_stop, "M0"},
    {Function::optional_stop, "M1"},
    {Function::program_end, "M2"},
    {Function::program_end_rewind, "M30"},
    {Function::subprogram_end, "M17"},
});

std::string_view name_of_frame(const ir::Code& c) {
  struct Row {
    Function function;
    std::string_view adds;
    std::string_view replaces;
  };
  static constexpr Row kFrames[] = {
      {Function::rotate, "AROT", "ROT"}, {Function::scale, "ASCALE", "SCALE"}, {Function::mirror, "AMIRROR", "MIRROR"}};
  const auto* const row = std::ranges::find(kFrames, c.function, &Row::function);
  if (row == std::end(kFrames)) return {};
  return c.argument == ir::kFrameAdds ? row->adds : c.argument == ir::kFrameReplaces ? row->replaces : "";
}

// G54 to G57; the fifth and sixth of the others are G505 and G506, and their further ones (above 100) follow those.
std::string name_of_offset(int number) {
  constexpr int kExtended = 100;
  constexpr int kLast = 99;
  const int own = number > kExtended ? number - kExtended + 6 : number;
  if (own < 0 || own > kLast) return {};
  if (own == 0) return "G500";
  return "G" + std::to_string(own <= 4 ? 53 + own : 500 + own);
}

}  // namespace

std::string name_of_code(const ir::Code& c) {
  if (c.function == Function::work_offset) return name_of_offset(c.argument);
  if (c.function == Function::machine_function) return "M" + std::to_string(c.argument);
  if (const std::string_view frame = name_of_frame(c); !frame.empty()) return std::string(frame);
  if (passes::is_floating_tap(c)) return "G63";
  if (c.function == Function::unit_inch && c.argument == 1) return "G70";
  if (c.function == Function::unit_mm && c.argument == 1) return "G71";
  const auto row = std::ranges::find(kNames, c.function, &CodeName::function);
  return row == kNames.end() ? std::string() : std::string(row->name);
}

}  // namespace dripfeed::sinumerik
