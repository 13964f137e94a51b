// One multi handle; names are resolved by libcurl's own threads. The address is looked at where its socket is made, so
// what was allowed is what is connected to. No redirect is followed, no proxy of the environment is used, and no
// connection is used twice: the next webhook may be allowed less.
#include "server/io/http_sender.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include <boost/asio/ip/address.hpp>
#include <curl/curl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include "server/io/target_address.h"

namespace dripfeed::io {

namespace {

namespace ip = boost::asio::ip;

constexpr long kAtMost_ms = 20'000;
constexpr long kConnect_ms = 10'000;

struct Close {
  void operator()(CURL* handle) const { curl_easy_cleanup(handle); }
  void operator()(curl_slist* list) const { curl_slist_free_all(list); }
  void operator()(CURLU* url) const { curl_url_cleanup(url); }
};
using Easy = std::unique_ptr<CURL, Close>;
using HeaderList = std::unique_ptr<curl_slist, Close>;
using Url = std::unique_ptr<CURLU, Close>;

// One call that is on. It does not move: libcurl knows its address.
struct Transfer {
  std::uint64_t ticket = 0;
  bool local = false;
  std::string refused;  // the address that it may not go to
  std::size_t answered_bytes = 0;
  std::size_t keeps_bytes = 0;
  std::string answer;
  std::array<char, CURL_ERROR_SIZE> error{};
  HeaderList headers;
  Easy easy;
};

std::optional<ip::address> address_of(const sockaddr& address) {
  if (address.sa_family == AF_INET) {
    ip::address_v4::bytes_type bytes{};
    const auto* const v4 = reinterpret_cast<const sockaddr_in*>(&address);
    std::copy_n(reinterpret_cast<const unsigned char*>(&v4->sin_addr), bytes.size(), bytes.begin());
    return ip::address_v4(bytes);
  }
  if (address.sa_family == AF_INET6) {
    ip::address_v6::bytes_type bytes{};
    const auto* const v6 = reinterpret_cast<const sockaddr_in6*>(&address);
    std::copy_n(reinterpret_cast<const unsigned char*>(&v6->sin6_addr), bytes.size(), bytes.begin());
    return ip::address_v6(bytes, v6->sin6_scope_id);
  }
  return std::nullopt;
}

bool may_reach(Reach reach, bool local) { return reach == Reach::open || (reach == Reach::local && local); }

curl_socket_t open_socket(void* user, curlsocktype purpose, curl_sockaddr* target) {
  auto& transfer = *static_cast<Transfer*>(user);
  const auto address = purpose == CURLSOCKTYPE_IPCXN ? address_of(target->addr) : std::nullopt;
  if (!address || !may_reach(reach_of(*address), transfer.local)) {
    transfer.refused = address ? address->to_string() : "no IP address";
    return CURL_SOCKET_BAD;
  }
  return ::socket(target->family, target->socktype | SOCK_CLOEXEC, target->protocol);
}

// One without an end is cut.
std::size_t take_answer(char* bytes, std::size_t size, std::size_t count, void* user) {
  auto& transfer = *static_cast<Transfer*>(user);
  transfer.answered_bytes += size * count;
  transfer.answer.append(bytes, std::min(size * count, transfer.keeps_bytes - transfer.answer.size()));
  return transfer.answered_bytes > app::kMostOfAnswer_bytes ? 0 : size * count;
}

std::string part_of(CURLU* url, CURLUPart part) {
  char* text = nullptr;
  if (curl_url_get(url, part, &text, 0) != CURLUE_OK || text == nullptr) return {};
  std::string copy(text);
  curl_free(text);
  return copy;
}

class CurlSender final : public app::HttpSender {
 public:
  CurlSender(HttpSenderSettings settings, CURLM* multi) : settings_(std::move(settings)), multi_(multi) {}
  ~CurlSender() override {
    for (const auto& [handle, transfer] : on_) curl_multi_remove_handle(multi_, handle);
    on_.clear();
    curl_multi_cleanup(multi_);
  }

  [[nodiscard]] std::string why_no_target(const std::string& text, bool local) const override;
  void begin(std::uint64_t ticket, const app::HttpCall& call) override;
  std::vector<app::HttpOutcome> work(std::chrono::milliseconds at_most) override;
  void wake() override { curl_multi_wakeup(multi_); }

 private:
  void set_up(Transfer& transfer, const app::HttpCall& call) const;

