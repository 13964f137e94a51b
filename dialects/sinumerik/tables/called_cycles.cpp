// A row a cycle. The order of the values is that of the PROC line of the cycle's own text, so that it stands once.
#include "dialects/sinumerik/tables/called_cycles.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/milling_cycles.h"

namespace dripfeed::sinumerik {

namespace {

using ir::CalledSort;
using ir::CycleValue;
using ir::DrillCycle;

// Parameters by Siemens' names (PGZ); the others are `other`.
struct ParameterRow {
  std::string_view name;
  CycleValue value;
};
constexpr ParameterRow kHoleParameters[] = {
    {"RTP", CycleValue::return_level},
    {"RFP", CycleValue::surface},
    {"SDIS", CycleValue::clearance},
    {"DP", CycleValue::depth},
    {"DPR", CycleValue::depth_below_surface},
    {"DTB", CycleValue::dwell},
    {"FDEP", CycleValue::first_peck_level},
    {"FDPR", CycleValue::first_peck},
    {"DAM", CycleValue::less_each_peck},
    {"DTS", CycleValue::first_dwell},
    {"FRF", CycleValue::first_peck_feed},
    {"VARI", CycleValue::removes_chips},
    {"AXN", CycleValue::axis},
    {"MDEP", CycleValue::least_peck},
    {"VRT", CycleValue::peck_retract},
    {"DTD", CycleValue::last_dwell},
    {"DIS1", CycleValue::peck_clearance},
    {"SDIR", CycleValue::spindle},
    {"SDR", CycleValue::spindle_back},
    {"SDAC", CycleValue::spindle_after},
    {"MPIT", CycleValue::thread_size},
    {"PIT", CycleValue::lead},
    {"POSS", CycleValue::spindle_angle},
    {"SST", CycleValue::speed},
    {"SST1", CycleValue::speed_back},
    {"ENC", CycleValue::encoder},
    {"FFR", CycleValue::feed_in},
    {"RFF", CycleValue::feed_out},
    {"RPA", CycleValue::shift_first},
    {"RPO", CycleValue::shift_second},
    {"RPAP", CycleValue::lift},
    {"GM", CycleValue::screen_geometry},
    {"DM", CycleValue::screen_plane},
    {"AM", CycleValue::screen_kinds},
};
constexpr ParameterRow kPatternParameters[] = {
    {"SPCA", CycleValue::pattern_first}, {"SPCO", CycleValue::pattern_second}, {"CPA", CycleValue::pattern_first},
    {"CPO", CycleValue::pattern_second}, {"RAD", CycleValue::pattern_radius},  {"STA1", CycleValue::pattern_angle},
    {"FDIS", CycleValue::pattern_start}, {"DBH", CycleValue::pattern_step},    {"INDA", CycleValue::pattern_step},
    {"NUM", CycleValue::pattern_count},
};

struct CycleRow {
  std::string_view name;
  CalledSort sort = CalledSort::hole;
  DrillCycle hole = DrillCycle::drill;
  bool floats = false;
};
constexpr CycleRow kRows[] = {
    {"CYCLE81", CalledSort::hole, DrillCycle::drill},
    {"CYCLE82", CalledSort::hole, DrillCycle::drill_dwell},
    {"CYCLE83", CalledSort::hole, DrillCycle::deep_hole},
    {"CYCLE84", CalledSort::hole, DrillCycle::tap_right},
    {"CYCLE840", CalledSort::hole, DrillCycle::tap_right, true},
    {"CYCLE85", CalledSort::hole, DrillCycle::feed_out},
    {"CYCLE86", CalledSort::hole, DrillCycle::stop_out},
    {"CYCLE87", CalledSort::hole, DrillCycle::manual_out},
    {"CYCLE88", CalledSort::hole, DrillCycle::manual_out},
    {"CYCLE89", CalledSort::hole, DrillCycle::feed_out_dwell},
    {"HOLES1", CalledSort::holes_in_row},
    {"HOLES2", CalledSort::holes_on_circle},
    {"CYCLE802", CalledSort::holes_anywhere},
    {"CYCLE95", CalledSort::removal},
    {"CYCLE97", CalledSort::thread},
};

// What writers call for a hole that no cycle is named after.
struct HoleRow {
  DrillCycle hole;
  std::string_view name;
};
constexpr HoleRow kWritten[] = {
    {DrillCycle::drill, "CYCLE81"},      {DrillCycle::drill_dwell, "CYCLE82"},    {DrillCycle::deep_hole, "CYCLE83"},
    {DrillCycle::chip_break, "CYCLE83"}, {DrillCycle::tap_right, "CYCLE84"},      {DrillCycle::tap_left, "CYCLE84"},
    {DrillCycle::feed_out, "CYCLE85"},   {DrillCycle::feed_out_dwell, "CYCLE85"}, {DrillCycle::stop_out, "CYCLE86"},
    {DrillCycle::manual_out, "CYCLE88"}, {DrillCycle::fine_bore, "CYCLE86"},
};

CycleValue value_called(std::string_view parameter, CalledSort sort) {
  const auto find_in = [&](std::span<const ParameterRow> rows) {
    const auto row = std::ranges::find(rows, parameter, &ParameterRow::name);
    return row == rows.end() ? CycleValue::other : row->value;
  };
  if (sort == CalledSort::hole) return find_in(kHoleParameters);
  const bool is_pattern = sort == CalledSort::holes_in_row || sort == CalledSort::holes_on_circle;
  return is_pattern ? find_in(kPatternParameters) : CycleValue::other;
}

// "REAL PX1=1EX30" is PX1, "STRING[15] PITM" is PITM.
std::string_view name_of_parameter(std::string_view written) {
  written = written.substr(0, written.find('='));
  return written.substr(written.rfind(' ') + 1);
}

// From "PROC CYCLE81(REAL RTP, REAL RFP, …) SAVE".
std::vector<CycleValue> values_of(const CycleRow& row) {
  if (row.sort == CalledSort::removal) return {CycleValue::contour};  // no text: the interpreter cuts it
  const std::string_view text = standard_cycle(row.name);
  std::vector<CycleValue> values;
  const std::size_t end = text.find(')');
  for (std::size_t at = text.find('(') + 1; at < end;) {
    const std::size_t comma = std::min(text.find(',', at), end);
    values.push_back(value_called(name_of_parameter(text.substr(at, comma - at)), row.sort));
    at = comma + 1;
  }
  return values;
}

std::vector<ir::CalledCycle> make_cycles() {
  std::vector<ir::CalledCycle> cycles;
  for (const CycleRow& row : kRows)
    cycles.push_back(
        {.name = row.name, .sort = row.sort, .hole = row.hole, .floats = row.floats, .values = values_of(row)});
  for (const MillRow& row : milling_cycles()) {
    const auto count = static_cast<std::size_t>(std::ranges::count(row.parameters, ' ')) + 1;
    std::vector<CycleValue> values(count, CycleValue::other);
    if (row.parameters.starts_with("KNAME")) values.front() = CycleValue::contour;
    cycles.push_back(
        {.name = row.name, .sort = CalledSort::milling, .values = std::move(values), .read_milling = row.read});
  }
  return cycles;
}

}  // namespace

std::span<const ir::CalledCycle> called_cycles() {
  static const std::vector<ir::CalledCycle> kCycles = make_cycles();
  return kCycles;
}

const ir::CalledCycle* find_called_cycle(std::string_view name) {
  const std::span<const ir::CalledCycle> cycles = called_cycles();
  const auto cycle = std::ranges::find(cycles, name, &ir::CalledCycle::name);
  return cycle == cycles.end() ? nullptr : &*cycle;
}

const ir::CalledCycle* cycle_for(DrillCycle hole) {
  const auto* const row = std::ranges::find(kWritten, hole, &HoleRow::hole);
  return row == std::end(kWritten) ? nullptr : find_called_cycle(row->name);
}

}  // namespace dripfeed::sinumerik
