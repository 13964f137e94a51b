// Requests to other systems. What the application needs of an HTTP client: many at once on the caller's thread, each
// with an end in a known time, none to an address that was not meant.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dripfeed::app {

enum class HttpVerb : std::uint8_t { post, get };

struct HttpCall {
  HttpVerb verb = HttpVerb::post;
  std::string url{};
  std::vector<std::pair<std::string, std::string>> headers{};
  std::string body{};                         // of a post
  bool local = false;                         // may go to this computer and to private networks
  std::chrono::milliseconds at_most{20'000};  // until it ends, and not longer than that
  std::size_t keeps_bytes = 0;                // of the answer's body, from its start; kMostOfAnswer_bytes at most
};
inline constexpr std::size_t kMostOfAnswer_bytes = std::size_t{64} * 1024;  // longer answers are cut

// Of a call that ended.
struct HttpOutcome {
  std::uint64_t ticket = 0;
  std::uint32_t status = 0;  // 0: no answer came
  std::string error{};       // why not
  std::string body{};        // of the answer, as much as the call keeps
};

// All but wake() on one thread.
class HttpSender {
 public:
  HttpSender() = default;
  HttpSender(const HttpSender&) = delete;
  HttpSender& operator=(const HttpSender&) = delete;
  virtual ~HttpSender() = default;  // gives up what is on

  // "" or what is wrong with a URL as a target, as the end of a sentence: "must be https". From any thread.
  [[nodiscard]] virtual std::string why_no_target(const std::string& url, bool local) const = 0;
  // Begins one. It ends within 20 s; a redirect is an answer as any other.
  virtual void begin(std::uint64_t ticket, const HttpCall& call) = 0;
  // Works on all that are on, for so long or until one has ended; those that ended.
  virtual std::vector<HttpOutcome> work(std::chrono::milliseconds at_most) = 0;
  // From any thread: work() returns soon.
  virtual void wake() = 0;
};
using MakeHttpSender = std::function<std::unique_ptr<HttpSender>()>;

}  // namespace dripfeed::app
