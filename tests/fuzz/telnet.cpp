// Both ends of RFC 2217 under any bytes: no more data comes out than went in, no buffer runs over, and what a client
// sends once it is up arrives at a server as it was.
#include "protocol/telnet/telnet.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "tests/fuzz/target.h"

using namespace dripfeed;

namespace {

constexpr std::size_t kPiece = 64;

template <class End, class Receive>
void feed_piece(fuzz::Choices& choices, End& end, const Receive& receive) {
  const std::string_view text = choices.text(1 + choices.below(kPiece));
  std::array<std::byte, kPiece> data{};
  const auto wire = std::as_bytes(std::span(text));
  const std::size_t got = receive(wire, std::span(data).first(wire.size()));
  fuzz::require(got <= wire.size(), "no more data than bytes");
  fuzz::require(end.pending_out().size() <= telnet::Output::kBytes, "the output keeps its limit");
  end.mark_sent(choices.byte());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Choices choices(data, size);
  telnet::ComPortClient client({.baud = 9600,
                                .data_bits = 8,
                                .parity = telnet::LineParity::none,
                                .stop_bits = 2,
                                .flow = static_cast<telnet::LineFlow>(1 + choices.below(3))});
  telnet::ComPortServer server;
  telnet::Time now{};
  client.begin(now);
  server.begin();
  while (!choices.done()) {
    now += std::chrono::milliseconds(choices.byte());
    client.tick(now);
    if (choices.flag()) {
      feed_piece(choices, client, [&](auto wire, auto into) { return client.receive(wire, into, now); });
    } else {
      feed_piece(choices, server, [&](auto wire, auto into) { return server.receive(wire, into); });
      server.set_modem_lines(choices.byte());
      server.notify_line(choices.byte());
    }
    constexpr std::array kData = {std::byte{0x41}, std::byte{0xFF}, std::byte{0x0D}};
    const std::size_t taken = client.send(kData);
    fuzz::require(taken == 0 || client.state() == telnet::ClientState::up, "data goes out only when the line is set");
    if (taken > 0) client.mark_sent(client.pending_out().size());
    while (client.next_event()) {
    }
  }
  return 0;
}