  HttpSenderSettings settings_;
  CURLM* multi_;
  std::map<CURL*, std::unique_ptr<Transfer>> on_;
  std::vector<app::HttpOutcome> not_begun_;
};

std::string CurlSender::why_no_target(const std::string& text, bool local) const {
  const Url url(curl_url());
  if (curl_url_set(url.get(), CURLUPART_URL, text.c_str(), 0) != CURLUE_OK) return "is no URL";
  const std::string scheme = part_of(url.get(), CURLUPART_SCHEME);
  if (scheme != "https" && scheme != "http") return "must be https, or http where it is local";
  if (scheme == "http" && !local) return "must be https: what leaves a local network is encrypted";
  std::string host = part_of(url.get(), CURLUPART_HOST);
  if (host.empty()) return "names no host";
  if (!part_of(url.get(), CURLUPART_USER).empty() || !part_of(url.get(), CURLUPART_PASSWORD).empty())
    return "must not have a name or password: the signature says who sends";
  if (!part_of(url.get(), CURLUPART_FRAGMENT).empty()) return "must not have a fragment";
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  boost::system::error_code is_name;
  const auto address = ip::make_address(host, is_name);
  if (is_name || may_reach(reach_of(address), local)) return {};
  return reach_of(address) == Reach::local ? "is in a private network or this computer: say that it is local"
                                           : "is an address that nothing is sent to";
}

void CurlSender::set_up(Transfer& transfer, const app::HttpCall& call) const {
  CURL* const easy = transfer.easy.get();
  const auto set = [easy](CURLoption option, auto value) { curl_easy_setopt(easy, option, value); };
  for (const auto& [name, value] : call.headers) {
    curl_slist* const longer = curl_slist_append(transfer.headers.get(), fmt::format("{}: {}", name, value).c_str());
    static_cast<void>(transfer.headers.release());
    transfer.headers.reset(longer);
  }
  set(CURLOPT_URL, call.url.c_str());
  set(CURLOPT_PROTOCOLS_STR, "http,https");
  set(CURLOPT_FOLLOWLOCATION, 0L);
  set(CURLOPT_PROXY, "");
  set(CURLOPT_NOSIGNAL, 1L);
  const long at_most_ms = std::clamp<long>(call.at_most.count(), 1, kAtMost_ms);
  set(CURLOPT_TIMEOUT_MS, at_most_ms);
  set(CURLOPT_CONNECTTIMEOUT_MS, std::min(kConnect_ms, at_most_ms));
  set(CURLOPT_FORBID_REUSE, 1L);
  set(CURLOPT_FRESH_CONNECT, 1L);
  set(CURLOPT_USERAGENT, settings_.user_agent.c_str());
  if (!settings_.ca_file.empty()) set(CURLOPT_CAINFO, settings_.ca_file.c_str());
  set(CURLOPT_HTTPHEADER, transfer.headers.get());
  if (call.verb == app::HttpVerb::post) {
    set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(call.body.size()));
    set(CURLOPT_COPYPOSTFIELDS, call.body.c_str());
  }
  set(CURLOPT_OPENSOCKETFUNCTION, &open_socket);
  set(CURLOPT_OPENSOCKETDATA, &transfer);
  set(CURLOPT_WRITEFUNCTION, &take_answer);
  set(CURLOPT_WRITEDATA, &transfer);
  set(CURLOPT_ERRORBUFFER, transfer.error.data());
}

void CurlSender::begin(std::uint64_t ticket, const app::HttpCall& call) {
  auto transfer = std::make_unique<Transfer>();
  transfer->ticket = ticket;
  transfer->local = call.local;
  transfer->keeps_bytes = std::min(call.keeps_bytes, app::kMostOfAnswer_bytes);
  transfer->easy.reset(curl_easy_init());
  // Who is allowed less than before is refused here, too.
  if (const std::string why = why_no_target(call.url, call.local); !why.empty()) {
    not_begun_.push_back({.ticket = ticket, .error = "the URL " + why});
    return;
  }
  set_up(*transfer, call);
  CURL* const easy = transfer->easy.get();
  if (curl_multi_add_handle(multi_, easy) != CURLM_OK) {
    not_begun_.push_back({.ticket = ticket, .error = "libcurl takes no request"});
    return;
  }
  on_.emplace(easy, std::move(transfer));
}

std::vector<app::HttpOutcome> CurlSender::work(std::chrono::milliseconds at_most) {
  std::vector<app::HttpOutcome> ended = std::exchange(not_begun_, {});
  int running = 0;
  curl_multi_perform(multi_, &running);
  if (ended.empty()) curl_multi_poll(multi_, nullptr, 0, static_cast<int>(at_most.count()), nullptr);
  curl_multi_perform(multi_, &running);
  int left = 0;
  while (const CURLMsg* const message = curl_multi_info_read(multi_, &left)) {
    if (message->msg != CURLMSG_DONE) continue;
    const auto found = on_.find(message->easy_handle);
    Transfer& transfer = *found->second;
    long status = 0;
    curl_easy_getinfo(message->easy_handle, CURLINFO_RESPONSE_CODE, &status);
    app::HttpOutcome outcome{.ticket = transfer.ticket};
    // An answer that was cut because it has no end is an answer.
    if (message->data.result == CURLE_OK || message->data.result == CURLE_WRITE_ERROR) {
      outcome.status = static_cast<std::uint32_t>(status);
      outcome.body = std::move(transfer.answer);
    } else if (!transfer.refused.empty()) {
      outcome.error = fmt::format("nothing is sent to {}: it is not open to this call", transfer.refused);
    } else {
      const bool has_words = transfer.error.front() != '\0';
      outcome.error = has_words ? transfer.error.data() : curl_easy_strerror(message->data.result);
    }
    ended.push_back(std::move(outcome));
    curl_multi_remove_handle(multi_, message->easy_handle);
    on_.erase(found);
  }
  return ended;
}

}  // namespace

std::expected<std::unique_ptr<app::HttpSender>, std::string> make_http_sender(HttpSenderSettings settings) {
  static const CURLcode kStarted = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (kStarted != CURLE_OK) return std::unexpected(std::string("libcurl does not start"));
  if (!settings.ca_file.empty() && ::access(settings.ca_file.c_str(), R_OK) != 0)
    return std::unexpected(fmt::format("{} cannot be read", settings.ca_file));
  CURLM* const multi = curl_multi_init();
  if (multi == nullptr) return std::unexpected(std::string("libcurl does not start"));
  return std::make_unique<CurlSender>(std::move(settings), multi);
}

}  // namespace dripfeed::io
