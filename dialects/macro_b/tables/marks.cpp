// One row a mark, those at the start of a line first.
#include "dialects/macro_b/tables/marks.h"

namespace dripfeed::macro_b {

namespace {

constexpr ir::DialectMark kMarks[] = {{"(", true}, {"#"}, {"M98"}, {"M99"}, {"G65"}, {"G43"}, {"G28"}};

}  // namespace

std::span<const ir::DialectMark> marks() { return kMarks; }

}  // namespace dripfeed::macro_b
