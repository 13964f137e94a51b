// Parameters and alarms: Programming Manual Cycles (PGZ), "Milling cycles", whose lists the later ones of "Programming
// cycles externally" (PGA) continue by UMODE, FS, ZFS and the modes of the operator's screen. What the values mean that
// several cycles have: mill_call.cpp. Alarms of their own: 61108 RAD1 and DP1 of a helix, 61116 an approach of no
// length, 61118 a face without length or width.
#include "dialects/sinumerik/tables/milling_cycles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dialects/sinumerik/tables/mill_call.h"

namespace dripfeed::sinumerik {

namespace {

using ir::MillCycle;
using ir::MillReading;
using ir::MillShape;
using ir::MillUnits;
using ir::MillValues;

constexpr std::uint32_t kAlarmCuts = 61'002;
constexpr std::uint32_t kAlarmHelix = 61'108;
constexpr std::uint32_t kAlarmApproach = 61'116;
constexpr std::uint32_t kAlarmFace = 61'118;
constexpr double kMostSlots = 1000.0;

constexpr std::string_view kPocket3 =
    "RTP RFP SDIS DP LENG WID CRAD PA PO STA MID FAL FALD FFP1 FFD CDIR VARI MIDA AP1 AP2 AD RAD1 DP1 UMODE FS ZFS "
    "GMODE DMODE AMODE";
constexpr std::string_view kPocket4 =
    "RTP RFP SDIS DP PRAD PA PO MID FAL FALD FFP1 FFD CDIR VARI MIDA AP1 AD RAD1 DP1 UMODE FS ZFS GMODE DMODE AMODE";
constexpr std::string_view kPocket1 =
    "RTP RFP SDIS DP DPR LENG WID CRAD PA PO STA FFD FFP1 MID CDIR FAL VARI MIDF FFP2 SSF";
constexpr std::string_view kPocket2 = "RTP RFP SDIS DP DPR PRAD PA PO FFD FFP1 MID CDIR FAL VARI MIDF FFP2 SSF";
constexpr std::string_view kSlot1 =
    "RTP RFP SDIS DP DPR NUM LENG WID CPA CPO RAD STA1 INDA FFD FFP1 MID CDIR FAL VARI MIDF FFP2 SSF FALD STA2 DP1 "
    "UMODE FS ZFS GMODE DMODE AMODE";
constexpr std::string_view kSlot2 =
    "RTP RFP SDIS DP DPR NUM AFSL WID CPA CPO RAD STA1 INDA FFD FFP1 MID CDIR FAL VARI MIDF FFP2 SSF FFCP UMODE FS ZFS "
    "GMODE DMODE AMODE";
constexpr std::string_view kLonghole =
    "RTP RFP SDIS DP DPR NUM LENG CPA CPO RAD STA1 INDA FFD FFP1 MID VARI UMODE GMODE DMODE AMODE";
constexpr std::string_view kCycle61 = "RTP RFP SDIS DP PA PO LENG WID MID MIDA FALD FFP1 VARI LIM DMODE AMODE";
constexpr std::string_view kCycle71 = "RTP RFP SDIS DP PA PO LENG WID STA MID MIDA FDP FALD FFP1 VARI FDP1";
constexpr std::string_view kCycle72 =
    "KNAME RTP RFP SDIS DP MID FAL FALD FFP1 FFD VARI RL AS1 LP1 FF3 AS2 LP2 UMODE FS ZFS GMODE DMODE AMODE";
constexpr std::string_view kCycle76 =
    "RTP RFP SDIS DP DPR LENG WID CRAD PA PO STA MID FAL FALD FFP1 FFD CDIR VARI AP1 AP2 FS ZFS GMODE DMODE AMODE";
constexpr std::string_view kCycle77 =
    "RTP RFP SDIS DP DPR PRAD PA PO MID FAL FALD FFP1 FFD CDIR VARI AP1 FS ZFS GMODE DMODE AMODE";

void pocket_values(MillCall& call) {
  call.screen_modes();
  call.levels();
  call.feeds();
  call.allowances();
  call.kind(false);
  call.entry();
  call.step();
  call.direction();
  MillCycle& c = call.reading.cycle;
  c.shape = MillShape::pocket;
  if (c.entry == ir::MillEntry::helix) c.entry_radius = call.size("RAD1");
  if (c.entry == ir::MillEntry::oscillation) c.entry_angle_deg = call.number("RAD1");
  const bool is_none = c.entry_radius == 0.0 || c.entry_depth == 0.0;
  if (c.roughs && c.entry == ir::MillEntry::helix && is_none) call.alarm(kAlarmHelix);
}

MillReading read_pocket3(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kPocket3);
  pocket_values(call);
  call.rectangle();
  return call.reading;
}

MillReading read_pocket4(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kPocket4);
  pocket_values(call);
  call.circle(2.0 * call.size("PRAD"));
  return call.reading;
}

