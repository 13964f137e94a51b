// What one connection knows. Its steps stand in connection.cpp (reading, answering), connection_spool.cpp (long bodies)
// and connection_write.cpp. Each step
// runs on the HTTP thread, so nothing needs a lock, and inside a fence: what it throws closes this connection alone.
#pragma once

#include <algorithm>
#include <array>
#include <exception>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include "server/http/connection.h"
#include "server/http/wire.h"

namespace dripfeed::http {

class Connection final : public ConnectionHandle, public std::enable_shared_from_this<Connection> {
 public:
  using Error = boost::beast::error_code;
  using Clock = std::chrono::steady_clock;

  Connection(boost::asio::ip::tcp::socket socket, Wire::TlsContext tls, ConnectionShared& shared);
  void start();
  void close() override;
  [[nodiscard]] const boost::asio::ip::address& peer() const override { return peer_; }
  [[nodiscard]] std::optional<Clock::time_point> waits_since() const override { return waits_since_; }

 private:
  // A handler that keeps the connection alive and stands inside its fence.
  template <class Step>
  auto fenced(Step step) {
    return [self = shared_from_this(), step = std::move(step)](auto... arguments) mutable {
      try {
        step(arguments...);
      } catch (const std::exception& error) {
        self->fail(error.what());
      }
    };
  }
  void fail(const char* what);

  // connection.cpp
  void read_next();
  void take_head();
  void on_head_parsed(Error error);
  void read_body();
  void on_read(Error error);
  void answer_in(Lane lane);
  bool take_room(std::size_t bytes, bool in_file);
  void give_room_back();
  void copy_headers();
  [[nodiscard]] bool is_proxy() const { return std::ranges::find(shared_.proxies, peer_) != shared_.proxies.end(); }
  void copy_forwarded();
  void refuse_unread(Error error);
  // Where the next request would begin is not known, or not waited for.
  void respond_unread(Response response);

  // connection_spool.cpp
  void spool_body();
  void read_piece();
  void on_piece(Error error);
  void on_written(const std::expected<void, std::string>& written);
  void refuse_upload(std::string_view why);

  // connection_write.cpp
  void respond(Response response);
  void count(const Response& response);
  void write_text(Response response);
  void write_head(const Response& response);
  void write_chunked_head(const Response& response, void (Connection::*next)());
  void write_chunk(std::string piece, void (Connection::*next)());
  void write_last_chunk();
  void write_source(Response response);
  void write_next_piece();
  void write_events(Response response);
  void watch_for_close();
  void on_events_ready();
  void write_next_events();
  void after_answer(Error error);
  void read_out();
  template <class Message>
  void fill_head(Message& message, const Response& response) const;

  Wire wire_;
  boost::asio::steady_timer timer_;
  ConnectionShared& shared_;
  Counted counted_;
  boost::asio::ip::address peer_;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::buffer_body>> long_parser_;  // of a spooled body
  std::optional<Clock::time_point> waits_since_;
  Request request_;
  Plan plan_;
  Clock::time_point read_at_{};              // its last byte, or when it was refused
  std::optional<Counted> at_work_;           // while it waits for its answer
  std::unique_ptr<SignIns::Place> sign_in_;  // while it waits for that of a sign-in
  std::optional<Counted> upload_;
  std::size_t room_bytes_ = 0;       // taken of the budget for bodies in memory
  std::size_t room_file_bytes_ = 0;  // and for those in files
  BodySource source_;
  std::shared_ptr<EventSubscription> events_;
  std::string piece_;
  std::array<char, 4096> probe_{};
  bool keep_alive_ = false;
  bool head_only_ = false;
  bool writing_events_ = false;
  bool comment_due_ = false;
  bool waits_for_disk_ = false;
};

// `detail` is one of our own sentences, so it needs no escapes.
Response plain_problem(unsigned status, std::string_view detail);

}  // namespace dripfeed::http
