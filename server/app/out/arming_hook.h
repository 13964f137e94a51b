// Another system is asked before a job is armed, as a planner wants it: one request, signed as webhooks are, with a
// known end. Its answer may refuse the arming; it arms nothing, and no feed waits for it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "server/app/base/error.h"
#include "server/app/ports/http_sender.h"
#include "store/store.h"

namespace dripfeed::app {

// What is asked.
struct ArmingQuestion {
  std::string id;  // of this question alone
  std::int64_t at_ms = 0;
  store::Job job;
  std::string program;  // its name
  std::optional<store::Order> order;
  std::string actor;  // who wants to arm it
};

struct HookAnswer {
  enum class Kind : std::uint8_t { allowed, refused, none };  // none: it says neither
  Kind kind = Kind::none;
  std::string why{};  // in its words, or ours where there is none
};

struct HookSettings {
  std::string url{};  // "": no system is asked
  std::string secret{};
  bool local = false;  // this computer and private networks are allowed
  std::chrono::milliseconds at_most{5000};
  bool arms_unanswered = false;  // where no answer comes the arming goes on, with a row in the audit
  MakeHttpSender make_sender{};
  std::function<std::string(const ArmingQuestion&)> write{};
  // Of a status and body that came.
  std::function<HookAnswer(std::uint32_t status, std::string_view body)> read{};
};

class ArmingHook {
 public:
  // One system, or none.
  explicit ArmingHook(HookSettings settings) : settings_(std::move(settings)) {}

  [[nodiscard]] bool is_set() const { return !settings_.url.empty(); }
  // Waits for the answer, as long as the settings have it; from any thread. Nothing: it allows it. A text: no answer
  // came and the arming goes on all the same; why. Errors: refused, with the words of the other system; or that none
  // came.
  [[nodiscard]] Result<std::optional<std::string>> ask(const ArmingQuestion& question) const;

 private:
  [[nodiscard]] HookAnswer post(const ArmingQuestion& question) const;

  HookSettings settings_;
};

}  // namespace dripfeed::app
