// A connection reads only when its answers are sent, so a client that never reads holds one buffer and no one up.
#include "server/io/modbus_listener.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>

#include "protocol/modbus/mbap.h"

namespace dripfeed::io {

namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;
using boost::system::error_code;

modbus::Time now() { return std::chrono::steady_clock::now().time_since_epoch(); }

class Connection final : public PeerConnection, public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, modbus::RegisterView& view)
      : socket_(std::move(socket)), timer_(socket_.get_executor()), protocol_(view, now()) {}
  void begin() override {
    read();
    watch();
  }
  void close() override {
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
  asio::steady_timer timer_;
  modbus::MbapConnection protocol_;
  std::array<std::byte, modbus::kMaxAdu> buffer_{};
  std::span<const std::byte> held_;
};

}  // namespace

std::expected<std::unique_ptr<PeerListener>, std::string> listen_modbus(const PeerSettings& settings,
                                                                        modbus::RegisterView& view) {
  return PeerListener::listen(settings, "Modbus", [&view](tcp::socket socket) {
    return std::make_shared<Connection>(std::move(socket), view);
  });
}

}  // namespace dripfeed::io
