// Sentences of device servers, by their beginnings.
#include <array>

#include "protocol/receive/transfer.h"

namespace dripfeed::receive {
namespace {

// A sentence is a line that begins so, letters of either case. All have lower-case words or a form that no block has.
constexpr std::array<std::string_view, 14> kSentences{
    "port already in use",    "device open failure",      "connection refused", "connection reset",
    "connection closed",      "connection timed out",     "network is down",    "no route to host",
    "host is unreachable",    "port is in use",           "serial port in use", "ser2net port ",
    "all connections in use", "access denied, port busy",
};

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool begins_with(std::string_view text, std::string_view sentence) {
  if (text.size() < sentence.size()) return false;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    if (lower(text[i]) != sentence[i]) return false;
  }
  return true;
}

}  // namespace

std::string_view device_text(std::string_view text) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find_first_of("\r\n", begin);
    const std::string_view line = text.substr(begin, end == std::string_view::npos ? end : end - begin);
    for (const std::string_view sentence : kSentences) {
      if (begins_with(line, sentence)) return line;
    }
    if (end == std::string_view::npos) break;
    begin = end + 1;
  }
  return {};
}

}  // namespace dripfeed::receive
