// Drilling, hole patterns and thread cycles that the control brings along, as programs of its own language: what they
// do is then the interpreter's. Parameters and sequence: Programming Manual Cycles (PGZ). Other standard cycles are
// kept as they are written.
//
// A depth that DPR gives goes before DP; a hole without depth is not drilled. Alarms are those of the cycles. The
// drilling axis is the one that stands on the plane. GM, DM and AM are modes of the operator's screen, a digit each
// (PGA, "Programming cycles externally"): GM 10 measures the depth to the shank or gives the diameter instead, which
// the tool's point decides; DM is the plane of the cycle, AM the kind of each value.
#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/cycle_texts.h"

namespace dripfeed::sinumerik {

namespace {

constexpr auto kFragments = std::to_array<CycleText>({
    {"hole", "REAL RTP, REAL RFP, REAL SDIS, REAL DP, REAL DPR"},
    {"screen", "INT GM, INT DM, INT AM"},
    // PITA: PIT is 1 mm, 2 threads an inch, 3 inch; 0 the unit of the call.
    {"lead_of_screen", R"(CASE (PITA) OF 1 GOTOF IN_MM 2 GOTOF BY_INCH 3 GOTOF IN_INCH DEFAULT GOTOF AS_CALLED
IN_MM: PIT=PIT*MM GOTOF AS_CALLED
BY_INCH: IF PIT==0 GOTOF AS_CALLED
PIT=25.4*MM/PIT GOTOF AS_CALLED
IN_INCH: PIT=25.4*MM*PIT
AS_CALLED:
@lead)"},
    // PIT, or that of the metric thread M<MPIT>; 61001: neither.
    {"lead", R"(LEAD=PIT
IF LEAD==0
SIZE=ABS(MPIT)
CASE (SIZE) OF 3 GOTOF M_3 4 GOTOF M_4 5 GOTOF M_5 6 GOTOF M_6 8 GOTOF M_8 10 GOTOF M_10 12 GOTOF M_12 DEFAULT GOTOF M_MORE
M_MORE:
CASE (SIZE) OF 14 GOTOF M_14 16 GOTOF M_14 18 GOTOF M_18 20 GOTOF M_18 22 GOTOF M_18 24 GOTOF M_24 27 GOTOF M_24 DEFAULT GOTOF M_LARGE
M_LARGE:
CASE (SIZE) OF 30 GOTOF M_30 33 GOTOF M_30 36 GOTOF M_36 39 GOTOF M_36 42 GOTOF M_42 45 GOTOF M_42 48 GOTOF M_48 DEFAULT GOTOF NO_SIZE
NO_SIZE:
SETAL(61001)
M_3: LEAD=0.5 GOTOF HAS_LEAD
M_4: LEAD=0.7 GOTOF HAS_LEAD
M_5: LEAD=0.8 GOTOF HAS_LEAD
M_6: LEAD=1 GOTOF HAS_LEAD
M_8: LEAD=1.25 GOTOF HAS_LEAD
M_10: LEAD=1.5 GOTOF HAS_LEAD
M_12: LEAD=1.75 GOTOF HAS_LEAD
M_14: LEAD=2 GOTOF HAS_LEAD
M_18: LEAD=2.5 GOTOF HAS_LEAD
M_24: LEAD=3 GOTOF HAS_LEAD
M_30: LEAD=3.5 GOTOF HAS_LEAD
M_36: LEAD=4 GOTOF HAS_LEAD
M_42: LEAD=4.5 GOTOF HAS_LEAD
M_48: LEAD=5
HAS_LEAD:
LEAD=LEAD*MM
IF MPIT<0
LEAD=-LEAD
ENDIF
ENDIF)"},
    // The axes of the plane and the one that stands on it.
    {"axes", R"(DEF AXIS TOOLAX, FIRST, SECOND
DEF REAL SIDE=1, MM=1
DEF INT PLANE)"},
    // A millimetre in the unit of the call: distances that are not given, and leads of metric threads.
    {"unit", R"(IF $P_GG[1013]==2
MM=1/25.4
ENDIF)"},
    {"plane", R"(PLANE=$P_GG[1006]
@axes_of_plane)"},
    {"plane_of_screen", R"(PLANE=$P_GG[1006]
IF DM MOD 10>0
PLANE=DM MOD 10
ENDIF
@axes_of_plane)"},
    {"axes_of_plane", R"(TOOLAX=AXNAME("Z")
FIRST=AXNAME("X")
SECOND=AXNAME("Y")
IF PLANE==2
TOOLAX=AXNAME("Y")
FIRST=AXNAME("Z")
SECOND=AXNAME("X")
ENDIF
IF PLANE==3
TOOLAX=AXNAME("X")
FIRST=AXNAME("Y")
SECOND=AXNAME("Z")
ENDIF)"},
    // AXN: another axis of the plane (G18 with 1 drills along Z); 0 and 3 are the one that stands on it.
    {"axis", R"(IF AXN==1
TOOLAX=FIRST
ENDIF
IF AXN==2
TOOLAX=SECOND
ENDIF)"},
    // 61101: the reference plane does not lie between retraction plane and depth.
    {"depth", R"(IF RTP<RFP
SIDE=-1
ENDIF
IF DPR<>0
DP=RFP-SIDE*ABS(DPR)
ENDIF
IF (RTP-RFP)*(RFP-DP)<0
SETAL(61101)
ENDIF
IF DP==RFP
M17
ENDIF)"},
    // … to the shank, or of a diameter: by the tool's data, which are not known.
    {"depth_of_screen", R"(@depth
IF (GM DIV 10) MOD 10==1
DP=DP-$P_TOOLR
ENDIF)"},
    {"dwell", R"(IF DTB>0
G4 F=DTB
ENDIF
IF DTB<0
G4 S=-DTB
ENDIF)"},
    // The sign of a dwell states its unit, or a digit of AM: 2 is turns.
    {"dwell_of_screen", R"(IF (AM DIV 10) MOD 10==2
DTB=-ABS(DTB)
ENDIF)"},
    // The next of strokes of STROKE from AT, where REST is left: none leaves less than DAM.
    {"next_stroke", R"(NEXT=AT-SIDE*STROKE
IF REST-STROKE<DAM
NEXT=DP+SIDE*DAM
ENDIF
IF REST<=2*DAM
NEXT=AT-SIDE*REST/2
ENDIF
IF REST<=STROKE
NEXT=DP
ENDIF)"},
    // 61102: no direction of the spindle.
    {"spindle", R"(IF (SDIR<>3) AND (SDIR<>4)
SETAL(61102)
ENDIF
IF SDIR==3
M3
ENDIF
IF SDIR==4
M4
ENDIF)"},
});

// A fragment may name others.
std::string with_fragments(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t mark = std::min(text.find('@', at), text.size());
    out += text.substr(at, mark - at);
    if (mark == text.size()) break;
    const std::size_t end = std::min(text.find_first_of(",)\n ", mark), text.size());
    const auto fragment = std::ranges::find(kFragments, text.substr(mark + 1, end - mark - 1), &CycleText::name);
    if (fragment != kFragments.end()) out += with_fragments(fragment->text);
    at = end;
  }
  return out;
}

std::map<std::string_view, std::string> make_cycles() {
  std::map<std::string_view, std::string> cycles;
  for (const auto texts : {drilling_cycles(), turning_cycles()})
    for (const CycleText& cycle : texts) cycles.emplace(cycle.name, with_fragments(cycle.text));
  return cycles;
}

}  // namespace

std::string_view standard_cycle(std::string_view name) {
  static const std::map<std::string_view, std::string> kCycles = make_cycles();
  const auto cycle = kCycles.find(name);
  return cycle == kCycles.end() ? std::string_view() : std::string_view(cycle->second);
}

}  // namespace dripfeed::sinumerik
