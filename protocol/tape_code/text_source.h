// Where the text of a program comes from, piece by piece, so that a text of any length is never whole in memory.
// The server implements it over its store, the command over a file; protocol code only pulls.
#pragma once

#include <cstdint>
#include <span>

namespace dripfeed::tape_code {

enum class SourceStatus : std::uint8_t {
  text,       // the span holds at least one character
  not_ready,  // nothing yet; ask again later
  end,        // the text is over
  failed,     // the text cannot be read any more
};

struct TextPiece {
  SourceStatus status = SourceStatus::end;
  std::span<const char> text{};  // stays valid until the next call of next()
};

// Program text with LF as EOB, in order. next() is called on the link's thread: it must not block, throw or allocate.
class TextSource {
 public:
  virtual ~TextSource() = default;
  virtual TextPiece next() noexcept = 0;
};

// A text that is whole in memory already, given so many times. The characters must outlive it.
class SpanSource final : public TextSource {
 public:
  explicit SpanSource(std::span<const char> text, std::uint32_t times = 1) : text_(text), times_left_(times) {}
  TextPiece next() noexcept override {
    if (times_left_ == 0 || text_.empty()) return {.status = SourceStatus::end, .text = {}};
    --times_left_;
    return {.status = SourceStatus::text, .text = text_};
  }

 private:
  std::span<const char> text_;
  std::uint32_t times_left_;
};

}  // namespace dripfeed::tape_code
