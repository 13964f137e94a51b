// The programs of a text by name and by number, and what kind of program each is.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "dialects/ir/program.h"

namespace dripfeed::ir {

// nullopt: none of that name.
inline std::optional<std::uint32_t> section_named(const Program& text, std::string_view name) {
  for (std::uint32_t i = 0; i < text.sections.size(); ++i)
    if (text.strings.at(text.sections[i].name) == name) return i;
  return std::nullopt;
}

// All statements where the text is one program.
inline Section section_at(const Program& text, std::uint32_t index) {
  if (!text.sections.empty()) return text.sections[index];
  return {.first = 0, .last = static_cast<std::uint32_t>(text.statements.size())};
}

constexpr bool returns(StatementKind kind) {
  return kind == StatementKind::subprogram_return || kind == StatementKind::return_to;
}

// It ends by M99 (RET) and not by M30 or M02: what is active at its start, and its arguments, are its caller's.
inline bool is_subprogram(const Program& text, std::uint32_t first, std::uint32_t last) {
  bool goes_back = false;
  for (std::uint32_t i = first; i < last; ++i) {
    if (text.statements[i].kind == StatementKind::program_end) return false;
    goes_back = goes_back || returns(text.statements[i].kind);
  }
  return goes_back;
}
inline bool is_subprogram(const Program& text, const Section& range) {
  return is_subprogram(text, range.first, range.last);
}

}  // namespace dripfeed::ir
