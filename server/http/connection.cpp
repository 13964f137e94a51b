// Runs on the server's single HTTP thread, so it needs no lock; only heavy answers are made in the pool and come back
// by post. One write is in flight at a time. Events go out as chunks; a comment every 15 s keeps proxies and dead peers
// honest.
#include "server/http/connection.h"

#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <fmt/format.h>
#include <sys/resource.h>

namespace dripfeed::http {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace bhttp = boost::beast::http;

constexpr std::chrono::seconds kReadTimeout{60};
constexpr std::chrono::seconds kWriteTimeout{30};
constexpr std::chrono::seconds kLinger{2};
constexpr std::chrono::seconds kEventComment{15};
constexpr std::size_t kPieceBytes = std::size_t{64} << 10U;

// A pool thread steps back behind the links' thread before its first heavy request, so that a check never delays a
// feed. Linux keeps a nice value per thread; 0 names the calling one.
void lower_priority_once() {
  thread_local const int lowered = ::setpriority(PRIO_PROCESS, 0, 19);
  static_cast<void>(lowered);
}

Method method_of(bhttp::verb verb) {
  if (verb == bhttp::verb::get) return Method::get;
  if (verb == bhttp::verb::post) return Method::post;
  if (verb == bhttp::verb::put) return Method::put;
  return verb == bhttp::verb::delete_ ? Method::del : Method::other;
}

class Connection final : public ConnectionHandle, public std::enable_shared_from_this<Connection> {
 public:
  Connection(asio::ip::tcp::socket socket, const ConnectionShared& shared)
      : stream_(std::move(socket)), timer_(stream_.get_executor()), shared_(shared) {}

  void read_next() {
    parser_.emplace();
    parser_->body_limit(kBodyLimit);
    parser_->header_limit(static_cast<std::uint32_t>(kHeaderLimit));
    stream_.expires_after(kReadTimeout);
    bhttp::async_read_header(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](beast::error_code error, std::size_t) { self->on_header(error); });
  }

  void close() override {
    timer_.cancel();
    if (events_) events_->on_ready({});
    events_.reset();
    beast::error_code ignored;  // closing a closed socket is no news
    stream_.socket().close(ignored);
  }

 private:
  // A long body of somebody who may not send it is not read.
  void on_header(beast::error_code error) {
    head_only_ = false;
    if (error) return refuse_unread(error);
    auto& message = parser_->get();
    keep_alive_ = message.keep_alive();
    head_only_ = message.method() == bhttp::verb::head;
    request_ = {};
    request_.method = head_only_ ? Method::get : method_of(message.method());
    if (const std::string_view fault = framing_fault(message); !fault.empty()) {
      return respond_unread(plain_problem(400, fault));
    }
    if (!read_target(message.target(), request_)) {
      return respond_unread(plain_problem(400, "the path of the request is malformed"));
    }
    copy_headers(message, request_);
    if (parser_->chunked() || parser_->content_length().value_or(0) > kShortBody) {
      auto refusal = shared_.answerer.refuse_long(request_);
      if (refusal && !parser_->chunked()) return respond_unread(std::move(*refusal));
      if (refusal) parser_->body_limit(kShortBody);
    }
    bhttp::async_read(stream_, buffer_, *parser_,
                      [self = shared_from_this()](beast::error_code read, std::size_t) { self->on_read(read); });
  }

  // Where the next request would begin is not known, or not waited for.
  void respond_unread(Response response) {
    keep_alive_ = false;
    respond(std::move(response));
  }

  void refuse_unread(beast::error_code error) {
    if (error == bhttp::error::body_limit)
      return respond_unread(plain_problem(413, "the body of the request is too large"));
    if (error == bhttp::error::header_limit)
      return respond_unread(plain_problem(431, "the header of the request is too large"));
    if (error.category() == make_error_code(bhttp::error::bad_method).category() &&
        error != bhttp::error::end_of_stream && error != bhttp::error::partial_message) {
      return respond_unread(plain_problem(400, "this is not HTTP/1.1: " + error.message()));
    }
    close();
  }

