// Machines, families and parts: a wrong document leaves nothing, each change is a revision, and a line with a
// job is left alone.
#include "server/app/shop/catalog.h"

#include <chrono>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;

constexpr std::string_view kFamily =
    "family pin \"Pin\"\n"
    "machine lathe, x is diameter\n"
    "param width length 20 mm in 5..50\n"
    "program turning\n"
    "  work offset 1\n"
    "  tool 1  nose 0.8 mm  tip 3\n"
    "  spindle 500 rpm cw\n"
    "  feed 0.15 mm/rev\n"
    "  rapid x 60 mm  z 2 mm\n"
    "  cut x width  z -10 mm\n"
    "  retract x 60 mm  then z 2 mm\n"
    "end\n";

class CatalogTest : public ShopTest {
 protected:
  CatalogTest() : shop_(database()) {}
  Shop shop_;
};

TEST_F(CatalogTest, AMachineHasALineAtOnce) {
  const store::Machine made = must(shop_.catalog.add_machine("lathe pty:/machine/lathe", "anna"));
  shop_.links.run_posted();
  EXPECT_EQ(made.revision, 1U);
  EXPECT_EQ(made.profile, "lathe pty:/machine/lathe");
  EXPECT_EQ(shop_.report(kLathe).state, LineState::idle);
  EXPECT_EQ(shop_.published().front(), "machine lathe ");
  EXPECT_EQ(refusal(shop_.catalog.add_machine("lathe pty:/machine/other", "anna")).code, ErrorCode::exists);
  EXPECT_EQ(shop_.links.cable("pty:/machine/other").opened, 0) << "a refused document opens nothing";
}

TEST_F(CatalogTest, AWrongProfileLeavesNothing) {
  const Error url = refusal(shop_.catalog.add_machine("lathe ftp://x", "anna"));
  EXPECT_EQ(url.code, ErrorCode::invalid);
  EXPECT_EQ(url.places.at(0).pointer, "/link/url");
  const Error dialect = refusal(shop_.catalog.add_machine("martian pty:/x", "anna"));
  EXPECT_EQ(dialect.code, ErrorCode::invalid);
  EXPECT_EQ(dialect.places.at(0).pointer, "/dialect");
  EXPECT_EQ(must(shop_.store.machines().list({})).items.size(), 0U);
  EXPECT_TRUE(shop_.lines.all().empty());
  EXPECT_EQ(refusal(shop_.catalog.profile(kLathe)).code, ErrorCode::not_found);
}

TEST_F(CatalogTest, AChangedProfileIsARevisionWithALineOfItsOwn) {
  shop_.add_machine(kLathe);
  EXPECT_EQ(refusal(shop_.catalog.change_machine(kLathe, 2, "lathe pty:/new", "anna")).code, ErrorCode::stale);
  EXPECT_EQ(refusal(shop_.catalog.change_machine(kLathe, 1, "mill pty:/new", "anna")).places.at(0).pointer, "/name");
  EXPECT_EQ(refusal(shop_.catalog.change_machine("mill", 1, "mill pty:/new", "anna")).code, ErrorCode::not_found);
  EXPECT_NE(shop_.links.cable(url_of(kLathe)).listener, nullptr) << "a refused change leaves the line alone";

  const store::Machine changed = must(shop_.catalog.change_machine(kLathe, 1, "lathe pty:/new", "anna"));
  shop_.round();  // the books may still have had the old line in its hands
  shop_.links.run_posted();
  EXPECT_EQ(changed.revision, 2U);
  EXPECT_EQ(shop_.links.cable(url_of(kLathe)).listener, nullptr);
  EXPECT_NE(shop_.links.cable("pty:/new").listener, nullptr);
  EXPECT_EQ(must(shop_.catalog.profile(kLathe)).line.link.text, "pty:/new");

  const int opened = shop_.links.cable("pty:/new").opened;
  must(shop_.catalog.change_machine(kLathe, 2, "lathe pty:/new", "anna"));
  EXPECT_EQ(shop_.links.cable("pty:/new").opened, opened) << "the line did not change";
}

TEST_F(CatalogTest, AMachineWithAJobIsNotChanged) {
  shop_.add_machine(kLathe);
  const store::Job job = shop_.add_job(kLathe, program(5));
  must(shop_.jobs.arm(job.id, std::nullopt, "olga"));
  EXPECT_EQ(refusal(shop_.catalog.change_machine(kLathe, 1, "lathe pty:/new", "anna")).code, ErrorCode::refused);
  shop_.links.receive(url_of(kLathe), kDc1);
  shop_.run(20ms);
  shop_.links.lose(url_of(kLathe));
  shop_.round();
  ASSERT_TRUE(shop_.job(job.id).torn);
  EXPECT_EQ(refusal(shop_.catalog.change_machine(kLathe, 1, "lathe pty:/new", "anna")).code, ErrorCode::refused)
      << "a new line would not know of the torn block";
  EXPECT_EQ(must(shop_.store.machines().get(kLathe)).revision, 1U);
  must(shop_.jobs.confirm_reset(kLathe, "reset", "olga"));
  must(shop_.catalog.change_machine(kLathe, 1, "lathe pty:/new", "anna"));
}

