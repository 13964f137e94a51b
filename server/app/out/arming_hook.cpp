// Each question has a sender of its own: questions of several machines do not wait for each other.
#include "server/app/out/arming_hook.h"

#include <utility>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "store/hash/webhook_secret.h"

namespace dripfeed::app {

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::size_t kKeptAnswer_bytes = 4096;

HookAnswer no_answer(std::string why) { return {.kind = HookAnswer::Kind::none, .why = std::move(why)}; }

}  // namespace

// The request ends by itself; the time here is for a sender that does not keep its word.
HookAnswer ArmingHook::post(const ArmingQuestion& question) const {
  const auto sender = settings_.make_sender();
  if (!sender) return no_answer("no request can be made");
  HttpCall post{.url = settings_.url,
                .headers = {},
                .body = settings_.write(question),
                .local = settings_.local,
                .at_most = settings_.at_most,
                .keeps_bytes = kKeptAnswer_bytes};
  const hash::WebhookMessage message{.id = question.id, .at_s = question.at_ms / 1000, .body = post.body};
  post.headers = {{"Content-Type", "application/json; charset=utf-8"},
                  {"webhook-id", question.id},
                  {"webhook-timestamp", fmt::format("{}", message.at_s)},
                  {"webhook-signature", hash::webhook_signature(settings_.secret, message).value_or("")}};
  constexpr milliseconds kLook{100};
  const auto until = steady_clock::now() + settings_.at_most + milliseconds(1000);
  sender->begin(1, post);
  while (steady_clock::now() < until) {
    const std::vector<HttpOutcome> ended = sender->work(kLook);
    if (ended.empty()) continue;
    const HttpOutcome& outcome = ended.front();
    return outcome.status == 0 ? no_answer(outcome.error) : settings_.read(outcome.status, outcome.body);
  }
  return no_answer(fmt::format("no answer within {} ms", settings_.at_most.count()));
}

Result<std::optional<std::string>> ArmingHook::ask(const ArmingQuestion& question) const {
  HookAnswer answer = post(question);
  if (answer.kind == HookAnswer::Kind::allowed) return std::nullopt;
  spdlog::warn("job {} on {}: the arming hook {}: {}", question.job.id, question.job.machine,
               answer.kind == HookAnswer::Kind::refused ? "refuses" : "gave no answer", answer.why);
  if (answer.kind == HookAnswer::Kind::refused)
    return fail(ErrorCode::refused, fmt::format("the system that is asked before an arming refuses: {}", answer.why));
  if (settings_.arms_unanswered) return std::move(answer.why);
  return fail(ErrorCode::refused,
              fmt::format("the system that is asked before an arming gives no answer: {}", answer.why));
}

}  // namespace dripfeed::app
