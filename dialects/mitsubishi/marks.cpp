// One row a mark, those at the start of a line first.
#include "dialects/mitsubishi/marks.h"

namespace dripfeed::mitsubishi {

namespace {

constexpr ir::DialectMark kMarks[] = {{"G31.1"}, {"G31.2"}, {"#100100"}, {"MITSUBISHI"}};

}  // namespace

std::span<const ir::DialectMark> marks() { return kMarks; }

}  // namespace dripfeed::mitsubishi
