// The transitions of releases, as a table, and what clears a text.
#include "store/releases.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace dripfeed::store {
namespace {

using enum ReleaseState;

// Every step towards the control looks at the verdict again. A reviewer sends a draft back; a failed proving goes back
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

bool clears(const Verdict& verdict, std::int64_t now_ms) {
  const auto is_waived = [&](std::string_view point) {
    return std::ranges::any_of(verdict.waivers,
                               [&](const Waiver& one) { return one.point == point && counts_at(one, now_ms); });
  };
  switch (verdict.of.outcome) {
    case Outcome::pass: return true;
    case Outcome::warn:
    case Outcome::unknown:
      return is_waived({}) || (!verdict.of.points.empty() && std::ranges::all_of(verdict.of.points, is_waived));
    case Outcome::fail: return false;
  }
  return false;
}

std::string why_not_clear(const Verdict& verdict, std::int64_t now_ms) {
  const auto ended = std::ranges::find_if(verdict.waivers, [&](const Waiver& one) { return !counts_at(one, now_ms); });
  if (verdict.of.outcome == Outcome::fail || ended == verdict.waivers.end())
    return std::string(name_of(verdict.of.outcome));
  return fmt::format("{}, and a waiver of {} has ended", name_of(verdict.of.outcome), ended->name);
}

}  // namespace dripfeed::store