  void on_read(beast::error_code error) {
    if (error) return refuse_unread(error);
    request_.body = std::move(parser_->get().body());
    stream_.expires_never();
    if (!shared_.answerer.is_heavy(request_)) return respond(shared_.answerer.answer(request_));
    request_.peer = stream_.socket().native_handle();
    asio::post(*shared_.pool, [self = shared_from_this(), request = std::move(request_)]() mutable {
      lower_priority_once();
      Response response = self->shared_.answerer.answer(request);
      asio::post(self->stream_.get_executor(),
                 [self, response = std::move(response)]() mutable { self->respond(std::move(response)); });
    });
  }

  // What the parser takes and RFC 9112 (3.2, 6.1) does not: no host or two, a coding of the body that is not ours.
  template <class Message>
  static std::string_view framing_fault(const Message& message) {
    if (message.version() >= 11 && message.count(bhttp::field::host) != 1) return "one Host is needed";
    const auto codings = message.count(bhttp::field::transfer_encoding);
    if (codings > 1 || (codings == 1 && !beast::iequals(message[bhttp::field::transfer_encoding], "chunked")))
      return "a body comes as it is or chunked";
    return {};
  }

  template <class Message>
  static void copy_headers(const Message& message, Request& request) {
    const auto take = [&](bhttp::field field) { return std::string(message[field]); };
    request.authorization = take(bhttp::field::authorization);
    request.cookie = take(bhttp::field::cookie);
    request.if_match = take(bhttp::field::if_match);
    request.idempotency_key = std::string(message["Idempotency-Key"]);
    request.last_event_id = std::string(message["Last-Event-ID"]);
    request.origin = take(bhttp::field::origin);
    request.host = take(bhttp::field::host);
    request.fetch_site = std::string(message["Sec-Fetch-Site"]);
    request.content_type = take(bhttp::field::content_type);
    request.content_encoding = take(bhttp::field::content_encoding);
  }

  // `detail` is one of our own sentences, so it needs no escapes.
  static Response plain_problem(unsigned status, std::string_view detail) {
    Response response;
    response.status = status;
    response.content_type = "application/problem+json";
    response.body =
        fmt::format(R"({{"type":"about:blank","title":"bad request","status":{},"detail":"{}"}})", status, detail);
    return response;
  }

  template <class Message>
  void fill_head(Message& message, const Response& response) const {
    message.result(response.status);
    message.version(11);
    message.keep_alive(keep_alive_);
    if (!response.content_type.empty()) message.set(bhttp::field::content_type, response.content_type);
    message.set("X-Content-Type-Options", "nosniff");
    message.set(bhttp::field::cache_control, "no-store");  // unless the answer says otherwise
    for (const auto& [name, value] : response.headers) message.set(name, value);
  }

  void respond(Response response) {
    if (head_only_) return write_head(response);
    if (response.events) return write_events(std::move(response));
    if (response.source) return write_source(std::move(response));
    write_text(std::move(response));
  }

  void write_text(Response response) {
    auto message = std::make_shared<bhttp::response<bhttp::string_body>>();
    fill_head(*message, response);
    message->body() = std::move(response.body);
    if (response.status != 204) message->prepare_payload();  // a 204 says nothing of a length
    stream_.expires_after(kWriteTimeout);
    bhttp::async_write(stream_, *message, [self = shared_from_this(), message](beast::error_code error, std::size_t) {
      self->after_answer(error);
    });
  }

