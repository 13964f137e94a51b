// A few clients at a time, as small PLCs have it: one more takes the place of the oldest.
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <vector>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "server/simulator/plc_port.h"

namespace dripfeed::simulator {

namespace {

// Of a request (Modbus Messaging on TCP/IP, 3.1.3): transaction, protocol 0, length of what follows, unit; then the
// PDU.
constexpr std::size_t kLengthAt = 4;
constexpr std::size_t kBeforeUnit = 6;
constexpr std::size_t kFunctionAt = 7;
constexpr std::size_t kShortest = 8;
constexpr std::size_t kLongest = 260;
constexpr std::size_t kClients = 4;

class Client {
 public:
  explicit Client(int socket) : socket_(socket) {
    const int on = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() { ::close(socket_); }
  [[nodiscard]] int socket() const { return socket_; }

  // What has come by now; false: it is over with this client.
  bool serve(const PlcAnswer& answer) {
    const ssize_t count = ::recv(socket_, bytes_.data() + gathered_, bytes_.size() - gathered_, MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return true;
    if (count <= 0) return false;
    gathered_ += static_cast<std::size_t>(count);
    while (gathered_ >= kBeforeUnit) {
      const std::size_t length = kBeforeUnit + bytes_[kLengthAt] * 256U + bytes_[kLengthAt + 1];
      if (length < kShortest || length > bytes_.size()) return false;  // the stream is out of step
      if (gathered_ < length) return true;
      if (!answer_one(std::span(bytes_).first(length), answer)) return false;
      std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(length),
                bytes_.begin() + static_cast<std::ptrdiff_t>(gathered_), bytes_.begin());
      gathered_ -= length;
    }
    return true;
  }

 private:
  // A write whose data is not as long as it says ends the connection.
  [[nodiscard]] static bool is_whole(std::span<const std::uint8_t> frame) {
    constexpr std::uint8_t kWriteMany = 16;
    constexpr std::uint8_t kExchange = 23;
    const std::size_t bytes_at = frame[kFunctionAt] == kWriteMany ? 12 : 16;
    if (frame[kFunctionAt] != kWriteMany && frame[kFunctionAt] != kExchange) return true;
    return frame.size() > bytes_at && frame.size() == bytes_at + 1 + frame[bytes_at];
  }
  [[nodiscard]] bool answer_one(std::span<const std::uint8_t> frame, const PlcAnswer& answer) const {
    if (!is_whole(frame)) return false;
    const auto out = answer({.frame = frame, .function_at = kFunctionAt});
    return out.empty() || ::send(socket_, out.data(), out.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(out.size());
  }

  int socket_;
  std::array<std::uint8_t, kLongest> bytes_{};
  std::size_t gathered_ = 0;
};

class TcpPort final : public PlcPort {
 public:
  explicit TcpPort(int listener) : listener_(listener) {}
  ~TcpPort() override {
    clients_.clear();
    ::close(listener_);
  }

  void serve(int wait_ms, const PlcAnswer& answer) override {
    std::vector<pollfd> files = {pollfd{listener_, POLLIN, 0}};
    for (const auto& client : clients_) files.push_back({client->socket(), POLLIN, 0});
    ::poll(files.data(), files.size(), wait_ms);
    const auto over = [&](const std::unique_ptr<Client>& client) {
      const auto file = std::ranges::find(files, client->socket(), &pollfd::fd);
      return file != files.end() && file->revents != 0 && !client->serve(answer);
    };
    std::erase_if(clients_, over);
    if (dropped_) clients_.clear();
    dropped_ = false;
    if ((files[0].revents & POLLIN) != 0) accept_client();
  }
  void drop_all() override { dropped_ = true; }  // after the request that is being answered
  [[nodiscard]] std::uint16_t port() const override {
    sockaddr_in address{};
    socklen_t length = sizeof(address);
    // The socket interface takes every address by this type.
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
    return ntohs(address.sin_port);
  }

 private:
  void accept_client() {
    const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (socket < 0) return;
    if (clients_.size() >= kClients) clients_.erase(clients_.begin());
    clients_.push_back(std::make_unique<Client>(socket));
  }

  int listener_;
  bool dropped_ = false;
  std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace

OpenedPort open_tcp_port(const machine::LinkUrl& url) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(url.port);
  const std::string host = url.host.empty() ? "127.0.0.1" : url.host;
  const bool known = ::inet_pton(AF_INET, host.c_str(), &address.sin_addr) == 1;
  // The socket interface takes every address by this type.
  if (!known || ::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
      ::listen(listener, static_cast<int>(kClients)) != 0) {
    const std::string why = known ? std::strerror(errno) : "not an IPv4 address";
    ::close(listener);
    return std::unexpected(fmt::format("{}: cannot listen: {}", url.text, why));
  }
  return std::make_unique<TcpPort>(listener);
}

}  // namespace dripfeed::simulator
