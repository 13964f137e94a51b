// By PGZ and PGA as we know them, compared with real calls. A digit of the modes of the operator's screen that is not
// certain is not interpreted.
//
//   VARI   units  1 rough, 2 finish, 4 finish the side alone, 5 chamfer; slots: 0 rough and finish
//          tens   how the tool goes in: 0 by rapid, 1 straight, 2 on a helix, 3 to and fro
//   CDIR   0 climb, 1 conventional, 2 clockwise (G2), 3 counterclockwise (G3)
//   GMODE  hundreds 1 mills, thousands 0 measures from the centre, ten thousands 1 mills all of it
//   DMODE  units   the plane, 1 to 3 for G17 to G19
//   AMODE  units   0 the depth is a coordinate, 1 a distance below the surface; tens 1: MIDA is in percent of the tool
//
// Alarms: 61002 VARI, 61101 the reference plane does not lie between retraction plane and depth, 61109 CDIR, 61110 the
// allowance of the base is above the infeed, 61113 the corner's radius is too large.
#include "dialects/sinumerik/tables/mill_call.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dripfeed::sinumerik {

namespace {

using ir::MillCycle;

constexpr std::uint32_t kAlarmKind = 61'002;
constexpr std::uint32_t kAlarmLevels = 61'101;
constexpr std::uint32_t kAlarmDirection = 61'109;
constexpr std::uint32_t kAlarmAllowance = 61'110;
constexpr std::uint32_t kAlarmCorner = 61'113;
constexpr double kMostPlaces = 1000.0;
constexpr double kSmall = 1e-9;

}  // namespace

double MillCall::number(std::string_view name) const {
  std::size_t place = 0;
  for (std::size_t at = 0; at < parameters_.size(); ++place) {
    const std::size_t end = std::min(parameters_.find(' ', at), parameters_.size());
    if (parameters_.substr(at, end - at) == name) {
      const bool is_given = place < values_.size() && !std::isnan(values_[place]);
      return is_given ? values_[place] : 0.0;
    }
    at = end + 1;
  }
  return 0.0;
}

double MillCall::size(std::string_view name) const { return std::abs(length(name)); }

int MillCall::digit(std::string_view name, double weight) const {
  const double value = number(name);
  if (!(value >= 0.0 && value < 1e9) || value != std::floor(value)) return 9;
  return static_cast<int>(std::fmod(std::floor(value / weight), 10.0));
}

void MillCall::alarm(std::uint32_t number) {
  if (is_whole()) reading.alarm = number;
}

void MillCall::leave(std::string_view why) {
  if (is_whole()) reading.not_interpreted = why;
}

void MillCall::levels() {
  MillCycle& c = reading.cycle;
  const double surface = length("RFP");
  const double side = length("RTP") < surface ? -1.0 : 1.0;
  const bool by_distance = digit("AMODE", 1.0) == 1;
  const double distance = number("DPR") != 0.0 ? size("DPR") : by_distance ? size("DP") : 0.0;
  c.return_level = length("RTP");
  c.surface = surface;
  c.clearance = size("SDIS");
  c.depth = number("DPR") != 0.0 || by_distance ? surface - side * distance : length("DP");
  if ((c.return_level - surface) * (surface - c.depth) < 0.0) alarm(kAlarmLevels);
}

