// Machines, families, parts, programs and contents: round trips, refused changes, pages.
#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class Catalog : public StoreTest {};

TEST_F(Catalog, MachineKeepsEveryRevision) {
  const Machine first = must(store_->machines().add("mill-1", "profile 1", by("anna", 10)));
  EXPECT_EQ(first.revision, 1U);
  const Machine second = must(store_->machines().change("mill-1", 1, "profile 2", by("bert", 20)));
  EXPECT_EQ(second.revision, 2U);
  reopen();
  const Machine newest = must(store_->machines().get("mill-1"));
  EXPECT_EQ(newest.profile, "profile 2");
  EXPECT_EQ(newest.changed_by, "bert");
  EXPECT_EQ(newest.changed_at_ms, 20);
  EXPECT_EQ(must(store_->machines().get("mill-1", 1)).profile, "profile 1");
  EXPECT_EQ(refusal(store_->machines().get("mill-1", 3)), ErrorCode::not_found);
}

TEST_F(Catalog, MachineRefusals) {
  must(store_->machines().add("mill-1", "profile", by("anna")));
  EXPECT_EQ(refusal(store_->machines().add("mill-1", "other", by("anna"))), ErrorCode::exists);
  EXPECT_EQ(refusal(store_->machines().add("", "other", by("anna"))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->machines().get("mill-2")), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->machines().change("mill-2", 1, "p", by("anna"))), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->machines().change("mill-1", 0, "p", by("anna"))), ErrorCode::stale_revision);
  EXPECT_EQ(refusal(store_->machines().change("mill-1", 2, "p", by("anna"))), ErrorCode::stale_revision);
  EXPECT_EQ(must(store_->machines().get("mill-1")).profile, "profile");
}

TEST_F(Catalog, TextsMayHoldAnyBytes) {
  const std::string odd("zero\0 quote ' percent % \xff\n", 26);
  must(store_->families().add("odd ' name", odd, by("anna")));
  EXPECT_EQ(must(store_->families().get("odd ' name")).text, odd);
  EXPECT_EQ(refusal(store_->families().get("odd")), ErrorCode::not_found);
}

TEST_F(Catalog, FamilyRevisionsNewestFirst) {
  must(store_->families().add("roll", "text 1", by("anna")));
  for (Revision revision = 1; revision < 5; ++revision) {
    must(store_->families().change("roll", revision, fmt::format("text {}", revision + 1), by("anna")));
  }
  const auto first = must(store_->families().revisions("roll", {.limit = 3, .after = {}}));
  ASSERT_EQ(first.items.size(), 3U);
  EXPECT_EQ(first.items[0].revision, 5U);
  EXPECT_EQ(first.items[2].text, "text 3");
  const auto second = must(store_->families().revisions("roll", {.limit = 3, .after = first.next}));
  ASSERT_EQ(second.items.size(), 2U);
  EXPECT_EQ(second.items[1].revision, 1U);
  EXPECT_EQ(second.next, "");
  EXPECT_EQ(refusal(store_->families().change("roll", 4, "late", by("anna"))), ErrorCode::stale_revision);
}

TEST_F(Catalog, PartNamesItsFamilyRevision) {
  must(store_->families().add("roll", "text", by("anna")));
  EXPECT_EQ(refusal(store_->parts().add("R-1", {"roll", 2, "{}"}, by("anna"))), ErrorCode::broken_reference);
  EXPECT_EQ(refusal(store_->parts().add("R-1", {"ring", 1, "{}"}, by("anna"))), ErrorCode::broken_reference);
  EXPECT_EQ(refusal(store_->parts().get("R-1")), ErrorCode::not_found) << "a refused part leaves nothing";
  must(store_->parts().add("R-1", {"roll", 1, "{1}"}, by("anna", 7)));
  EXPECT_EQ(refusal(store_->parts().add("R-1", {"roll", 1, "{1}"}, by("anna"))), ErrorCode::exists);
  const Part changed = must(store_->parts().change("R-1", 1, {"roll", 1, "{2}"}, by("bert", 8)));
  EXPECT_EQ(changed.revision, 2U);
  EXPECT_EQ(refusal(store_->parts().change("R-1", 1, {"roll", 1, "{3}"}, by("bert"))), ErrorCode::stale_revision);
  const Part newest = must(store_->parts().get("R-1"));
  EXPECT_EQ(newest.made_of.values, "{2}");
  EXPECT_EQ(newest.made_of.family, "roll");
  EXPECT_EQ(newest.changed_by, "bert");
  EXPECT_EQ(must(store_->parts().get("R-1", 1)).made_of.values, "{1}");
  EXPECT_EQ(must(store_->parts().revisions("R-1", {})).items.size(), 2U);
}

TEST_F(Catalog, PartsOfOneFamily) {
  must(store_->families().add("roll", "text", by("anna")));
  must(store_->families().add("ring", "text", by("anna")));
  for (int i = 0; i < 6; ++i) {
    must(store_->parts().add(fmt::format("P-{}", i), {i % 2 == 0 ? "roll" : "ring", 1, "{}"}, by("anna")));
  }
  const auto page = must(store_->parts().list({.limit = 2, .after = {}}, "ring"));
  ASSERT_EQ(page.items.size(), 2U);
  EXPECT_EQ(page.items[0].number, "P-1");
  const auto rest = must(store_->parts().list({.limit = 2, .after = page.next}, "ring"));
  ASSERT_EQ(rest.items.size(), 1U);
  EXPECT_EQ(rest.items[0].number, "P-5");
  EXPECT_EQ(must(store_->parts().list({})).items.size(), 6U);
}

