// A text that a person writes, laid out again: block numbers, blanks, the case of letters. It stays the same program,
// or it is refused with the lines that stand against it. Nothing is stored.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/renumber/renumber.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/checks/diagnose.h"

namespace dripfeed::app {

enum class Rewriting : std::uint8_t { renumber, add_blanks, remove_blanks, upper_case, lower_case };
// By Rewriting.
inline constexpr std::string_view kRewritingNames[] = {"renumber", "add_blanks", "remove_blanks", "upper_case",
                                                       "lower_case"};

inline constexpr std::uint32_t kMostNumberStep = 10'000;

struct RewriteOrder {
  DiagnoseOrder of;
  Rewriting how = Rewriting::renumber;
  // Of `renumber` alone.
  compile::Numbering numbering = compile::Numbering::numbered;
  std::uint32_t first = 10;
  std::uint32_t step = 10;
};

struct Rewritten {
  std::string text;                      // as it was where nothing is to be changed; empty: refused
  std::uint32_t numbers = 0;             // blocks that have one now; of `renumber` alone
  std::uint32_t references = 0;          // that name one of them
  std::vector<std::string> assumptions;  // sentences for people
  std::vector<compile::RenumberRefusal> refused;
};

Rewritten renumber_text(const compile::RenumberRequest& request);

// Errors: as open_text.
Result<Rewritten> rewrite_text(const RewriteOrder& order, const Documents& documents);

}  // namespace dripfeed::app
