// One program text with its name, and the conversion from a byte offset to the line and column that a person sees.
// Lines are counted as the controls count them: LF, CR LF, CR and LF CR CR each end one block (EOB).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::text {

// 1-based; columns count bytes, column_chars counts UTF-8 code points (an invalid byte counts as one).
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  std::uint32_t column_chars = 1;
};

// Length of the EOB that starts at `offset` of `text`: 0 when there is none, 1 (LF or CR), 2 (CR LF) or 3 (LF CR CR).
std::uint32_t eob_length(std::string_view text, std::size_t offset);

class Source {
 public:
  Source() = default;
  // `name` is what messages call it: a path or a program name. The text is kept, never copied again.
  Source(std::string name, std::string text);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string_view text() const { return *text_; }
  [[nodiscard]] Position position(std::uint32_t offset) const;
  // Text of a 1-based line without its EOB; empty when there is no such line.
  [[nodiscard]] std::string_view line(std::uint32_t number) const;
  [[nodiscard]] std::uint32_t line_count() const;

 private:
  std::string name_;
  std::shared_ptr<const std::string> text_ = std::make_shared<const std::string>();
  std::vector<std::uint32_t> line_starts_ = {0};
};

}  // namespace dripfeed::text