TEST_F(Catalog, ProgramKnowsWhereItsTextCameFrom) {
  must(store_->machines().add("mill-1", "profile", by("anna")));
  const Program made = add_rendered(*store_, "%\nM30\n%\n", "mill-1");
  reopen({.own = true});  // an owner drops what nothing refers to: this is referred to
  const Program program = must(store_->programs().get(made.id));
  EXPECT_EQ(program.name, "O0100");
  EXPECT_EQ(program.dialect, "fanuc");
  const ProgramRevision& newest = program.newest;
  EXPECT_EQ(newest.revision, 1U);
  EXPECT_EQ(newest.bytes, 8U);
  EXPECT_EQ(newest.blocks, 2U);
  EXPECT_EQ(newest.facts, "facts");
  EXPECT_EQ(newest.origin.kind, OriginKind::rendered);
  EXPECT_EQ(newest.origin.family, "roll");
  EXPECT_EQ(newest.origin.part, "R-100");
  EXPECT_EQ(newest.origin.part_revision, 1U);
  EXPECT_EQ(newest.origin.machine, "mill-1");
  EXPECT_EQ(newest.origin.mode, "explicit");
  EXPECT_EQ(must(read_whole(store_->contents(), newest.sha256, 100)), "%\nM30\n%\n");
  EXPECT_EQ(must(read_whole(store_->contents(), newest.places_sha256, 100)), "places of %\nM30\n%\n");
}

TEST_F(Catalog, ProgramRevisions) {
  const Program program = add_program(*store_, "one");
  NewProgramText next;
  next.sha256 = must(store_->contents().put("two")).sha256;
  EXPECT_EQ(refusal(store_->programs().add_revision(program.id, 2, next, by("anna"))), ErrorCode::stale_revision);
  EXPECT_EQ(refusal(store_->programs().add_revision(99, 1, next, by("anna"))), ErrorCode::not_found);
  const Program changed = must(store_->programs().add_revision(program.id, 1, next, by("anna")));
  EXPECT_EQ(changed.newest.revision, 2U);
  EXPECT_EQ(changed.newest.origin.kind, OriginKind::uploaded);
  EXPECT_EQ(must(store_->programs().get_revision(program.id, 1)).sha256, program.newest.sha256);
  EXPECT_EQ(refusal(store_->programs().get_revision(program.id, 3)), ErrorCode::not_found);
  const auto revisions = must(store_->programs().revisions(program.id, {.limit = 1, .after = {}}));
  EXPECT_EQ(revisions.items[0].revision, 2U);
  EXPECT_EQ(must(store_->programs().revisions(program.id, {.limit = 1, .after = revisions.next})).items[0].revision,
            1U);
}

TEST_F(Catalog, ProgramNeedsWhatItRefersTo) {
  NewProgramText text;
  text.sha256 = std::string(64, 'a');
  EXPECT_EQ(refusal(store_->programs().add("O1", "fanuc", text, by("anna"))), ErrorCode::broken_reference);
  text.sha256 = must(store_->contents().put("x")).sha256;
  EXPECT_EQ(refusal(store_->programs().add("", "fanuc", text, by("anna"))), ErrorCode::invalid_value);
  text.origin.kind = OriginKind::rendered;
  EXPECT_EQ(refusal(store_->programs().add("O1", "fanuc", text, by("anna"))), ErrorCode::invalid_value);
  text.origin.family = "roll";
  text.origin.family_revision = 1;
  EXPECT_EQ(refusal(store_->programs().add("O1", "fanuc", text, by("anna"))), ErrorCode::broken_reference);
  EXPECT_TRUE(must(store_->programs().list({})).items.empty());
}

TEST_F(Catalog, ProgramsByNameAndPart) {
  must(store_->machines().add("mill-1", "profile", by("anna")));
  const Program rendered = add_rendered(*store_, "text", "mill-1");
  const Program uploaded = add_program(*store_, "other", "O0200");
  const auto all = must(store_->programs().list({}));
  ASSERT_EQ(all.items.size(), 2U);
  EXPECT_EQ(all.items[0].id, uploaded.id) << "newest first";
  const auto named = must(store_->programs().list({}, {.name = "O0200", .part = {}}));
  ASSERT_EQ(named.items.size(), 1U);
  EXPECT_EQ(named.items[0].id, uploaded.id);
  const auto of_part = must(store_->programs().list({}, {.name = {}, .part = "R-100"}));
  ASSERT_EQ(of_part.items.size(), 1U);
  EXPECT_EQ(of_part.items[0].id, rendered.id);
  EXPECT_TRUE(must(store_->programs().list({}, {.name = "O0200", .part = "R-100"})).items.empty());
}

TEST_F(Catalog, PagesTileTheList) {
  for (int i = 0; i < 25; ++i) must(store_->machines().add(fmt::format("m{:02}", (i * 7) % 25), "p", by("anna")));
  std::vector<std::string> seen;
  PageRequest request{.limit = 10, .after = {}};
  do {
    const auto page = must(store_->machines().list(request));
    for (const Machine& machine : page.items) seen.push_back(machine.name);
    request.after = page.next;
  } while (!request.after.empty());
  ASSERT_EQ(seen.size(), 25U);
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], fmt::format("m{:02}", i));
  EXPECT_EQ(must(store_->machines().list({.limit = 25, .after = {}})).next, "") << "a full last page has no next";
}

TEST_F(Catalog, BadPagesAreRefused) {
  EXPECT_EQ(refusal(store_->machines().list({.limit = 0, .after = {}})), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->machines().list({.limit = kPageLimitMax + 1, .after = {}})), ErrorCode::invalid_value);
  for (const char* cursor : {"x", "1x", "-1", " 1", "99999999999999999999"}) {
    EXPECT_EQ(refusal(store_->programs().list({.limit = 1, .after = cursor})), ErrorCode::invalid_value) << cursor;
  }
}

}  // namespace
}  // namespace dripfeed::store_test
