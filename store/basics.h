// What all repositories share: ids, who did something and when, pages of a list. Times are given by the caller in
// milliseconds since 1970 (UTC); the store has no clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace dripfeed::store {

using Id = std::uint64_t;        // of a row; 0 is none
using Revision = std::uint64_t;  // 1, 2, 3, … ; 0 is none

// Who did it, and when. Each change of the store leaves a row in the audit with both.
struct Stamp {
  std::string actor;
  std::int64_t at_ms = 0;
};

// How a program goes to a control. Verdicts and releases hold for one delivery only.
enum class Delivery : std::uint8_t { drip, memory };

// The names of an enum's values in their order, as they stand in the database and may stand in documents.
template <class E>
inline constexpr std::array<std::string_view, 0> kNames{};
template <>
inline constexpr std::array<std::string_view, 2> kNames<Delivery>{"drip", "memory"};

template <class E>
concept Named = std::is_enum_v<E> && (kNames<E>.size() > 0);

template <Named E>
constexpr std::string_view name_of(E value) {
  return kNames<E>[static_cast<std::size_t>(value)];
}

// The value with this name: named<Delivery>("drip").
template <Named E>
constexpr std::optional<E> named(std::string_view name) {
  for (std::size_t i = 0; i < kNames<E>.size(); ++i) {
    if (kNames<E>[i] == name) return static_cast<E>(i);
  }
  return std::nullopt;
}

inline constexpr std::uint32_t kPageLimitMax = 1000;

// `after` is the `next` of the page before, or empty for the first one.
struct PageRequest {
  std::uint32_t limit = 50;  // 1..kPageLimitMax
  std::string after{};
};

// `next` is empty on the last page.
template <class T>
struct Page {
  std::vector<T> items;
  std::string next;
};

// Which machines something is about; empty: all.
using OfMachines = std::function<bool(std::string_view machine)>;

// Base of the repositories: they are referred to, not copied.
class Repository {
 public:
  Repository() = default;
  Repository(const Repository&) = delete;
  Repository& operator=(const Repository&) = delete;
  virtual ~Repository() = default;
};

}  // namespace dripfeed::store
