// The register bus against a Modbus server of the library's own: what a failed call leaves behind is a closed
// connection, so that no late answer is taken for the next one's.
#include "server/io/modbus_bus.h"

#include <array>
#include <atomic>
#include <thread>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <modbus.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace dripfeed::io {
namespace {

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
    bus_ = make_modbus_bus(url);
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

TEST(ModbusBus, NobodyThereIsAFailure) {
  std::uint16_t port = 0;
  {
    const ModbusServer gone;
    port = gone.port();
  }
  auto url = machine::parse_link_url("modbus-tcp://127.0.0.1:502/1").value();
  url.port = port;
  const auto bus = make_modbus_bus(url);
  std::array<std::uint16_t, 1> value{};
  const auto failed = bus->read(0, value);
  ASSERT_FALSE(failed);
  EXPECT_TRUE(failed.error().link_lost);
}

}  // namespace
}  // namespace dripfeed::io