void MillCall::screen_modes() {
  if (digit("AMODE", 1.0) > 1) leave("with a kind of depth (AMODE) that is not known");
  if (digit("AMODE", 10.0) > 1) leave("with a kind of infeed (AMODE) that is not known");
  if (digit("GMODE", 1.0) != 0 || digit("GMODE", 10.0) != 0 || digit("GMODE", 100.0) > 1)
    leave("with a mode (GMODE) that is not known");
  if (digit("GMODE", 1000.0) != 0) leave("from a corner (GMODE)");
  if (digit("GMODE", 10'000.0) > 1) leave("for what another tool has left (GMODE)");
  const int plane = digit("DMODE", 1.0);
  if (plane != 0 && plane != units_.plane) leave("in another plane (DMODE) than the one in effect");
  if (number("UMODE") != 0.0) leave("with a mode (UMODE) that is not known");
}

void MillCall::feeds() {
  reading.cycle.feed = feed("FFP1");
  reading.cycle.feed_in = feed("FFD");
  reading.cycle.finish_feed = feed("FFP2");
  if (feed("FFP1") < 0.0 || feed("FFD") < 0.0) leave("with a feed below 0");
}

void MillCall::allowances() {
  MillCycle& c = reading.cycle;
  c.infeed = c.finish_infeed = size("MID");
  c.allowance_side = size("FAL");
  c.allowance_base = size("FALD");
  if (c.infeed > 0.0 && c.allowance_base > c.infeed + kSmall) alarm(kAlarmAllowance);
}

// Where neither allowance leaves anything, finishing goes along the side.
void MillCall::kind(bool may_do_both) {
  MillCycle& c = reading.cycle;
  const int which = digit("VARI", 1.0);
  if (which == 5) return leave("with a chamfer (VARI)");
  if ((which == 0 && !may_do_both) || which == 3 || which > 4) return alarm(kAlarmKind);
  c.roughs = which < 2;
  const bool leaves_none = c.allowance_side == 0.0 && c.allowance_base == 0.0;
  c.finishes_side = which == 4 || (which != 1 && c.allowance_side > 0.0) || (which == 2 && leaves_none);
  c.finishes_base = (which == 0 || which == 2) && c.allowance_base > 0.0;
  if (which == 4) c.allowance_base = 0.0;
}

void MillCall::entry() {
  constexpr std::array kEntries = {ir::MillEntry::rapid, ir::MillEntry::straight, ir::MillEntry::helix,
                                   ir::MillEntry::oscillation};
  const auto index = static_cast<std::size_t>(digit("VARI", 10.0));
  if (index >= kEntries.size()) return alarm(kAlarmKind);
  if (digit("VARI", 100.0) != 0 || digit("VARI", 1000.0) > 1) return leave("with a kind (VARI) that is not known");
  reading.cycle.entry = kEntries[index];
  reading.cycle.entry_depth = size("DP1");
}

void MillCall::step() {
  const bool in_percent = digit("AMODE", 10.0) == 1;
  reading.cycle.step = in_percent ? 0.0 : size("MIDA");
  reading.cycle.step_of_tool = in_percent ? std::abs(number("MIDA")) / 100.0 : 0.0;
}

void MillCall::direction() {
  constexpr std::array kDirections = {ir::MillDirection::climb, ir::MillDirection::conventional,
                                      ir::MillDirection::clockwise, ir::MillDirection::counterclockwise};
  const double which = number("CDIR");
  if (!(which >= 0.0 && which < static_cast<double>(kDirections.size())) || which != std::floor(which))
    return alarm(kAlarmDirection);
  reading.cycle.direction = kDirections[static_cast<std::size_t>(which)];
}

void MillCall::rectangle() {
  MillCycle& c = reading.cycle;
  c.length = length("LENG");
  c.width = length("WID");
  c.corner_radius = size("CRAD");
  if (c.length < 0.0 || c.width < 0.0) return leave("from a corner (LENG or WID below 0)");
  if (c.corner_radius > std::min(c.length, c.width) / 2.0 + kSmall) alarm(kAlarmCorner);
  c.places.push_back({length("PA"), length("PO"), number("STA")});
}

void MillCall::circle(double diameter_mm) {
  MillCycle& c = reading.cycle;
  c.length = c.width = diameter_mm;
  c.corner_radius = diameter_mm / 2.0;
  c.places.push_back({length("PA"), length("PO"), 0.0});
}

void MillCall::on_rays() {
  MillCycle& c = reading.cycle;
  const double count = number("NUM");
  if (!(count >= 1.0 && count <= kMostPlaces)) return leave("with a number of places (NUM) that it has not");
  const double step = number("INDA") != 0.0 ? number("INDA") : 360.0 / count;
  const double radius = size("RAD") + size("LENG") / 2.0;
  for (int n = 0; n < count; ++n) {
    const double angle_deg = number("STA1") + n * step;
    const double angle = angle_deg * std::numbers::pi / 180.0;
    c.places.push_back({length("CPA") + radius * std::cos(angle), length("CPO") + radius * std::sin(angle), angle_deg});
  }
  c.length = size("LENG");
}

}  // namespace dripfeed::sinumerik
