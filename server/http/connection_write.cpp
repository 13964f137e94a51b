// From an answer to bytes. One write is in flight at a time. Long texts and events go out as chunks; a comment every
// 15 s keeps proxies and dead peers honest.
#include <algorithm>
#include <chrono>

#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/chunk_encode.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/write.hpp>
#include <spdlog/spdlog.h>

#include "server/http/connection_state.h"

namespace dripfeed::http {

namespace {

namespace asio = boost::asio;
namespace bhttp = boost::beast::http;

constexpr std::chrono::seconds kWriteTimeout{30};
constexpr std::chrono::seconds kLinger{2};
constexpr std::chrono::seconds kEventComment{15};
constexpr std::size_t kPieceBytes = std::size_t{64} << 10U;
constexpr std::size_t kLongestHeader_bytes = 8192;

// Beast throws where a header is too long, and writes a line break as it stands.
bool is_header(std::string_view value) {
  return value.size() <= kLongestHeader_bytes &&
         std::ranges::none_of(value, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; });
}

bool has_good_headers(const Response& response) {
  return is_header(response.content_type) &&
         std::ranges::all_of(response.headers, [](const auto& header) { return is_header(header.second); });
}

// These two say nothing of a length.
bool may_have_body(const Response& response) { return response.status != 204 && response.status != 304; }

}  // namespace

template <class Message>
void Connection::fill_head(Message& message, const Response& response) const {
  message.result(response.status);
  message.version(11);
  message.keep_alive(keep_alive_);
  if (!response.content_type.empty()) message.set(bhttp::field::content_type, response.content_type);
  message.set("X-Content-Type-Options", "nosniff");
  // One name may come more than once: each cookie has a header of its own (RFC 6265, 3).
  for (const auto& [name, value] : response.headers) message.insert(name, value);
  if (message.count(bhttp::field::cache_control) == 0) message.set(bhttp::field::cache_control, "no-store");
}

// What was refused before it was read whole took no time of ours.
void Connection::count(const Response& response) {
  at_work_.reset();
  sign_in_.reset();
  const auto took = read_at_ == Clock::time_point{} ? Clock::duration{} : Clock::now() - read_at_;
  shared_.traffic->answered(plan_.route, plan_.lane, response.status, took);
}

void Connection::respond(Response response) {
  give_room_back();
  if (!has_good_headers(response)) {
    spdlog::error("HTTP: {} has an answer with a header that cannot be sent", request_.target);
    response = plain_problem(500, "the answer has a header that cannot be sent");
  }
  count(response);
  waits_since_ = Clock::now();  // for the peer to read
  if (head_only_) return write_head(response);
  if (response.events) return write_events(std::move(response));
  if (response.source) return write_source(std::move(response));
  write_text(std::move(response));
}

void Connection::write_text(Response response) {
  auto message = std::make_shared<bhttp::response<bhttp::string_body>>();
  fill_head(*message, response);
  message->body() = std::move(response.body);
  if (may_have_body(response)) message->prepare_payload();
  wire_.lowest().expires_after(kWriteTimeout);
  bhttp::async_write(wire_, *message, fenced([this, message](Error error, auto) { after_answer(error); }));
}

void Connection::after_answer(Error error) {
  if (error) return close();
  if (keep_alive_) return read_next();
  waits_since_ = Clock::now();
  wire_.lowest().expires_after(kLinger);
  if (wire_.tls() != nullptr) {
    wire_.tls()->async_shutdown(fenced([this](Error) { close(); }));
    return;
  }
  // Closing with bytes unread would reset the connection, and the client might never see the answer.
  wire_.lowest().socket().shutdown(asio::ip::tcp::socket::shutdown_send, error);
  read_out();
}

void Connection::read_out() {
  wire_.async_read_some(asio::buffer(probe_), fenced([this](Error error, auto) {
                          if (error) return close();
                          read_out();
                        }));
}

