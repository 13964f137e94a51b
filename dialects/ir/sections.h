// The programs of a text by name and by number, and what kind of program each is.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "dialects/ir/program.h"

namespace dripfeed::ir {

// A number alone holds no block.
inline bool is_empty(const Program& text, const Section& section) {
  for (std::uint32_t i = section.first; i < section.last; ++i)
    if (text.statements[i].kind != StatementKind::empty) return false;
  return true;
}

// The first of that name that has blocks, otherwise the first. nullopt: none of that name.
inline std::optional<std::uint32_t> section_named(const Program& text, std::string_view name) {
  std::optional<std::uint32_t> found;
  for (std::uint32_t i = 0; i < text.sections.size(); ++i) {
    if (text.strings.at(text.sections[i].name) != name) continue;
    if (!is_empty(text, text.sections[i])) return i;
    if (!found) found = i;
  }
  return found;
}

// All statements where the text is one program.
inline Section section_at(const Program& text, std::uint32_t index) {
  if (!text.sections.empty()) return text.sections[index];
  return {.first = 0, .last = static_cast<std::uint32_t>(text.statements.size())};
}

constexpr bool returns(StatementKind kind) {
  return kind == StatementKind::subprogram_return || kind == StatementKind::return_to;
}

// The range has an end of its own (M30, M2).
inline bool has_end(const Program& text, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t i = first; i < last; ++i)
    if (text.statements[i].kind == StatementKind::program_end) return true;
  return false;
}

// A program that others call: it returns (M99, M17, RET) or has a head (PROC), and no end of its own. What is active at
// its start, and its arguments, are its caller's.
inline bool is_subprogram(const Program& text, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t i = first; i < last; ++i) {
    const StatementKind kind = text.statements[i].kind;
    if (returns(kind) || kind == StatementKind::procedure) return !has_end(text, first, last);
  }
  return false;
}
inline bool is_subprogram(const Program& text, const Section& range) {
  return is_subprogram(text, range.first, range.last);
}
// All of the text.
inline bool is_subprogram(const Program& text) {
  return is_subprogram(text, 0, static_cast<std::uint32_t>(text.statements.size()));
}

}  // namespace dripfeed::ir
