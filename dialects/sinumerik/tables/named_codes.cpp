// G functions and commands that have a name instead of a number. Dynamics, approach and corner behaviour have no effect
// on the moves that are modelled; orientation and transformations have, and say so as not_modelled. The
// references are to the list of G functions in the Programming Manual Fundamentals (PG) and to the commands in Job
// Planning (PGA).
#include <array>
#include <vector>

#include "dialects/ir/spline_use.h"
#include "dialects/sinumerik/tables/codes.h"

namespace dripfeed::sinumerik {

namespace {

using enum ir::Function;
using Group = ir::ModalGroup;
using enum WordUse;

// clang-format off
constexpr auto kNamed = std::to_array<GCode>({
  {{"CIP", -1, arc_via, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"CT", -1, arc_tangent, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"ASPLINE", -1, spline, ir::kSplineAkima, Group::motion, "PG, G group 1"}, 1, usual},
  {{"BSPLINE", -1, spline, ir::kSplineB, Group::motion, "PG, G group 1"}, 1, usual},
  {{"CSPLINE", -1, spline, ir::kSplineCubic, Group::motion, "PG, G group 1"}, 1, usual},
  {{"POLY", -1, polynomial, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"INVCW", -1, not_modelled, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"INVCCW", -1, not_modelled, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"OEMIPO1", -1, not_modelled, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"OEMIPO2", -1, not_modelled, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"GORAP", -1, not_modelled, 0, Group::motion, "PG, G group 1"}, 1, usual},
  {{"REPOSL", -1, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"REPOSQ", -1, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"REPOSH", -1, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"REPOSA", -1, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"REPOSQA", -1, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"REPOSHA", -1, not_modelled, 0, Group::non_modal, "PG, G group 2"}, 2, own},
  {{"TRANS", -1, local_shift, 1, Group::frame, "PG, G group 3"}, 3, usual},
  {{"ATRANS", -1, local_shift_add, 0, Group::frame, "PG, G group 3"}, 3, usual},
  {{"ROT", -1, rotate, 1, Group::frame, "PG, G group 3"}, 3, usual},
  {{"SCALE", -1, scale, 1, Group::frame, "PG, G group 3"}, 3, usual},
  {{"MIRROR", -1, mirror, 1, Group::frame, "PG, G group 3"}, 3, usual},
  {{"AROT", -1, rotate, 0, Group::frame, "PG, G group 3"}, 3, usual},
  {{"ASCALE", -1, scale, 0, Group::frame, "PG, G group 3"}, 3, usual},
  {{"AMIRROR", -1, mirror, 0, Group::frame, "PG, G group 3"}, 3, usual},
  {{"ROTS", -1, not_modelled, 0, Group::frame, "PG, G group 3"}, 3, own},
  {{"AROTS", -1, not_modelled, 0, Group::frame, "PG, G group 3"}, 3, own},
  {{"CROTS", -1, not_modelled, 0, Group::frame, "PG, G group 3"}, 3, own},
  {{"STARTFIFO", -1, no_effect, 0, Group::other, "PG, G group 4"}, 4, usual},
  {{"STOPFIFO", -1, no_effect, 0, Group::other, "PG, G group 4"}, 4, usual},
  {{"FIFOCTRL", -1, no_effect, 0, Group::other, "PG, G group 4"}, 4, usual},
  {{"SUPA", -1, machine_coordinates, 0, Group::other, "PG, G group 9"}, 9, usual},
  {{"SUPD", -1, not_modelled, 0, Group::other, "PG, G group 9"}, 9, usual},
  {{"CFC", -1, no_effect, 0, Group::other, "PG, G group 16"}, 16, usual},
  {{"CFTCP", -1, no_effect, 0, Group::other, "PG, G group 16"}, 16, usual},
  {{"CFIN", -1, no_effect, 0, Group::other, "PG, G group 16"}, 16, usual},
  {{"NORM", -1, no_effect, 0, Group::other, "PG, G group 17"}, 17, usual},
  {{"KONT", -1, no_effect, 0, Group::other, "PG, G group 17"}, 17, usual},
  {{"KONTC", -1, no_effect, 0, Group::other, "PG, G group 17"}, 17, usual},
  {{"KONTT", -1, no_effect, 0, Group::other, "PG, G group 17"}, 17, usual},
  {{"BNAT", -1, spline_begin, ir::kSplineNatural, Group::other, "PG, G group 19"}, 19, usual},
  {{"BTAN", -1, spline_begin, ir::kSplineTangent, Group::other, "PG, G group 19"}, 19, usual},
  {{"BAUTO", -1, spline_begin, ir::kSplineFree, Group::other, "PG, G group 19"}, 19, usual},
  {{"ENAT", -1, spline_end, ir::kSplineNatural, Group::other, "PG, G group 20"}, 20, usual},
  {{"ETAN", -1, spline_end, ir::kSplineTangent, Group::other, "PG, G group 20"}, 20, usual},
  {{"EAUTO", -1, spline_end, ir::kSplineFree, Group::other, "PG, G group 20"}, 20, usual},
  {{"BRISK", -1, no_effect, 0, Group::other, "PG, G group 21"}, 21, usual},
  {{"SOFT", -1, no_effect, 0, Group::other, "PG, G group 21"}, 21, usual},
  {{"DRIVE", -1, no_effect, 0, Group::other, "PG, G group 21"}, 21, usual},
  {{"CUT2D", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT2DF", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT3DC", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT3DF", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT3DFS", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT3DFF", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT3DCC", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT3DCCD", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT2DD", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT2DFD", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT3DCD", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CUT3DFD", -1, no_effect, 0, Group::other, "PG, G group 22"}, 22, usual},
  {{"CDOF", -1, no_effect, 0, Group::other, "PG, G group 23"}, 23, usual},
  {{"CDON", -1, no_effect, 0, Group::other, "PG, G group 23"}, 23, usual},
  {{"CDOF2", -1, no_effect, 0, Group::other, "PG, G group 23"}, 23, usual},
  {{"FFWOF", -1, no_effect, 0, Group::other, "PG, G group 24"}, 24, usual},
  {{"FFWON", -1, no_effect, 0, Group::other, "PG, G group 24"}, 24, usual},
  {{"ORIWKS", -1, not_modelled, 0, Group::other, "PG, G group 25"}, 25, usual},
  {{"ORIMKS", -1, not_modelled, 0, Group::other, "PG, G group 25"}, 25, usual},
  {{"RMB", -1, no_effect, 0, Group::other, "PG, G group 26"}, 26, usual},
  {{"RMI", -1, no_effect, 0, Group::other, "PG, G group 26"}, 26, usual},
  {{"RME", -1, no_effect, 0, Group::other, "PG, G group 26"}, 26, usual},
  {{"RMN", -1, no_effect, 0, Group::other, "PG, G group 26"}, 26, usual},
  {{"ORIC", -1, not_modelled, 0, Group::other, "PG, G group 27"}, 27, usual},
  {{"ORID", -1, not_modelled, 0, Group::other, "PG, G group 27"}, 27, usual},
  {{"WALIMON", -1, no_effect, 0, Group::other, "PG, G group 28"}, 28, usual},
  {{"WALIMOF", -1, no_effect, 0, Group::other, "PG, G group 28"}, 28, usual},
  {{"DIAMOF", -1, diameter_off, 0, Group::diameter, "PG, G group 29"}, 29, usual},
  {{"DIAMON", -1, diameter_on, 0, Group::diameter, "PG, G group 29"}, 29, usual},
  {{"DIAM90", -1, diameter_absolute_only, 0, Group::diameter, "PG, G group 29"}, 29, usual},
  {{"DIAMCYCOF", -1, not_modelled, 0, Group::diameter, "PG, G group 29"}, 29, usual},
  {{"COMPOF", -1, no_effect, 0, Group::other, "PG, G group 30"}, 30, usual},
  {{"COMPON", -1, no_effect, 0, Group::other, "PG, G group 30"}, 30, usual},
  {{"COMPCURV", -1, no_effect, 0, Group::other, "PG, G group 30"}, 30, usual},
  {{"COMPCAD", -1, no_effect, 0, Group::other, "PG, G group 30"}, 30, usual},
  {{"COMPSURF", -1, no_effect, 0, Group::other, "PG, G group 30"}, 30, usual},
  {{"COMPPATH", -1, no_effect, 0, Group::other, "PG, G group 30"}, 30, usual},
  {{"OSOF", -1, no_effect, 0, Group::other, "PG, G group 34"}, 34, usual},
  {{"OSC", -1, no_effect, 0, Group::other, "PG, G group 34"}, 34, usual},
  {{"OSS", -1, no_effect, 0, Group::other, "PG, G group 34"}, 34, usual},
  {{"OSSE", -1, no_effect, 0, Group::other, "PG, G group 34"}, 34, usual},
  {{"OSD", -1, no_effect, 0, Group::other, "PG, G group 34"}, 34, usual},
  {{"OST", -1, no_effect, 0, Group::other, "PG, G group 34"}, 34, usual},
  {{"FNORM", -1, no_effect, 0, Group::other, "PG, G group 37"}, 37, usual},
  {{"FLIN", -1, not_modelled, 0, Group::other, "PG, G group 37"}, 37, usual},
  {{"FCUB", -1, not_modelled, 0, Group::other, "PG, G group 37"}, 37, usual},
  {{"SPIF1", -1, no_effect, 0, Group::other, "PG, G group 38"}, 38, usual},
  {{"SPIF2", -1, no_effect, 0, Group::other, "PG, G group 38"}, 38, usual},
  {{"CPRECOF", -1, no_effect, 0, Group::other, "PG, G group 39"}, 39, usual},
  {{"CPRECON", -1, no_effect, 0, Group::other, "PG, G group 39"}, 39, usual},
  {{"CUTCONOF", -1, not_modelled, 0, Group::other, "PG, G group 40"}, 40, usual},
  {{"CUTCONON", -1, not_modelled, 0, Group::other, "PG, G group 40"}, 40, usual},
  {{"LFOF", -1, no_effect, 0, Group::other, "PG, G group 41"}, 41, usual},
  {{"LFON", -1, no_effect, 0, Group::other, "PG, G group 41"}, 41, usual},
  {{"SPATH", -1, no_effect, 0, Group::other, "PG, G group 45"}, 45, usual},
  {{"UPATH", -1, no_effect, 0, Group::other, "PG, G group 45"}, 45, usual},
  {{"LFTXT", -1, no_effect, 0, Group::other, "PG, G group 46"}, 46, usual},
  {{"LFWP", -1, no_effect, 0, Group::other, "PG, G group 46"}, 46, usual},
  {{"LFPOS", -1, no_effect, 0, Group::other, "PG, G group 46"}, 46, usual},
  {{"CP", -1, not_modelled, 0, Group::other, "PG, G group 49"}, 49, usual},
  {{"PTP", -1, not_modelled, 0, Group::other, "PG, G group 49"}, 49, usual},
  {{"PTPG0", -1, not_modelled, 0, Group::other, "PG, G group 49"}, 49, usual},
  {{"PTPWOC", -1, not_modelled, 0, Group::other, "PG, G group 49"}, 49, usual},
  {{"ORIEULER", -1, not_modelled, 0, Group::other, "PG, G group 50"}, 50, usual},
  {{"ORIRPY", -1, not_modelled, 0, Group::other, "PG, G group 50"}, 50, usual},
  {{"ORIRPY2", -1, not_modelled, 0, Group::other, "PG, G group 50"}, 50, usual},
  {{"ORIVIRT1", -1, not_modelled, 0, Group::other, "PG, G group 50"}, 50, usual},
  {{"ORIVIRT2", -1, not_modelled, 0, Group::other, "PG, G group 50"}, 50, usual},
  {{"ORIAXPOS", -1, not_modelled, 0, Group::other, "PG, G group 50"}, 50, usual},
  {{"ORIVECT", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORIAXES", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORIPATH", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORIPLANE", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORICONCW", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORICONCCW", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORICONIO", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORICONTO", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORICURVE", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"ORIPATHS", -1, not_modelled, 0, Group::other, "PG, G group 51"}, 51, usual},
  {{"PAROT", -1, not_modelled, 0, Group::other, "PG, G group 52"}, 52, usual},
  {{"PAROTOF", -1, not_modelled, 0, Group::other, "PG, G group 52"}, 52, usual},
  {{"TOROT", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"TOROTOF", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"TOROTX", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"TOROTY", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"TOROTZ", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"TOFRAME", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"TOFRAMEX", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"TOFRAMEY", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"TOFRAMEZ", -1, not_modelled, 0, Group::other, "PG, G group 53"}, 53, usual},
  {{"ROTROTOF", -1, not_modelled, 0, Group::other, "PG, G group 54"}, 54, usual},
  {{"RTLION", -1, no_effect, 0, Group::other, "PG, G group 55"}, 55, usual},
  {{"RTLIOF", -1, no_effect, 0, Group::other, "PG, G group 55"}, 55, usual},
  {{"TOWSTD", -1, not_modelled, 0, Group::other, "PG, G group 56"}, 56, usual},
  {{"TOWMCS", -1, not_modelled, 0, Group::other, "PG, G group 56"}, 56, usual},
  {{"TOWWCS", -1, not_modelled, 0, Group::other, "PG, G group 56"}, 56, usual},
  {{"TOWBCS", -1, not_modelled, 0, Group::other, "PG, G group 56"}, 56, usual},
  {{"TOWTCS", -1, not_modelled, 0, Group::other, "PG, G group 56"}, 56, usual},
  {{"TOWKCS", -1, not_modelled, 0, Group::other, "PG, G group 56"}, 56, usual},
  {{"FENDNORM", -1, no_effect, 0, Group::other, "PG, G group 57"}, 57, usual},
  {{"RELIEVEON", -1, no_effect, 0, Group::other, "PG, G group 58"}, 58, usual},
  {{"RELIEVEOF", -1, no_effect, 0, Group::other, "PG, G group 58"}, 58, usual},
  {{"DYNNORM", -1, no_effect, 0, Group::other, "PG, G group 59"}, 59, usual},
  {{"DYNPOS", -1, no_effect, 0, Group::other, "PG, G group 59"}, 59, usual},
  {{"DYNROUGH", -1, no_effect, 0, Group::other, "PG, G group 59"}, 59, usual},
  {{"DYNSEMIFIN", -1, no_effect, 0, Group::other, "PG, G group 59"}, 59, usual},
  {{"DYNFINISH", -1, no_effect, 0, Group::other, "PG, G group 59"}, 59, usual},
  {{"DYNPREC", -1, no_effect, 0, Group::other, "PG, G group 59"}, 59, usual},
  {{"WALCS0", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS1", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS2", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS3", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS4", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS5", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS6", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS7", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS8", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS9", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"WALCS10", -1, no_effect, 0, Group::other, "PG, G group 60"}, 60, usual},
  {{"ORISOF", -1, no_effect, 0, Group::other, "PG, G group 61"}, 61, usual},
  {{"ORISON", -1, no_effect, 0, Group::other, "PG, G group 61"}, 61, usual},
  {{"RMBBL", -1, no_effect, 0, Group::other, "PG, G group 62"}, 62, usual},
  {{"RMIBL", -1, no_effect, 0, Group::other, "PG, G group 62"}, 62, usual},
  {{"RMEBL", -1, no_effect, 0, Group::other, "PG, G group 62"}, 62, usual},
  {{"RMNBL", -1, no_effect, 0, Group::other, "PG, G group 62"}, 62, usual},
  {{"STOPRE", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"SBLON", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"SBLOF", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"DISPLON", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"DISPLOF", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"ACTBLOCNO", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"PREPRO", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"DRFOF", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"ICYCON", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"ICYCOF", -1, no_effect, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"TRAFOOF", -1, transformation, 0, Group::other, "PGA, transformations"}, 0, usual},
  {{"RTCPON", -1, not_modelled, 0, Group::other, "PGA, commands"}, 0, usual},
  {{"RTCPOF", -1, not_modelled, 0, Group::other, "PGA, commands"}, 0, usual},
});
// clang-format on

// GFRAME0 to GFRAME100, the frames of grinding.
constexpr std::size_t kGrindingFrameCount = 101;
using GrindingFrameName = std::array<char, 10>;
constexpr std::array<GrindingFrameName, kGrindingFrameCount> kGrindingFrames = [] {
  std::array<GrindingFrameName, kGrindingFrameCount> names{};
  for (std::size_t n = 0; n < names.size(); ++n) {
    GrindingFrameName& name = names[n];
    std::size_t at = 0;
    for (const char c : {'G', 'F', 'R', 'A', 'M', 'E'}) name[at++] = c;
    if (n >= 100) name[at++] = static_cast<char>('0' + n / 100);
    if (n >= 10) name[at++] = static_cast<char>('0' + n / 10 % 10);
    name[at] = static_cast<char>('0' + n % 10);
  }
  return names;
}();

}  // namespace

std::span<const GCode> named_codes() {
  static const std::vector<GCode> rows = [] {
    std::vector<GCode> all(kNamed.begin(), kNamed.end());
    for (const GrindingFrameName& name : kGrindingFrames)
      all.push_back({{name.data(), -1, ir::Function::not_modelled, 0, ir::ModalGroup::other, "PG, G group 64"},
                     64,
                     WordUse::usual});
    return all;
  }();
  return rows;
}

}  // namespace dripfeed::sinumerik
