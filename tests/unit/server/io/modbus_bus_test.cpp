// The register bus against a Modbus server of the library's own: what a failed call leaves is a closed
// connection, so that no late answer is taken for the next one's.
#include "server/io/modbus_bus.h"

#include <array>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <modbus.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/support/calling_bus.h"

namespace dripfeed::io {
namespace {

std::unique_ptr<app::RegisterBus> make_bus(const machine::LinkUrl& url) {
  return test::calling_bus(url, take_modbus_seat);
}

class ModbusServer {
 public:
  ModbusServer() : context_(modbus_new_tcp("127.0.0.1", 0)), mapping_(modbus_mapping_new(0, 0, 256, 0)) {
    listener_ = modbus_tcp_listen(context_, 4);
    thread_ = std::thread([this] { loop(); });
  }
  ModbusServer(const ModbusServer&) = delete;
  ModbusServer& operator=(const ModbusServer&) = delete;
  ~ModbusServer() {
    stopping_ = true;
    ::shutdown(listener_, SHUT_RDWR);  // wakes who accepts
    drop();
    thread_.join();
    ::close(listener_);
    modbus_mapping_free(mapping_);
    modbus_free(context_);
  }

  [[nodiscard]] std::uint16_t port() const {
    sockaddr_in address{};
    socklen_t length = sizeof(address);
    // The socket interface takes every address by this type.
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
    return ntohs(address.sin_port);
  }
  // The next request is answered only after so long / by closing the connection.
  void delay_next(std::chrono::milliseconds delay) { delay_ms_ = delay.count(); }
  void hang_up_next() { hang_up_ = true; }
  void drop() {
    const int client = client_.load();
    if (client >= 0) ::shutdown(client, SHUT_RDWR);
  }
  [[nodiscard]] int connections() const { return connections_; }
  [[nodiscard]] int requests() const { return requests_; }

 private:
  void loop() {
    while (!stopping_) {
      const int client = ::accept(listener_, nullptr, nullptr);
      if (client < 0) continue;
      ++connections_;
      client_ = client;
      modbus_set_socket(context_, client);
      serve();
      client_ = -1;
      ::close(client);
    }
  }
  void serve() {
    for (;;) {
      std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> query{};
      const int length = modbus_receive(context_, query.data());
      if (length <= 0) return;
      ++requests_;
      if (hang_up_.exchange(false)) return;
      const auto delay = delay_ms_.exchange(0);
      if (delay > 0) std::this_thread::sleep_for(std::chrono::milliseconds(delay));
      if (modbus_reply(context_, query.data(), length, mapping_) < 0) return;
    }
  }

  modbus_t* context_;
  modbus_mapping_t* mapping_;
  int listener_ = -1;
  std::atomic<int> client_{-1};
  std::atomic<bool> stopping_{false};
  std::atomic<bool> hang_up_{false};
  std::atomic<std::int64_t> delay_ms_{0};
  std::atomic<int> connections_{0};
  std::atomic<int> requests_{0};
  std::thread thread_;
};

class ModbusBusTest : public ::testing::Test {
 protected:
  ModbusBusTest() {
    auto url = machine::parse_link_url("modbus-tcp://127.0.0.1:502/1").value();
    url.port = server_.port();
    bus_ = make_bus(url);
  }
  bool write(std::uint16_t address, std::initializer_list<std::uint16_t> values) {
    const std::vector<std::uint16_t> registers(values);
    return bus_->write(address, registers).has_value();
  }
  std::optional<std::uint16_t> read(std::uint16_t address) {
    std::array<std::uint16_t, 1> value{};
    if (!bus_->read(address, value)) return std::nullopt;
    return value.front();
  }

