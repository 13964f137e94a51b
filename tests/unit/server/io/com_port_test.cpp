// rfc2217:// against a device server of the test's own: the line is set before anything passes, eight bits pass both
// directions, modem lines and line errors are reported, a server that sets something else is not used.
#include <array>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "protocol/telnet/telnet.h"
#include "tests/unit/server/io/listening.h"

namespace dripfeed::io {
namespace {

using namespace test;

// One connection, served by one thread; what it is ordered to do happens between two looks at the socket.
class DeviceServer {
 public:
  explicit DeviceServer(std::string first_words = "") : first_words_(std::move(first_words)) {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    // The socket interface takes every address by this type.
    EXPECT_EQ(::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    EXPECT_EQ(::listen(listener_, 1), 0);
    socklen_t length = sizeof(address);
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
    port_ = ntohs(address.sin_port);
    thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
  }
  DeviceServer(const DeviceServer&) = delete;
  DeviceServer& operator=(const DeviceServer&) = delete;
  ~DeviceServer() {
    thread_.request_stop();
    thread_.join();
    ::close(listener_);
  }

  [[nodiscard]] std::string url(const std::string& options = "") const {
    return "rfc2217://127.0.0.1:" + std::to_string(port_) + options;
  }
  void act(std::function<void(telnet::ComPortServer&)> action) {
    const std::lock_guard lock(mutex_);
    actions_.push_back(std::move(action));
  }
  telnet::PortState port() {
    const std::lock_guard lock(mutex_);
    return server_.port();
  }
  bool await_data(const std::string& text) {
    const auto until = std::chrono::steady_clock::now() + kLongest;
    while (std::chrono::steady_clock::now() < until) {
      {
        const std::lock_guard lock(mutex_);
        if (data_ == text) return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }

 private:
  void serve(const std::stop_token& stop) {
    const int peer = accept(stop);
    if (peer < 0) return;
    if (!first_words_.empty()) {
      EXPECT_EQ(::send(peer, first_words_.data(), first_words_.size(), MSG_NOSIGNAL),
                static_cast<ssize_t>(first_words_.size()));
      ::shutdown(peer, SHUT_WR);
      std::array<std::byte, 256> wire{};
      while (::recv(peer, wire.data(), wire.size(), 0) > 0) {  // unread bytes would turn the close into a reset
      }
      ::close(peer);
      return;
    }
    {
      const std::lock_guard lock(mutex_);
      server_.begin();
    }
    while (!stop.stop_requested() && look(peer)) {
    }
    ::close(peer);
  }
  int accept(const std::stop_token& stop) const {
    while (!stop.stop_requested()) {
      pollfd file{.fd = listener_, .events = POLLIN, .revents = 0};
      if (::poll(&file, 1, 5) == 1) return ::accept(listener_, nullptr, nullptr);
    }
    return -1;
  }
  bool look(int peer) {
    pollfd file{.fd = peer, .events = POLLIN, .revents = 0};
    const bool came = ::poll(&file, 1, 2) == 1;
    const std::lock_guard lock(mutex_);
    if (came) {
      std::array<std::byte, 256> wire{};
      std::array<std::byte, 256> data{};
      const ssize_t count = ::recv(peer, wire.data(), wire.size(), 0);
      if (count <= 0) return false;
      const std::size_t got = server_.receive(std::span(wire).first(static_cast<std::size_t>(count)), data);
      for (std::size_t i = 0; i < got; ++i) data_ += static_cast<char>(data[i]);
    }
    for (const auto& action : std::exchange(actions_, {})) action(server_);
    const auto out = server_.pending_out();
    if (!out.empty() && ::send(peer, out.data(), out.size(), MSG_NOSIGNAL) > 0) server_.mark_sent(out.size());
    return true;
  }

  std::string first_words_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::mutex mutex_;
  telnet::ComPortServer server_;
  std::vector<std::function<void(telnet::ComPortServer&)>> actions_;
  std::string data_;
  std::jthread thread_;
};

TEST_F(LinkTest, ComPortIsSetBeforeItCarries) {
  DeviceServer server;
  ASSERT_EQ(open(server.url()), "");
  ASSERT_TRUE(heard_.await_ups(1));
  const telnet::PortState port = server.port();
  EXPECT_EQ(port.baud, 9600U);
  EXPECT_EQ(port.data_bits, 8);  // 7E2 with the parity made in software
  EXPECT_EQ(port.parity, 1);
  EXPECT_EQ(port.stop_bits, 2);
  EXPECT_TRUE(port.dtr && port.rts);

  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  EXPECT_EQ(write(all), 256U);
  EXPECT_TRUE(server.await_data(all));
  server.act([&](telnet::ComPortServer& s) { EXPECT_EQ(s.send(bytes_of(all)), 256U); });
  ASSERT_TRUE(heard_.await_received(256));
  EXPECT_EQ(heard_.received(), all);
}

TEST_F(LinkTest, ComPortReportsLinesAndErrors) {
  DeviceServer server;
  ASSERT_EQ(open(server.url()), "");
  ASSERT_TRUE(heard_.await_ups(1));
  server.act([](telnet::ComPortServer& s) { s.set_modem_lines(telnet::modem::kCts | telnet::modem::kDsr); });
  ASSERT_TRUE(heard_.await_lines("cts on"));
  EXPECT_TRUE(heard_.await_lines("dsr on"));
  server.act([](telnet::ComPortServer& s) {
    s.set_modem_lines(telnet::modem::kDsr);
    s.notify_line(telnet::line::kOverrun | telnet::line::kParity);
  });
  ASSERT_TRUE(heard_.await_lines("cts off"));
  app::LineErrors errors;
  for (int i = 0; i < 3000 && errors.overrun == 0; ++i) {
    thread_->run([&] { errors = link_->errors(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(errors, (app::LineErrors{.parity = 1, .framing = 0, .overrun = 1, .breaks = 0}));
}

TEST_F(LinkTest, ComPortHoldsTheControlByItsRts) {
  DeviceServer server;
  ASSERT_EQ(open(server.url()), "");
  ASSERT_TRUE(heard_.await_ups(1));
  for (const bool on : {false, true}) {
    thread_->run([&] { EXPECT_TRUE(link_->set_rts(on)); });
    for (int i = 0; i < 3000 && server.port().rts != on; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(server.port().rts, on);
  }
}

TEST_F(LinkTest, ComPortWaitsWhileTheServerSuspends) {
  DeviceServer server;
  ASSERT_EQ(open(server.url()), "");
  ASSERT_TRUE(heard_.await_ups(1));
  server.act([](telnet::ComPortServer& s) {
    s.ask_suspend(true);
    const std::array<std::byte, 1> marker = {std::byte{'!'}};
    EXPECT_EQ(s.send(marker), 0U);  // what was asked waits in the output
  });
  server.act([](telnet::ComPortServer& s) { s.set_modem_lines(telnet::modem::kCts); });
  ASSERT_TRUE(heard_.await_lines("cts on"));
  EXPECT_EQ(write("A"), 0U);
  const int before = heard_.writables();
  server.act([](telnet::ComPortServer& s) { s.ask_suspend(false); });
  ASSERT_TRUE(heard_.await_writables(before + 1));
  EXPECT_EQ(write("A"), 1U);
  EXPECT_TRUE(server.await_data("A"));
}

TEST_F(LinkTest, ComPortPassesOnWhyTheServerHangsUp) {
  DeviceServer server("Port already in use\r\n");
  ASSERT_EQ(open(server.url()), "");
  ASSERT_TRUE(heard_.await_losses(1));
  EXPECT_EQ(heard_.reason(), "the other side closed the line (the device server reports: Port already in use)");
  EXPECT_EQ(heard_.ups(), 0);
  EXPECT_EQ(heard_.received(), "");
}

}  // namespace
}  // namespace dripfeed::io
