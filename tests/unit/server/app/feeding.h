// What the tests of lines share: a line's settings, a program and an order for it, and the wire as text.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "protocol/feed/feed.h"
#include "protocol/tape_code/text_source.h"
#include "server/app/lines/line.h"
#include "server/machine/profile.h"

namespace dripfeed::app::test {

inline constexpr std::string_view kDc1 = "\x11";
inline constexpr std::string_view kDc3 = "\x93";  // with its parity
inline constexpr std::string_view kSyn = "\x96";
inline constexpr const char* kUrl = "pty:/machine/lathe";

// 9600 baud 7E2: 1.146 ms a character. No leader, no trailer.
inline machine::LineSettings line_settings(const char* url = kUrl) {
  machine::LineSettings line;
  line.link = machine::parse_link_url(url).value();
  line.end_by_quiet_s = 3.0;
  return line;
}

inline std::string program(int blocks) {
  std::string text = "%\nO0042\n";
  for (int i = 0; i < blocks; ++i) text += "G01X" + std::to_string(100 + i) + ".Z-5.F0.2\n";
  return text + "M30\n%\n";
}

// Without parity.
inline std::string text_of(std::string_view wire) {
  std::string text;
  for (const char c : wire) text += static_cast<char>(c & 0x7F);
  return text;
}

inline feed::ProgramFacts facts_of(std::string_view text) {
  feed::ProgramCheck check(feed::kParenthesesSyntax);
  check.append(std::span(text.data(), text.size()));
  return check.finish().value();
}

// A text that lives as long as its order.
class OwnedText final : public tape_code::TextSource {
 public:
  explicit OwnedText(std::string text) : text_(std::move(text)), source_(text_) {}
  tape_code::TextPiece next() noexcept override { return source_.next(); }

 private:
  std::string text_;
  tape_code::SpanSource source_;
};

inline LineOrder order_of(std::uint64_t job, const std::string& text, std::uint64_t reserve = feed::kNoReserve) {
  return {.job = job,
          .facts = facts_of(text),
          .source = std::make_shared<OwnedText>(text),
          .expires_after = feed::kArmingExpiry,
          .reserve = reserve,
          .session = 7};
}

}  // namespace dripfeed::app::test
