// Tags, folders and the archive of programs, and the order in which programs were changed.
#include <algorithm>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class Labels : public StoreTest {
 protected:
  std::vector<std::string> names(const ProgramFilter& filter) {
    std::vector<std::string> found;
    for (const Program& one : must(store_->programs().list({}, filter)).items) found.push_back(one.name);
    std::ranges::sort(found);
    return found;
  }
  Program put(const std::string& name, const std::vector<std::string>& tags, const std::string& folder) {
    const Program program = add_program(*store_, "%\n" + name + "\nM30\n%\n", name);
    return must(store_->programs().label(program.id, {.tags = tags, .folder = folder}, by("paula")));
  }
};

using Names = std::vector<std::string>;

TEST_F(Labels, AreKeptAndFilteredBy) {
  EXPECT_EQ(put("O1", {"pump", "alu", "pump"}, "acme/pumps").tags, (Names{"alu", "pump"}));
  put("O2", {"pump"}, "acme");
  put("O3", {}, "acme_2");
  EXPECT_EQ(names({.tag = "pump"}), (Names{"O1", "O2"}));
  EXPECT_EQ(names({.tag = "pum"}), Names{});
  EXPECT_EQ(names({.folder = "acme"}), (Names{"O1", "O2"}))
      << "those below it, not those that begin with the same letters";
  EXPECT_EQ(names({.folder = "acme/pumps"}), Names{"O1"});
  EXPECT_EQ(names({.folder = "acme_2"}), Names{"O3"});
  EXPECT_EQ(names({.folder = "acmeX2"}), Names{}) << "an underline is no wildcard";
  EXPECT_EQ(names({.tag = "pump", .folder = "acme/pumps"}), Names{"O1"});
}

TEST_F(Labels, WhatIsNotGivenStays) {
  const Program first = put("O1", {"a"}, "f");
  const Program moved = must(store_->programs().label(first.id, {.folder = "g"}, by("paula")));
  EXPECT_EQ(moved.tags, Names{"a"});
  EXPECT_EQ(moved.folder, "g");
  const Program bare = must(store_->programs().label(first.id, {.tags = Names{}}, by("paula")));
  EXPECT_TRUE(bare.tags.empty());
  EXPECT_EQ(bare.folder, "g");
  EXPECT_EQ(bare.newest.revision, 1U) << "labels make no revision";
  EXPECT_EQ(refusal(store_->programs().label(first.id, {.tags = Names{""}}, by("paula"))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->programs().label(99, {}, by("paula"))), ErrorCode::not_found);
  EXPECT_EQ(must(store_->programs().get(first.id)).folder, "g");
}

TEST_F(Labels, AnArchivedProgramTakesNothingNew) {
  const Program program = put("O1", {}, "");
  EXPECT_EQ(refusal(store_->programs().archive(program.id, "", by("paula"))), ErrorCode::invalid_value);
  const Program archived = must(store_->programs().archive(program.id, "sold", by("paula", 77)));
  EXPECT_EQ(archived.archived.by, "paula");
  EXPECT_EQ(archived.archived.reason, "sold");
  EXPECT_EQ(archived.archived.at_ms, 77);
  EXPECT_EQ(names({.shelf = Shelf::in_use}), Names{});
  EXPECT_EQ(names({.shelf = Shelf::archived}), Names{"O1"});
  EXPECT_EQ(names({}), Names{"O1"});
  const Content text = must(store_->contents().put("%\nO1\nG0\nM30\n%\n"));
  EXPECT_EQ(refusal(store_->programs().add_revision(program.id, 1, {.sha256 = text.sha256}, by("paula"))),
            ErrorCode::refused_transition);
  must(store_->machines().add("mill-1", "{}", by("paula")));
  EXPECT_EQ(refusal(store_->releases().add({program.id, 1, "mill-1", Delivery::drip}, by("paula"))),
            ErrorCode::refused_transition);
  EXPECT_EQ(refusal(store_->programs().archive(program.id, "again", by("paula"))), ErrorCode::refused_transition);
  EXPECT_FALSE(must(store_->programs().fetch_back(program.id, "it is ordered again", by("paula"))).is_archived());
  EXPECT_EQ(refusal(store_->programs().fetch_back(program.id, "again", by("paula"))), ErrorCode::refused_transition);
  must(store_->programs().add_revision(program.id, 1, {.sha256 = text.sha256}, by("paula")));
}

TEST_F(Labels, WhatIsInWorkIsNotArchived) {
  const Job job = add_job(*store_, "mill-1");
  const auto refused = store_->programs().archive(job.program, "sold", by("paula"));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().detail.find("job 1"), std::string::npos) << refused.error().detail;
  must(store_->jobs().move(job.id, {.to = JobState::cancelled}, by("paula")));
  EXPECT_EQ(refusal(store_->programs().archive(job.program, "sold", by("paula"))), ErrorCode::refused_transition);
  must(store_->releases().move(job.release, {.to = ReleaseState::obsolete}, by("paula")));
  must(store_->programs().archive(job.program, "sold", by("paula")));
}

TEST_F(Labels, ChangesAreInOrder) {
  const Program one = put("O1", {}, "");
  const Program two = put("O2", {}, "");
  EXPECT_EQ(must(store_->programs().count_changed_after(0)), 2U);
  const Program again = must(store_->programs().label(one.id, {.folder = "f"}, by("paula")));
  EXPECT_GT(again.change, two.change);
  const auto all = must(store_->programs().changed_after(0, 10));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, two.id);
  EXPECT_EQ(all[1].id, one.id);
  EXPECT_EQ(must(store_->programs().changed_after(0, 1)).size(), 1U);
  EXPECT_TRUE(must(store_->programs().changed_after(again.change, 10)).empty());
}

