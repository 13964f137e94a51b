// A header that gives no length is reported once; what follows it is skipped up to the next "Content-Length".
#include "server/lsp/frames.h"

#include <algorithm>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::lsp {

namespace {

constexpr std::string_view kEndOfHeader = "\r\n\r\n";
constexpr std::string_view kLength = "CONTENT-LENGTH:";

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
  while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
  return text;
}

bool is_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

// Of the lines of a header; nothing where none of them gives it as a number.
std::optional<std::size_t> length_in(std::string_view header) {
  while (!header.empty()) {
    const std::string_view line = header.substr(0, header.find("\r\n"));
    header.remove_prefix(std::min(header.size(), line.size() + 2));
    if (!text::upper_case(line.substr(0, kLength.size())).starts_with(kLength)) continue;
    const std::string_view digits = trimmed(line.substr(kLength.size()));
    const auto length = text::parse_integer(digits);
    if (!is_digits(digits) || !length) return std::nullopt;
    return static_cast<std::size_t>(*length);
  }
  return std::nullopt;
}

}  // namespace

// What gives no length, up to where the next header may begin.
void FrameReader::drop_header(std::size_t header_bytes) {
  const std::string_view rest = std::string_view(buffer_).substr(0, header_bytes + kLength.size());
  const std::size_t again = text::upper_case(rest).find(kLength, 1);
  buffer_.erase(0, std::min(again, header_bytes));
}

std::optional<FrameReader::Frame> FrameReader::next() {
  while (true) {
    const std::size_t skipped = std::min(to_skip_bytes_, buffer_.size());
    buffer_.erase(0, skipped);
    to_skip_bytes_ -= skipped;
    const std::size_t end = buffer_.find(kEndOfHeader);
    const bool is_whole = end != std::string::npos;
    if (to_skip_bytes_ > 0 || (!is_whole && buffer_.size() <= kLongestHeader_bytes)) return std::nullopt;
    const std::size_t content = is_whole ? end + kEndOfHeader.size() : buffer_.size() - kEndOfHeader.size();
    const auto length = is_whole ? length_in(std::string_view(buffer_).substr(0, end)) : std::nullopt;
    if (!length) {
      drop_header(content);
      if (is_lost_) continue;
      is_lost_ = true;
      return FrameFault::no_length;
    }
    is_lost_ = false;
    if (*length <= longest_bytes_ && buffer_.size() - content < *length) return std::nullopt;
    std::string message = *length <= longest_bytes_ ? buffer_.substr(content, *length) : std::string();
    if (*length > longest_bytes_) {
      to_skip_bytes_ = *length;
      buffer_.erase(0, content);
      return FrameFault::too_long;
    }
    buffer_.erase(0, content + *length);
    return message;
  }
}

std::string framed(std::string_view content) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", content.size(), content);
}

}  // namespace dripfeed::lsp
