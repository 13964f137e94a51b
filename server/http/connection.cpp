// From bytes to a request, and to the lane that answers it. What RFC 9112 refuses and the parser takes is refused here,
// because two who read one stream differently are how requests are smuggled.
#include "server/http/connection.h"

#include <algorithm>
#include <chrono>

#include <boost/asio/post.hpp>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/read.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/http/connection_state.h"
#include "server/json/problem_codes.h"

namespace dripfeed::http {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace bhttp = boost::beast::http;

constexpr std::chrono::seconds kReadTimeout{60};
constexpr std::chrono::seconds kHandshakeTimeout{10};
constexpr std::size_t kSlowest_bytes_s = std::size_t{32} * 1024;  // of a body
constexpr std::size_t kReadAtOnce_bytes = 4096;
constexpr std::string_view kHeadEnd = "\r\n\r\n";

Method method_of(bhttp::verb verb) {
  if (verb == bhttp::verb::get) return Method::get;
  if (verb == bhttp::verb::post) return Method::post;
  if (verb == bhttp::verb::put) return Method::put;
  if (verb == bhttp::verb::patch) return Method::patch;
  return verb == bhttp::verb::delete_ ? Method::del : Method::other;
}

// A line that goes on in the next one (obs-fold) is read as one header by some and as two by others.
bool has_folded_line(std::string_view head) {
  return head.find("\r\n ") != std::string_view::npos || head.find("\r\n\t") != std::string_view::npos;
}

// What the parser takes and RFC 9112 (3.2, 6.1) does not: no host or two, a coding of the body that is not ours.
template <class Message>
std::string_view framing_fault(const Message& message) {
  if (message.version() >= 11 && message.count(bhttp::field::host) != 1) return "exactly one Host header is needed";
  const auto codings = message.count(bhttp::field::transfer_encoding);
  if (codings > 1 || (codings == 1 && !beast::iequals(message[bhttp::field::transfer_encoding], "chunked")))
    return "a body must be unencoded or chunked";
  return {};
}

// The last of a list, which the proxy next to us wrote.
std::string last_of(std::string_view list) {
  if (const std::size_t comma = list.rfind(','); comma != std::string_view::npos) list.remove_prefix(comma + 1);
  while (list.starts_with(' ')) list.remove_prefix(1);
  while (list.ends_with(' ')) list.remove_suffix(1);
  return std::string(list);
}

}  // namespace

Response plain_problem(unsigned status, std::string_view detail) {
  const json::ProblemCode& code = json::problem_code(status, detail);
  Response response;
  response.status = status;
  response.content_type = "application/problem+json";
  response.body = fmt::format(R"({{"type":"about:blank","title":"{}","status":{},"code":"{}","detail":"{}"}})",
                              code.title, status, code.code, detail);
  if (code.retry_s != 0) response.headers.emplace_back("Retry-After", fmt::format("{}", code.retry_s));
  return response;
}

Connection::Connection(asio::ip::tcp::socket socket, Wire::TlsContext tls, ConnectionShared& shared)
    : wire_(std::move(socket), std::move(tls)),
      timer_(wire_.get_executor()),
      shared_(shared),
      counted_(shared.traffic->connections) {
  Error gone;  // then it is refused by the first read
  const auto endpoint = wire_.lowest().socket().remote_endpoint(gone);
  if (!gone) peer_ = endpoint.address();
  // An answer leaves with its last byte, not when the peer has acknowledged the first.
  wire_.lowest().socket().set_option(asio::ip::tcp::no_delay(true), gone);
}

void Connection::start() {
  waits_since_ = Clock::now();
  if (wire_.tls() == nullptr) return read_next();
  wire_.lowest().expires_after(kHandshakeTimeout);
  wire_.tls()->async_handshake(asio::ssl::stream_base::server, fenced([this](Error error) {
                                 if (error) return close();
                                 read_next();
                               }));
}