  ModbusServer server_;
  std::unique_ptr<app::RegisterBus> bus_;
};

TEST_F(ModbusBusTest, ReadsWhatItWrote) {
  EXPECT_EQ(server_.connections(), 0) << "it connects with its first call";
  ASSERT_TRUE(write(5, {0x1234, 0xFFFF}));
  EXPECT_EQ(read(5), 0x1234);
  EXPECT_EQ(read(6), 0xFFFF);
  EXPECT_EQ(read(7), 0);
  const std::vector<std::uint16_t> most(121, 7);
  EXPECT_TRUE(bus_->write(0, most)) << "a whole mailbox";
  EXPECT_EQ(server_.connections(), 1);
}

TEST_F(ModbusBusTest, AFailedCallClosesTheConnectionAndTheNextOneOpensIt) {
  ASSERT_TRUE(write(5, {1}));
  server_.hang_up_next();
  const std::vector<std::uint16_t> registers = {2};
  const auto failed = bus_->write(5, registers);
  ASSERT_FALSE(failed);
  EXPECT_TRUE(failed.error().link_lost);
  EXPECT_NE(failed.error().text.find("modbus-tcp://127.0.0.1"), std::string::npos) << failed.error().text;
  EXPECT_EQ(server_.requests(), 2) << "a write whose effect is unknown is not repeated";
  EXPECT_EQ(read(5), 1);
  EXPECT_EQ(server_.connections(), 2);
}

TEST_F(ModbusBusTest, ALateAnswerIsNeverTakenForTheNextOnes) {
  ASSERT_TRUE(write(5, {55}));
  ASSERT_TRUE(write(6, {66}));
  server_.delay_next(std::chrono::milliseconds(1500));
  EXPECT_FALSE(read(5)) << "longer than it waits";
  std::optional<std::uint16_t> value;
  for (int i = 0; i < 20 && !value; ++i) value = read(6);
  EXPECT_EQ(value, 66);
}

TEST_F(ModbusBusTest, AnAddressThatIsNotThereFails) {
  EXPECT_FALSE(read(256));
  EXPECT_EQ(read(255), 0) << "the next call is a new one";
}

TEST_F(ModbusBusTest, WritesAndReadsInOneRequest) {
  std::array<std::uint16_t, 3> back{};
  const std::vector<std::uint16_t> registers = {11, 22, 33};
  const auto exchanged = bus_->exchange(20, registers, 20, back);
  ASSERT_TRUE(exchanged) << exchanged.error().text;
  EXPECT_TRUE(*exchanged);
  EXPECT_EQ(back, (std::array<std::uint16_t, 3>{11, 22, 33})) << "the read comes after the write";
  EXPECT_EQ(server_.requests(), 1);
}

TEST_F(ModbusBusTest, AnExceptionLeavesTheConnection) {
  const auto failed = bus_->write(255, std::vector<std::uint16_t>{1, 2});
  ASSERT_FALSE(failed);
  EXPECT_FALSE(failed.error().link_lost);
  EXPECT_TRUE(write(5, {1}));
  std::array<std::uint16_t, 2> beyond{};
  const auto only_written = bus_->exchange(7, std::vector<std::uint16_t>{77}, 255, beyond);
  ASSERT_TRUE(only_written) << "refused as one request, so it is written by another";
  EXPECT_FALSE(*only_written);
  EXPECT_EQ(read(7), 77);
  EXPECT_EQ(server_.connections(), 1);
}

// Two machines behind one gateway: one connection, and neither waits for more than one request of the other.
TEST_F(ModbusBusTest, UnitsAtOneAddressShareItInTurn) {
  auto url = machine::parse_link_url("modbus-tcp://127.0.0.1:502/2").value();
  url.port = server_.port();
  const auto other = make_bus(url);
  std::atomic<int> mine{0};
  std::atomic<int> theirs{0};
  const auto ask = [](app::RegisterBus& bus, std::atomic<int>& done) {
    std::array<std::uint16_t, 1> value{};
    for (int i = 0; i < 200; ++i) done += bus.read(0, value) ? 1 : 0;
  };
  std::thread second([&] { ask(*other, theirs); });
  ask(*bus_, mine);
  second.join();
  EXPECT_EQ(mine, 200);
  EXPECT_EQ(theirs, 200);
  EXPECT_EQ(server_.connections(), 1);
}

TEST(ModbusBus, ThereIsALimitOfConnections) {
  std::vector<std::unique_ptr<app::RegisterBus>> all;
  for (std::size_t i = 0; i < kMaxBuses; ++i)
    all.push_back(make_bus(machine::parse_link_url("modbus-rtu:/nowhere/" + std::to_string(i)).value()));
  std::array<std::uint16_t, 1> value{};
  const auto over = make_bus(machine::parse_link_url("modbus-rtu:/nowhere/more").value());
  const auto failed = over->read(0, value);
  ASSERT_FALSE(failed);
  EXPECT_NE(failed.error().text.find("16 register buses"), std::string::npos) << failed.error().text;
  const auto shared = make_bus(machine::parse_link_url("modbus-rtu:/nowhere/3?unit=9").value());
  EXPECT_EQ(shared->read(0, value).error().text.find("16 register buses"), std::string::npos) << "it is there already";
  const auto other_rate = make_bus(machine::parse_link_url("modbus-rtu:/nowhere/3?baud=9600").value());
  EXPECT_NE(other_rate->read(0, value).error().text.find("other settings"), std::string::npos);
  all.clear();
  EXPECT_EQ(make_bus(machine::parse_link_url("modbus-rtu:/nowhere/more").value())
                ->read(0, value)
                .error()
                .text.find("16 register buses"),
            std::string::npos);
}

// Two pseudo-terminals with a wire between them: the bus at one end, libmodbus's RTU server with two units at the
// other.
class RtuLine {
 public:
  RtuLine() {
    for (int& end : ends_) {
      end = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
      ::grantpt(end);
      ::unlockpt(end);
    }
    wire_ = std::thread([this] { carry(); });
    server_ = std::thread([this] { serve(); });
  }
  RtuLine(const RtuLine&) = delete;
  RtuLine& operator=(const RtuLine&) = delete;
  ~RtuLine() {
    stopping_ = true;
    server_.join();
    wire_.join();
    for (const int end : ends_) ::close(end);
  }
  [[nodiscard]] std::string host_end() const { return ::ptsname(ends_[0]); }

