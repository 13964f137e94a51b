// Keywords of Mitsubishi besides the common ones: other spellings of three functions.
#include <algorithm>
#include <array>

#include "dialects/mitsubishi/tables.h"

namespace dripfeed::mitsubishi {

namespace {

using enum macro_b::KeywordRole;
using ir::Operator;

constexpr auto kOwn = std::to_array<macro_b::Keyword>({
    {"ATN", function, Operator::atan},
    {"RND", function, Operator::round},
    {"SQR", function, Operator::sqrt},
});

}  // namespace

std::span<const macro_b::Keyword> keywords() {
  static const std::vector<macro_b::Keyword> kAll = [] {
    const auto common = macro_b::common_keywords();
    std::vector<macro_b::Keyword> all(common.begin(), common.end());
    all.insert(all.end(), kOwn.begin(), kOwn.end());
    std::ranges::sort(all, {}, &macro_b::Keyword::spelling);
    return all;
  }();
  return kAll;
}

}  // namespace dripfeed::mitsubishi