// In straight down, VARI 0 to 2 alone; CPA, CPO and STA1 are named as those of the later cycles. The side is finished
// at once where MIDF gives no depths.
void older_pocket_values(MillCall& call) {
  call.levels();
  call.feeds();
  call.allowances();
  if (call.number("VARI") > 2.0) call.leave("with a kind (VARI) that is not known");
  call.kind(true);
  call.direction();
  MillCycle& c = call.reading.cycle;
  c.shape = MillShape::pocket;
  c.finish_infeed = call.size("MIDF");
  if (call.number("SSF") != 0.0 && (c.finishes_side || c.finishes_base))
    call.leave("with a speed of its own for finishing (SSF)");
}

MillReading read_pocket1(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kPocket1);
  older_pocket_values(call);
  call.rectangle();
  return call.reading;
}

MillReading read_pocket2(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kPocket2);
  older_pocket_values(call);
  call.circle(2.0 * call.size("PRAD"));
  return call.reading;
}

// The helix is as wide as the slot lets it be; STA2 is the steepest angle to and fro. The side is finished at once
// where MIDF gives no depths.
MillReading read_slot1(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kSlot1);
  call.screen_modes();
  call.levels();
  call.feeds();
  call.allowances();
  call.kind(true);
  call.entry();
  call.direction();
  call.on_rays();
  MillCycle& c = call.reading.cycle;
  c.shape = MillShape::pocket;
  c.width = call.size("WID");
  c.corner_radius = c.width / 2.0;
  c.finish_infeed = call.size("MIDF");
  c.entry_radius = c.width / 2.0;
  c.entry_angle_deg = call.number("STA2");
  if (call.number("SSF") != 0.0 && (c.finishes_side || c.finishes_base))
    call.leave("with a speed of its own for finishing (SSF)");
  if (c.length < c.width) call.leave("with slots that are wider than long");
  if (c.roughs && c.entry == ir::MillEntry::helix && c.entry_depth == 0.0) call.alarm(kAlarmHelix);
  return call.reading;
}

// AFSL: from the centre of the slot's first end to that of its last, counterclockwise from STA1. With one slot and 360
// degrees it is a ring (ShopMill (BAS) 10.04, "Circumferential slot"), and only between the centres it closes.
void place_on_circle(MillCall& call) {
  MillCycle& c = call.reading.cycle;
  const double count = call.number("NUM");
  const double angle = call.number("AFSL");
  if (!(count >= 1.0 && count <= kMostSlots) || count != std::floor(count))
    return call.leave("with a number of slots (NUM) that it has not");
  const double step = call.number("INDA") != 0.0 ? call.number("INDA") : 360.0 / count;
  c.bend_radius = call.size("RAD");
  c.bend_deg = angle;
  if (!(angle > 0.0 && angle <= 360.0) || (count > 1.0 && angle == 360.0))
    return call.leave("with an angle (AFSL) that no slot has");
  if (c.bend_radius <= c.width / 2.0) return call.leave("with slots that are wider than their circle");
  // The chord between the ends of neighbours.
  const double gap_deg = std::min(std::abs(step), 360.0 - std::abs(step) * (count - 1.0)) - angle;
  const double gap = 2.0 * c.bend_radius * std::sin(std::min(gap_deg, 180.0) * std::numbers::pi / 360.0);
  if (count > 1.0 && gap <= c.width) return call.leave("with slots that touch each other");
  for (int n = 0; n < count; ++n)
    c.places.push_back({call.length("CPA"), call.length("CPO"), call.number("STA1") + n * step});
}