  void after_answer(beast::error_code error) {
    if (error) return close();
    if (keep_alive_) return read_next();
    // Closing with bytes unread would reset the connection, and the client might never see the answer.
    stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, error);
    stream_.expires_after(kLinger);
    read_out();
  }

  void read_out() {
    stream_.async_read_some(asio::buffer(probe_), [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->close();
      self->read_out();
    });
  }

  // HEAD: as GET, without the body.
  void write_head(const Response& response) {
    auto message = std::make_shared<bhttp::response<bhttp::empty_body>>();
    fill_head(*message, response);
    if (response.events || response.source) {
      message->chunked(true);
    } else if (response.status != 204) {
      message->content_length(response.body.size());
    }
    auto serializer = std::make_shared<bhttp::response_serializer<bhttp::empty_body>>(*message);
    stream_.expires_after(kWriteTimeout);
    bhttp::async_write_header(stream_, *serializer,
                              [self = shared_from_this(), message, serializer](beast::error_code error, std::size_t) {
                                self->after_answer(error);
                              });
  }

  // The head of a chunked answer, then `next`.
  void write_chunked_head(const Response& response, void (Connection::*next)()) {
    auto message = std::make_shared<bhttp::response<bhttp::empty_body>>();
    fill_head(*message, response);
    message->chunked(true);
    auto serializer = std::make_shared<bhttp::response_serializer<bhttp::empty_body>>(*message);
    stream_.expires_after(kWriteTimeout);
    bhttp::async_write_header(
        stream_, *serializer,
        [self = shared_from_this(), message, serializer, next](beast::error_code error, std::size_t) {
          if (error) return self->close();
          (self.get()->*next)();
        });
  }

  void write_chunk(std::string piece, void (Connection::*next)()) {
    piece_ = std::move(piece);
    stream_.expires_after(kWriteTimeout);
    asio::async_write(stream_, bhttp::make_chunk(asio::buffer(piece_)),
                      [self = shared_from_this(), next](beast::error_code error, std::size_t) {
                        if (error) return self->close();
                        self->stream_.expires_never();
                        (self.get()->*next)();
                      });
  }

  void write_source(Response response) {
    source_ = std::move(response.source);
    write_chunked_head(response, &Connection::write_next_piece);
  }

  void write_next_piece() {
    std::string piece(kPieceBytes, '\0');
    const auto count = source_(std::span(piece.data(), piece.size()));
    if (!count) return close();  // no last chunk: the client sees that the body is torn
    if (*count > 0) {
      piece.resize(*count);
      return write_chunk(std::move(piece), &Connection::write_next_piece);
    }
    source_ = nullptr;
    asio::async_write(stream_, bhttp::make_chunk_last(),
                      [self = shared_from_this()](beast::error_code error, std::size_t) { self->after_answer(error); });
  }

  void write_events(Response response) {
    events_ = std::move(response.events);
    keep_alive_ = false;
    events_->on_ready([weak = weak_from_this(), executor = stream_.get_executor()] {
      asio::post(executor, [weak] {
        if (const auto self = weak.lock()) self->on_events_ready();
      });
    });
    watch_for_close();
    writing_events_ = true;
    write_chunked_head(response, &Connection::write_next_events);
  }

  // A watcher sends nothing more: any byte or end of stream from it closes the connection.
  void watch_for_close() {
    stream_.async_read_some(asio::buffer(probe_),
                            [self = shared_from_this()](beast::error_code, std::size_t) { self->close(); });
  }

  void on_events_ready() {
    if (!events_ || writing_events_) return;
    timer_.cancel();
    write_next_events();
  }

  void write_next_events() {
    writing_events_ = false;
    if (!events_) return;
    std::string ready = events_->take();
    if (ready.empty() && comment_due_) ready = ": alive\n\n";
    comment_due_ = false;
    if (!ready.empty()) {
      writing_events_ = true;
      return write_chunk(std::move(ready), &Connection::write_next_events);
    }
    stream_.expires_never();
    const auto due = events_->due_after();
    timer_.expires_after(due ? std::chrono::steady_clock::duration(*due) : kEventComment);
    timer_.async_wait([self = shared_from_this(), comment = !due](beast::error_code error) {
      if (error || self->writing_events_) return;
      self->comment_due_ = comment;
      self->write_next_events();
    });
  }

  beast::tcp_stream stream_;
  asio::steady_timer timer_;
  const ConnectionShared& shared_;
  beast::flat_buffer buffer_;
  std::optional<bhttp::request_parser<bhttp::string_body>> parser_;
  Request request_;
  BodySource source_;
  std::shared_ptr<EventSubscription> events_;
  std::string piece_;
  std::array<char, 4096> probe_{};
  bool keep_alive_ = false;
  bool head_only_ = false;
  bool writing_events_ = false;
  bool comment_due_ = false;
};

}  // namespace

std::weak_ptr<ConnectionHandle> serve(asio::ip::tcp::socket socket, const ConnectionShared& shared) {
  const auto connection = std::make_shared<Connection>(std::move(socket), shared);
  connection->read_next();
  return connection;
}

}  // namespace dripfeed::http
