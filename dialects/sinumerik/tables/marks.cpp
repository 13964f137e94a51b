// One row a mark, those at the start of a line first.
#include "dialects/sinumerik/tables/marks.h"

namespace dripfeed::sinumerik {

namespace {

constexpr ir::DialectMark kMarks[] = {{"%_N_", true},
                                      {";", true},
                                      {"DEF ", true},
                                      {"PROC ", true},
                                      {"EXTERN ", true},
                                      {"MSG(", true},
                                      {"MSG (", true},
                                      {"ENDIF", true},
                                      {"ENDWHILE", true},
                                      {"ENDFOR", true},
                                      {"GOTOF"},
                                      {"GOTOB"},
                                      {"$P_"},
                                      {"$A"},
                                      {"CR="},
                                      {"LIMS="},
                                      {"DIAM"},
                                      {"G500"},
                                      {"T=\""},
                                      {"=AC("},
                                      {"=IC("},
                                      {"SUPA"},
                                      {"CYCLE8"},
                                      {"X="},
                                      {"Y="},
                                      {"Z="}};
constexpr std::string_view kEndings[] = {".MPF", ".SPF", "_MPF", "_SPF"};

}  // namespace

std::span<const ir::DialectMark> marks() { return kMarks; }
std::span<const std::string_view> file_endings() { return kEndings; }

}  // namespace dripfeed::sinumerik