void Connection::close() {
  timer_.cancel();
  if (events_) events_->on_ready({});
  events_.reset();
  source_ = nullptr;
  request_.spooled.reset();
  give_room_back();
  Error ignored;  // closing a closed socket is no news
  wire_.lowest().socket().close(ignored);
}

void Connection::fail(const char* what) {
  spdlog::error("HTTP: the connection from {} is closed: {}", peer_.to_string(), what);
  close();
}

void Connection::read_next() {
  parser_.emplace();
  parser_->body_limit(kLargeBody_bytes);
  parser_->header_limit(static_cast<std::uint32_t>(kHeaderLimit_bytes));
  waits_since_ = Clock::now();
  wire_.lowest().expires_after(kReadTimeout);
  take_head();
}

// The head is looked at whole, before the parser joins what is folded.
void Connection::take_head() {
  const auto bytes = buffer_.data();
  const std::string_view read(static_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t end = read.find(kHeadEnd);
  if (end != std::string_view::npos || read.size() > kHeaderLimit_bytes) {
    if (has_folded_line(read.substr(0, end)))
      return respond_unread(plain_problem(400, "a header must stand on one line"));
    Error error;
    buffer_.consume(parser_->put(bytes, error));
    if (error == bhttp::error::need_more) error = bhttp::error::header_limit;
    return on_head_parsed(error);
  }
  wire_.async_read_some(buffer_.prepare(kReadAtOnce_bytes), fenced([this](Error error, auto count) {
                          if (error) return close();
                          buffer_.commit(static_cast<std::size_t>(count));
                          take_head();
                        }));
}

// A long body of someone who may not send it is not read.
void Connection::on_head_parsed(Error error) {
  head_only_ = false;
  plan_ = {};
  read_at_ = {};
  if (error) return refuse_unread(error);
  auto& message = parser_->get();
  keep_alive_ = message.keep_alive();
  head_only_ = message.method() == bhttp::verb::head;
  request_ = {};
  request_.method = head_only_ ? Method::get : method_of(message.method());
  if (const std::string_view fault = framing_fault(message); !fault.empty())
    return respond_unread(plain_problem(400, fault));
  if (!read_target(message.target(), request_))
    return respond_unread(plain_problem(400, "the path of the request is malformed"));
  copy_headers();
  plan_ = shared_.answerer.plan(request_);
  read_body();
}

void Connection::read_body() {
  const bool chunked = parser_->chunked();
  const std::uint64_t length = parser_->content_length().value_or(0);
  std::size_t limit = plan_.body_limit_bytes;
  if (chunked || length > kShortBody_bytes) {
    auto refusal = shared_.answerer.refuse_long(request_);
    if (refusal && !chunked) return respond_unread(std::move(*refusal));
    if (refusal) limit = kShortBody_bytes;
  }
  if (length > limit)
    return respond_unread(plain_problem(413, fmt::format("the body is too large: this path takes {} bytes", limit)));
  parser_->body_limit(limit);
  const std::size_t most = chunked ? limit : static_cast<std::size_t>(length);
  const bool in_file = most > kSmallBody_bytes;
  if (!take_room(most, in_file))
    return respond_unread(plain_problem(503, "too many large requests are being read: send this one again"));
  if (parser_->is_done()) return on_read({});
  wire_.lowest().expires_after(kReadTimeout + std::chrono::seconds(most / kSlowest_bytes_s));
  if (in_file) return spool_body();
  bhttp::async_read(wire_, buffer_, *parser_, fenced([this](Error error, auto) { on_read(error); }));
}

void Connection::on_read(Error error) {
  if (error) return refuse_unread(error);
  waits_since_.reset();
  read_at_ = Clock::now();
  at_work_.emplace(shared_.traffic->at_work(plan_.lane));
  if (!request_.spooled) request_.body = std::move(parser_->get().body());
  wire_.lowest().expires_never();
  // Whoever is a proxy brings the requests of many.
  SignIns* const sign_ins = plan_.lane == Lane::secret     ? &shared_.sign_ins
                            : plan_.lane == Lane::provider ? &shared_.provider_sign_ins
                                                           : nullptr;
  if (sign_ins != nullptr && !is_proxy()) {
    sign_in_ = sign_ins->take(peer_);
    if (!sign_in_)
      return respond_unread(plain_problem(503,
                                          "too many sign-ins and changes of tokens or passwords from this address are "
                                          "waiting: send this one again"));
  }
  if (plan_.lane != Lane::here) return answer_in(plan_.lane);
  respond(shared_.answerer.answer(request_));
}

void Connection::answer_in(Lane lane) {
  request_.peer = wire_.lowest().socket().native_handle();
  const bool taken = shared_.lanes->submit(
      lane, [self = shared_from_this(), request = std::move(request_), fetches = plan_.fetches_body]() mutable {
        const auto fetched = fetches ? fetch_body(request) : std::expected<void, std::string>();
        Response response = fetched ? self->shared_.answerer.answer(request) : plain_problem(507, fetched.error());
        asio::post(self->wire_.get_executor(),
                   self->fenced([connection = self.get(), answer = std::move(response)]() mutable {
                     connection->respond(std::move(answer));
                   }));
      });
  if (!taken) respond_unread(plain_problem(503, "too many requests of this kind are waiting: send this one again"));
}

// Of what all bodies may take together. Short ones are not counted.
bool Connection::take_room(std::size_t bytes, bool in_file) {
  if (bytes <= kShortBody_bytes) return true;
  Traffic::Count& all = in_file ? shared_.traffic->spooled_bytes : shared_.traffic->body_bytes;
  if (bytes > (in_file ? kSpoolBudget_bytes : kBodyBudget_bytes) - all) return false;
  (in_file ? room_file_bytes_ : room_bytes_) = bytes;
  all += bytes;
  if (in_file) upload_.emplace(shared_.traffic->uploads);
  return true;
}

void Connection::give_room_back() {
  shared_.traffic->body_bytes -= std::exchange(room_bytes_, 0);
  shared_.traffic->spooled_bytes -= std::exchange(room_file_bytes_, 0);
  upload_.reset();
}

void Connection::respond_unread(Response response) {
  keep_alive_ = false;
  respond(std::move(response));
}

void Connection::refuse_unread(Error error) {
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

void Connection::copy_headers() {
  const auto& message = parser_->get();
  const auto take = [&](bhttp::field field) { return std::string(message[field]); };
  request_.authorization = take(bhttp::field::authorization);
  request_.cookie = take(bhttp::field::cookie);
  request_.if_match = take(bhttp::field::if_match);
  request_.if_none_match = take(bhttp::field::if_none_match);
  request_.accept_encoding = take(bhttp::field::accept_encoding);
  request_.shown_user = std::string(message["X-Dripfeed-User"]);
  request_.idempotency_key = std::string(message["Idempotency-Key"]);
  request_.last_event_id = std::string(message["Last-Event-ID"]);
  request_.accept = take(bhttp::field::accept);
  request_.origin = take(bhttp::field::origin);
  request_.host = take(bhttp::field::host);
  request_.fetch_site = std::string(message["Sec-Fetch-Site"]);
  request_.content_type = take(bhttp::field::content_type);
  request_.content_encoding = take(bhttp::field::content_encoding);
  request_.is_encrypted = wire_.tls() != nullptr;
  copy_forwarded();
}

void Connection::copy_forwarded() {
  if (!is_proxy()) return;
  const auto& message = parser_->get();
  request_.forwarded_host = last_of(std::string_view(message["X-Forwarded-Host"]));
  if (beast::iequals(last_of(std::string_view(message["X-Forwarded-Proto"])), "https")) request_.is_encrypted = true;
}

std::weak_ptr<ConnectionHandle> serve(asio::ip::tcp::socket socket, std::shared_ptr<asio::ssl::context> tls,
                                      ConnectionShared& shared) {
  const auto connection = std::make_shared<Connection>(std::move(socket), std::move(tls), shared);
  connection->start();
  return connection;
}

}  // namespace dripfeed::http
