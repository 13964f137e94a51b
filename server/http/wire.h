// A socket with or without TLS as one type of stream, so that all of a connection is compiled once. It forwards to the
// one or the other; timeouts are those of the socket below. For one thread.
#pragma once

#include <memory>
#include <utility>
#include <variant>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/tcp_stream.hpp>

namespace dripfeed::http {

class Wire {
 public:
  using Plain = boost::beast::tcp_stream;
  using Tls = boost::asio::ssl::stream<Plain>;
  using executor_type = Plain::executor_type;
  using TlsContext = std::shared_ptr<boost::asio::ssl::context>;

  // Without a context: plain.
  Wire(boost::asio::ip::tcp::socket socket, TlsContext context) : context_(std::move(context)) {
    if (context_) {
      stream_.emplace<Tls>(Plain(std::move(socket)), *context_);
    } else {
      stream_.emplace<Plain>(std::move(socket));
    }
  }

  Tls* tls() { return std::get_if<Tls>(&stream_); }
  Plain& lowest() {
    Tls* const secure = tls();
    return secure != nullptr ? secure->next_layer() : std::get<Plain>(stream_);
  }
  executor_type get_executor() { return lowest().get_executor(); }

  template <class Buffers, class Handler>
  void async_read_some(const Buffers& buffers, Handler&& handler) {
    if (Tls* const secure = tls()) return secure->async_read_some(buffers, std::forward<Handler>(handler));
    std::get<Plain>(stream_).async_read_some(buffers, std::forward<Handler>(handler));
  }
  template <class Buffers, class Handler>
  void async_write_some(const Buffers& buffers, Handler&& handler) {
    if (Tls* const secure = tls()) return secure->async_write_some(buffers, std::forward<Handler>(handler));
    std::get<Plain>(stream_).async_write_some(buffers, std::forward<Handler>(handler));
  }

 private:
  TlsContext context_;  // lives as long as the stream
  std::variant<std::monostate, Plain, Tls> stream_;
};

}  // namespace dripfeed::http
