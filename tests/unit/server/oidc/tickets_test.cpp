// What binds a sign-in to its browser: how long, how often, and that no text of another's makes one.
#include "server/oidc/tickets.h"

#include <gtest/gtest.h>

#include "store/hash/token.h"

namespace dripfeed::oidc {
namespace {

constexpr std::int64_t kNow_ms = 1'790'000'000'000;

std::string why(const app::Result<Ticket>& taken) { return taken ? "taken" : taken.error().text; }

TEST(Tickets, ComeBackOnceAsTheyWereGiven) {
  Tickets tickets;
  const Ticket given = tickets.open(kNow_ms);
  const auto taken = tickets.take(given.cookie, given.state, kNow_ms + Tickets::kLast_ms);
  ASSERT_TRUE(taken) << why(taken);
  EXPECT_EQ(taken->nonce, given.nonce);
  EXPECT_EQ(taken->verifier, given.verifier);
  EXPECT_EQ(given.verifier.size(), 43U) << "RFC 7636 wants 43 at least";
  EXPECT_EQ(why(tickets.take(given.cookie, given.state, kNow_ms)), "this sign-in was used before: begin it again");
}

TEST(Tickets, AreEachAnotherOne) {
  const Tickets tickets;
  const Ticket a = tickets.open(kNow_ms);
  const Ticket b = tickets.open(kNow_ms);
  EXPECT_NE(a.cookie, b.cookie);
  for (const std::string& one : {a.state, a.nonce, a.verifier})
    for (const std::string& other : {b.state, b.nonce, b.verifier}) EXPECT_NE(one, other);
  EXPECT_NE(a.state, a.nonce);
  EXPECT_NE(a.state, a.verifier);
}

TEST(Tickets, EndAfterTenMinutes) {
  Tickets tickets;
  const Ticket given = tickets.open(kNow_ms);
  EXPECT_EQ(why(tickets.take(given.cookie, given.state, kNow_ms + Tickets::kLast_ms + 1)),
            "this sign-in took too long: begin it again");
  EXPECT_EQ(why(tickets.take(given.cookie, given.state, kNow_ms - 1)), "this sign-in took too long: begin it again")
      << "a clock that was set back";
}

TEST(Tickets, OfAnotherBrowserOrProcessAreNone) {
  Tickets tickets;
  Tickets other;
  const Ticket mine = tickets.open(kNow_ms);
  const Ticket theirs = tickets.open(kNow_ms);
  const std::string none = "this browser did not begin this sign-in: begin it again";
  EXPECT_EQ(why(tickets.take(mine.cookie, theirs.state, kNow_ms)), none);
  EXPECT_EQ(why(tickets.take("", mine.state, kNow_ms)), none);
  EXPECT_EQ(why(tickets.take(mine.cookie, "", kNow_ms)), none);
  EXPECT_EQ(why(tickets.take(mine.cookie + "x", mine.state, kNow_ms)), none);
  EXPECT_EQ(why(other.take(mine.cookie, mine.state, kNow_ms)), none);
  const std::string later = std::to_string(kNow_ms + 60'000) + mine.cookie.substr(mine.cookie.find('.'));
  EXPECT_EQ(why(tickets.take(later, mine.state, kNow_ms)), none) << "its time is changed";
}

}  // namespace
}  // namespace dripfeed::oidc
