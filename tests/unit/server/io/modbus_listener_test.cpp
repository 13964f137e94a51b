// The Modbus server on a real socket against libmodbus's client: who may read, what is refused, and what a client that
// says half a request meets.
#include "server/io/modbus_listener.h"

#include <array>
#include <chrono>
#include <memory>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <modbus.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace dripfeed::io {
namespace {

class View final : public modbus::RegisterView {
 public:
  bool has_unit(std::uint8_t unit) override { return unit == 3; }
  bool read(std::uint8_t, std::uint16_t first, std::span<std::uint16_t> into) override {
    if (first + into.size() > 40) return false;
    for (std::size_t i = 0; i < into.size(); ++i) into[i] = static_cast<std::uint16_t>(500 + first + i);
    return true;
  }
};

struct FreeContext {
  void operator()(modbus_t* context) const {
    modbus_close(context);
    modbus_free(context);
  }
};
using Client = std::unique_ptr<modbus_t, FreeContext>;

Client client_of(std::uint16_t port, int unit) {
  Client client(modbus_new_tcp("127.0.0.1", port));
  modbus_set_slave(client.get(), unit);
  EXPECT_EQ(modbus_connect(client.get()), 0);
  return client;
}

class ModbusListenerTest : public ::testing::Test {
 protected:
  void listen(std::vector<std::string> allowed) {
    auto listener = listen_modbus({.host = "127.0.0.1", .port = 0, .allowed = std::move(allowed)}, view_);
    ASSERT_TRUE(listener) << listener.error();
    listener_ = std::move(*listener);
  }
  View view_;
  std::unique_ptr<PeerListener> listener_;
};

TEST_F(ModbusListenerTest, AClientReadsAndIsRefusedAWrite) {
  listen({});
  const Client client = client_of(listener_->port(), 3);
  std::array<std::uint16_t, 40> registers{};
  ASSERT_EQ(modbus_read_registers(client.get(), 0, 40, registers.data()), 40);
  EXPECT_EQ(registers[39], 539);
  ASSERT_EQ(modbus_read_input_registers(client.get(), 7, 2, registers.data()), 2);
  EXPECT_EQ(registers[0], 507);
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(modbus_write_register(client.get(), 0, 1), -1);
  EXPECT_EQ(errno, EMBXILFUN);
  EXPECT_EQ(modbus_write_registers(client.get(), 0, 2, registers.data()), -1);
  EXPECT_EQ(errno, EMBXILFUN);
  EXPECT_EQ(modbus_read_registers(client.get(), 39, 2, registers.data()), -1);
  EXPECT_EQ(errno, EMBXILADD);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(2)) << "an exception waits for nothing";
  modbus_set_slave(client.get(), 4);
  EXPECT_EQ(modbus_read_registers(client.get(), 0, 1, registers.data()), -1);
  EXPECT_EQ(errno, EMBXGTAR);
  modbus_set_slave(client.get(), 3);
  EXPECT_EQ(modbus_read_registers(client.get(), 0, 1, registers.data()), 1);
}

TEST_F(ModbusListenerTest, WhoIsNotOnTheListIsLetGo) {
  listen({"192.0.2.1"});
  const Client client = client_of(listener_->port(), 3);
  std::uint16_t value = 0;
  EXPECT_EQ(modbus_read_registers(client.get(), 0, 1, &value), -1);
  EXPECT_EQ(listener_->refused(), 1U);
}

TEST_F(ModbusListenerTest, HalfARequestIsLetGoAndHoldsNoOneUp) {
  listen({"127.0.0.1"});
  const Client half = client_of(listener_->port(), 3);
  const int socket = modbus_get_socket(half.get());
  ASSERT_EQ(::send(socket, "\0\1\0\0\0", 5, 0), 5);
  const Client other = client_of(listener_->port(), 3);
  std::uint16_t value = 0;
  EXPECT_EQ(modbus_read_registers(other.get(), 0, 1, &value), 1);
  pollfd closed{socket, POLLIN, 0};
  ASSERT_EQ(::poll(&closed, 1, 10'000), 1);
  char none = 0;
  EXPECT_EQ(::recv(socket, &none, 1, 0), 0) << "closed";
  EXPECT_EQ(modbus_read_registers(other.get(), 0, 1, &value), 1);
}

TEST_F(ModbusListenerTest, ManyClientsAtOnce) {
  listen({});
  std::vector<Client> clients;
  for (std::size_t i = 0; i < PeerListener::kMaxConnections; ++i) clients.push_back(client_of(listener_->port(), 3));
  std::uint16_t value = 0;
  for (const Client& client : clients) EXPECT_EQ(modbus_read_registers(client.get(), 1, 1, &value), 1);
  const Client beyond = client_of(listener_->port(), 3);
  EXPECT_EQ(modbus_read_registers(beyond.get(), 1, 1, &value), -1);
  EXPECT_EQ(listener_->refused(), 1U);
}

TEST_F(ModbusListenerTest, BeyondLoopbackNeedsAList) {
  const auto open = listen_modbus({.host = "0.0.0.0", .port = 0, .allowed = {}}, view_);
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().find("which addresses"), std::string::npos);
  EXPECT_TRUE(listen_modbus({.host = "0.0.0.0", .port = 0, .allowed = {"127.0.0.1"}}, view_));
  EXPECT_FALSE(listen_modbus({.host = "plc", .port = 0, .allowed = {}}, view_));
  EXPECT_FALSE(listen_modbus({.host = "127.0.0.1", .port = 0, .allowed = {"plc"}}, view_));
}

}  // namespace
}  // namespace dripfeed::io
