// Listens at one address for peers that only read: a thread of its own accepts and serves them, those of the addresses
// that are named, and so many at the same time. What a peer is sent, its connection decides.
#pragma once

#include <atomic>
#include <cstdint>
#include <expected>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

namespace dripfeed::io {

struct PeerSettings {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;  // 0: one that the system chooses
  // IP addresses that may connect; others are let go at once. Empty: whoever reaches a loopback address, and then the
  // address must be one, because the protocols here know no rights.
  std::vector<std::string> allowed;
};

// All on the listener's thread.
class PeerConnection {
 public:
  PeerConnection() = default;
  PeerConnection(const PeerConnection&) = delete;
  PeerConnection& operator=(const PeerConnection&) = delete;
  virtual ~PeerConnection() = default;
  virtual void begin() = 0;
  virtual void close() = 0;
};

class PeerListener {
 public:
  using Make = std::function<std::shared_ptr<PeerConnection>(boost::asio::ip::tcp::socket)>;
  // Connections at the same time; more are let go at once.
  static constexpr std::size_t kMaxConnections = 16;

  // Listens and serves. Or one sentence that says what is wrong with the settings, or what the system refused.
  // `protocol`: its name for people, 11 characters or fewer.
  static std::expected<std::unique_ptr<PeerListener>, std::string> listen(const PeerSettings& settings,
                                                                          std::string protocol, Make make);
  PeerListener(const PeerListener&) = delete;
  PeerListener& operator=(const PeerListener&) = delete;
  ~PeerListener();
  [[nodiscard]] std::uint16_t port() const { return port_; }
  // From any thread: who may connect from now on, and connections of others end. Or a sentence, and nothing changes.
  std::expected<void, std::string> set_allowed(const std::vector<std::string>& allowed);
  // Connections that were not allowed or were too many, since the start.
  [[nodiscard]] std::uint64_t refused() const { return refused_.load(); }

 private:
  using Address = boost::asio::ip::address;
  struct Peer {
    Address address;
    std::weak_ptr<PeerConnection> connection;
  };

  PeerListener(std::string protocol, std::vector<Address> allowed, Make make);
  void open(const boost::asio::ip::tcp::endpoint& endpoint);
  void run();
  void accept_next();
  void take(boost::asio::ip::tcp::socket socket);
  void accept_later();
  [[nodiscard]] bool may_connect(const Address& peer) const;

  std::string protocol_;
  std::vector<Address> allowed_;
  Make make_;
  boost::asio::io_context context_{1};
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer again_;
  std::list<Peer> peers_;
  std::atomic<std::uint64_t> refused_{0};
  std::uint16_t port_ = 0;
  Address address_;
  std::jthread thread_;
};

}  // namespace dripfeed::io
