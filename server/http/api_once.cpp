// Idempotency keys: the same request with the same key has its effect once and gets the same answer.
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/http/api.h"
#include "store/hash/hash.h"
#include "store/hash/sha256.h"

namespace dripfeed::http {

namespace {

// A client that repeats a request does so within minutes.
constexpr std::int64_t kReplyKept_ms = 24LL * 3600 * 1000;
constexpr std::int64_t kForgetEvery_ms = 3600LL * 1000;

constexpr std::string_view kJson = "application/json";
constexpr std::string_view kContentType = "Content-Type";

constexpr std::size_t kHashedAtOnce_bytes = std::size_t{256} << 10U;

std::expected<std::string, std::string> hash_of_body(const Request& request) {
  if (!request.spooled) return hash::sha256_hex(request.body);
  hash::Sha256 hash;
  std::string piece(kHashedAtOnce_bytes, '\0');
  const BodyPieces pieces = pieces_of(request);
  while (true) {
    const auto count = pieces(piece);
    if (!count) return std::unexpected(count.error());
    if (*count == 0) return hash.hex();
    hash.add(std::string_view(piece).substr(0, *count));
  }
}

// Headers of a kept answer: one a line, its type among them where it is not JSON.
std::string write_headers(const Response& response) {
  std::string lines;
  if (response.content_type != kJson) lines = fmt::format("{}: {}\n", kContentType, response.content_type);
  for (const auto& [name, value] : response.headers) lines += fmt::format("{}: {}\n", name, value);
  return lines;
}

void read_headers(std::string_view lines, Response& response) {
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    const std::size_t colon = line.find(": ");
    if (colon == std::string_view::npos) continue;
    const std::string_view name = line.substr(0, colon);
    const std::string_view value = line.substr(colon + 2);
    if (name == kContentType) {
      response.content_type = value;
    } else {
      response.headers.emplace_back(name, value);
    }
  }
}

// Holds a key while it lives, if no one else does.
class KeyInUse {
 public:
  KeyInUse(std::mutex& mutex, std::set<std::string>& keys, std::string key)
      : mutex_(mutex), keys_(keys), key_(std::move(key)) {
    const std::lock_guard lock(mutex_);
    is_ours_ = keys_.insert(key_).second;
  }
  KeyInUse(const KeyInUse&) = delete;
  KeyInUse& operator=(const KeyInUse&) = delete;
  ~KeyInUse() {
    const std::lock_guard lock(mutex_);
    if (is_ours_) keys_.erase(key_);
  }
  [[nodiscard]] bool is_ours() const { return is_ours_; }

 private:
  std::mutex& mutex_;
  std::set<std::string>& keys_;
  std::string key_;
  bool is_ours_ = false;
};

}  // namespace

// While one request with a key is being answered, another with the same key is asked to try again later.
Response Api::answer_once(const Request& request, const Route& route, const Call& call) {
  const std::string key =
      fmt::format("{} {} {} {}", call.user, name_of(request.method), request.target, request.idempotency_key);
  const KeyInUse use(keys_mutex_, keys_in_use_, key);
  if (!use.is_ours()) return problem_response(409, "a request with this key is being answered");
  return answer_first(request, route, call);
}

// Once an hour, with the first answer that is kept.
void Api::forget_old_replies(std::int64_t now_ms) {
  std::int64_t last_ms = forgot_at_ms_;
  if (now_ms - last_ms < kForgetEvery_ms || !forgot_at_ms_.compare_exchange_strong(last_ms, now_ms)) return;
  const auto forgotten = application_.store().replies().forget_before(now_ms - kReplyKept_ms);
  if (!forgotten) spdlog::warn("old answers under idempotency keys: {}", store::message_of(forgotten.error()));
}

// What was answered before under the key, or why that is not known.
std::optional<Response> Api::answered_before(const store::ReplyKey& key) {
  const auto before = application_.store().replies().find(key);
  if (!before) return problem_response(app::from_store(before.error()));
  if (!*before) return std::nullopt;
  Response response = json_response((*before)->status, (*before)->body);
  if (response.body.empty()) response.content_type.clear();
  read_headers((*before)->headers, response);
  return response;
}

// Only what was done is kept.
store::Result<void> Api::keep_answer(const store::ReplyKey& key, const Response& response) {
  if (response.status >= 400) return {};
  const store::Reply reply{.status = static_cast<std::uint16_t>(response.status),
                           .headers = write_headers(response),
                           .body = response.body,
                           .at_ms = application_.clock().wall_ms()};
  forget_old_replies(reply.at_ms);
  return application_.store().replies().keep(key, reply);
}

// Its last step looks for an earlier answer itself, in its transaction: that is cheaper than a look before it, and what
// goes before the step changes nothing.
Response Api::answer_staged(const Call& call, const Route& route, const store::ReplyKey* key) {
  const Commit commit = [&](const std::function<Response()>& step) {
    Response response;
    const auto done = application_.store().atomically_shared([&]() -> store::Result<void> {
      if (auto before = key == nullptr ? std::nullopt : answered_before(*key)) {
        response = std::move(*before);
        return {};
      }
      response = step();
      return key == nullptr ? store::Result<void>{} : keep_answer(*key, response);
    });
    return done ? response : problem_response(app::from_store(done.error()));
  };
  Call staged = call;
  staged.once = &commit;
  return route.handler(staged);
}

// Under a key the effect happens once. A light route's effect and its kept answer are one transaction, and so is the
// last step of a staged or bulk one: its text is stored before, under its hash, which changes nothing. For the others a
// crash between the two lets a repetition try again, and the state of things (a job that is armed already) refuses it.
Response Api::answer_first(const Request& request, const Route& route, const Call& call) {
  auto body_sha256 = hash_of_body(request);
  if (!body_sha256) return problem_response(507, body_sha256.error());
  const store::ReplyKey key{.actor = std::string(call.user),
                            .route = fmt::format("{} {}", name_of(request.method), request.target),
                            .key = request.idempotency_key,
                            .request_sha256 = std::move(*body_sha256)};
  if (route.weight == Weight::staged) return answer_staged(call, route, &key);
  if (auto before = answered_before(key)) return std::move(*before);
  const Commit once = [&](const std::function<Response()>& step) {
    Response response;
    app::Events::Hold news(application_.events());
    const auto done = application_.store().atomically([&] {
      response = step();
      return keep_answer(key, response);
    });
    if (done) news.release();
    return done ? response : problem_response(app::from_store(done.error()));
  };
  if (route.weight == Weight::light) return once([&] { return route.handler(call); });
  if (route.weight == Weight::bulk) {
    Call bulk = call;
    bulk.once = &once;
    return route.handler(bulk);
  }
  Response response = route.handler(call);
  if (const auto kept = keep_answer(key, response); !kept) return problem_response(app::from_store(kept.error()));
  return response;
}

}  // namespace dripfeed::http
