// Which characters a control takes, as a bitmap, and a streaming check of a text against it before anything is sent.
// The controls' sets are rows of a table; the meaning of a program plays no part here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/tape_code/code_table.h"

namespace dripfeed::tape_code {

// A set of bytes.
class CharacterSet {
 public:
  constexpr CharacterSet() = default;
  // Lists the members; "A-Z" stands for a range, a '-' at the end for itself.
  constexpr explicit CharacterSet(std::string_view members) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      const bool range = i + 2 < members.size() && members[i + 1] == '-';
      const auto first = static_cast<std::uint8_t>(members[i]);
      const auto last = range ? static_cast<std::uint8_t>(members[i + 2]) : first;
      for (unsigned c = first; c <= last; ++c) add(static_cast<std::uint8_t>(c));
      if (range) i += 2;
    }
  }
  constexpr void add(std::uint8_t byte) { bits_[byte / 64U] |= std::uint64_t{1} << (byte % 64U); }
  constexpr bool has(std::uint8_t byte) const { return ((bits_[byte / 64U] >> (byte % 64U)) & 1U) != 0; }
  // What both hold.
  friend constexpr CharacterSet operator&(CharacterSet a, const CharacterSet& b) {
    for (std::size_t i = 0; i < a.bits_.size(); ++i) a.bits_[i] &= b.bits_[i];
    return a;
  }

 private:
  std::array<std::uint64_t, 4> bits_{};
};

struct NamedCharacterSet {
  std::string_view name;
  CharacterSet set;
  std::string_view source;
};

// The known sets: "iso-core", "fanuc-iso", "mitsubishi", "mazak", "sinumerik", "ascii". All hold LF, none CR, NUL or a
// DC code.
std::span<const NamedCharacterSet> character_sets();
std::optional<CharacterSet> find_character_set(std::string_view name);
// What a code has: 128 characters of ISO, all bytes of ASCII, the few of EIA and its specials.
CharacterSet characters_of(const EncodeTable& code);

struct IllegalCharacter {
  std::uint64_t line = 1;    // 1-based count of EOBs (LF)
  std::uint64_t column = 1;  // 1-based byte
  std::uint64_t text_offset = 0;
  std::uint8_t byte = 0;
};

// Checks a text with LF as EOB, piece by piece. Keeps the first kMaxReported findings and counts all.
class CharacterCheck {
 public:
  static constexpr std::size_t kMaxReported = 32;

  explicit CharacterCheck(const CharacterSet& set) : set_(set) {}
  void append(std::span<const char> text);
  std::span<const IllegalCharacter> found() const { return {found_.data(), reported_}; }
  std::uint64_t count() const { return count_; }

 private:
  CharacterSet set_;
  std::uint64_t line_ = 1;
  std::uint64_t column_ = 1;
  std::uint64_t offset_ = 0;
  std::uint64_t count_ = 0;
  std::size_t reported_ = 0;
  std::array<IllegalCharacter, kMaxReported> found_{};
};

}  // namespace dripfeed::tape_code
