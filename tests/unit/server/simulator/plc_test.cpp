// The simulated PLC on a loopback socket: what is written twice is appended once, and a client that says half a word
// holds up no one.
#include "server/simulator/plc.h"

#include <array>
#include <chrono>
#include <functional>
#include <thread>

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "protocol/modbus/modbus.h"
#include "server/io/io.h"
#include "tests/support/calling_bus.h"
#include "tests/support/temp_folder.h"

namespace dripfeed::simulator {
namespace {

using namespace std::chrono_literals;
using modbus::MailboxCommand;

class PlcTest : public ::testing::Test {
 protected:
  void start(const PlcSettings& settings = {}) {
    auto url = machine::parse_link_url("modbus-tcp://127.0.0.1:1502/1").value();
    url.port = 0;
    auto started = Plc::start(url, settings);
    ASSERT_TRUE(started) << started.error();
    plc_ = std::move(*started);
    url.port = plc_->port();
    bus_ = test::calling_bus(url, io::take_modbus_seat);
  }
  bool write(MailboxCommand command, std::uint16_t seq, std::string_view text = {}, std::uint32_t offset = 0,
             std::uint32_t session = 5) {
    modbus::Mailbox mailbox{};
    const std::size_t used = modbus::encode({.session = session,
                                             .command = command,
                                             .seq = seq,
                                             .offset = offset,
                                             .payload = std::as_bytes(std::span(text))},
                                            mailbox);
    return bus_->write(app::kMailboxAddress, std::span<const std::uint16_t>(mailbox).first(used)).has_value();
  }
  modbus::Status status() {
    modbus::StatusImage image{};
    EXPECT_TRUE(bus_->read(app::kStatusAddress, image));
    return modbus::decode_status(image).value();
  }
  std::expected<modbus::MachineWords, modbus::MachineFault> words() {
    std::array<std::uint16_t, modbus::kStatusAndMachine> image{};
    EXPECT_TRUE(bus_->read(app::kStatusAddress, image));
    return modbus::decode_machine(std::span<const std::uint16_t>(image).subspan(modbus::kStatusRegisters));
  }
  bool until(const std::function<bool()>& condition) {
    for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(5ms);
    return condition();
  }
  // A client that speaks in bytes.
  int connect_raw() {
    const int client = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(plc_->port());
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    return client;
  }
  static void send(int client, std::string_view bytes) {
    EXPECT_EQ(::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
  }

  std::unique_ptr<Plc> plc_;
  std::unique_ptr<app::RegisterBus> bus_;
};

TEST_F(PlcTest, AppendsEachBlockOnceAndRunsWhatIsWhole) {
  start();
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(write(MailboxCommand::data, 1, "G0X1.\nG0X"));
  ASSERT_TRUE(write(MailboxCommand::open, 1)) << "the session again changes nothing";
  EXPECT_EQ(status().appended, 9U);
  ASSERT_TRUE(until([&] { return plc_->report().blocks_run == 1; })) << "half a block waits";
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(write(MailboxCommand::data, 2, "2.\nM30\n", 9));
  ASSERT_TRUE(write(MailboxCommand::data, 4, "never", 16)) << "a gap is refused";
  EXPECT_EQ(status().nak, modbus::Nak::sequence);
  ASSERT_TRUE(write(MailboxCommand::eof, 3, {}, 16));
  ASSERT_TRUE(until([&] { return plc_->report().complete; }));
  EXPECT_EQ(plc_->report().text, "G0X1.\nG0X2.\nM30\n");
  EXPECT_EQ(plc_->report().blocks_run, 3U);
  EXPECT_EQ(status().state, modbus::ReceiverState::done);
}

TEST_F(PlcTest, AWriteBringsTheStatusThatStandsAfterIt) {
  start();
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  const std::string_view text = "G0X1.\n";
  modbus::Mailbox mailbox{};
  const std::size_t used = modbus::encode(
      {.session = 5, .command = MailboxCommand::data, .seq = 1, .offset = 0, .payload = std::as_bytes(std::span(text))},
      mailbox);
  for (int i = 0; i < 3; ++i) {
    modbus::StatusImage image{};
    const auto exchanged = bus_->exchange(app::kMailboxAddress, std::span<const std::uint16_t>(mailbox).first(used),
                                          app::kStatusAddress, image);
    ASSERT_TRUE(exchanged) << exchanged.error().text;
    ASSERT_TRUE(*exchanged);
    EXPECT_EQ(modbus::decode_status(image)->ack_seq, 1);
    EXPECT_EQ(modbus::decode_status(image)->appended, text.size()) << "once, however often it is written";
  }
  EXPECT_EQ(plc_->report().text, text);
}

TEST_F(PlcTest, ANewSessionBeginsWithNothing) {
  start();
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  ASSERT_TRUE(write(MailboxCommand::data, 1, "G0X1.\n"));
  ASSERT_TRUE(write(MailboxCommand::open, 1, {}, 0, 6));
  EXPECT_EQ(plc_->report().text, "");
  ASSERT_TRUE(write(MailboxCommand::data, 1, "old\n", 0, 5));
  EXPECT_EQ(status().appended, 0U) << "a late message of the session before";
}

TEST_F(PlcTest, CreditKeepsTheBufferFromRunningOver) {
  PlcSettings small;
  small.buffer_bytes = 3 * modbus::kMaxPayload;
  start(small);
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  EXPECT_EQ(status().free_blocks, 3U);
  const std::string slow = "G4P100000\n" + std::string(modbus::kMaxPayload - 11, 'X') + "\n";
  std::uint32_t offset = 0;
  for (std::uint16_t seq = 1; seq <= 4; ++seq, offset += static_cast<std::uint32_t>(slow.size()))
    ASSERT_TRUE(write(MailboxCommand::data, seq, slow, offset));
  EXPECT_EQ(status().nak, modbus::Nak::full);
  EXPECT_LE(status().appended, 3 * modbus::kMaxPayload + 10);
}

TEST_F(PlcTest, HalfARequestHoldsUpNoOne) {
  start();
  const int half = connect_raw();
  send(half, std::string_view("\0\1\0\0\0\6\1", 7));
  std::this_thread::sleep_for(50ms);
  const auto before = std::chrono::steady_clock::now();
  for (int i = 0; i < 20; ++i) static_cast<void>(plc_->report());
  EXPECT_LT(std::chrono::steady_clock::now() - before, 400ms) << "each would have waited for the rest of it";
  EXPECT_EQ(plc_->report().requests, 0U);
  ASSERT_TRUE(write(MailboxCommand::open, 1)) << "a client more";
  EXPECT_EQ(status().state, modbus::ReceiverState::ready);
  ::close(half);
}

TEST_F(PlcTest, ARequestInPiecesAndTwoInOnePieceAreAnswered) {
  start();
  const int client = connect_raw();
  const std::string read("\0\1\0\0\0\6\1\3\0\x80\0\1", 12);
  for (const char byte : read) {
    send(client, std::string_view(&byte, 1));
    std::this_thread::sleep_for(2ms);
  }
  std::array<char, 64> answer{};
  EXPECT_EQ(::recv(client, answer.data(), 11, MSG_WAITALL), 11);
  EXPECT_EQ(std::string_view(answer.data(), 11), std::string_view("\0\1\0\0\0\5\1\3\2\xDF\1", 11));
  send(client, read + read);
  EXPECT_EQ(::recv(client, answer.data(), 22, MSG_WAITALL), 22);
  EXPECT_EQ(plc_->report().requests, 3U);
  ::close(client);
}

TEST_F(PlcTest, AStreamThatIsOutOfStepIsDropped) {
  start();
  // Lengths that cannot be, and a write whose data is not as long as it says.
  const std::string_view wrong[] = {{"\0\1\0\0\0\1\1\3\0\0\0\1", 12},
                                    {"\0\1\0\0\xFF\xFF\1\3\0\0\0\1", 12},
                                    {"\0\1\0\0\0\7\1\x10\0\0\0\1\xF6", 13},
                                    {"\0\1\0\0\0\6\1\x10\0\0\0\1", 12}};
  for (const std::string_view bytes : wrong) {
    const int client = connect_raw();
    send(client, bytes);
    char byte = 0;
    EXPECT_LE(::recv(client, &byte, 1, 0), 0) << "closed, not answered";
    ::close(client);
  }
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  EXPECT_EQ(status().state, modbus::ReceiverState::ready);
}

TEST_F(PlcTest, ThePanelShowsInTheMachinesWords) {
  start();
  EXPECT_EQ(words().value().state, modbus::MachineState::idle);
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  ASSERT_TRUE(write(MailboxCommand::data, 1, "%\nO0042\nG4P100000\nM30\n%\n"));
  ASSERT_TRUE(until([&] { return words().value().line == 3; }));
  EXPECT_EQ(words().value().state, modbus::MachineState::running);
  EXPECT_EQ(words().value().program, 42U);
  const std::vector<std::uint16_t> panel = {4, 1, 2, 1, 0, 77, 5};
  ASSERT_TRUE(bus_->write(kPanelAddress, panel));
  EXPECT_EQ(words().value(), (modbus::MachineWords{.state = modbus::MachineState::alarm,
                                                   .program = 42,
                                                   .line = 3,
                                                   .alarm = 65'538,
                                                   .bell = 5,
                                                   .request = 1,
                                                   .requested = 77}));
}

TEST_F(PlcTest, AHeldMachineRunsNothing) {
  start();
  ASSERT_TRUE(bus_->write(kPanelAddress, std::vector<std::uint16_t>{3}));
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  ASSERT_TRUE(write(MailboxCommand::data, 1, "M5\nM5\n"));
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(plc_->report().blocks_run, 0U);
  ASSERT_TRUE(bus_->write(kPanelAddress, std::vector<std::uint16_t>{0}));
  EXPECT_TRUE(until([&] { return plc_->report().blocks_run == 2; }));
}

TEST_F(PlcTest, OfTheMapWithoutWordsRefusesALongerRead) {
  PlcSettings old;
  old.has_words = false;
  start(old);
  std::array<std::uint16_t, modbus::kStatusAndMachine> image{};
  const auto all = bus_->read(app::kStatusAddress, image);
  ASSERT_FALSE(all);
  EXPECT_FALSE(all.error().link_lost) << "an exception";
  EXPECT_EQ(status().state, modbus::ReceiverState::idle);
}

TEST_F(PlcTest, ARestartKeepsTheTextAndCountsTheBoot) {
  PlcSettings settings;
  settings.faults = {{FaultKind::plc_restart, 4}};
  start(settings);
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  ASSERT_TRUE(write(MailboxCommand::data, 1, "G0X1.\n"));
  ASSERT_TRUE(bus_->write(app::kAnswerAddress, std::vector<std::uint16_t>{1}));
  std::array<std::uint16_t, 1> answer{};
  for (int i = 0; i < 3 && !bus_->read(app::kAnswerAddress, answer); ++i) continue;
  EXPECT_EQ(answer[0], 0);
  EXPECT_EQ(status().boot_counter, 2);
  EXPECT_EQ(status().appended, 6U);
}

class RtuPlcTest : public PlcTest {
 protected:
  void start_rtu(const PlcSettings& settings = {}, const std::string& more = "&timeout_ms=100") {
    const std::string path = folder_.file("plc");
    const auto url = [&](int unit) {
      return machine::parse_link_url("modbus-rtu:" + path + "?unit=" + std::to_string(unit) + more).value();
    };
    auto started = Plc::start(url(5), settings);
    ASSERT_TRUE(started) << started.error();
    plc_ = std::move(*started);
    bus_ = test::calling_bus(url(5), io::take_modbus_seat);
    other_ = test::calling_bus(url(6), io::take_modbus_seat);
  }

