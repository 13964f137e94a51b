// One thread for all connections: they wait far more than they work. Its loop is a fence, and so is each step of a
// connection. Where there are too many connections, the one that waits longest for its peer goes first, so that whoever
// opens many and says nothing keeps no one out, and descriptors are left for the lines.
#include "server/http/server.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include "server/app/base/fence.h"
#include "server/http/connection.h"
#include "server/http/tls.h"

namespace dripfeed::http {

namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;

constexpr std::chrono::milliseconds kAcceptAgain{100};
constexpr std::chrono::seconds kLookAtFiles{2};
constexpr std::chrono::hours kNoLimit{24 * 365};
constexpr std::size_t kMostConnections = 1024;

// Half of what the process may open at most: the other half is for lines, files of the store and ports.
std::size_t connection_limit() {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return kMostConnections / 4;
  return std::clamp<std::size_t>(files.rlim_cur / 2, 16, kMostConnections);
}

class ListeningServer final : public Server {
 public:
  ListeningServer(Answerer answerer, const ServerSettings& settings)
      : traffic_(settings.traffic ? settings.traffic : std::make_shared<Traffic>(0)),
        lanes_(settings.heavy_threads),
        spool_(lanes_, settings.spool_folder),
        acceptor_(context_),
        again_(context_),
        look_(context_) {
    shared_.answerer = std::move(answerer);
    shared_.lanes = &lanes_;
    shared_.spool = &spool_;
    shared_.traffic = traffic_.get();
  }
  ~ListeningServer() override { stop(kNoLimit); }

  // Throws boost::system::system_error; start() is the fence.
  void listen(const ListenAddress& address, std::optional<TlsFiles> tls, std::vector<asio::ip::address> proxies) {
    tls_ = std::move(tls);
    shared_.proxies = std::move(proxies);
    const tcp::endpoint endpoint(asio::ip::make_address(address.host), address.port);
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
    port_ = acceptor_.local_endpoint().port();
    accept_next();
    if (tls_) look_later();
    thread_ = std::thread([this] { run(); });
  }

  [[nodiscard]] std::uint16_t port() const override { return port_; }

  std::expected<void, std::string> set_proxies(const std::vector<std::string>& proxies) override;

  void close() override {
    asio::post(context_, [this] {
      boost::system::error_code ignored;  // the acceptor is going away
      acceptor_.close(ignored);
      again_.cancel();
      look_.cancel();
      for (const auto& weak : connections_) {
        if (const auto connection = weak.lock()) connection->close();
      }
    });
  }

  bool stop(std::chrono::milliseconds at_most) override {
    const auto until = std::chrono::steady_clock::now() + at_most;
    close();
    if (!lanes_.stop(at_most)) return false;
    std::unique_lock lock(ended_mutex_);
    if (thread_.joinable() && !ended_changed_.wait_until(lock, until, [this] { return ended_; })) return false;
    lock.unlock();
    if (thread_.joinable()) thread_.join();
    return true;
  }

 private:
  // The fence of the HTTP thread: what comes here was thrown outside the fence of a connection.
  void run() {
    ::prctl(PR_SET_NAME, "http");
    while (!app::fenced("http", [this] { context_.run(); })) continue;
    const std::lock_guard lock(ended_mutex_);
    ended_ = true;
    ended_changed_.notify_all();
  }

