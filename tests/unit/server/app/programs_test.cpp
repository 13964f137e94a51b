// Programs from outside and from families, and what the checks say of them: a verdict stands for one text hash on one
// revision of a machine.
#include "server/app/library/programs.h"

#include <fstream>
#include <iterator>

#include "server/app/checks/checking.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace test;

constexpr std::string_view kText = "%\nO0042\nG90G21\nG01X1.F100.\nM30\n%\n";

class ProgramsTest : public ShopTest {
 protected:
  ProgramsTest()
      : shop_(database()),
        programs_(shop_.store, shop_.links.clock(), shop_.documents),
        checking_(shop_.store, shop_.events, shop_.links.clock(), shop_.documents) {
    shop_.add_machine("mill");
    shop_.add_machine("lathe");
  }
  store::Family add_roll() {
    std::ifstream file(DRIPFEED_SOURCE_DIR "/deploy/families/hyperbolic-roll.family");
    return must(shop_.catalog.add_family(std::string(std::istreambuf_iterator<char>(file), {}), "anna"));
  }
  [[nodiscard]] std::size_t count() { return must(shop_.store.programs().list({})).items.size(); }

  Shop shop_;
  Programs programs_;
  Checking checking_;
};

TEST_F(ProgramsTest, AnUploadIsRevisionedByItsHash) {
  const store::Program program = must(programs_.upload("O0042", "fanuc", kText, "anna"));
  EXPECT_EQ(program.newest.revision, 1U);
  EXPECT_EQ(program.newest.bytes, kText.size());
  EXPECT_EQ(program.newest.blocks, 4U);
  EXPECT_EQ(program.newest.created_by, "anna");
  EXPECT_EQ(must(store::read_whole(shop_.store.contents(), program.newest.sha256, 1000)), kText);
  EXPECT_EQ(refusal(programs_.upload_revision(program.id, 2, "%\nM30\n%\n", "anna")).code, ErrorCode::stale);
  EXPECT_EQ(refusal(programs_.upload_revision(99, 1, "%\nM30\n%\n", "anna")).code, ErrorCode::not_found);
  const store::Program changed = must(programs_.upload_revision(program.id, 1, "%\nM30\n%\n", "anna"));
  EXPECT_EQ(changed.newest.revision, 2U);
  EXPECT_NE(changed.newest.sha256, program.newest.sha256);
  EXPECT_EQ(must(shop_.store.programs().get_revision(program.id, 1)).sha256, program.newest.sha256);
}

TEST_F(ProgramsTest, AWrongUploadLeavesNothing) {
  EXPECT_EQ(refusal(programs_.upload("O1", "martian", kText, "anna")).places.at(0).pointer, "/dialect");
  EXPECT_EQ(refusal(programs_.upload("O1", "fanuc", "", "anna")).places.at(0).pointer, "/text");
  EXPECT_EQ(refusal(programs_.upload("", "fanuc", kText, "anna")).code, ErrorCode::invalid);
  EXPECT_EQ(count(), 0U);
}

TEST_F(ProgramsTest, CountsBlocksAtEveryKindOfEob) {
  EXPECT_EQ(count_blocks(""), 0U);
  EXPECT_EQ(count_blocks("%\n%\n"), 0U);
  EXPECT_EQ(count_blocks("%\r\nG1\r\n \t\r\nM30\r\n%\r\n"), 2U);
  EXPECT_EQ(count_blocks("%\rG1\rM30\r%"), 2U);
  EXPECT_EQ(count_blocks("%\n\r\rG1\n\r\rM30\n\r\r%"), 2U);
  EXPECT_EQ(count_blocks("G1"), 1U);
}

