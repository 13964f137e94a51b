// A program for each diagnostic that triggers it, and one that nearly does: the goldens of the tests, written into the
// binary by cmake/diagnostic_examples.cmake.
#pragma once

#include <span>
#include <string_view>

namespace dripfeed::cli {

struct DiagnosticExample {
  std::string_view id;
  std::string_view dialect;
  std::string_view trigger;
  std::string_view near_miss;  // empty without one
};
// Sorted by id.
std::span<const DiagnosticExample> diagnostic_examples();

}  // namespace dripfeed::cli