// VARI, tens: the path to the next slot, 0 straight. The side is finished at once where MIDF gives no depths.
MillReading read_slot2(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kSlot2);
  call.screen_modes();
  call.levels();
  call.feeds();
  call.allowances();
  call.kind(true);
  call.direction();
  MillCycle& c = call.reading.cycle;
  c.shape = MillShape::bent_slot;
  c.width = call.size("WID");
  c.finish_infeed = call.size("MIDF");
  place_on_circle(call);
  if (call.digit("VARI", 10.0) != 0) call.leave("with a path to the next slot (VARI) that is not straight");
  if (call.digit("VARI", 100.0) != 0 || call.digit("VARI", 1000.0) > 1)
    call.leave("with a kind (VARI) that is not known");
  if (call.number("SSF") != 0.0 && c.finishes_side) call.leave("with a speed of its own for finishing (SSF)");
  return call.reading;
}

// VARI, where it is given, has the entry as its tens: straight down at both ends, as without it.
MillReading read_longhole(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kLonghole);
  call.screen_modes();
  call.levels();
  call.feeds();
  call.allowances();
  call.on_rays();
  call.reading.cycle.shape = MillShape::long_hole;
  if (call.digit("VARI", 10.0) > 1 || call.number("VARI") >= 100.0) call.leave("with a kind (VARI) that is not known");
  return call.reading;
}

// From the corner at PA, PO, around which STA turns it. VARI: units 1 rough, 2 finish; tens 1, 2 along the first or
// second axis, 3, 4 there and back.
void face_values(MillCall& call) {
  constexpr std::array kCuts = {ir::FaceCuts::first, ir::FaceCuts::second, ir::FaceCuts::first_to_and_fro,
                                ir::FaceCuts::second_to_and_fro};
  call.levels();
  call.feeds();
  call.allowances();
  call.step();
  MillCycle& c = call.reading.cycle;
  c.shape = MillShape::face;
  const double length = call.length("LENG");
  const double width = call.length("WID");
  const double angle = call.number("STA") * std::numbers::pi / 180.0;
  c.length = std::abs(length);
  c.width = std::abs(width);
  c.places.push_back({call.length("PA") + (length * std::cos(angle) - width * std::sin(angle)) / 2.0,
                      call.length("PO") + (length * std::sin(angle) + width * std::cos(angle)) / 2.0,
                      call.number("STA")});
  c.beyond_end = c.clearance;
  const int kind = call.digit("VARI", 1.0);
  const auto cuts = static_cast<std::size_t>(call.digit("VARI", 10.0));
  if (kind < 1 || kind > 2 || cuts < 1 || cuts > kCuts.size()) return call.alarm(kAlarmCuts);
  if (call.number("VARI") >= 100.0) call.leave("with a kind (VARI) that is not known");
  c.cuts = kCuts[cuts - 1];
  c.roughs = kind == 1;
  c.finishes_base = kind == 2;
  if (length == 0.0 || width == 0.0) call.alarm(kAlarmFace);
}