TEST_F(CatalogTest, OpensTheLinesOfAllMachines) {
  must(shop_.store.machines().add("mill", "mill pty:/machine/mill", by("anna")));
  must(shop_.store.machines().add("wreck", "wreck nonsense", by("anna")));
  must(shop_.store.machines().add("zeta", "zeta pty:/machine/zeta", by("anna")));
  must(shop_.catalog.open_lines());
  shop_.links.run_posted();
  EXPECT_NE(shop_.lines.find("mill"), nullptr);
  EXPECT_EQ(shop_.lines.find("wreck"), nullptr) << "one that cannot be read keeps no other from its line";
  EXPECT_NE(shop_.lines.find("zeta"), nullptr);
}

TEST_F(CatalogTest, FamiliesAreReadBeforeTheyAreStored) {
  const store::Family made = must(shop_.catalog.add_family(kFamily, "anna"));
  EXPECT_EQ(made.name, "pin");
  EXPECT_EQ(made.revision, 1U);
  EXPECT_EQ(refusal(shop_.catalog.add_family(kFamily, "anna")).code, ErrorCode::exists);
  std::string wrong(kFamily);
  wrong.replace(wrong.find("20 mm"), 5, "20 kg");
  const Error error = refusal(shop_.catalog.change_family("pin", 1, wrong, "anna"));
  EXPECT_EQ(error.code, ErrorCode::invalid);
  ASSERT_FALSE(error.places.empty());
  EXPECT_EQ(error.places.front().line, 3U);
  EXPECT_GT(error.places.front().column, 0U);
  std::string other(kFamily);
  other.replace(other.find("pin"), 3, "rod");
  EXPECT_EQ(refusal(shop_.catalog.change_family("pin", 1, other, "anna")).code, ErrorCode::invalid);
  std::string longer(kFamily);
  longer.replace(longer.find("20 mm"), 5, "30 mm");
  EXPECT_EQ(refusal(shop_.catalog.change_family("pin", 2, longer, "anna")).code, ErrorCode::stale);
  EXPECT_EQ(must(shop_.catalog.change_family("pin", 1, longer, "anna")).revision, 2U);
  EXPECT_EQ(must(shop_.store.families().get("pin", 1)).text, kFamily) << "a revision never changes";
}

TEST_F(CatalogTest, APartsValuesMustBindToItsFamily) {
  must(shop_.catalog.add_family(kFamily, "anna"));
  EXPECT_EQ(refusal(shop_.catalog.add_part("P1", "bolt", {}, "anna")).code, ErrorCode::not_found);
  EXPECT_EQ(refusal(shop_.catalog.add_part("P1", "pin", {{"width", "60 mm"}}, "anna")).code, ErrorCode::invalid);
  EXPECT_EQ(refusal(shop_.catalog.add_part("P1", "pin", {{"witdh", "10 mm"}}, "anna")).code, ErrorCode::invalid);
  EXPECT_EQ(refusal(shop_.catalog.add_part("P1", "pin", {{"width", "10 deg"}}, "anna")).code, ErrorCode::invalid);
  EXPECT_TRUE(must(shop_.store.parts().list({})).items.empty());
  const store::Part made = must(shop_.catalog.add_part("P1", "pin", {{"width", "10 mm"}}, "anna"));
  EXPECT_EQ(made.made_of.family_revision, 1U);
  EXPECT_EQ(made.made_of.values, "width=10 mm");
  EXPECT_EQ(refusal(shop_.catalog.change_part("P1", 7, {{"width", "11 mm"}}, "anna")).code, ErrorCode::stale);
  EXPECT_EQ(refusal(shop_.catalog.change_part("P1", 1, {{"width", "1 mm"}}, "anna")).code, ErrorCode::invalid);
  EXPECT_EQ(refusal(shop_.catalog.change_part("P2", 1, {}, "anna")).code, ErrorCode::not_found);
  EXPECT_EQ(must(shop_.catalog.change_part("P1", 1, {{"width", "11 mm"}}, "anna")).revision, 2U);
  EXPECT_EQ(must(shop_.store.parts().get("P1", 1)).made_of.values, "width=10 mm");
}

}  // namespace
}  // namespace dripfeed::app
