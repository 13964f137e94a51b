// A request and its answer as the handlers see them: no socket, no Beast. Header names are given by what they are for;
// a handler never looks for others.
#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/http/event_stream.h"

namespace dripfeed::http {

class SpooledBody;

enum class Method : std::uint8_t { get, post, put, del, patch, other };
std::string_view name_of(Method method);

struct Request {
  Method method = Method::get;
  std::string target;                        // as sent
  std::vector<std::string> path;             // decoded segments after the leading slash
  std::map<std::string, std::string> query;  // decoded
  std::string authorization;
  std::string cookie;
  std::string if_match;
  std::string if_none_match;
  std::string accept_encoding;
  std::string idempotency_key;
  std::string last_event_id;
  std::string accept;
  std::string shown_user;  // X-Dripfeed-User: whose name the page shows; "" where it says nothing
  std::string origin;
  std::string host;
  std::string forwarded_host;  // as a trusted proxy says; "" without one
  std::string fetch_site;      // Sec-Fetch-Site
  bool is_encrypted = false;   // TLS up to us, or up to a trusted proxy
  std::string content_type;
  std::string content_encoding;
  std::string body;
  std::shared_ptr<SpooledBody> spooled;  // a long body before it is fetched into `body`; see fetch_body(). One that
                                         // is a file is not fetched
  int peer = -1;  // the socket, for work that is given up when the client leaves; it is open until the answer
};

// Fetches a long body, for whoever may wait for the disk. Errors: as SpooledBody::read().
std::expected<void, std::string> fetch_body(Request& request);

// The body in pieces, wherever it lies, for whoever may wait for the disk: fills what it is given from the front and
// says how much, 0 at the end. Holds as long as the request. Errors: as SpooledBody::read().
using BodyPieces = std::function<std::expected<std::size_t, std::string>(std::span<char>)>;
BodyPieces pieces_of(const Request& request);
std::uint64_t body_bytes(const Request& request);

// Gives the next piece of a long body: how many bytes it wrote, 0 at the end, or what failed (then the connection is
// cut, so that a half text never looks whole).
using BodySource = std::function<std::expected<std::size_t, std::string>(std::span<char>)>;

struct Response {
  unsigned status = 200;
  std::string content_type = "application/json";
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  BodySource source;                          // instead of `body`, sent chunked
  std::shared_ptr<EventSubscription> events;  // instead of both: a text/event-stream until either side closes
};

// Splits and decodes the target of a request. Nothing when an escape is broken or a segment is "." or "..".
bool read_target(std::string_view target, Request& request);
// Percent-decoded as a segment of a path is. Nothing when an escape is broken.
std::optional<std::string> decode_segment(std::string_view text);

}  // namespace dripfeed::http