  test::TempFolder folder_;
  std::unique_ptr<app::RegisterBus> other_;
};

TEST_F(RtuPlcTest, AnswersForItsUnitAlone) {
  start_rtu();
  ASSERT_TRUE(write(MailboxCommand::open, 1));
  std::array<std::uint16_t, 1> value{};
  EXPECT_FALSE(other_->read(app::kStatusAddress, value));
  ASSERT_TRUE(write(MailboxCommand::data, 1, "G0X1.\n"));
  EXPECT_EQ(status().appended, 6U);
  EXPECT_EQ(plc_->report().requests, 3U);
}

TEST_F(RtuPlcTest, WhatFailsIsNeverTakenForAnAnswer) {
  for (const FaultKind kind :
       {FaultKind::plc_lose, FaultKind::plc_silent, FaultKind::plc_busy, FaultKind::plc_damage}) {
    PlcSettings settings;
    settings.faults = {{kind, 2}};
    start_rtu(settings);
    EXPECT_TRUE(write(MailboxCommand::open, 1)) << name_of(kind);
    EXPECT_FALSE(write(MailboxCommand::data, 1, "G0X1.\n")) << name_of(kind);
    const bool taken = kind == FaultKind::plc_silent || kind == FaultKind::plc_damage;
    EXPECT_EQ(status().appended, taken ? 6U : 0U) << name_of(kind);
    bus_.reset();
    other_.reset();
    plc_.reset();
  }
}

TEST_F(RtuPlcTest, ADamagedRequestIsPassedOver) {
  start_rtu();
  const int line = ::open(folder_.file("plc").c_str(), O_RDWR | O_NOCTTY);
  ASSERT_GE(line, 0);
  EXPECT_EQ(::write(line, "\x05\x03\0\x80\0\1\1\1", 8), 8);
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(plc_->report().requests, 0U);
  ::close(line);
  EXPECT_EQ(status().state, modbus::ReceiverState::idle) << "the next one counts";
}

}  // namespace
}  // namespace dripfeed::simulator
