// What all repositories share: ids, who did something and when, pages of a list. Times are given by the caller in
// milliseconds since 1970 (UTC); the store has no clock.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::store {

using Id = std::uint64_t;        // of a row; 0 is none
using Revision = std::uint64_t;  // 1, 2, 3, … ; 0 is none

// Who did it, and when. Each change of the store leaves a row in the audit with both.
struct Stamp {
  std::string actor;
  std::int64_t at_ms = 0;
};

// How a program goes to a control. Verdicts and releases hold for one way only.
enum class Delivery : std::uint8_t { drip, memory };
std::string_view name_of(Delivery delivery);

inline constexpr std::uint32_t kPageLimitMax = 1000;

// `after` is the `next` of the page before, or empty for the first one.
struct PageRequest {
  std::uint32_t limit = 50;  // 1..kPageLimitMax
  std::string after;
};

// `next` is empty on the last page.
template <class T>
struct Page {
  std::vector<T> items;
  std::string next;
};

// Base of the repositories: they are referred to, not copied.
class Repository {
 public:
  Repository() = default;
  Repository(const Repository&) = delete;
  Repository& operator=(const Repository&) = delete;
  virtual ~Repository() = default;
};

}  // namespace dripfeed::store
