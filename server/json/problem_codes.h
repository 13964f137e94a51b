// What a refused request is called, for programs: a code that stays the same in every version, with its status of HTTP.
// The code says what a caller can do; the sentence of a problem, and its id (sentences.h), say more.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"

namespace dripfeed::json {

struct ProblemCode {
  std::string_view code;
  unsigned status;  // of HTTP
  std::string_view title;
  std::string_view about;           // one clause, for the documentation
  unsigned retry_s = 0;             // when to ask again, for Retry-After; 0: asking again is of no use by itself
  std::string_view sentences = {};  // ids of the sentences that have this code, with blanks between
};

// By status; the first of a status is the code of all that have none of their own.
std::span<const ProblemCode> problem_codes();
// Of an answer with this status and sentence.
const ProblemCode& problem_code(unsigned status, std::string_view sentence);
const ProblemCode& problem_code(const app::Error& error);

}  // namespace dripfeed::json
