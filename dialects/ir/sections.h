// The programs of a text by name and by number.
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

}  // namespace dripfeed::ir