TEST_F(Labels, WhatWasArchivedLongEnoughIsErased) {
  const Program program = put("O1", {"pump"}, "acme");
  const auto erase = [&](std::int64_t until_ms, const std::string& reason) {
    return store_->programs().erase(program.id, until_ms, reason, by("anna", 200));
  };
  EXPECT_EQ(refusal(erase(1000, "sold")), ErrorCode::refused_transition) << "it is in use";
  must(store_->programs().archive(program.id, "sold", by("paula", 100)));
  EXPECT_EQ(refusal(erase(99, "sold")), ErrorCode::refused_transition) << "archived later";
  EXPECT_EQ(refusal(erase(100, "")), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->programs().erase(99, 100, "sold", by("anna"))), ErrorCode::not_found);
  must(store_->attachments().add(
      {.to = {.program = program.id}, .name = "a", .media_type = "b/c", .sha256 = program.newest.sha256}, by("anna")));
  const Program erased = must(erase(100, "nobody makes it"));
  EXPECT_EQ(erased.id, program.id);
  EXPECT_EQ(erased.name, "O1");
  EXPECT_EQ(erased.deleted.by, "anna");
  EXPECT_EQ(erased.deleted.reason, "nobody makes it");
  EXPECT_EQ(erased.newest.revision, 0U) << "nothing names its text";
  EXPECT_EQ(names({}), Names{});
  EXPECT_EQ(names({.shelf = Shelf::archived}), Names{});
  EXPECT_EQ(must(store_->programs().changed_after(program.change, 9)).back().id, program.id);
  EXPECT_TRUE(must(store_->attachments().list({})).items.empty());
  EXPECT_EQ(refusal(erase(100, "again")), ErrorCode::refused_transition);
  EXPECT_EQ(refusal(store_->programs().fetch_back(program.id, "again", by("anna"))), ErrorCode::refused_transition);
  EXPECT_EQ(refusal(store_->programs().label(program.id, {.folder = "f"}, by("anna"))), ErrorCode::refused_transition);
  reopen({.own = true});
  EXPECT_EQ(refusal(store_->contents().find(program.newest.sha256)), ErrorCode::not_found);
  EXPECT_GT(put("O1", {}, "acme").id, program.id) << "its id never comes back, its name does";
  must(store_->check());
}

TEST_F(Labels, WhatHistoryNamesStaysWithItsText) {
  const Job job = add_job(*store_, "mill-1");
  const Content later = must(store_->contents().put("%\nO1 (later)\nM30\n%\n"));
  must(store_->programs().add_revision(job.program, 1, {.sha256 = later.sha256}, by("paula")));
  must(store_->jobs().move(job.id, {.to = JobState::cancelled}, by("paula")));
  must(store_->releases().move(job.release, {.to = ReleaseState::obsolete}, by("paula")));
  must(store_->programs().archive(job.program, "sold", by("paula", 100)));
  EXPECT_EQ(must(store_->programs().erase(job.program, 100, "sold", by("anna"))).newest.revision, 0U);
  reopen({.own = true});
  EXPECT_EQ(must(store_->programs().get_revision(job.program, 1)).sha256, job.text_sha256);
  must(store_->contents().verify(job.text_sha256));
  EXPECT_EQ(refusal(store_->contents().find(later.sha256)), ErrorCode::not_found) << "no job named it";
  EXPECT_EQ(must(store_->jobs().get(job.id)).program, job.program);
  EXPECT_EQ(must(store_->ledger().interval(job.id)).high, 0U);
  must(store_->check());
}

TEST_F(Labels, ADraftKeepsAProgramFromBeingErased) {
  const Program drafted = put("O1", {}, "");
  must(store_->machines().add("mill-1", "{}", by("paula")));
  const Release draft = must(store_->releases().add({drafted.id, 1, "mill-1", Delivery::drip}, by("paula")));
  must(store_->programs().archive(drafted.id, "sold", by("paula", 100)));
  const auto refused = store_->programs().erase(drafted.id, 100, "sold", by("anna"));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().detail.find("release 1"), std::string::npos) << refused.error().detail;
  must(store_->releases().move(draft.id, {.to = ReleaseState::obsolete}, by("paula")));
  must(store_->programs().erase(drafted.id, 100, "sold", by("anna")));
}

TEST_F(Labels, AJobThatCallsItKeepsAProgramFromBeingErased) {
  const Job job = add_job(*store_, "mill-1");
  const Program called = put("O9", {}, "");
  must(store_->verdicts().add({.program = job.program,
                               .revision = 1,
                               .machine = "mill-1",
                               .machine_revision = 1,
                               .outcome = Outcome::pass,
                               .calls = {{.name = "O9", .program = called.id, .revision = 1}}},
                              by("paula")));
  must(store_->programs().archive(called.id, "sold", by("paula", 100)));
  const auto refused = store_->programs().erase(called.id, 100, "sold", by("anna"));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().detail.find("job 1 calls it"), std::string::npos) << refused.error().detail;
  must(store_->jobs().move(job.id, {.to = JobState::cancelled}, by("paula")));
  EXPECT_EQ(must(store_->programs().erase(called.id, 100, "sold", by("anna"))).newest.revision, 1U)
      << "a verdict names it";
}

}  // namespace
}  // namespace dripfeed::store_test
