// One io_context and thread: a PLC that polls asks little. A connection reads only when its answers are sent, so a
// client that never reads holds one buffer and no one up.
#include "server/io/modbus_listener.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <list>
#include <thread>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>

#include "protocol/modbus/mbap.h"

namespace dripfeed::io {

namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kAcceptAgain{100};

modbus::Time now() { return std::chrono::steady_clock::now().time_since_epoch(); }

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, asio::ip::address peer, modbus::RegisterView& view)
      : socket_(std::move(socket)), peer_(std::move(peer)), timer_(socket_.get_executor()), protocol_(view, now()) {
    error_code ignored;  // an answer goes a little later then
    socket_.set_option(tcp::no_delay(true), ignored);
  }
  [[nodiscard]] const asio::ip::address& peer() const { return peer_; }
  void begin() {
    read();
    watch();
  }
  void close() {
    error_code ignored;  // it is going away
    timer_.cancel();
    socket_.close(ignored);
  }

 private:
  void read() {
    socket_.async_read_some(asio::buffer(buffer_), [self = shared_from_this()](error_code error, std::size_t count) {
      if (error) return self->close();
      self->held_ = std::span<const std::byte>(self->buffer_).first(count);
      self->work();
    });
  }

  // Takes what is held, sends what that gave, and again until all is taken.
  void work() {
    held_ = held_.subspan(protocol_.receive(held_, now()));
    if (protocol_.pending_out().empty()) {
      if (protocol_.ended() != modbus::MbapEnd::none) return close();
      return held_.empty() ? read() : work();
    }
    const std::span<const std::byte> out = protocol_.pending_out();
    asio::async_write(socket_, asio::buffer(out.data(), out.size()),
                      [self = shared_from_this()](error_code error, std::size_t count) {
                        if (error) return self->close();
                        self->protocol_.mark_sent(count);
                        self->work();
                      });
  }

  // Looks at the deadline when it may have passed; each request moves it on.
  void watch() {
    const modbus::Time left = std::min<modbus::Time>(protocol_.deadline() - now(), modbus::kRequestAtMost);
    timer_.expires_after(std::max<modbus::Time>(left, std::chrono::milliseconds(1)));
    timer_.async_wait([self = shared_from_this()](error_code error) {
      if (error || !self->socket_.is_open()) return;
      self->protocol_.tick(now());
      if (self->protocol_.ended() != modbus::MbapEnd::none) return self->close();
      self->watch();
    });
  }

  tcp::socket socket_;
  asio::ip::address peer_;
  asio::steady_timer timer_;
  modbus::MbapConnection protocol_;
  std::array<std::byte, modbus::kMaxAdu> buffer_{};
  std::span<const std::byte> held_;
};

// Who may connect at this address. Modbus has no rights of its own, so beyond loopback they must be named.
std::expected<std::vector<asio::ip::address>, std::string> allowed_at(const asio::ip::address& address,
                                                                      const std::vector<std::string>& named) {
  std::vector<asio::ip::address> allowed;
  for (const std::string& text : named) {
    error_code bad;
    allowed.push_back(asio::ip::make_address(text, bad));
    if (bad) return std::unexpected(fmt::format("\"{}\" is not an IP address", text));
  }
  if (allowed.empty() && !address.is_loopback()) {
    return std::unexpected(fmt::format("{} is not loopback, and Modbus has no rights: state which addresses may read",
                                       address.to_string()));
  }
  return allowed;
}

class AsioListener final : public ModbusListener {
 public:
  AsioListener(modbus::RegisterView& view, std::vector<asio::ip::address> allowed)
      : view_(view), allowed_(std::move(allowed)), acceptor_(context_), again_(context_) {}
  ~AsioListener() override {
    asio::post(context_, [this] {
      error_code ignored;  // the acceptor is going away
      acceptor_.close(ignored);
      again_.cancel();
      for (const auto& weak : connections_) {
        if (const auto connection = weak.lock()) connection->close();
      }
    });
    if (thread_.joinable()) thread_.join();
  }

  // Throws boost::system::system_error; listen_modbus() is the fence.
  void listen(const tcp::endpoint& endpoint) {
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
    port_ = acceptor_.local_endpoint().port();
    address_ = endpoint.address();
    accept_next();
    thread_ = std::jthread([this] { run(); });
  }

  [[nodiscard]] std::uint16_t port() const override { return port_; }
  [[nodiscard]] std::uint64_t refused() const override { return refused_.load(); }
  std::expected<void, std::string> set_allowed(const std::vector<std::string>& allowed) override {
    auto addresses = allowed_at(address_, allowed);
    if (!addresses) return std::unexpected(std::move(addresses.error()));
    asio::post(context_, [this, known = std::move(*addresses)]() mutable {
      allowed_ = std::move(known);
      for (const auto& weak : connections_) {
        const auto connection = weak.lock();
        if (connection && !may_connect(connection->peer())) connection->close();
      }
    });
    return {};
  }

 private:
  // The fence of the thread: what one connection throws is reported, and the others are served on.
  void run() {
    ::prctl(PR_SET_NAME, "Modbus server");
    for (bool over = false; !over;) {
      try {
        context_.run();
        over = true;
      } catch (const std::exception& error) {
        spdlog::critical("the Modbus server: {}", error.what());
      }
    }
  }

  void accept_next() {
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      if (!acceptor_.is_open()) return;
      if (error) return accept_later();
      take(std::move(socket));
      accept_next();
    });
  }

  // A socket that is not kept is closed by its end.
  void take(tcp::socket socket) {
    std::erase_if(connections_, [](const auto& connection) { return connection.expired(); });
    error_code error;
    const tcp::endpoint peer = socket.remote_endpoint(error);
    if (error || !may_connect(peer.address()) || connections_.size() >= kMaxConnections) {
      refused_.fetch_add(1);
      return;
    }
    const auto connection = std::make_shared<Connection>(std::move(socket), peer.address(), view_);
    connections_.push_back(connection);
    connection->begin();
  }

  [[nodiscard]] bool may_connect(const asio::ip::address& peer) const {
    return allowed_.empty() || std::ranges::find(allowed_, peer) != allowed_.end();
  }

  // The system has no file descriptor left, or the peer went away meanwhile.
  void accept_later() {
    again_.expires_after(kAcceptAgain);
    again_.async_wait([this](error_code error) {
      if (!error && acceptor_.is_open()) accept_next();
    });
  }

  modbus::RegisterView& view_;
  std::vector<asio::ip::address> allowed_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  asio::steady_timer again_;
  std::list<std::weak_ptr<Connection>> connections_;
  std::atomic<std::uint64_t> refused_{0};
  std::uint16_t port_ = 0;
  asio::ip::address address_;
  std::jthread thread_;
};

}  // namespace

std::expected<std::unique_ptr<ModbusListener>, std::string> listen_modbus(const ModbusListenSettings& settings,
                                                                          modbus::RegisterView& view) {
  error_code bad;
  const asio::ip::address address = asio::ip::make_address(settings.host, bad);
  if (bad) return std::unexpected(fmt::format("\"{}\" is not an IP address", settings.host));
  auto allowed = allowed_at(address, settings.allowed);
  if (!allowed) return std::unexpected(std::move(allowed.error()));
  auto listener = std::make_unique<AsioListener>(view, std::move(*allowed));
  try {
    listener->listen({address, settings.port});
  } catch (const boost::system::system_error& error) {
    return std::unexpected(
        fmt::format("cannot listen on {}:{}: {}", settings.host, settings.port, error.code().message()));
  }
  return listener;
}

}  // namespace dripfeed::io
