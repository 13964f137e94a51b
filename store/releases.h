// Releases: what lets a text go to a machine. A release binds text hash, machine and delivery, and moves by one table
// of states. Towards the control it must have a fresh verdict that clears the text; the store looks at it in the same
// transaction that moves the release.
#pragma once

#include <span>

#include "store/verdicts.h"

namespace dripfeed::store {

enum class ReleaseState : std::uint8_t { draft, in_review, proving, approved, obsolete };
template <>
inline constexpr std::array<std::string_view, 5> kNames<ReleaseState>{"draft", "in_review", "proving", "approved",
                                                                      "obsolete"};

struct ReleaseTransition {
  ReleaseState from = ReleaseState::draft;
  ReleaseState to = ReleaseState::draft;
  bool needs_verdict = false;    // the newest verdict clears the text and is not stale
  bool needs_sign_off = false;   // a note
  bool needs_transfers = false;  // how many transfers the proving may take
};
// All that are allowed.
std::span<const ReleaseTransition> release_transitions();

// A text that continues another release's.
struct RestartOf {
  Id release = 0;          // 0: it is no restart
  std::uint64_t line = 0;  // of that release's text
  [[nodiscard]] bool is_one() const { return release != 0; }
};

// " that continues release 7 at line 40"; "" of what is none.
std::string words_of(const RestartOf& restart);

struct NewRelease {
  Id program = 0;
  Revision revision = 0;
  std::string machine{};
  Delivery delivery = Delivery::drip;
  RestartOf restart{};
};

struct Release {
  Id id = 0;
  NewRelease of;
  std::string text_sha256;
  ReleaseState state = ReleaseState::draft;
  std::uint64_t transfers_allowed = 0;  // while proving
  std::uint64_t transfers_done = 0;     // jobs that began to feed while proving
  std::string proved_by;                // the operator who signed the proving off; "": no one yet
  std::string proof;                    // what they wrote
  std::string created_by;
  std::int64_t created_at_ms = 0;
  std::string approved_by;  // the sign-off, once it is approved
  std::string sign_off;
  std::int64_t changed_at_ms = 0;
};

struct ReleaseMove {
  ReleaseState to = ReleaseState::draft;
  std::string note{};
  std::uint64_t transfers = 0;  // for proving: at least 1; of a restart 1
  std::string shown_sha256{};   // of a restart, for proving: of the text that whoever releases it has seen
};

// One step of a release's history.
struct ReleaseStep {
  ReleaseState from = ReleaseState::draft;
  ReleaseState to = ReleaseState::draft;
  std::string actor;
  std::string note;
  std::int64_t at_ms = 0;
};

struct ReleaseFilter {
  Id program = 0;         // 0: all
  std::string machine{};  // empty: all
};

// Why a text may be fed: the release, and the verdict it rests on. A verdict that became stale after the approval does
// not take the approval back; `verdict.stale` shows it.
struct Clearance {
  Release release;
  Verdict verdict;
};

class Releases : public Repository {
 public:
  // A draft. Errors: broken_reference (also of a restart whose release is neither proving nor approved),
  // refused_transition (the program is archived), exists (one for this text, machine and delivery that is not
  // obsolete).
  virtual Result<Release> add(const NewRelease& release, const Stamp& by) = 0;
  // Errors: not_found, refused_transition, no_verdict, verdict_not_passed, verdict_stale, sign_off_missing,
  // invalid_value (proving without transfers), not_signed_off (to approved, unless the machine's group waives the
  // operator), four_eyes (to approved, where the machine's group wants another person than who wrote or released the
  // text). A restart is shown, and then released for one transfer by its proving alone:
  // invalid_value (another text than it has, more transfers), four_eyes at the proving, refused_transition to approved.
  virtual Result<Release> move(Id release, const ReleaseMove& move, const Stamp& by) = 0;
  // An operator signs off what the transfers of this proving have shown. Errors: not_found, refused_transition (it is
  // not being proved, or is a restart), sign_off_missing (no note), not_proved (no transfer has ended well since the
  // proving began).
  virtual Result<Release> sign_off(Id release, std::string_view note, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<Release> get(Id release) = 0;
  // Newest first.
  virtual Result<Page<Release>> list(const PageRequest& page, const ReleaseFilter& filter = {}) = 0;
  // Oldest first.
  virtual Result<std::vector<ReleaseStep>> history(Id release) = 0;
  // Whether this very text may be fed now. Errors: not_released, transfers_used_up, no_verdict, verdict_not_passed.
  virtual Result<Clearance> released_for(std::string_view text_sha256, std::string_view machine, Delivery delivery,
                                         std::int64_t now_ms) = 0;
};

}  // namespace dripfeed::store
