// One thread for all connections (they wait far more than they work), a pool for heavy requests at nice 19 so that a
// check never delays a feed.
#include "server/http/server.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <fmt/format.h>

#include "server/http/connection.h"

namespace dripfeed::http {

namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;

constexpr std::chrono::milliseconds kAcceptAgain{100};

// Two at least: a sweep, of which there is one at a time, keeps no check waiting.
std::size_t pool_size() { return std::max(2U, std::thread::hardware_concurrency() - 1U); }

class ListeningServer final : public Server {
 public:
  explicit ListeningServer(Answerer answerer) : pool_(pool_size()), acceptor_(context_), again_(context_) {
    shared_.answerer = std::move(answerer);
    shared_.pool = &pool_;
  }
  ~ListeningServer() override { stop(); }

  // Throws boost::system::system_error; start() is the fence.
  void listen(const ListenAddress& address) {
    const tcp::endpoint endpoint(asio::ip::make_address(address.host), address.port);
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
    port_ = acceptor_.local_endpoint().port();
    accept_next();
    thread_ = std::jthread([this] { context_.run(); });
  }

  [[nodiscard]] std::uint16_t port() const override { return port_; }

 private:
  void accept_next() {
    acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (!acceptor_.is_open()) return;  // stopped, maybe with this connection just accepted
      if (error) return accept_later();
      std::erase_if(connections_, [](const auto& connection) { return connection.expired(); });
      connections_.push_back(serve(std::move(socket), shared_));
      accept_next();
    });
  }

  // The system has no file descriptor left, or the peer went away meanwhile.
  void accept_later() {
    again_.expires_after(kAcceptAgain);
    again_.async_wait([this](boost::system::error_code error) {
      if (!error && acceptor_.is_open()) accept_next();
    });
  }

  void stop() {
    asio::post(context_, [this] {
      boost::system::error_code ignored;  // the acceptor is going away
      acceptor_.close(ignored);
      again_.cancel();
      for (const auto& weak : connections_) {
        if (const auto connection = weak.lock()) connection->close();
      }
    });
    pool_.join();
    if (thread_.joinable()) thread_.join();
  }

  asio::io_context context_{1};
  asio::thread_pool pool_;
  ConnectionShared shared_;
  tcp::acceptor acceptor_;
  asio::steady_timer again_;
  std::vector<std::weak_ptr<ConnectionHandle>> connections_;
  std::uint16_t port_ = 0;
  std::jthread thread_;
};

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

bool is_loopback(const ListenAddress& address) { return asio::ip::make_address(address.host).is_loopback(); }

std::expected<std::unique_ptr<Server>, std::string> Server::start(const ListenAddress& address, Answerer answerer) {
  auto server = std::make_unique<ListeningServer>(std::move(answerer));
  try {
    server->listen(address);
  } catch (const boost::system::system_error& error) {
    return std::unexpected(
        fmt::format("cannot listen on {}:{}: {}", address.host, address.port, error.code().message()));
  }
  return server;
}

}  // namespace dripfeed::http
