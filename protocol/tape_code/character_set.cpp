// The characters that the controls take, one row each, and the streaming check.
#include "protocol/tape_code/character_set.h"

namespace dripfeed::tape_code {
namespace {

constexpr std::string_view kIsoCore = "A-Z0-9 %()+./:#*=[],\n-";
constexpr std::string_view kIsoFull = "A-Z0-9 %()+./:#*=[],&?@\"'<>\t\n-";
constexpr std::string_view kIsoWithLowerCase = "A-Za-z0-9 %()+./:#*=[],&?@\"'<>!$_;\t\n-";
constexpr std::string_view kPrintable = " -~\t\n";

constexpr std::array<NamedCharacterSet, 6> kSets{{
    {"iso-core", CharacterSet(kIsoCore), "ISO 840 characters that the oldest readers take without a TH alarm"},
    {"fanuc-iso", CharacterSet(kIsoFull), "tape code list, ISO column; lower case is a TH alarm on older series"},
    {"mitsubishi", CharacterSet(kIsoWithLowerCase),
     "ISO R-840; lower case in comments only, which is not looked at here"},
    {"mazak", CharacterSet(kIsoWithLowerCase), "EIA/ISO programs; lower case in comments only"},
    {"sinumerik", CharacterSet(kPrintable), "7-bit text: printable characters, HT and LF"},
    {"ascii", CharacterSet(kPrintable), "printable ASCII, HT and LF"},
}};

}  // namespace

std::span<const NamedCharacterSet> character_sets() { return kSets; }

std::optional<CharacterSet> find_character_set(std::string_view name) {
  for (const NamedCharacterSet& row : kSets) {
    if (row.name == name) return row.set;
  }
  return std::nullopt;
}

CharacterSet characters_of(const EncodeTable& code) {
  CharacterSet set;
  for (unsigned byte = 0; byte < 256; ++byte) {
    if (code.has(static_cast<char>(byte))) set.add(static_cast<std::uint8_t>(byte));
  }
  return set;
}

void CharacterCheck::append(std::span<const char> text) {
  for (const char character : text) {
    const auto byte = static_cast<std::uint8_t>(character);
    if (!set_.has(byte)) {
      ++count_;
      if (reported_ < kMaxReported) {
        found_[reported_++] = {.line = line_, .column = column_, .text_offset = offset_, .byte = byte};
      }
    }
    ++offset_;
    ++column_;
    if (character != '\n') continue;
    ++line_;
    column_ = 1;
  }
}

}  // namespace dripfeed::tape_code
