// One row a mark, those at the start of a line first.
#include "dialects/haas/marks.h"

namespace dripfeed::haas {

namespace {

constexpr ir::DialectMark kMarks[] = {{"G154"}, {"G187"}, {"G103 P"}, {"M97 P"}, {"HAAS"}};

}  // namespace

std::span<const ir::DialectMark> marks() { return kMarks; }

}  // namespace dripfeed::haas
