// A half-open range of bytes in one text, and an edit that replaces such a range. Offsets are 32-bit: a program that is
// held whole is at most 4 GiB; longer ones are streamed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace dripfeed::text {

struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  [[nodiscard]] constexpr std::uint32_t size() const { return end - begin; }
  [[nodiscard]] constexpr bool empty() const { return begin == end; }
  [[nodiscard]] constexpr std::string_view in(std::string_view whole) const { return whole.substr(begin, end - begin); }
  friend constexpr bool operator==(Span, Span) = default;
};

// The smallest span that holds both.
constexpr Span join(Span a, Span b) { return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end}; }

struct Edit {
  Span replaced;
  std::string text;
};

}  // namespace dripfeed::text
