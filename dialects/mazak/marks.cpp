// One row a mark, those at the start of a line first.
#include "dialects/mazak/marks.h"

namespace dripfeed::mazak {

namespace {

constexpr ir::DialectMark kMarks[] = {{"G52.5"}, {"G53.5"},  {"G68.5"},  {"G122.1"}, {"G123.1"}, {"G270 "},   {"G271 "},
                                      {"G276 "}, {"#70001"}, {"#70002"}, {"#70003"}, {"MAZAK"},  {"INTEGREX"}};
constexpr std::string_view kEndings[] = {".EIA"};

}  // namespace

std::span<const ir::DialectMark> marks() { return kMarks; }
std::span<const std::string_view> file_endings() { return kEndings; }

}  // namespace dripfeed::mazak
