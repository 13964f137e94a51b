// Naming a broken property: to standard error, then abort, which libFuzzer and the replay both catch.
#include "tests/fuzz/target.h"

#include <cstdlib>

#include <fmt/core.h>

namespace dripfeed::fuzz {

void require(bool holds, std::string_view property) {
  if (holds) return;
  fmt::print(stderr, "broken property: {}\n", property);
  std::abort();
}

}  // namespace dripfeed::fuzz