 private:
  void carry() {
    std::array<char, 256> buffer{};
    while (!stopping_) {
      std::array<pollfd, 2> files = {pollfd{ends_[0], POLLIN, 0}, pollfd{ends_[1], POLLIN, 0}};
      ::poll(files.data(), 2, 5);
      for (std::size_t i = 0; i < 2; ++i) {
        const ssize_t count = ::read(ends_[i], buffer.data(), buffer.size());
        if (count > 0) {
          EXPECT_EQ(::write(ends_[1 - i], buffer.data(), static_cast<std::size_t>(count)), count);
        }
        if (count < 0) std::this_thread::sleep_for(std::chrono::microseconds(200));  // no one has the other end open
      }
    }
  }
  void serve() {
    modbus_t* const context = modbus_new_rtu(::ptsname(ends_[1]), 19200, 'E', 8, 1);
    modbus_mapping_t* const mapping = modbus_mapping_new(0, 0, 16, 0);
    modbus_set_slave(context, 5);
    modbus_connect(context);
    modbus_set_indication_timeout(context, 0, 50'000);
    while (!stopping_) {
      std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> query{};
      const int length = modbus_receive(context, query.data());
      if (length > 0) modbus_reply(context, query.data(), length, mapping);
    }
    modbus_mapping_free(mapping);
    modbus_close(context);
    modbus_free(context);
  }

  std::array<int, 2> ends_{};
  std::atomic<bool> stopping_{false};
  std::thread wire_;
  std::thread server_;
};

TEST(ModbusBus, SpeaksRtuOnASerialLine) {
  const RtuLine line;
  const std::string url = "modbus-rtu:" + line.host_end() + "?baud=19200&framing=8E1&timeout_ms=300&unit=";
  const auto bus = make_bus(machine::parse_link_url(url + "5").value());
  const std::vector<std::uint16_t> registers = {1, 2, 3};
  std::array<std::uint16_t, 3> back{};
  std::expected<void, app::BusFailure> written;
  for (int i = 0; i < 20; ++i) {
    written = bus->write(2, registers);  // the server may not be up yet
    if (written) break;
  }
  ASSERT_TRUE(written) << written.error().text;
  ASSERT_TRUE(bus->read(2, back));
  EXPECT_EQ(back, (std::array<std::uint16_t, 3>{1, 2, 3}));
  const auto exchanged = bus->exchange(3, std::vector<std::uint16_t>{7}, 2, back);
  ASSERT_TRUE(exchanged);
  EXPECT_TRUE(*exchanged);
  EXPECT_EQ(back[1], 7);
  // No one has this number; the line is made again after the silence, and the other unit is as before.
  const auto nothing_there = make_bus(machine::parse_link_url(url + "6").value());
  EXPECT_FALSE(nothing_there->read(2, back));
  // libmodbus's server takes what follows a request for another for that one's answer, and passes it over.
  bool again = false;
  for (int i = 0; i < 10 && !again; ++i) again = bus->read(2, back).has_value();
  EXPECT_TRUE(again);
  EXPECT_EQ(back[1], 7);
}

TEST(ModbusBus, NoPeerIsAFailure) {
  std::uint16_t port = 0;
  {
    const ModbusServer gone;
    port = gone.port();
  }
  auto url = machine::parse_link_url("modbus-tcp://127.0.0.1:502/1").value();
  url.port = port;
  const auto bus = make_bus(url);
  std::array<std::uint16_t, 1> value{};
  const auto failed = bus->read(0, value);
  ASSERT_FALSE(failed);
  EXPECT_TRUE(failed.error().link_lost);
}

}  // namespace
}  // namespace dripfeed::io
