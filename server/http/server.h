// The listener: accepts connections on one address and has each request answered by a function. It owns the HTTP thread
// and the lanes of threads that answer; nothing here runs on a link's thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/http/lanes.h"
#include "server/http/request.h"
#include "server/http/traffic.h"

namespace dripfeed::http {

inline constexpr std::size_t kSmallBody_bytes = std::size_t{1} << 20U;     // of most requests
inline constexpr std::size_t kLargeBody_bytes = std::size_t{64} << 20U;    // of those that carry a text
inline constexpr std::size_t kShortBody_bytes = std::size_t{64} << 10U;    // is read whoever sends it
inline constexpr std::size_t kBodyBudget_bytes = std::size_t{256} << 20U;  // of all bodies in memory at one time
inline constexpr std::size_t kSpoolBudget_bytes = std::size_t{2}
                                                  << 30U;  // of all that lie in files: beyond kSmallBody_bytes
inline constexpr std::size_t kHeaderLimit_bytes = std::size_t{16} << 10U;

struct ListenAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 8840;  // 0: any free one, see Server::port
};

// "127.0.0.1:8840", "[::1]:8840", ":8840" (loopback); or one sentence that says what is wrong.
std::expected<ListenAddress, std::string> parse_listen_address(std::string_view text);
bool is_loopback(const ListenAddress& address);
bool is_ip_address(const std::string& text);

// Where a request is answered, and how long its body may be; known from its head.
struct Plan {
  Lane lane = Lane::here;
  std::size_t body_limit_bytes = kShortBody_bytes;
  std::size_t route = SIZE_MAX;  // its place in the table, for the counts; SIZE_MAX: none
  bool fetches_body = true;      // false: a long body stays in its file
};

// `answer` gives the response, on a thread of the lane that `plan` names; `refuse_long` is asked with the head of a
// request, before a body beyond kShortBody_bytes is read. All must be safe to call from several threads.
struct Answerer {
  std::function<Plan(const Request&)> plan;
  std::function<std::optional<Response>(const Request&)> refuse_long;
  std::function<Response(const Request&)> answer;
};

struct ServerSettings {
  ListenAddress address;
  std::filesystem::path spool_folder;  // for long bodies that arrive; made when it is needed
  // PEM files; empty: plain HTTP. Read again when they change.
  std::string tls_certificate;
  std::string tls_key;
  unsigned heavy_threads = 2;          // see Lanes
  std::vector<std::string> proxies;    // IP addresses whose X-Forwarded-Host and X-Forwarded-Proto are believed
  std::shared_ptr<Traffic> traffic{};  // where it counts; nullptr: nowhere
};

class Server {
 public:
  // Binds and starts; or one sentence that says what is wrong: what the system said of the address, what OpenSSL said
  // of the certificate, which proxy is not an address.
  static std::expected<std::unique_ptr<Server>, std::string> start(const ServerSettings& settings, Answerer answerer);
  virtual ~Server() = default;  // stop() must have said true, or was never called: then it waits for all work
  [[nodiscard]] virtual std::uint16_t port() const = 0;
  // From any thread: from the next request on. Nothing changes where one is not an address; the sentence states which.
  virtual std::expected<void, std::string> set_proxies(const std::vector<std::string>& proxies) = 0;
  // Closes the listener and every connection: no request comes in any more.
  virtual void close() = 0;
  // close(), then gives the requests at work so much time. False when one still runs: see Lanes::stop.
  virtual bool stop(std::chrono::milliseconds at_most) = 0;

  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

 protected:
  Server() = default;
};

}  // namespace dripfeed::http
