// Where a line of a text stands.
#pragma once

#include <cstdint>
#include <string_view>

#include "dialects/text/source.h"
#include "dialects/text/span.h"

namespace dripfeed::compile {

// Of line `number`, from 1, without its end; empty at the beginning of the text for 0 and for lines that it does not
// have.
inline text::Span span_of_line(const text::Source& source, std::uint32_t number) {
  const std::string_view line = number == 0 ? std::string_view() : source.line(number);
  const auto begin = static_cast<std::uint32_t>(line.empty() ? 0 : line.data() - source.text().data());
  return {begin, begin + static_cast<std::uint32_t>(line.size())};
}

}  // namespace dripfeed::compile
