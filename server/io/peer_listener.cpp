// One io_context and thread: peers that poll ask little.
#include "server/io/peer_listener.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include <boost/asio/post.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>

namespace dripfeed::io {

namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kAcceptAgain{100};

// Who may connect at this address.
std::expected<std::vector<asio::ip::address>, std::string> allowed_at(const asio::ip::address& address,
                                                                      std::string_view protocol,
                                                                      const std::vector<std::string>& named) {
  std::vector<asio::ip::address> allowed;
  for (const std::string& text : named) {
    error_code bad;
    allowed.push_back(asio::ip::make_address(text, bad));
    if (bad) return std::unexpected(fmt::format("\"{}\" is not an IP address", text));
  }
  if (allowed.empty() && !address.is_loopback())
    return std::unexpected(fmt::format("{} is not loopback, and {} has no rights: state which addresses may read",
                                       address.to_string(), protocol));
  return allowed;
}

}  // namespace

std::expected<std::unique_ptr<PeerListener>, std::string> PeerListener::listen(const PeerSettings& settings,
                                                                               std::string protocol, Make make) {
  error_code bad;
  const asio::ip::address address = asio::ip::make_address(settings.host, bad);
  if (bad) return std::unexpected(fmt::format("\"{}\" is not an IP address", settings.host));
  auto allowed = allowed_at(address, protocol, settings.allowed);
  if (!allowed) return std::unexpected(std::move(allowed.error()));
  std::unique_ptr<PeerListener> listener(new PeerListener(std::move(protocol), std::move(*allowed), std::move(make)));
  try {
    listener->open({address, settings.port});
  } catch (const boost::system::system_error& error) {
    return std::unexpected(
        fmt::format("cannot listen on {}:{}: {}", settings.host, settings.port, error.code().message()));
  }
  return listener;
}

PeerListener::PeerListener(std::string protocol, std::vector<Address> allowed, Make make)
    : protocol_(std::move(protocol)),
      allowed_(std::move(allowed)),
      make_(std::move(make)),
      acceptor_(context_),
      again_(context_) {}

PeerListener::~PeerListener() {
  asio::post(context_, [this] {
    error_code ignored;  // the acceptor is going away
    acceptor_.close(ignored);
    again_.cancel();
    for (const Peer& peer : peers_)
      if (const auto connection = peer.connection.lock()) connection->close();
  });
  if (thread_.joinable()) thread_.join();
}

// Throws boost::system::system_error; listen() is the fence.
void PeerListener::open(const tcp::endpoint& endpoint) {
  acceptor_.open(endpoint.protocol());
  acceptor_.set_option(tcp::acceptor::reuse_address(true));
  acceptor_.bind(endpoint);
  acceptor_.listen();
  port_ = acceptor_.local_endpoint().port();
  address_ = endpoint.address();
  accept_next();
  thread_ = std::jthread([this] { run(); });
}

std::expected<void, std::string> PeerListener::set_allowed(const std::vector<std::string>& allowed) {
  auto addresses = allowed_at(address_, protocol_, allowed);
  if (!addresses) return std::unexpected(std::move(addresses.error()));
  asio::post(context_, [this, known = std::move(*addresses)]() mutable {
    allowed_ = std::move(known);
    for (const Peer& peer : peers_) {
      const auto connection = peer.connection.lock();
      if (connection && !may_connect(peer.address)) connection->close();
    }
  });
  return {};
}

// The fence of the thread: what one connection throws is reported, and the others are served on.
void PeerListener::run() {
  ::prctl(PR_SET_NAME, (protocol_ + " out").c_str());
  for (bool over = false; !over;) {
    try {
      context_.run();
      over = true;
    } catch (const std::exception& error) {
      spdlog::critical("the {} server: {}", protocol_, error.what());
    }
  }
}

void PeerListener::accept_next() {
  acceptor_.async_accept([this](error_code error, tcp::socket socket) {
    if (!acceptor_.is_open()) return;
    if (error) return accept_later();
    take(std::move(socket));
    accept_next();
  });
}

// A socket that is not kept is closed by its end.
void PeerListener::take(tcp::socket socket) {
  std::erase_if(peers_, [](const Peer& peer) { return peer.connection.expired(); });
  error_code error;
  const tcp::endpoint from = socket.remote_endpoint(error);
  if (error || !may_connect(from.address()) || peers_.size() >= kMaxConnections) {
    refused_.fetch_add(1);
    return;
  }
  error_code ignored;  // what is sent goes a little later then
  socket.set_option(tcp::no_delay(true), ignored);
  const auto connection = make_(std::move(socket));
  peers_.push_back({from.address(), connection});
  connection->begin();
}

bool PeerListener::may_connect(const Address& peer) const {
  return allowed_.empty() || std::ranges::find(allowed_, peer) != allowed_.end();
}

// The system has no file descriptor left, or the peer went away meanwhile.
void PeerListener::accept_later() {
  again_.expires_after(kAcceptAgain);
  again_.async_wait([this](error_code error) {
    if (!error && acceptor_.is_open()) accept_next();
  });
}

}  // namespace dripfeed::io
