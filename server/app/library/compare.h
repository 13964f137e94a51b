// Two programs compared: as texts, by what their lines mean, and by the moves that they make. Each
// answer stands alone, and "equal" is stated only where both were understood whole.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/library.h"
#include "dialects/compile/translate/compare_moves.h"
#include "server/app/base/check_budget.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/base/text_difference.h"

namespace dripfeed::app {

enum class Likeness : std::uint8_t { equal, differs, not_compared };
inline constexpr std::array<std::string_view, 3> kLikenessWords = {"equal", "differs", "not_compared"};
constexpr std::string_view name_of(Likeness one) { return kLikenessWords[static_cast<std::size_t>(one)]; }

// Lines that stand in one of the two where the other has others, or none.
struct ChangedLines {
  std::vector<NumberedLine> first;
  std::vector<NumberedLine> second;
};

struct LinesAnswer {
  Likeness likeness = Likeness::not_compared;
  std::string why;                    // it was not compared
  std::vector<ChangedLines> changes;  // kMostChanges at most, of kMostLines lines each
  std::uint64_t change_count = 0;     // all of them
};

struct Comparison {
  static constexpr std::size_t kMostChanges = 200;
  static constexpr std::size_t kMostLines = 50;
  LinesAnswer text;
  LinesAnswer meaning;
  compile::MovesAnswer moves;
};
constexpr Likeness likeness_of(const compile::MovesAnswer& moves) {
  if (!moves.why.empty()) return Likeness::not_compared;
  return moves.equal ? Likeness::equal : Likeness::differs;
}

struct ComparedText {
  text::Source source;
  const compile::Dialect* dialect = nullptr;
  ir::Control control;
  compile::FindText find_called = [](std::string_view) { return std::nullopt; };
};
// `used_up` as in interpreter::RunOptions.
Comparison compare(const ComparedText& first, const ComparedText& second, const std::function<std::string()>& used_up);

// Two stored texts, as data.
struct CompareOrder {
  struct Side {
    std::string name;
    std::string dialect;
    std::string text;
  };
  Side first;
  Side second;
  std::string profile;  // the machine's document; empty: the control that each text looks like
};
// Errors: invalid: a dialect that is not known, or another one than the machine's.
Result<Comparison> compare_case(const CompareOrder& order, const Documents& documents, const CheckBudget& budget);

}  // namespace dripfeed::app
