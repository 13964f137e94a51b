// The Modbus server on any bytes: the answers do not depend on how the stream is cut, each is a frame that a client can
// read, and nothing is answered after an end.
#include <algorithm>
#include <string>

#include "protocol/modbus/mbap.h"
#include "tests/fuzz/target.h"

using namespace dripfeed;

namespace {

class View final : public modbus::RegisterView {
 public:
  bool has_unit(std::uint8_t unit) override { return unit % 2 == 1; }
  bool read(std::uint8_t, std::uint16_t first, std::span<std::uint16_t> into) override {
    if (first + into.size() > 300) return false;
    std::fill(into.begin(), into.end(), first);
    return true;
  }
};

std::string talk(std::string_view in, std::size_t piece) {
  View view;
  modbus::MbapConnection connection(view, {});
  std::string out;
  while (!in.empty() && connection.ended() == modbus::MbapEnd::none) {
    const std::size_t taken = connection.receive(std::as_bytes(std::span(in.substr(0, piece))), {});
    const auto answers = connection.pending_out();
    fuzz::require(taken > 0 || !answers.empty(), "it takes bytes, or has something to send first");
    for (const std::byte byte : answers) out.push_back(static_cast<char>(byte));
    connection.mark_sent(answers.size());
    in.remove_prefix(taken);
  }
  return out;
}

std::size_t byte_at(std::string_view text, std::size_t at) { return static_cast<std::uint8_t>(text[at]); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view in = fuzz::text_of(data, size);
  const std::string answers = talk(in, in.size() + 1);
  fuzz::require(talk(in, 1) == answers && talk(in, 7) == answers, "the answers do not depend on how the stream is cut");
  std::string_view left = answers;
  while (!left.empty()) {
    fuzz::require(left.size() >= 9 && left[2] == 0 && left[3] == 0, "an answer has a header, a unit and two bytes");
    const std::size_t length = 6 + byte_at(left, 4) * 256 + byte_at(left, 5);
    fuzz::require(length <= left.size() && length <= modbus::kMaxAdu, "an answer is as long as it says");
    const bool refused = byte_at(left, 7) >= 0x80;
    fuzz::require(refused ? length == 9 : length == 9 + byte_at(left, 8), "an answer is whole or an exception");
    left.remove_prefix(length);
  }
  return 0;
}
