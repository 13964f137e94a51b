// One row a code.
#include "server/json/problem_codes.h"

#include <algorithm>
#include <array>

#include "server/json/sentences.h"

namespace dripfeed::json {

namespace {

constexpr unsigned kSoon_s = 5;
constexpr unsigned kDiskFull_s = 60;  // a person makes room

constexpr std::array kCodes = {
    ProblemCode{"malformed", 400, "malformed",
                "the request cannot be read, or has a query parameter that is not known"},
    ProblemCode{"not_signed_in", 401, "not signed in", "there is no token and no session, or it has ended"},
    ProblemCode{"wrong_secret", 401, "wrong secret", "the name, password, PIN or token is wrong", 0,
                "wrong_secret token_not_valid"},
    ProblemCode{"not_allowed", 403, "not allowed", "the caller may not do this"},
    ProblemCode{"role_missing", 403, "role missing", "the caller's role is too low for this, or for this machine", 0,
                "needs_role approver_needed approver_accepts admin_loads early_by_approver"},
    ProblemCode{"scope_missing", 403, "scope missing", "the token's scope does not contain this change", 0,
                "token_scope"},
    ProblemCode{"not_found", 404, "not found", "there is no such route or thing"},
    ProblemCode{"method_not_allowed", 405, "method not allowed", "the path has other methods: see Allow"},
    ProblemCode{"refused", 409, "refused", "the state of things does not allow it now"},
    ProblemCode{"exists", 409, "exists already", "the name or number is taken", 0, "store_exists"},
    ProblemCode{"in_progress", 409, "in progress", "the same is being done: ask again when it has ended", 0,
                "being_answered sweep_runs maintenance_runs"},
    ProblemCode{"other_user", 409, "another user", "the page shows another person than the one who is signed in", 0,
                "page_shows_other"},
    ProblemCode{"wrong_state", 409, "wrong state", "this cannot follow the present state", 0,
                "store_transition no_effect nothing_waits no_torn job_not_on_line"},
    ProblemCode{"no_verdict", 409, "no verdict", "the text was never checked for this machine and delivery", 0,
                "store_no_verdict"},
    ProblemCode{"verdict_not_passed", 409, "verdict not passed", "the newest verdict does not clear the text", 0,
                "store_not_passed"},
    ProblemCode{"verdict_stale", 409, "verdict stale", "what it rests on changed after the verdict: check again", 0,
                "store_verdict_stale changed_after_verdict"},
    ProblemCode{"not_released", 409, "not released", "no release lets this text go to this machine", 0,
                "store_not_released"},
    ProblemCode{"no_machine_of_group", 409, "no machine of the group",
                "no machine of the group can take the program: see `errors`", 0, "none_of_group"},
    ProblemCode{"transfers_used_up", 409, "transfers used up", "the proving has had its transfers", 0, "store_used_up"},
    ProblemCode{"sign_off_missing", 409, "sign-off missing", "an approval needs a note of who signs it off", 0,
                "store_sign_off"},
    ProblemCode{"not_proved", 409, "not proved",
                "an operator signs off what a transfer has shown: none has ended well since the proving began", 0,
                "store_not_proved"},
    ProblemCode{"not_signed_off", 409, "not signed off",
                "a release is approved for this machine after an operator signed its proving off", 0,
                "store_not_signed_off"},
    ProblemCode{"four_eyes", 409, "four eyes", "who wrote or released a text may not approve it", 0, "store_four_eyes"},
    ProblemCode{"machine_busy", 409, "machine busy", "a job has the machine's line", 0,
                "store_machine_busy job_on_line job_holds_profile job_waits line_busy_settings line_still_used "
                "line_in_use control_sends line_tested"},
    ProblemCode{"machine_torn", 409, "block torn", "a block may be torn: a person resets the control and confirms that",
                0,
                "store_machine_torn torn_reset_first maybe_torn block_torn_here block_torn_confirm other_session "
                "line_confirm_first"},
    ProblemCode{"too_early", 409, "too early", "the job may not be armed before its time", 0, "store_too_early"},
    ProblemCode{"on_hold", 409, "on hold", "a person put the job on hold: the detail names who, and why", 0,
                "store_on_hold"},
    ProblemCode{
        "end_not_confirmed", 409, "end not confirmed",
        "a person must first confirm the end of another job of the machine: the detail names it and what is asked", 0,
        "store_end_not_confirmed"},
    ProblemCode{"hook_refused", 409, "hook refused",
                "the system that is asked before an arming refuses it: its words are in the detail", 0, "hook_refuses"},
    ProblemCode{"hook_unanswered", 409, "hook unanswered", "the system that is asked before an arming gives no answer",
                0, "hook_silent"},
    ProblemCode{"sign_in_not_begun", 409, "sign-in not begun",
                "this browser did not begin this sign-in by the provider, or it took too long, or was used", 0,
                "sign_in_other sign_in_late sign_in_used"},
    ProblemCode{"provider_refused", 409, "provider refused", "the OpenID Connect provider refuses the sign-in", 0,
                "provider_refuses"},
    ProblemCode{"id_token_refused", 409, "ID token refused",
                "what the provider signed is not taken: the detail names the rule", 0, "id_token_refused"},
    ProblemCode{"name_taken", 409, "name taken",
                "the provider's name for the person belongs to another account here, or is not a name", 0,
                "provider_name_taken provider_no_name"},
    ProblemCode{"account_waits", 409, "account waits", "an administrator has to enable the account, or it is locked", 0,
                "account_not_enabled account_locked"},
    ProblemCode{"no_role", 409, "no role", "no group of the person at the provider gives a role here", 0,
                "provider_no_group"},
    ProblemCode{"line_down", 409, "line down", "the machine has no line, or its link is down", 0,
                "no_line no_line_because line_elsewhere store_not_leased link_down link_down_plain nothing_leaves"},
    ProblemCode{"append_only", 409, "append only", "what is written there never changes", 0, "store_append_only"},
    ProblemCode{"stale_revision", 412, "stale revision", "another change came first: read it again"},
    ProblemCode{"too_large", 413, "too large", "the body is too long for this route, or for the limits of this shop"},
    ProblemCode{"no_json", 415, "no JSON", "the body is not JSON, or is encoded"},
    ProblemCode{"invalid", 422, "invalid", "a value is missing or wrong: see `errors`"},
    ProblemCode{"key_reused", 422, "key reused", "the idempotency key was used for another request", 0,
                "store_key_reused"},
    ProblemCode{"revision_missing", 428, "revision missing", "If-Match with the revision that is changed is needed"},
    ProblemCode{"too_many", 429, "too many", "too many wrong secrets, or too many who watch", 10},
    ProblemCode{"header_too_large", 431, "too large", "the header of the request is too large"},
    ProblemCode{"internal", 500, "internal error", "the request failed inside the server; the log states why"},
    ProblemCode{"unavailable", 503, "unavailable", "the server cannot do it for now", kSoon_s},
    ProblemCode{"provider_unanswered", 503, "provider unanswered",
                "the OpenID Connect provider gives no answer, or none that can be used; passwords and PINs still work",
                kSoon_s, "provider_silent provider_unusable"},
    ProblemCode{"overloaded", 503, "overloaded", "too many requests wait: send it again", 1,
                "too_many_large too_many_waiting too_many_sign_ins"},
    ProblemCode{"disk_full", 503, "disk full", "the disk is full: running work is finished, nothing new begins",
                kDiskFull_s, "store_disk_full disk_full_ends"},
    ProblemCode{"no_room", 507, "no room on the disk", "the body could not be kept on the disk"},
    ProblemCode{"over_quota", 507, "over quota",
                "the store has reached the limit of its options: a person must make room"},
};

struct ErrorRow {
  app::ErrorCode error;
  std::string_view code;
};
constexpr std::array kErrors = {
    ErrorRow{app::ErrorCode::not_found, "not_found"},     ErrorRow{app::ErrorCode::exists, "exists"},
    ErrorRow{app::ErrorCode::malformed, "malformed"},     ErrorRow{app::ErrorCode::invalid, "invalid"},
    ErrorRow{app::ErrorCode::stale, "stale_revision"},    ErrorRow{app::ErrorCode::refused, "refused"},
    ErrorRow{app::ErrorCode::unavailable, "unavailable"}, ErrorRow{app::ErrorCode::internal, "internal"},
    ErrorRow{app::ErrorCode::too_large, "too_large"},     ErrorRow{app::ErrorCode::over_quota, "over_quota"},
};

bool has_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t end = words.find(' ');
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(end == std::string_view::npos ? words.size() : end + 1);
  }
  return false;
}

