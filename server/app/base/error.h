// What a use case could not do, as people and programs get it: a code that decides the HTTP status and exit code, a
// sentence, and the places where there are some.
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <utility>
#include <vector>

#include "store/error.h"

namespace dripfeed::app {

enum class ErrorCode : std::uint8_t {
  not_found,
  exists,
  malformed,    // the request is not even JSON
  invalid,      // the request makes no sense: see `places`
  stale,        // another revision is the newest
  refused,      // the state of things does not allow it now
  too_large,    // more than the shop's limits let in at once
  over_quota,   // all together are more than the limits
  unavailable,  // disk full, store busy, line not there
  internal,
};

// Where in a document or text: a JSON pointer, or line and column of a text (1-based; 0: none).
struct ErrorPlace {
  std::string pointer;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::string text;
};

struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string text;
  std::vector<ErrorPlace> places;
};

template <class T>
using Result = std::expected<T, Error>;

inline std::unexpected<Error> fail(ErrorCode code, std::string text, std::vector<ErrorPlace> places = {}) {
  return std::unexpected(Error{code, std::move(text), std::move(places)});
}

// The store's errors in these terms.
Error from_store(const store::Error& error);

// A store's result in these terms.
template <class T>
Result<T> lift(store::Result<T> result) {
  if (!result) return std::unexpected(from_store(result.error()));
  if constexpr (std::is_void_v<T>) {
    return {};
  } else {
    return std::move(*result);
  }
}

}  // namespace dripfeed::app
