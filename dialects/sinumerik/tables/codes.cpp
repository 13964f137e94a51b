// Rows by number. G505 to G599 are one row each as well, made from one pattern. The references are to the list of G
// functions in the Programming Manual Fundamentals (PG) and its list of M functions.
#include "dialects/sinumerik/tables/codes.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

namespace {

using enum ir::Function;
using Group = ir::ModalGroup;
using enum WordUse;

// clang-format off
// G70 and G71 have the argument 1: they hold for lengths only, feeds stay in the machine's own unit.
constexpr auto kNumbered = std::to_array<GCode>({
  {{"G0", 0, rapid, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G1", 10, linear, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G2", 20, arc_cw, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G3", 30, arc_ccw, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G4", 40, dwell, 0, Group::non_modal, "PG, G group 2"}, 2, usual},
  {{"G5", 50, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G7", 70, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G9", 90, exact_stop_once, 0, Group::other, "PG, G group 11"}, 11, usual},
  {{"G17", 170, plane_xy, 0, Group::plane, "PG, G group 6"}, 6, usual},
  {{"G18", 180, plane_zx, 0, Group::plane, "PG, G group 6"}, 6, usual},
  {{"G19", 190, plane_yz, 0, Group::plane, "PG, G group 6"}, 6, usual},
  {{"G25", 250, not_modelled, 0, Group::frame, "PG, G group 3"}, 3, own},
  {{"G26", 260, not_modelled, 0, Group::frame, "PG, G group 3"}, 3, own},
  {{"G33", 330, thread, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G34", 340, thread_changing, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G35", 350, thread_changing, 1, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G40", 400, comp_off, 0, Group::comp, "PG, G group 7"}, 7, usual},
  {{"G41", 410, comp_left, 0, Group::comp, "PG, G group 7"}, 7, usual},
  {{"G42", 420, comp_right, 0, Group::comp, "PG, G group 7"}, 7, usual},
  {{"G53", 530, machine_coordinates, 0, Group::other, "PG, G group 9"}, 9, usual},
  {{"G54", 540, work_offset, 1, Group::work_offset, "PG, G group 8"}, 8, usual},
  {{"G55", 550, work_offset, 2, Group::work_offset, "PG, G group 8"}, 8, usual},
  {{"G56", 560, work_offset, 3, Group::work_offset, "PG, G group 8"}, 8, usual},
  {{"G57", 570, work_offset, 4, Group::work_offset, "PG, G group 8"}, 8, usual},
  {{"G58", 580, axial_shift, 0, Group::frame, "PG, G group 3"}, 3, usual},
  {{"G59", 590, axial_shift, 1, Group::frame, "PG, G group 3"}, 3, usual},
  {{"G60", 600, exact_stop_mode, 0, Group::exact_stop, "PG, G group 10"}, 10, usual},
  {{"G62", 620, not_modelled, 0, Group::other, "PG, G group 57"}, 57, usual},
  {{"G63", 630, linear, 0, Group::non_modal, "PG, G group 2"}, 2, usual},
  {{"G64", 640, continuous_path, 0, Group::exact_stop, "PG, G group 10"}, 10, usual},
  {{"G70", 700, unit_inch, 1, Group::unit, "PG, G group 13"}, 13, usual},
  {{"G71", 710, unit_mm, 1, Group::unit, "PG, G group 13"}, 13, usual},
  {{"G74", 740, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G75", 750, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G90", 900, absolute, 0, Group::distance, "PG, G group 14"}, 14, usual},
  {{"G91", 910, incremental, 0, Group::distance, "PG, G group 14"}, 14, usual},
  {{"G93", 930, feed_inverse_time, 0, Group::feed, "PG, G group 15"}, 15, usual},
  {{"G94", 940, feed_per_min, 0, Group::feed, "PG, G group 15"}, 15, usual},
  {{"G95", 950, feed_per_rev, 0, Group::feed, "PG, G group 15"}, 15, usual},
  {{"G96", 960, surface_speed_on, 0, Group::surface_speed, "PG, G group 15"}, 15, usual},
  {{"G97", 970, surface_speed_off, 0, Group::surface_speed, "PG, G group 15"}, 15, usual},
  {{"G110", 1100, pole_from_last, 0, Group::frame, "PG, G group 3"}, 3, usual},
  {{"G111", 1110, pole_from_zero, 0, Group::frame, "PG, G group 3"}, 3, usual},
  {{"G112", 1120, pole_from_pole, 0, Group::frame, "PG, G group 3"}, 3, usual},
  {{"G140", 1400, not_modelled, 0, Group::other, "PG, G group 43"}, 43, usual},
  {{"G141", 1410, not_modelled, 0, Group::other, "PG, G group 43"}, 43, usual},
  {{"G142", 1420, not_modelled, 0, Group::other, "PG, G group 43"}, 43, usual},
  {{"G143", 1430, not_modelled, 0, Group::other, "PG, G group 43"}, 43, usual},
  {{"G147", 1470, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G148", 1480, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G153", 1530, machine_coordinates, 0, Group::other, "PG, G group 9"}, 9, usual},
  {{"G247", 2470, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G248", 2480, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G290", 2900, no_effect, 0, Group::other, "PG, G group 47"}, 47, usual},
  {{"G291", 2910, not_modelled, 0, Group::other, "PG, G group 47"}, 47, usual},
  {{"G331", 3310, tap, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G332", 3320, tap_retract, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G335", 3350, not_modelled, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G336", 3360, not_modelled, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"G340", 3400, not_modelled, 0, Group::other, "PG, G group 44"}, 44, usual},
  {{"G341", 3410, not_modelled, 0, Group::other, "PG, G group 44"}, 44, usual},
  {{"G347", 3470, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G348", 3480, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"G450", 4500, no_effect, 0, Group::other, "PG, G group 18"}, 18, usual},
  {{"G451", 4510, no_effect, 0, Group::other, "PG, G group 18"}, 18, usual},
  {{"G460", 4600, no_effect, 0, Group::other, "PG, G group 48"}, 48, usual},
  {{"G461", 4610, no_effect, 0, Group::other, "PG, G group 48"}, 48, usual},
  {{"G462", 4620, no_effect, 0, Group::other, "PG, G group 48"}, 48, usual},
  {{"G500", 5000, work_offset, 0, Group::work_offset, "PG, G group 8"}, 8, usual},
  {{"G601", 6010, no_effect, 0, Group::other, "PG, G group 12"}, 12, usual},
  {{"G602", 6020, no_effect, 0, Group::other, "PG, G group 12"}, 12, usual},
  {{"G603", 6030, no_effect, 0, Group::other, "PG, G group 12"}, 12, usual},
  {{"G621", 6210, not_modelled, 0, Group::other, "PG, G group 57"}, 57, usual},
  {{"G641", 6410, continuous_path, 0, Group::exact_stop, "PG, G group 10"}, 10, usual},
  {{"G642", 6420, continuous_path, 0, Group::exact_stop, "PG, G group 10"}, 10, usual},
  {{"G643", 6430, continuous_path, 0, Group::exact_stop, "PG, G group 10"}, 10, usual},
  {{"G644", 6440, continuous_path, 0, Group::exact_stop, "PG, G group 10"}, 10, usual},
  {{"G645", 6450, continuous_path, 0, Group::exact_stop, "PG, G group 10"}, 10, usual},
  {{"G700", 7000, unit_inch, 0, Group::unit, "PG, G group 13"}, 13, usual},
  {{"G710", 7100, unit_mm, 0, Group::unit, "PG, G group 13"}, 13, usual},
  {{"G810", 8100, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G811", 8110, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G812", 8120, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G813", 8130, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G814", 8140, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G815", 8150, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G816", 8160, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G817", 8170, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G818", 8180, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G819", 8190, not_modelled, 0, Group::other, "PG, G group 31"}, 31, usual},
  {{"G820", 8200, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G821", 8210, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G822", 8220, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G823", 8230, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G824", 8240, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G825", 8250, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G826", 8260, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G827", 8270, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G828", 8280, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G829", 8290, not_modelled, 0, Group::other, "PG, G group 32"}, 32, usual},
  {{"G931", 9310, not_modelled, 0, Group::feed, "PG, G group 15"}, 15, usual},
  {{"G942", 9420, not_modelled, 0, Group::feed, "PG, G group 15"}, 15, usual},
  {{"G952", 9520, not_modelled, 0, Group::feed, "PG, G group 15"}, 15, usual},
  {{"G961", 9610, surface_speed_on, 0, Group::surface_speed, "PG, G group 15"}, 15, usual},
  {{"G962", 9620, not_modelled, 0, Group::feed, "PG, G group 15"}, 15, usual},
  {{"G971", 9710, surface_speed_off, 0, Group::surface_speed, "PG, G group 15"}, 15, usual},
  {{"G972", 9720, not_modelled, 0, Group::feed, "PG, G group 15"}, 15, usual},
  {{"G973", 9730, not_modelled, 0, Group::feed, "PG, G group 15"}, 15, usual},
});

constexpr auto kMCodes = std::to_array<ir::CodeRow>({
  {"M0", 0, program_stop, 0, Group::flow, "PG, M functions"},
  {"M1", 10, optional_stop, 0, Group::flow, "PG, M functions"},
  {"M2", 20, program_end_rewind, 0, Group::flow, "PG, M functions"},
  {"M3", 30, spindle_cw, 0, Group::spindle, "PG, M functions"},
  {"M4", 40, spindle_ccw, 0, Group::spindle, "PG, M functions"},
  {"M5", 50, spindle_stop, 0, Group::spindle, "PG, M functions"},
  {"M6", 60, tool_change, 0, Group::other, "PG, M functions"},
  {"M7", 70, coolant_mist, 0, Group::coolant, "ISO 6983, M functions"},
  {"M8", 80, coolant_flood, 0, Group::coolant, "ISO 6983, M functions"},
  {"M9", 90, coolant_off, 0, Group::coolant, "ISO 6983, M functions"},
  {"M17", 170, subprogram_end, 0, Group::flow, "PG, M functions"},
  {"M19", 190, spindle_orient, 0, Group::spindle, "PG, M functions"},
  {"M30", 300, program_end_rewind, 0, Group::flow, "PG, M functions"},
});
// clang-format on

constexpr int kFirstFurtherOffset = 505;
constexpr std::size_t kFurtherOffsets = 95;

// "G505" to "G599", which the rows' names point into.
constexpr auto kFurtherOffsetNames = [] {
  std::array<std::array<char, 4>, kFurtherOffsets> names{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t n = static_cast<std::size_t>(kFirstFurtherOffset) + i;
    names[i] = {'G', '5', static_cast<char>('0' + n / 10 % 10), static_cast<char>('0' + n % 10)};
  }
  return names;
}();

std::vector<GCode> make_g_codes() {
  std::vector<GCode> rows(named_codes().begin(), named_codes().end());
  rows.insert(rows.end(), kNumbered.begin(), kNumbered.end());
  for (std::size_t i = 0; i < kFurtherOffsets; ++i) {
    const auto n = static_cast<std::int16_t>(kFirstFurtherOffset + static_cast<int>(i));
    rows.push_back(
        {{std::string_view(kFurtherOffsetNames[i].data(), 4), static_cast<std::int16_t>(n * 10),
          ir::Function::work_offset, static_cast<std::int16_t>(n - 500), ir::ModalGroup::work_offset, "PG, G group 8"},
         8,
         usual});
  }
  std::ranges::sort(rows, {}, [](const GCode& g) { return std::pair(g.row.number10, g.row.name); });
  return rows;
}

}  // namespace

std::span<const GCode> g_codes() {
  static const std::vector<GCode> rows = make_g_codes();
  return rows;
}

std::span<const ir::CodeRow> g_code_rows() {
  static const std::vector<ir::CodeRow> rows = [] {
    std::vector<ir::CodeRow> plain;
    for (const GCode& g : g_codes()) plain.push_back(g.row);
    return plain;
  }();
  return rows;
}

std::span<const ir::CodeRow> m_code_rows() { return kMCodes; }

const GCode* find_g_code(std::uint32_t number) {
  static const std::vector<const GCode*> by_number = [] {
    std::vector<const GCode*> table(1000, nullptr);
    for (const GCode& g : g_codes())
      if (g.row.number10 >= 0) table[static_cast<std::size_t>(g.row.number10 / 10)] = &g;
    return table;
  }();
  return number < by_number.size() ? by_number[number] : nullptr;
}

const GCode* find_named_code(std::string_view name) {
  static const NameIndex index = index_of(named_codes(), [](const GCode& g) { return g.row.name; });
  const std::uint32_t found = index.find(name);
  return found == NameIndex::kNotFound ? nullptr : &named_codes()[found];
}

const GCode* find_code_as_written(std::string_view text) {
  if (text.size() < 2 || to_upper(text.front()) != 'G' || !is_digit(text[1])) return find_named_code(text);
  std::uint32_t number = 0;
  for (const char c : text.substr(1)) {
    if (!is_digit(c) || number > 999) return nullptr;
    number = number * 10 + static_cast<std::uint32_t>(c - '0');
  }
  return find_g_code(number);
}

const ir::CodeRow* find_m_code(std::uint32_t number) {
  if (number > 999) return nullptr;
  const auto row = std::ranges::find(kMCodes, static_cast<std::int16_t>(number * 10), &ir::CodeRow::number10);
  return row == kMCodes.end() ? nullptr : &*row;
}

}  // namespace dripfeed::sinumerik
