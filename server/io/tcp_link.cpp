// Small buffers bound what the network holds of a program, and of what a control said and no one heard yet; keepalive
// and the user timeout find a peer that is gone without a word.
#include "server/io/tcp_link.h"

#include <algorithm>
#include <chrono>
#include <string_view>
#include <vector>

#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>
#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

namespace dripfeed::io {

namespace {

using tcp = asio::ip::tcp;
using Peers = tcp::resolver::results_type;

constexpr int kSocketSendBytes = 4096;
constexpr int kSocketReceiveBytes = 16'384;
constexpr std::chrono::seconds kConnectTimeout{10};
constexpr int kKeepIdle_s = 10;
constexpr int kKeepInterval_s = 3;
constexpr int kKeepCount = 3;
constexpr int kUserTimeout_ms = (kKeepIdle_s + kKeepInterval_s * kKeepCount) * 1000;

void set_option(int descriptor, int level, int name, int value) {
  ::setsockopt(descriptor, level, name, &value, sizeof(value));  // a hint: the link works without it
}

void tune(tcp::socket& socket) {
  const int descriptor = socket.native_handle();
  set_option(descriptor, SOL_SOCKET, SO_SNDBUF, kSocketSendBytes);
  set_option(descriptor, SOL_SOCKET, SO_RCVBUF, kSocketReceiveBytes);
  set_option(descriptor, IPPROTO_TCP, TCP_NODELAY, 1);
  set_option(descriptor, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(descriptor, IPPROTO_TCP, TCP_KEEPIDLE, kKeepIdle_s);
  set_option(descriptor, IPPROTO_TCP, TCP_KEEPINTVL, kKeepInterval_s);
  set_option(descriptor, IPPROTO_TCP, TCP_KEEPCNT, kKeepCount);
  set_option(descriptor, IPPROTO_TCP, TCP_USER_TIMEOUT, kUserTimeout_ms);
  socket.non_blocking(true);
}

void connect_to(const std::shared_ptr<TcpCore>& core, const Peers& peers, Peers::const_iterator peer) {
  boost::system::error_code failed;
  core->stream().open(peer->endpoint().protocol(), failed);
  if (failed) return core->lose(failed.message());
  core->stream().async_connect(*peer, [core, peers, peer](boost::system::error_code error) {
    if (core->listener() == nullptr) return;
    if (!error) {
      tune(core->stream());
      return core->begin();
    }
    boost::system::error_code ignored;  // it never was connected
    core->stream().close(ignored);
    const auto next = std::next(peer);
    if (next == peers.end()) return core->lose(error.message());
    connect_to(core, peers, next);  // a name may stand for an IPv6 and an IPv4 address
  });
}

class TcpLink : public app::Link {
 public:
  TcpLink(std::shared_ptr<TcpCore> core, bool reset) : core_(std::move(core)), reset_(reset) {}
  ~TcpLink() override {
    reset_on_close(*core_, reset_);
    core_->detach();
  }

  std::size_t write(std::span<const std::byte> bytes) override { return core_->write(bytes); }
  std::size_t read(std::span<std::byte> into) override { return core_->read(into); }
  // What TCP holds says nothing of the line behind the device server.
  std::optional<std::uint64_t> unsent() override { return std::nullopt; }
  [[nodiscard]] bool unheard() const override { return core_->unheard(); }
  [[nodiscard]] std::string_view note() const override { return core_->note(); }
  std::optional<std::uint64_t> unconfirmed() override {
    return core_->up() ? read_unconfirmed(core_->stream().native_handle()) : std::nullopt;
  }

 private:
  std::shared_ptr<TcpCore> core_;
  bool reset_;
};

// Who may connect to a listener; empty: anyone.
using AllowedPeers = std::vector<asio::ip::address>;

bool is_allowed(const AllowedPeers& peers, const tcp::socket& socket) {
  boost::system::error_code gone;
  const auto peer = socket.remote_endpoint(gone).address();
  return !gone && (peers.empty() || std::ranges::find(peers, peer) != peers.end());
}

// A peer that may not is closed at once, and the next one is waited for.
void accept_one(const std::shared_ptr<tcp::acceptor>& acceptor, const std::shared_ptr<TcpCore>& core,
                const AllowedPeers& peers) {
  acceptor->async_accept(core->stream(), [core, acceptor, peers](boost::system::error_code error) {
    if (core->listener() == nullptr) return;
    boost::system::error_code ignored;
    if (!error && !is_allowed(peers, core->stream())) {
      core->stream().close(ignored);
      return accept_one(acceptor, core, peers);
    }
    acceptor->close(ignored);
    if (error) return core->lose(error.message());
    tune(core->stream());
    core->begin();
  });
}

// Waits for one peer (a device server in client mode). While that one is there, the next is refused by the system.
class TcpListenLink final : public TcpLink {
 public:
  TcpListenLink(asio::io_context& context, const tcp::endpoint& local, const std::shared_ptr<TcpCore>& core, bool reset,
                const AllowedPeers& peers)
      : TcpLink(core, reset), acceptor_(std::make_shared<tcp::acceptor>(context, local)) {
    accept_one(acceptor_, core, peers);
  }
  ~TcpListenLink() override {
    boost::system::error_code ignored;  // closed already once a peer came
    acceptor_->close(ignored);
  }

 private:
  std::shared_ptr<tcp::acceptor> acceptor_;
};

// The option peers: addresses with commas between, or "any". Whoever connects plays the control, so beyond loopback
// a person must have said who may.
std::expected<AllowedPeers, std::string> allowed_peers(const machine::LinkUrl& url, const asio::ip::address& local) {
  const auto given = url.options.find("peers");
  if (given == url.options.end()) {
    if (local.is_loopback()) return AllowedPeers{};
    return std::unexpected(fmt::format(
        "{} would let any computer on the network act as the control: name who may connect (?peers=192.168.1.5), "
        "or pass ?peers=any",
        url.text));
  }
  AllowedPeers peers;
  std::string_view rest = given->second;
  if (rest == "any") return peers;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    boost::system::error_code bad;
    peers.push_back(asio::ip::make_address(std::string(one), bad));
    if (bad) return std::unexpected(fmt::format("{}: peer \"{}\" is not an IP address", url.text, one));
  }
  return peers;
}

bool always_reset(const machine::LineSettings& line) {
  const auto given = line.link.options.find("close");
  return given != line.link.options.end() && given->second == "reset";
}

}  // namespace

std::optional<std::uint64_t> read_unconfirmed(int descriptor) {
  int count = 0;
  if (::ioctl(descriptor, SIOCOUTQ, &count) != 0 || count < 0) return std::nullopt;
  return static_cast<std::uint64_t>(count);
}

void reset_on_close(TcpCore& core, bool always) {
  if (!core.up() || !core.stream().is_open()) return;
  if (!always && read_unconfirmed(core.stream().native_handle()).value_or(0) == 0) return;
  boost::system::error_code ignored;  // then it closes as usual
  core.stream().set_option(asio::socket_base::linger(true, 0), ignored);
}

void connect(const std::shared_ptr<TcpCore>& core, const std::string& host, std::uint16_t port) {
  // A peer that does not answer at all would keep the system trying for minutes.
  const auto timer = std::make_shared<asio::steady_timer>(core->stream().get_executor(), kConnectTimeout);
  timer->async_wait([weak = std::weak_ptr(core), timer, host](boost::system::error_code) {
    const auto still = weak.lock();
    if (still && !still->up()) still->lose(fmt::format("{} does not answer", host));
  });
  // A name is looked up on a thread of Asio's own: a slow name server must not hold up the lines that run.
  const auto resolver = std::make_shared<tcp::resolver>(core->stream().get_executor());
  resolver->async_resolve(host, std::to_string(port),
                          [core, resolver](boost::system::error_code error, const Peers& peers) {
                            if (core->listener() == nullptr) return;
                            if (error) return core->lose(error.message());
                            connect_to(core, peers, peers.begin());
                          });
}

std::expected<std::unique_ptr<app::Link>, std::string> open_tcp_link(boost::asio::io_context& context,
                                                                     const machine::LineSettings& line,
                                                                     app::LinkListener& listener) {
  const auto core = std::make_shared<TcpCore>(tcp::socket(context), listener);
  connect(core, line.link.host, line.link.port);
  return std::make_unique<TcpLink>(core, always_reset(line));
}

std::expected<std::unique_ptr<app::Link>, std::string> open_tcp_listener(boost::asio::io_context& context,
                                                                         const machine::LineSettings& line,
                                                                         app::LinkListener& listener) {
  const std::string host = line.link.host.empty() ? "127.0.0.1" : line.link.host;
  const auto core = std::make_shared<TcpCore>(tcp::socket(context), listener);
  const tcp::endpoint local(asio::ip::make_address(host), line.link.port);
  const auto peers = allowed_peers(line.link, local.address());
  if (!peers) return std::unexpected(peers.error());
  return std::make_unique<TcpListenLink>(context, local, core, always_reset(line), *peers);
}

}  // namespace dripfeed::io