TEST_F(ProgramsTest, RendersAPartWithWhereItCameFrom) {
  const store::Family family = add_roll();
  must(shop_.catalog.add_part("R-100", family.name, {{"roll_length", "100 mm"}}, "anna"));
  RenderOrder order;
  order.part = "R-100";
  order.machine = "lathe";
  order.mode = compile::RenderMode::explicit_blocks;
  const Rendered rendered = must(programs_.render(order, "anna"));
  const store::Origin& origin = rendered.program.newest.origin;
  EXPECT_EQ(rendered.program.name, "R-100");
  EXPECT_EQ(origin.kind, store::OriginKind::rendered);
  EXPECT_EQ(origin.part, "R-100");
  EXPECT_EQ(origin.part_revision, 1U);
  EXPECT_EQ(origin.family, family.name);
  EXPECT_EQ(origin.machine_revision, 1U);
  EXPECT_EQ(origin.values, "roll_length=100 mm");
  EXPECT_EQ(origin.mode, "explicit");
  EXPECT_TRUE(rendered.program.newest.facts.starts_with("profile "));
  EXPECT_EQ(must(store::read_whole(shop_.store.contents(), rendered.program.newest.sha256, 1 << 20)),
            rendered.result.text);
  const std::string places =
      must(store::read_whole(shop_.store.contents(), rendered.program.newest.places_sha256, 1 << 20));
  EXPECT_EQ(static_cast<std::size_t>(std::count(places.begin(), places.end(), '\n')),
            rendered.result.places.entries.size());

  // A part keeps the family revision that its values were made for.
  std::string changed = family.text;
  changed.replace(changed.find("100 mm"), 6, "120 mm");
  must(shop_.catalog.change_family(family.name, 1, changed, "anna"));
  EXPECT_EQ(must(programs_.render(order, "anna")).program.newest.sha256, rendered.program.newest.sha256);
  RenderOrder direct;
  direct.family = family.name;
  direct.machine = "lathe";
  direct.values = {{"roll_length", "100 mm"}};
  direct.mode = order.mode;
  const Rendered newest = must(programs_.render(direct, "anna"));
  EXPECT_EQ(newest.program.newest.origin.family_revision, 2U);
  EXPECT_NE(newest.program.newest.sha256, rendered.program.newest.sha256);
}

// A program that was wrapped as a family is stored, ordered and rendered like any other one.
TEST_F(ProgramsTest, AWrappedProgramIsRenderedFromAPart) {
  const std::string program = "%\r\nO0042 (SLOT)\r\nG90G21\r\n#100=50.(WIDTH)\r\nG01X#100F100.\r\nM30\r\n%\r\n";
  const std::string head = "family slot \"A slot\"\nmachine mill\nparam width length 50 mm in 1..80 is #100\n";
  const store::Family family = must(shop_.catalog.add_family(head + "native fanuc\n" + program, "anna"));
  EXPECT_EQ(must(shop_.store.families().get("slot")).text, family.text);
  EXPECT_EQ(refusal(shop_.catalog.add_part("S-1", "slot", {{"width", "99 mm"}}, "anna")).code, ErrorCode::invalid);
  must(shop_.catalog.add_part("S-1", "slot", {}, "anna"));
  must(shop_.catalog.add_part("S-2", "slot", {{"width", "12.5 mm"}}, "anna"));
  RenderOrder order;
  order.machine = "mill";
  order.delivery = store::Delivery::memory;
  order.part = "S-1";
  const Rendered standard = must(programs_.render(order, "anna"));
  EXPECT_EQ(must(store::read_whole(shop_.store.contents(), standard.program.newest.sha256, 1000)), program);
  EXPECT_EQ(standard.program.newest.origin.mode, "macro");
  order.part = "S-2";
  const Rendered narrow = must(programs_.render(order, "anna"));
  EXPECT_EQ(narrow.result.text, "%\r\nO0042 (SLOT)\r\nG90G21\r\n#100=12.5(WIDTH)\r\nG01X#100F100.\r\nM30\r\n%\r\n");
  EXPECT_EQ(narrow.program.newest.origin.values, "width=12.5 mm");

  // What could not be rendered is not stored.
  const Error wrong =
      refusal(shop_.catalog.change_family("slot", 1, head + "native fanuc\n#100=5.\n#100=6.\nM30\n", "anna"));
  EXPECT_EQ(wrong.code, ErrorCode::invalid);
  EXPECT_NE(wrong.text.find("lines 1 and 2 of the native program"), std::string::npos) << wrong.text;
  EXPECT_EQ(refusal(shop_.catalog.change_family("slot", 1, head + "native klingon\nM30\n", "anna")).places.size(), 1U);
}

