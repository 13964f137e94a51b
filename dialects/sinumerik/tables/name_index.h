// Finds a name in a table by its spelling, whatever its case: the look-up of keywords, named codes and system
// variables. What a row means is its table's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace dripfeed::sinumerik {

inline constexpr char to_upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
inline constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
inline constexpr bool is_name_character(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
bool same_name(std::string_view a, std::string_view b);

// An upper-case copy without allocation; names longer than the buffer keep their first bytes, and no table has such.
class UpperName {
 public:
  explicit UpperName(std::string_view name);
  [[nodiscard]] std::string_view view() const { return {buffer_.data(), size_}; }

 private:
  std::array<char, 256> buffer_{};
  std::size_t size_ = 0;
};

// Open addressing, at most a quarter full, so that a look-up is one or two probes. Names are upper case and live as
// long as the index.
class NameIndex {
 public:
  static constexpr std::uint32_t kNotFound = 0xFFFFFFFFU;

  explicit NameIndex(std::span<const std::string_view> names);
  // Index of the name in the span of the constructor.
  [[nodiscard]] std::uint32_t find(std::string_view name) const;

 private:
  struct Slot {
    std::string_view name;
    std::uint32_t index = kNotFound;
  };
  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
};

// The index of a table whose rows have a `name`, or `row.name` one level down by `projection`.
template <class Rows, class Projection>
NameIndex index_of(const Rows& rows, Projection projection) {
  std::vector<std::string_view> names;
  names.reserve(std::size(rows));
  for (const auto& row : rows) names.push_back(projection(row));
  return NameIndex(names);
}

}  // namespace dripfeed::sinumerik
