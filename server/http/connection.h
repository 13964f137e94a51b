// One HTTP connection: reads a request, has it answered, writes the answer, again. Beast stays out of this header.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>

#include "server/http/server.h"
#include "server/http/sign_ins.h"
#include "server/http/spool.h"

namespace dripfeed::http {

// What all connections of a server share. It outlives them; all but `sign_ins`, `answerer`, `lanes` and `traffic` is
// for the HTTP thread.
struct ConnectionShared {
  SignIns sign_ins{};
  SignIns provider_sign_ins{};  // of their own: a provider that hangs keeps no password out
  Answerer answerer;
  Lanes* lanes = nullptr;
  const Spool* spool = nullptr;
  std::vector<boost::asio::ip::address> proxies;
  Traffic* traffic = nullptr;
};

// A connection as its server sees it.
class ConnectionHandle {
 public:
  ConnectionHandle() = default;
  ConnectionHandle(const ConnectionHandle&) = delete;
  ConnectionHandle& operator=(const ConnectionHandle&) = delete;
  virtual ~ConnectionHandle() = default;
  virtual void close() = 0;
  [[nodiscard]] virtual const boost::asio::ip::address& peer() const = 0;
  // Since when it waits for its peer to say what it wants; nothing while it is answered or watches events. The one that
  // waits longest is closed where there are too many.
  [[nodiscard]] virtual std::optional<std::chrono::steady_clock::time_point> waits_since() const = 0;
};

// Takes the socket and serves it until either side closes; it lives by its pending operations. `tls`: nullptr for plain
// HTTP. On the HTTP thread, as every member of the handle.
std::weak_ptr<ConnectionHandle> serve(boost::asio::ip::tcp::socket socket,
                                      std::shared_ptr<boost::asio::ssl::context> tls, ConnectionShared& shared);

}  // namespace dripfeed::http
