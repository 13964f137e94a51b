// The listener: accepts connections on one address and has each request answered by a function. It owns the HTTP thread
// and the pool of heavy requests; nothing here runs on a link's thread.
#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "server/http/request.h"

namespace dripfeed::http {

inline constexpr std::size_t kBodyLimit = std::size_t{64} << 20U;  // bytes of a request's body
inline constexpr std::size_t kShortBody = std::size_t{64} << 10U;  // is read whoever sends it
inline constexpr std::size_t kHeaderLimit = std::size_t{16} << 10U;

struct ListenAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 8840;  // 0: any free one, see Server::port
};

// "127.0.0.1:8840", "[::1]:8840", ":8840" (loopback); or one sentence that says what is wrong.
std::expected<ListenAddress, std::string> parse_listen_address(std::string_view text);
bool is_loopback(const ListenAddress& address);

// `answer` gives the response at once; `is_heavy` says that it is to be called from the pool instead; `refuse_long`
// is asked with the head of a request, before a body beyond kShortBody is read. All must be safe to call from several
// threads.
struct Answerer {
  std::function<std::optional<Response>(const Request&)> refuse_long;
  std::function<bool(const Request&)> is_heavy;
  std::function<Response(const Request&)> answer;
};

class Server {
 public:
  // Binds and starts; or what the system said, with the address.
  static std::expected<std::unique_ptr<Server>, std::string> start(const ListenAddress& address, Answerer answerer);
  virtual ~Server() = default;  // stops, closes every connection, joins
  [[nodiscard]] virtual std::uint16_t port() const = 0;

  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

 protected:
  Server() = default;
};

}  // namespace dripfeed::http