TEST_F(ProgramsTest, AWrongOrderStoresNothing) {
  add_roll();
  RenderOrder order;
  order.machine = "lathe";
  EXPECT_EQ(refusal(programs_.render(order, "anna")).code, ErrorCode::invalid) << "neither part nor family";
  order.part = "R-100";
  order.family = "hyperbolic-roll";
  EXPECT_EQ(refusal(programs_.render(order, "anna")).code, ErrorCode::invalid) << "both";
  order.family.clear();
  EXPECT_EQ(refusal(programs_.render(order, "anna")).code, ErrorCode::not_found);
  order.part.clear();
  order.family = "hyperbolic-roll";
  order.values = {{"roll_length", "5 mm"}};
  EXPECT_EQ(refusal(programs_.render(order, "anna")).code, ErrorCode::invalid) << "out of range";
  order.values.clear();
  order.machine = "mill";
  EXPECT_NE(refusal(programs_.render(order, "anna")).text.find("the machine is a mill"), std::string::npos);
  order.machine = "grinder";
  EXPECT_EQ(refusal(programs_.render(order, "anna")).code, ErrorCode::not_found);
  EXPECT_EQ(count(), 0U);
}

TEST_F(ProgramsTest, AVerdictStandsForOneTextOnOneMachineRevision) {
  const store::Program program = must(programs_.upload("O0042", "fanuc", kText, "anna"));
  CheckOrder order{.program = program.id, .revision = 0, .machine = "mill", .delivery = store::Delivery::drip};
  const store::Verdict verdict = must(checking_.check(order, "anna"));
  EXPECT_EQ(verdict.text_sha256, program.newest.sha256);
  EXPECT_EQ(verdict.of.revision, 1U);
  EXPECT_EQ(verdict.of.machine_revision, 1U);
  EXPECT_EQ(verdict.of.report, store::name_of(verdict.of.outcome)) << "the report says the same as the row";
  EXPECT_FALSE(verdict.stale);
  EXPECT_EQ(shop_.last_published(), "verdict mill O0042");
  EXPECT_EQ(must(shop_.store.verdicts().newest(program.newest.sha256, "mill", store::Delivery::drip))->id, verdict.id);
  EXPECT_FALSE(must(shop_.store.verdicts().newest(program.newest.sha256, "mill", store::Delivery::memory)));
  must(shop_.catalog.change_machine("mill", 1, "mill pty:/new", "anna"));
  EXPECT_TRUE(must(shop_.store.verdicts().get(verdict.id)).stale);
}

TEST_F(ProgramsTest, ATextWithAnErrorFails) {
  const store::Program program = must(programs_.upload("O1", "fanuc", "%\nO1\nWHILE[#1LT3]DO1\nM30\n%\n", "anna"));
  const CheckOrder order{.program = program.id, .revision = 1, .machine = "mill", .delivery = store::Delivery::drip};
  EXPECT_EQ(must(checking_.check(order, "anna")).of.outcome, store::Outcome::fail);
}

TEST_F(ProgramsTest, ChecksWhatItIsOrderedToAndNothingElse) {
  const store::Program program = must(programs_.upload("O1", "sinumerik-840d", "G0 X1\nM30\n", "anna"));
  CheckOrder order{.program = program.id, .revision = 0, .machine = "mill", .delivery = store::Delivery::memory};
  EXPECT_EQ(refusal(checking_.check(order, "anna")).code, ErrorCode::invalid) << "another dialect";
  order.machine = "grinder";
  EXPECT_EQ(refusal(checking_.check(order, "anna")).code, ErrorCode::not_found);
  order.program = 99;
  EXPECT_EQ(refusal(checking_.check(order, "anna")).code, ErrorCode::not_found);
  order = {.program = program.id, .revision = 2, .machine = "mill", .delivery = store::Delivery::drip};
  EXPECT_EQ(refusal(checking_.check(order, "anna")).code, ErrorCode::not_found);
  EXPECT_TRUE(must(shop_.store.verdicts().list({})).items.empty());
}

}  // namespace
}  // namespace dripfeed::app
