// The transitions of releases, as a table, and what clears a text.
#include "store/releases.h"

#include <array>

#include <fmt/format.h>

namespace dripfeed::store {
namespace {

using enum ReleaseState;

// Every step towards the control looks at the verdict anew. A reviewer sends a draft back; a failed proving goes back
// to the review.
constexpr std::array kTransitions{
    ReleaseTransition{.from = draft, .to = in_review, .needs_verdict = true},
    ReleaseTransition{.from = draft, .to = obsolete},
    ReleaseTransition{.from = in_review, .to = draft},
    ReleaseTransition{.from = in_review, .to = proving, .needs_verdict = true, .needs_transfers = true},
    ReleaseTransition{.from = in_review, .to = obsolete},
    ReleaseTransition{.from = proving, .to = in_review},
    ReleaseTransition{.from = proving, .to = approved, .needs_verdict = true, .needs_sign_off = true},
    ReleaseTransition{.from = proving, .to = obsolete},
    ReleaseTransition{.from = approved, .to = obsolete},
};

}  // namespace

std::span<const ReleaseTransition> release_transitions() { return kTransitions; }

std::string words_of(const RestartOf& restart) {
  if (!restart.is_one()) return {};
  return fmt::format(" that continues release {} at line {}", restart.release, restart.line);
}

bool clears(const Verdict& verdict) {
  switch (verdict.of.outcome) {
    case Outcome::pass: return true;
    case Outcome::warn:
    case Outcome::unknown: return !verdict.waivers.empty();
    case Outcome::fail: return false;
  }
  return false;
}

}  // namespace dripfeed::store
