// Places in a text as the protocol counts them: lines from 0, ended by LF, CR LF or CR, and characters from 0 in a unit
// that client and server agree on. Everything else of dripfeed counts bytes.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "dialects/text/span.h"

namespace dripfeed::lsp {

enum class PositionUnit : std::uint8_t { utf8, utf16, utf32 };
// By PositionUnit, as the protocol names them.
inline constexpr std::array<std::string_view, 3> kPositionUnitNames = {"utf-8", "utf-16", "utf-32"};

struct Position {
  std::uint32_t line = 0;
  std::uint32_t character = 0;
};

struct Range {
  Position start;
  Position end;
};
// Whether they have a place in common; ranges that touch have one.
bool touches(const Range& a, const Range& b);

class Lines {
 public:
  Lines() = default;
  // The text must outlive it.
  explicit Lines(std::string_view text);

  // A place after the end of a line is the end of the line; one after the last line is the end of the text.
  [[nodiscard]] std::uint32_t offset_of(Position position, PositionUnit unit) const;
  [[nodiscard]] Position position_of(std::uint32_t offset, PositionUnit unit) const;
  [[nodiscard]] Range range_of(text::Span span, PositionUnit unit) const;
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(starts_.size()); }
  // Without its end.
  [[nodiscard]] text::Span span_of(std::uint32_t line) const;

 private:
  std::string_view text_;
  std::vector<std::uint32_t> starts_ = {0};
};

}  // namespace dripfeed::lsp