  void accept_next() {
    acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (!acceptor_.is_open()) return;  // stopped, maybe with this connection just accepted
      if (error) return accept_later();
      app::fenced("http, a connection that is not taken", [&] { take(std::move(socket)); });
      accept_next();
    });
  }

  void take(tcp::socket socket) {
    std::erase_if(connections_, [](const auto& connection) { return connection.expired(); });
    boost::system::error_code gone;  // the peer went away meanwhile
    const auto peer = socket.remote_endpoint(gone).address();
    if (gone || !make_room_for(peer)) return;  // destroying the socket closes it
    connections_.push_back(serve(std::move(socket), tls_ ? tls_->context() : nullptr, shared_));
  }

  // A proxy stands for many, so it has no limit of its own.
  bool make_room_for(const asio::ip::address& peer) {
    const bool is_proxy = std::ranges::find(shared_.proxies, peer) != shared_.proxies.end();
    const auto is_from_peer = [&](const ConnectionHandle& one) { return one.peer() == peer; };
    if (!is_proxy && count_if(is_from_peer) >= most_ / 2) return close_oldest(is_from_peer);
    if (connections_.size() >= most_) return close_oldest([](const ConnectionHandle&) { return true; });
    return true;
  }

  template <class Which>
  std::size_t count_if(const Which& which) const {
    return static_cast<std::size_t>(std::ranges::count_if(connections_, [&](const auto& weak) {
      const auto connection = weak.lock();
      return connection && which(*connection);
    }));
  }

  // Of those that wait for their peer. False where none does.
  template <class Which>
  bool close_oldest(const Which& which) {
    std::shared_ptr<ConnectionHandle> oldest;
    for (const auto& weak : connections_) {
      auto connection = weak.lock();
      if (!connection || !which(*connection) || !connection->waits_since()) continue;
      if (!oldest || *connection->waits_since() < *oldest->waits_since()) oldest = std::move(connection);
    }
    if (!oldest) return false;
    std::erase_if(connections_, [&](const auto& weak) { return weak.lock() == oldest; });
    oldest->close();
    return true;
  }

  // The system has no file descriptor left, or the peer went away meanwhile.
  void accept_later() {
    again_.expires_after(kAcceptAgain);
    again_.async_wait([this](boost::system::error_code error) {
      if (!error && acceptor_.is_open()) accept_next();
    });
  }

  void look_later() {
    look_.expires_after(kLookAtFiles);
    look_.async_wait([this](boost::system::error_code error) {
      if (error || !acceptor_.is_open()) return;
      look_later();  // whatever happens to this look
      tls_->refresh();
    });
  }

  std::shared_ptr<Traffic> traffic_;
  ConnectionShared shared_;  // outlives what lies in the context
  Lanes lanes_;              // before the context: a body that ends with it goes through a lane
  Spool spool_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  asio::steady_timer again_;
  asio::steady_timer look_;
  std::optional<TlsFiles> tls_;
  std::vector<std::weak_ptr<ConnectionHandle>> connections_;
  const std::size_t most_ = connection_limit();
  std::uint16_t port_ = 0;
  std::mutex ended_mutex_;
  std::condition_variable ended_changed_;
  bool ended_ = false;
  std::thread thread_;
};

std::expected<std::vector<asio::ip::address>, std::string> addresses_of(const std::vector<std::string>& texts) {
  std::vector<asio::ip::address> addresses;
  for (const std::string& text : texts) {
    boost::system::error_code bad;
    addresses.push_back(asio::ip::make_address(text, bad));
    if (bad) return std::unexpected(fmt::format("proxy \"{}\" is not an IP address", text));
  }
  return addresses;
}

std::expected<void, std::string> ListeningServer::set_proxies(const std::vector<std::string>& proxies) {
  auto addresses = addresses_of(proxies);
  if (!addresses) return std::unexpected(std::move(addresses.error()));
  asio::post(context_, [this, known = std::move(*addresses)]() mutable { shared_.proxies = std::move(known); });
  return {};
}

}  // namespace

std::expected<ListenAddress, std::string> parse_listen_address(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return std::unexpected(fmt::format("\"{}\" is not ADDRESS:PORT", text));
  ListenAddress address;
  std::string_view host = text.substr(0, colon);
  const std::string_view port = text.substr(colon + 1);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  if (host == "localhost") host = "127.0.0.1";
  if (!host.empty()) address.host = host;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (port.empty() || error != std::errc{} || end != port.data() + port.size()) {
    return std::unexpected(fmt::format("port \"{}\" is not 0..65535", port));
  }
  boost::system::error_code bad;
  asio::ip::make_address(address.host, bad);
  if (bad) return std::unexpected(fmt::format("\"{}\" is not an IP address", address.host));
  return address;
}

bool is_ip_address(const std::string& text) {
  boost::system::error_code bad;
  asio::ip::make_address(text, bad);
  return !bad;
}

bool is_loopback(const ListenAddress& address) { return asio::ip::make_address(address.host).is_loopback(); }

std::expected<std::unique_ptr<Server>, std::string> Server::start(const ServerSettings& settings, Answerer answerer) {
  auto proxies = addresses_of(settings.proxies);
  if (!proxies) return std::unexpected(proxies.error());
  std::optional<TlsFiles> tls;
  if (!settings.tls_certificate.empty()) {
    auto files = TlsFiles::open(settings.tls_certificate, settings.tls_key);
    if (!files) return std::unexpected(files.error());
    tls.emplace(std::move(*files));
  }
  auto server = std::make_unique<ListeningServer>(std::move(answerer), settings);
  const ListenAddress& address = settings.address;
  try {
    server->listen(address, std::move(tls), std::move(*proxies));
  } catch (const boost::system::system_error& error) {
    return std::unexpected(
        fmt::format("cannot listen on {}:{}: {}", address.host, address.port, error.code().message()));
  }
  return server;
}

}  // namespace dripfeed::http