const ProblemCode* by_sentence(unsigned status, std::string_view id) {
  const auto* const row = std::ranges::find_if(
      kCodes, [&](const ProblemCode& one) { return one.status == status && has_word(one.sentences, id); });
  return row == kCodes.end() ? nullptr : row;
}

// By the sentence itself, or by one that it names: "lathe cannot be armed: the disk is full".
const ProblemCode& refined(const ProblemCode& plain, std::string_view sentence) {
  const auto found = sentence_of(sentence);
  if (!found) return plain;
  if (const ProblemCode* row = by_sentence(plain.status, found->id)) return *row;
  for (const auto& [name, value] : found->values) {
    const auto inner = sentence_of(value);
    if (!inner) continue;
    if (const ProblemCode* row = by_sentence(plain.status, inner->id)) return *row;
  }
  return plain;
}

// The first of kCodes that fits; `internal` where none does.
template <class Fits>
const ProblemCode& first(const Fits& fits) {
  const auto* const row = std::ranges::find_if(kCodes, fits);
  if (row != kCodes.end()) return *row;
  return *std::ranges::find(kCodes, "internal", &ProblemCode::code);
}

}  // namespace

std::span<const ProblemCode> problem_codes() { return kCodes; }

const ProblemCode& problem_code(unsigned status, std::string_view sentence) {
  return refined(first([&](const ProblemCode& one) { return one.status == status; }), sentence);
}

const ProblemCode& problem_code(const app::Error& error) {
  const auto* const row = std::ranges::find(kErrors, error.code, &ErrorRow::error);
  const std::string_view code = row == kErrors.end() ? "internal" : row->code;
  return refined(first([&](const ProblemCode& one) { return one.code == code; }), error.text);
}

}  // namespace dripfeed::json
