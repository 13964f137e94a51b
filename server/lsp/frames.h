// Messages of the base protocol: "Content-Length: N", an empty line, N bytes. Whatever comes instead is skipped up to
// where the next message can begin, so that wrong input ends nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace dripfeed::lsp {

// Longest content of one message. A program of that size would take an editor minutes, too.
inline constexpr std::size_t kLongestMessage_bytes = std::size_t{64} << 20U;

enum class FrameFault : std::uint8_t { no_length, too_long };

class FrameReader {
 public:
  using Frame = std::variant<std::string, FrameFault>;

  explicit FrameReader(std::size_t longest_bytes = kLongestMessage_bytes) : longest_bytes_(longest_bytes) {}

  void add(std::string_view bytes) { buffer_.append(bytes); }
  // The next message, or the next fault; nothing until more bytes have come.
  std::optional<Frame> next();

 private:
  static constexpr std::size_t kLongestHeader_bytes = 4096;

  void drop_header(std::size_t header_bytes);

  std::size_t longest_bytes_;
  std::size_t to_skip_bytes_ = 0;  // of a message that is too long
  bool is_lost_ = false;           // between messages: reported once
  std::string buffer_;
};

// The content with its header.
std::string framed(std::string_view content);

}  // namespace dripfeed::lsp
