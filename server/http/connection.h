// One HTTP connection: reads a request, has it answered, writes the answer, again. Beast stays behind this header.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/thread_pool.hpp>

#include "server/http/server.h"

namespace dripfeed::http {

// What all connections of a server share. It outlives them.
struct ConnectionShared {
  Answerer answerer;
  boost::asio::thread_pool* pool = nullptr;
};

// Takes the socket and serves it until either side closes; it lives by its pending operations. `closer` of the returned
// handle ends it from the server's thread.
class ConnectionHandle {
 public:
  ConnectionHandle() = default;
  ConnectionHandle(const ConnectionHandle&) = delete;
  ConnectionHandle& operator=(const ConnectionHandle&) = delete;
  virtual ~ConnectionHandle() = default;
  virtual void close() = 0;
};
std::weak_ptr<ConnectionHandle> serve(boost::asio::ip::tcp::socket socket, const ConnectionShared& shared);

}  // namespace dripfeed::http
