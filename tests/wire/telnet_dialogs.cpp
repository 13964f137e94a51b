// Every dialog of tests/wire/telnet, whole, byte by byte and at random splits; every row of the client's table is taken
// by one of them. And client against server: whatever the splits, the line is set as asked and every byte passes.
#include <gtest/gtest.h>

#include "tests/wire/telnet_player.h"

namespace dripfeed::wire {
namespace {

using Splits = TelnetPlayer::Splits;

TEST(TelnetDialogs, PlayAtAllSplits) {
  const std::vector<Dialog> dialogs = load_dialogs("telnet");
  ASSERT_FALSE(dialogs.empty());
  std::uint32_t rows = 0;
  for (const Dialog& dialog : dialogs) {
    TelnetPlayer whole(Splits::whole, 0);
    EXPECT_EQ(whole.play(dialog), "") << dialog.name;
    rows |= whole.rows_taken();
    EXPECT_EQ(TelnetPlayer(Splits::single_bytes, 0).play(dialog), "") << dialog.name;
    for (unsigned seed = 1; seed <= 10; ++seed)
      EXPECT_EQ(TelnetPlayer(Splits::random, seed).play(dialog), "") << dialog.name << " seed " << seed;
  }
  for (std::size_t i = 0; i < telnet::client_table().size(); ++i) {
    const telnet::ClientRow& row = telnet::client_table()[i];
    EXPECT_TRUE((rows >> i & 1U) != 0) << "no dialog takes " << name(row.from) << " + " << name(row.input);
  }
}

// Moves what one end has to say to the other, in pieces.
template <class From, class To>
bool carry(From& from, std::mt19937& random, std::string& data, const To& to) {
  const auto pending = from.pending_out();
  if (pending.empty()) return false;
  const std::size_t count = 1 + random() % pending.size();
  const std::vector<std::byte> wire(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(count));
  from.mark_sent(count);
  std::vector<std::byte> got(count);
  const std::size_t n = to(wire, std::span(got));
  for (std::size_t i = 0; i < n; ++i) data += static_cast<char>(got[i]);
  return true;
}

std::vector<std::byte> some_bytes(std::mt19937& random) {
  std::vector<std::byte> bytes(1 + random() % 40);
  constexpr std::array<unsigned, 6> kSpecial = {0xFF, 0x0D, 0x00, 0x0A, 0xF0, 0xFA};
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() % 2 == 0 ? kSpecial[random() % 6] : random());
  return bytes;
}

TEST(TelnetPair, CarriesEveryByteInBothDirections) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    std::mt19937 random(seed);
    telnet::ComPortSettings settings{.baud = 1 + static_cast<std::uint32_t>(random() % 4'000'000),
                                     .data_bits = static_cast<std::uint8_t>(7 + random() % 2),
                                     .parity = static_cast<telnet::LineParity>(1 + random() % 3),
                                     .stop_bits = static_cast<std::uint8_t>(1 + random() % 2),
                                     .flow = static_cast<telnet::LineFlow>(1 + random() % 3)};
    telnet::ComPortClient client(settings);
    telnet::ComPortServer server;
    client.begin(telnet::Time(0));
    server.begin();
    server.set_modem_lines(telnet::modem::kCts | telnet::modem::kDsr);
    std::string sent_down;
    std::string sent_up;
    std::string got_down;
    std::string got_up;
    for (int i = 0; i < 400; ++i) {
      const std::vector<std::byte> down = some_bytes(random);
      const std::vector<std::byte> up = some_bytes(random);
      const std::size_t down_taken = client.send(down);
      const std::size_t up_taken = client.state() == telnet::ClientState::up ? server.send(up) : 0;
      for (std::size_t k = 0; k < down_taken; ++k) sent_down += static_cast<char>(down[k]);
      for (std::size_t k = 0; k < up_taken; ++k) sent_up += static_cast<char>(up[k]);
      carry(client, random, got_down, [&](const auto& wire, auto data) { return server.receive(wire, data); });
      carry(server, random, got_up,
            [&](const auto& wire, auto data) { return client.receive(wire, data, telnet::Time(i)); });
    }
    while (carry(client, random, got_down, [&](const auto& wire, auto data) { return server.receive(wire, data); }) ||
           carry(server, random, got_up,
                 [&](const auto& wire, auto data) { return client.receive(wire, data, telnet::Time(1000)); })) {
    }
    ASSERT_EQ(client.state(), telnet::ClientState::up) << seed;
    ASSERT_GT(sent_down.size(), 100U) << seed;
    EXPECT_EQ(got_down, sent_down) << seed;
    EXPECT_EQ(got_up, sent_up) << seed;
    EXPECT_EQ(server.port().baud, settings.baud);
    EXPECT_EQ(server.port().data_bits, settings.data_bits);
    EXPECT_EQ(server.port().parity, static_cast<std::uint8_t>(settings.parity));
    EXPECT_EQ(server.port().stop_bits, settings.stop_bits);
    EXPECT_EQ(server.port().flow, static_cast<std::uint8_t>(settings.flow));
    EXPECT_TRUE(server.port().dtr && server.port().rts);
    EXPECT_TRUE(server.take_purge());
    EXPECT_EQ(client.modem_lines().value_or(0) & 0xF0U, 0x30U);
  }
}

std::string answer_to(telnet::ComPortServer& server, const std::string& wire) {
  std::vector<std::byte> bytes;
  for (const char c : characters(wire)) bytes.push_back(static_cast<std::byte>(c));
  std::vector<std::byte> data(bytes.size());
  server.receive(bytes, data);
  std::string out;
  for (const std::byte byte : server.pending_out()) out += static_cast<char>(byte);
  server.mark_sent(server.pending_out().size());
  return out;
}

TEST(TelnetServer, AnswersAClientThatNeverSentWill) {
  telnet::ComPortServer server;
  server.begin();
  server.mark_sent(server.pending_out().size());
  EXPECT_EQ(answer_to(server, "FF FA 2C 02 07 FF F0"), characters("FF FA 2C 6B 00 FF F0 FF FA 2C 66 07 FF F0"));
  EXPECT_EQ(answer_to(server, "FF FC 2C FF FA 2C 02 08 FF F0"), "") << "one that said WONT gets nothing";
}

}  // namespace
}  // namespace dripfeed::wire
