// Sockets on loopback, in both roles: refused, closed in half, reset, and one peer at a time.
#include <array>
#include <thread>

#include <arpa/inet.h>
#include <linux/sockios.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "server/io/read_allowance.h"
#include "server/io/stream_core.h"
#include "tests/unit/server/io/listening.h"

namespace dripfeed::io {
namespace {

using namespace test;

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

// A socket of the far end; it goes with the test.
class FarEnd {
 public:
  explicit FarEnd(int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) : descriptor_(descriptor) {}
  FarEnd(const FarEnd&) = delete;
  FarEnd& operator=(const FarEnd&) = delete;
  ~FarEnd() { close(); }

  std::uint16_t listen() {
    const sockaddr_in any = loopback(0);
    // The socket interface takes every address by this type.
    EXPECT_EQ(::bind(descriptor_, reinterpret_cast<const sockaddr*>(&any), sizeof(any)), 0);
    EXPECT_EQ(::listen(descriptor_, 4), 0);
    sockaddr_in bound{};
    socklen_t length = sizeof(bound);
    ::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&bound), &length);
    return ntohs(bound.sin_port);
  }
  int accept() const {
    pollfd file{.fd = descriptor_, .events = POLLIN, .revents = 0};
    EXPECT_EQ(::poll(&file, 1, static_cast<int>(std::chrono::milliseconds(kLongest).count())), 1);
    return ::accept(descriptor_, nullptr, nullptr);
  }
  bool connect(std::uint16_t port) const {
    const sockaddr_in address = loopback(port);
    return ::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  }
  void send_text(std::string_view text) const {
    EXPECT_EQ(::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  // Waits until the other side's kernel has all that was sent.
  [[nodiscard]] bool arrived() const {
    for (int i = 0; i < 5'000; ++i) {
      int waiting = 0;
      if (::ioctl(descriptor_, SIOCOUTQ, &waiting) == 0 && waiting == 0) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }
  // What the socket takes of it within 10 ms.
  [[nodiscard]] std::size_t push(std::string_view text) const {
    pollfd file{.fd = descriptor_, .events = POLLOUT, .revents = 0};
    if (::poll(&file, 1, 10) != 1) return 0;
    const ssize_t count = ::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  [[nodiscard]] std::string hear(std::size_t bytes) const {
    std::string text(bytes, '\0');
    const ssize_t count = ::recv(descriptor_, text.data(), bytes, MSG_WAITALL);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
  }
  void close_half() const { ::shutdown(descriptor_, SHUT_WR); }
  void reset() {
    const linger now{.l_onoff = 1, .l_linger = 0};
    ::setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &now, sizeof(now));
    close();
  }
  void close() {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
  }

 private:
  int descriptor_;
};

std::string url_of(const char* scheme, std::uint16_t port) { return scheme + std::to_string(port); }

class SocketTest : public LinkTest {
 protected:
  // Connected to a listener of the far end.
  void connect() {
    FarEnd listener;
    ASSERT_EQ(open(url_of("tcp://127.0.0.1:", listener.listen())), "");
    peer_ = std::make_unique<FarEnd>(listener.accept());
    ASSERT_TRUE(heard_.await_ups(1));
  }
  std::unique_ptr<FarEnd> peer_;
};

TEST_F(SocketTest, BytesPassInBothDirections) {
  connect();
  const std::string odd("\x11\x13\x93\0\r\n\xFF", 7);
  EXPECT_EQ(write(odd), odd.size());
  EXPECT_EQ(peer_->hear(odd.size()), odd);
  peer_->send_text(odd);
  ASSERT_TRUE(heard_.await_received(odd.size()));
  EXPECT_EQ(heard_.received(), odd);
  EXPECT_FALSE(unsent()) << "what TCP holds says nothing of the line behind the device server";
}

TEST_F(SocketTest, ARefusedConnectionIsLostAndNeverUp) {
  std::uint16_t port = 0;
  {
    FarEnd gone;
    port = gone.listen();
  }
  ASSERT_EQ(open(url_of("tcp://127.0.0.1:", port)), "");
  ASSERT_TRUE(heard_.await_losses(1));
  EXPECT_EQ(heard_.reason(), "Connection refused");
  EXPECT_EQ(heard_.ups(), 0);
}

TEST_F(SocketTest, AHalfClosedPeerIsGone) {
  connect();
  peer_->send_text("last");
  peer_->close_half();
  ASSERT_TRUE(heard_.await_losses(1));
  EXPECT_EQ(heard_.received(), "last") << "what came before the end is heard";
  EXPECT_EQ(heard_.reason(), "the other side closed the line");
  static_cast<void>(write("x"));
  close();
  EXPECT_EQ(heard_.losses(), 1);
}

TEST_F(SocketTest, AResetIsReportedOnce) {
  connect();
  peer_->reset();
  ASSERT_TRUE(heard_.await_losses(1));
  EXPECT_EQ(heard_.reason(), "Connection reset by peer");
  for (int i = 0; i < 3; ++i) static_cast<void>(write("into the void"));
  thread_->run([] {});
  EXPECT_EQ(heard_.losses(), 1);
}

// What a peer that writes as fast as it can gets into the socket within a time.
std::size_t flood(const FarEnd& peer, std::chrono::milliseconds how_long) {
  const std::string piece(65'536, '\x11');
  const auto until = std::chrono::steady_clock::now() + how_long;
  std::size_t sent = 0;
  while (std::chrono::steady_clock::now() < until) sent += peer.push(piece);
  return sent;
}

TEST_F(SocketTest, AFloodIsReadInPiecesAndNamed) {
  connect();
  const auto note = [&] {
    std::string text;
    thread_->run([&] { text = link_->note(); });
    return text;
  };
  const auto unheard = [&] {
    bool is = false;
    thread_->run([&] { is = link_->unheard(); });
    return is;
  };
  EXPECT_EQ(note(), "");
  EXPECT_FALSE(unheard());
  const auto begin = std::chrono::steady_clock::now();
  flood(*peer_, std::chrono::milliseconds(1500));
  const std::size_t read = heard_.received().size();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_LE(static_cast<double>(read), kReadsAtOnce_bytes + kReadBytes + kReadsPerSecond_bytes * took.count());
  EXPECT_EQ(note(), app::kFloodNote);
  EXPECT_TRUE(unheard());
}

TEST_F(SocketTest, NothingLeavesBeforeWhatCameIsHeard) {
  connect();
  // More than may be read at once, and no more than the kernel holds: what is still in transit has not come.
  peer_->send_text(std::string(3 * kReadsAtOnce_bytes, '\x11') + '\x13');
  ASSERT_TRUE(peer_->arrived());
  std::size_t taken = 0;
  bool heard = false;
  for (int i = 0; i < 30'000 && !heard; ++i) {
    thread_->run([&] {
      std::array<std::byte, 256> piece{};
      while (const std::size_t count = link_->read(piece)) heard_.on_receive(std::span(piece).first(count));
      heard = heard_.received().ends_with('\x13');
      if (!heard) taken += link_->write(bytes_of("x"));
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(heard);
  EXPECT_EQ(taken, 0U);
}

TEST_F(SocketTest, APeerThatReadsNothingFillsALittleAndNoMore) {
  connect();
  const std::string much(1 << 20, 'x');
  std::size_t taken = 0;
  for (std::size_t now = write(much); now > 0; now = write(much)) {
    taken += now;
    ASSERT_LT(taken, std::size_t{64} << 20U);
  }
  EXPECT_EQ(peer_->hear(taken).size(), taken);
  EXPECT_TRUE(heard_.await_writables(1));
}

TEST_F(SocketTest, ListensForOnePeer) {
  std::uint16_t port = 0;
  {
    FarEnd free_port;
    port = free_port.listen();
  }
  ASSERT_EQ(open(url_of("tcp-listen://:", port)), "");
  EXPECT_EQ(write("nobody hears"), 0U);
  EXPECT_EQ(heard_.ups(), 0);
  FarEnd first;
  ASSERT_TRUE(first.connect(port));
  ASSERT_TRUE(heard_.await_ups(1));
  EXPECT_EQ(write("hello"), 5U);
  EXPECT_EQ(first.hear(5), "hello");
  FarEnd second;
  EXPECT_FALSE(second.connect(port)) << "one peer is enough";
  first.close();
  ASSERT_TRUE(heard_.await_losses(1));
  close();
  ASSERT_EQ(open(url_of("tcp-listen://:", port)), "");
  FarEnd third;
  ASSERT_TRUE(third.connect(port));
  EXPECT_TRUE(heard_.await_ups(2));
}

TEST_F(SocketTest, AListenerTakesThoseWhoMayConnect) {
  std::uint16_t port = 0;
  {
    FarEnd free_port;
    port = free_port.listen();
  }
  const std::string anywhere = "tcp-listen://0.0.0.0:" + std::to_string(port);
  EXPECT_NE(open(anywhere).find("name who may connect"), std::string::npos);
  EXPECT_NE(open(anywhere + "?peers=shop").find("\"shop\" is not an IP address"), std::string::npos);
  ASSERT_EQ(open(anywhere + "?peers=192.0.2.1"), "");
  FarEnd stranger;
  ASSERT_TRUE(stranger.connect(port));
  EXPECT_EQ(stranger.hear(1), "") << "closed at once";
  EXPECT_EQ(heard_.ups(), 0);
  close();
  ASSERT_EQ(open(anywhere + "?peers=192.0.2.1,127.0.0.1"), "");
  FarEnd known;
  ASSERT_TRUE(known.connect(port));
  EXPECT_TRUE(heard_.await_ups(1));
  close();
  EXPECT_EQ(open(anywhere + "?peers=any"), "");
}

TEST_F(SocketTest, APortThatIsTakenIsRefused) {
  FarEnd taken;
  const std::uint16_t port = taken.listen();
  EXPECT_NE(open(url_of("tcp-listen://:", port)).find("Address already in use"), std::string::npos);
  EXPECT_NE(open("tcp-listen://nonsense:" + std::to_string(port)), "");
}

TEST_F(SocketTest, ARegisterBusIsNoLinkOfBytes) {
  EXPECT_NE(open("modbus-tcp://127.0.0.1:502/1").find("is not a link of bytes"), std::string::npos);
}

TEST_F(SocketTest, MayBeClosedWhileItConnects) {
  FarEnd listener;
  const std::uint16_t port = listener.listen();
  for (int i = 0; i < 50; ++i) {
    thread_->run([&] {
      auto opened = thread_->open(line_of(url_of("tcp://127.0.0.1:", port)), heard_);
      ASSERT_TRUE(opened);
      link_ = std::move(*opened);
      link_.reset();
    });
  }
  thread_->run([] {});
  EXPECT_EQ(heard_.ups(), 0);
  EXPECT_EQ(heard_.losses(), 0);
}

}  // namespace
}  // namespace dripfeed::io
