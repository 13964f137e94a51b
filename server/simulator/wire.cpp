// A pty's master sees EIO while no host has the slave open; that is no input, not a fault.
#include "server/simulator/wire.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include "server/io/pty_owner.h"
#include "server/simulator/telnet_wire.h"

namespace dripfeed::simulator {

namespace {

std::string system_text() { return std::strerror(errno); }

std::size_t read_some(int descriptor, std::span<std::byte> into) {
  const ssize_t count = ::read(descriptor, into.data(), into.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

class PtyWire final : public Wire {
 public:
  PtyWire(int master, std::string path, io::PtyOwner owner)
      : master_(master), path_(std::move(path)), owner_(std::move(owner)) {}
  ~PtyWire() override { cut(); }
  [[nodiscard]] int descriptor() const override { return master_; }
  std::size_t read(std::span<std::byte> into) override { return read_some(master_, into); }
  void write(std::span<const std::byte> bytes) override {
    // A few control characters: the pty's buffer of 20 kB takes them, or no one listens and they are lost as on a wire.
    static_cast<void>(!::write(master_, bytes.data(), bytes.size()));
  }
  void cut() override {
    if (master_ < 0) return;
    owner_.let_go();  // before the number is free for another
    ::close(master_);
    master_ = -1;
  }
  [[nodiscard]] std::string address() const override { return "pty:" + path_; }

 private:
  int master_;
  std::string path_;
  io::PtyOwner owner_;
};

class TcpWire final : public Wire {
 public:
  explicit TcpWire(int listener) : listener_(listener) {}
  ~TcpWire() override {
    if (peer_ >= 0) ::close(peer_);
    if (listener_ >= 0) ::close(listener_);
  }
  [[nodiscard]] int descriptor() const override { return peer_ >= 0 ? peer_ : listener_; }
  std::size_t read(std::span<std::byte> into) override {
    if (peer_ < 0) {
      accept_peer();
      return 0;
    }
    const ssize_t count = ::recv(peer_, into.data(), into.size(), MSG_DONTWAIT);
    if (count > 0) return static_cast<std::size_t>(count);
    if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
      ::close(peer_);
      peer_ = -1;
    }
    return 0;
  }
  [[nodiscard]] bool take_connected() override { return std::exchange(connected_, false); }
  void write(std::span<const std::byte> bytes) override {
    if (peer_ >= 0) static_cast<void>(!::send(peer_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL));
  }
  void cut() override {
    const linger reset{.l_onoff = 1, .l_linger = 0};
    if (peer_ >= 0) {
      ::setsockopt(peer_, SOL_SOCKET, SO_LINGER, &reset, sizeof(reset));
      ::close(peer_);
    }
    if (listener_ >= 0) ::close(listener_);
    peer_ = listener_ = -1;
  }
  [[nodiscard]] std::string address() const override {
    sockaddr_in address{};
    socklen_t length = sizeof(address);
    // The socket interface takes every address by this type.
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
    return fmt::format("tcp://127.0.0.1:{}", ntohs(address.sin_port));
  }

 private:
  void accept_peer() {
    peer_ = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (peer_ < 0) return;
    connected_ = true;
    const int on = 1;
    ::setsockopt(peer_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
  }

  int listener_;
  int peer_ = -1;
  bool connected_ = false;
};

using Opened = std::expected<std::unique_ptr<Wire>, std::string>;

Opened open_pty(const machine::LinkUrl& url) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::array<char, 128> name{};
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0 ||
      ::ptsname_r(master, name.data(), name.size()) != 0) {
    return std::unexpected(fmt::format("{}: cannot make a pseudo-terminal: {}", url.text, system_text()));
  }
  // Raw from the start: an echo would send our DC1 back to us before the host opens the line.
  termios settings{};
  ::tcgetattr(master, &settings);
  ::cfmakeraw(&settings);
  ::tcsetattr(master, TCSANOW, &settings);
  auto owner = io::PtyOwner::link(url.path, name.data());
  if (!owner) {
    ::close(master);
    return std::unexpected(fmt::format("{}: {}", url.text, owner.error()));
  }
  return std::make_unique<PtyWire>(master, url.path, std::move(*owner));
}

Opened open_tcp(const machine::LinkUrl& url) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(url.port);
  if (::inet_pton(AF_INET, url.host.empty() ? "127.0.0.1" : url.host.c_str(), &address.sin_addr) != 1) {
    ::close(listener);
    return std::unexpected(fmt::format("{}: \"{}\" is not an IPv4 address", url.text, url.host));
  }
  if (listener < 0 || ::bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0 ||
      ::listen(listener, 1) != 0) {
    const std::string reason = system_text();
    ::close(listener);
    return std::unexpected(fmt::format("{}: cannot listen: {}", url.text, reason));
  }
  return std::make_unique<TcpWire>(listener);
}

}  // namespace

Opened Wire::open(const machine::LinkUrl& url) {
  if (url.kind == machine::LinkKind::pty) return open_pty(url);
  if (url.kind == machine::LinkKind::tcp_listen) return open_tcp(url);
  if (url.kind == machine::LinkKind::rfc2217_listen) {
    auto socket = open_tcp(url);
    if (!socket) return socket;
    return over_telnet(std::move(*socket));
  }
  return std::unexpected(fmt::format(
      "{}: a simulated control lives on pty:/path, tcp-listen://:port or rfc2217-listen://:port", url.text));
}

}  // namespace dripfeed::simulator