// Whether LENG and WID are lengths or a corner's coordinates, a digit of AMODE states that is not certain: both are the
// same from a corner at 0.
MillReading read_cycle61(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kCycle61);
  call.screen_modes();
  face_values(call);
  const bool is_open = call.number("PA") != 0.0 && call.digit("AMODE", 1000.0) != 0;
  if (is_open || (call.number("PO") != 0.0 && call.digit("AMODE", 10'000.0) != 0))
    call.leave("with a second corner (AMODE) that is not certain");
  if (call.number("LIM") != 0.0) call.leave("with sides that it must not cross (LIM)");
  return call.reading;
}

// FDP: how far beyond the face a cut ends; FDP1: how far beyond it the last one reaches across.
MillReading read_cycle71(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kCycle71);
  face_values(call);
  call.reading.cycle.beyond_end = call.size("FDP");
  call.reading.cycle.beyond_side = call.size("FDP1");
  return call.reading;
}

// AS1, AS2: units 1 straight along the tangent, 4 vertically. Without compensation the control has no others (ShopMill
// (BAS) 10.04, "Path milling along the center-point path"), and the length counts from the tool's centre, which is what
// the contour leads then.
ir::MillApproach approach_of(MillCall& call, std::string_view name, double length) {
  const int kind = call.digit(name, 1.0);
  if ((kind != 1 && kind != 4) || call.number(name) >= 10.0)
    call.leave("with an approach (AS1, AS2) that is not known");
  if (kind == 1 && length == 0.0) call.alarm(kAlarmApproach);
  return kind == 1 ? ir::MillApproach::straight : ir::MillApproach::vertical;
}

// RL 40: without compensation of the radius. VARI: hundreds where the tool goes after each depth. How far from the
// contour the approach begins under compensation, no source states for certain.
MillReading read_cycle72(MillValues values, const MillUnits& units) {
  constexpr std::array kLifts = {ir::MillLift::return_level, ir::MillLift::in_front, ir::MillLift::clearance,
                                 ir::MillLift::none};
  MillCall call(values, units, kCycle72);
  call.screen_modes();
  call.levels();
  call.feeds();
  call.allowances();
  MillCycle& c = call.reading.cycle;
  c.shape = MillShape::path;
  if (call.number("RL") != 40.0) call.leave("with compensation of the radius (RL), whose approach is not certain");
  const int kind = call.digit("VARI", 1.0);
  if (kind == 5) call.leave("with a chamfer (VARI)");
  if (kind == 2) call.leave("with finishing (VARI) along the tool's centre");
  if (kind != 1) call.alarm(kAlarmCuts);
  if (call.digit("VARI", 10.0) != 0) call.leave("with a path from depth to depth by feed (VARI)");
  const auto lift = static_cast<std::size_t>(call.digit("VARI", 100.0));
  if (lift >= kLifts.size() || call.number("VARI") >= 1000.0) call.leave("with a kind (VARI) that is not known");
  if (lift < kLifts.size()) c.lift = kLifts[lift];
  if (c.allowance_side != 0.0) call.leave("with an allowance (FAL) along the tool's centre");
  const bool is_alike = call.number("AS2") == 0.0;
  c.approach_length = call.size("LP1");
  c.retract_length = is_alike ? c.approach_length : call.size("LP2");
  c.approach = approach_of(call, "AS1", c.approach_length);
  c.retract = is_alike ? c.approach : approach_of(call, "AS2", c.retract_length);
  return call.reading;
}

void spigot_values(MillCall& call) {
  call.screen_modes();
  call.levels();
  call.feeds();
  call.allowances();
  call.kind(false);
  call.direction();
  call.reading.cycle.shape = MillShape::spigot;
}

// AP1 and AP2: the blank's length and width.
MillReading read_cycle76(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kCycle76);
  spigot_values(call);
  call.rectangle();
  call.reading.cycle.blank_length = call.size("AP1");
  call.reading.cycle.blank_width = call.size("AP2");
  return call.reading;
}

// PRAD and AP1 are the diameters of the spigot and of its blank.
MillReading read_cycle77(MillValues values, const MillUnits& units) {
  MillCall call(values, units, kCycle77);
  spigot_values(call);
  call.circle(call.size("PRAD"));
  call.reading.cycle.blank_length = call.reading.cycle.blank_width = call.size("AP1");
  return call.reading;
}

}  // namespace

std::span<const MillRow> milling_cycles() {
  static constexpr auto kMillRows = std::to_array<MillRow>({
      {"POCKET1", kPocket1, read_pocket1},
      {"POCKET2", kPocket2, read_pocket2},
      {"POCKET3", kPocket3, read_pocket3},
      {"POCKET4", kPocket4, read_pocket4},
      {"SLOT1", kSlot1, read_slot1},
      {"SLOT2", kSlot2, read_slot2},
      {"LONGHOLE", kLonghole, read_longhole},
      {"CYCLE61", kCycle61, read_cycle61},
      {"CYCLE71", kCycle71, read_cycle71},
      {"CYCLE72", kCycle72, read_cycle72},
      {"CYCLE76", kCycle76, read_cycle76},
      {"CYCLE77", kCycle77, read_cycle77},
  });
  return kMillRows;
}

}  // namespace dripfeed::sinumerik