// HEAD: as GET, without the body.
void Connection::write_head(const Response& response) {
  auto message = std::make_shared<bhttp::response<bhttp::empty_body>>();
  fill_head(*message, response);
  if (response.events || response.source) {
    message->chunked(true);
  } else if (may_have_body(response)) {
    message->content_length(response.body.size());
  }
  auto serializer = std::make_shared<bhttp::response_serializer<bhttp::empty_body>>(*message);
  wire_.lowest().expires_after(kWriteTimeout);
  bhttp::async_write_header(wire_, *serializer,
                            fenced([this, message, serializer](Error error, auto) { after_answer(error); }));
}

// The head of a chunked answer, then `next`.
void Connection::write_chunked_head(const Response& response, void (Connection::*next)()) {
  auto message = std::make_shared<bhttp::response<bhttp::empty_body>>();
  fill_head(*message, response);
  message->chunked(true);
  auto serializer = std::make_shared<bhttp::response_serializer<bhttp::empty_body>>(*message);
  wire_.lowest().expires_after(kWriteTimeout);
  bhttp::async_write_header(wire_, *serializer, fenced([this, message, serializer, next](Error error, auto) {
                              if (error) return close();
                              (this->*next)();
                            }));
}

void Connection::write_chunk(std::string piece, void (Connection::*next)()) {
  piece_ = std::move(piece);
  wire_.lowest().expires_after(kWriteTimeout);
  asio::async_write(wire_, bhttp::make_chunk(asio::buffer(piece_)), fenced([this, next](Error error, auto) {
                      if (error) return close();
                      wire_.lowest().expires_never();
                      (this->*next)();
                    }));
}

void Connection::write_last_chunk() {
  wire_.lowest().expires_after(kWriteTimeout);
  asio::async_write(wire_, bhttp::make_chunk_last(), fenced([this](Error error, auto) { after_answer(error); }));
}

void Connection::write_source(Response response) {
  source_ = std::move(response.source);
  write_chunked_head(response, &Connection::write_next_piece);
}

void Connection::write_next_piece() {
  if (!source_) return close();  // closed meanwhile
  std::string piece(kPieceBytes, '\0');
  const auto count = source_(std::span(piece.data(), piece.size()));
  if (!count) return close();  // no last chunk: the client sees that the body is torn
  if (*count > 0) {
    piece.resize(*count);
    waits_since_ = Clock::now();
    return write_chunk(std::move(piece), &Connection::write_next_piece);
  }
  source_ = nullptr;
  write_last_chunk();
}

void Connection::write_events(Response response) {
  events_ = std::move(response.events);
  keep_alive_ = false;
  waits_since_.reset();
  events_->on_ready([weak = weak_from_this(), executor = wire_.get_executor()] {
    asio::post(executor, [weak] {
      if (const auto self = weak.lock()) self->fenced([connection = self.get()] { connection->on_events_ready(); })();
    });
  });
  watch_for_close();
  writing_events_ = true;
  write_chunked_head(response, &Connection::write_next_events);
}

// A watcher sends nothing more: any byte or end of stream from it closes the connection.
void Connection::watch_for_close() {
  wire_.async_read_some(asio::buffer(probe_), fenced([this](Error, auto) { close(); }));
}

void Connection::on_events_ready() {
  if (!events_ || writing_events_) return;
  timer_.cancel();
  write_next_events();
}

void Connection::write_next_events() {
  writing_events_ = false;
  if (!events_) return;
  if (events_->ended()) return close();
  std::string ready = events_->take();
  if (ready.empty() && comment_due_) ready = ": alive\n\n";
  comment_due_ = false;
  if (!ready.empty()) {
    writing_events_ = true;
    return write_chunk(std::move(ready), &Connection::write_next_events);
  }
  wire_.lowest().expires_never();
  timer_.expires_after(kEventComment);
  timer_.async_wait(fenced([this](Error error) {
    if (error || writing_events_) return;
    comment_due_ = true;
    write_next_events();
  }));
}

}  // namespace dripfeed::http
