// Attachments: of one owner, under one name, until a person removes them; what becomes of their bytes.
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class Attachments : public StoreTest {
 protected:
  Result<Attachment> attach(const AttachedTo& to, const std::string& name, const std::string& bytes) {
    const Content content = must(store_->contents().put(bytes));
    return store_->attachments().add(
        {.to = to, .name = name, .media_type = "application/pdf", .sha256 = content.sha256}, by("paula", 50));
  }
  Id a_program() { return add_program(*store_, "%\nO1\nM30\n%\n").id; }
  std::vector<std::string> names(const AttachedTo& of) {
    std::vector<std::string> found;
    for (const Attachment& one : must(store_->attachments().list({}, of)).items) found.push_back(one.of.name);
    return found;
  }
};

using Names = std::vector<std::string>;

TEST_F(Attachments, BelongToAProgramAFamilyAPartOrAnOrder) {
  const Id program = a_program();
  must(store_->families().add("roll", "family roll", by("paula")));
  must(store_->parts().add("R-1", {.family = "roll", .family_revision = 1, .values = "{}"}, by("paula")));
  const Id order = must(store_->orders().add({.number = "A-1", .plan = {.part = "R-1"}}, by("paula"))).id;
  const Attachment sheet = must(attach({.program = program}, "sheet.pdf", "12345"));
  EXPECT_EQ(sheet.of.to, AttachedTo{.program = program});
  EXPECT_EQ(sheet.bytes, 5U);
  EXPECT_EQ(sheet.added_by, "paula");
  EXPECT_EQ(sheet.added_at_ms, 50);
  EXPECT_FALSE(sheet.is_removed());
  must(attach({.family = "roll"}, "sheet.pdf", "of the family"));
  must(attach({.part = "R-1"}, "sheet.pdf", "12345"));
  must(attach({.order = order}, "order.pdf", "of the order"));
  EXPECT_EQ(names({.program = program}), Names{"sheet.pdf"});
  EXPECT_EQ(names({.family = "roll"}), Names{"sheet.pdf"});
  EXPECT_EQ(names({.part = "R-1"}), Names{"sheet.pdf"});
  EXPECT_EQ(names({.order = order}), Names{"order.pdf"});
  EXPECT_EQ(names({}), (Names{"order.pdf", "sheet.pdf", "sheet.pdf", "sheet.pdf"})) << "newest first";
  EXPECT_EQ(must(store_->attachments().list({.limit = 3})).items.size(), 3U);
}

TEST_F(Attachments, AreRefusedWithoutOneOwnerANameOrBytes) {
  const Id program = a_program();
  EXPECT_EQ(refusal(attach({}, "a", "1")), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(attach({.program = program, .part = "R-1"}, "a", "1")), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(attach({.program = program}, "", "1")), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(attach({.program = program + 1}, "a", "1")), ErrorCode::broken_reference);
  EXPECT_EQ(refusal(attach({.part = "R-1"}, "a", "1")), ErrorCode::broken_reference);
  EXPECT_EQ(refusal(store_->attachments().list({}, {.program = 1, .order = 1})), ErrorCode::invalid_value);
  const NewAttachment hollow{
      .to = {.program = program}, .name = "a", .media_type = "b", .sha256 = std::string(64, '0')};
  EXPECT_EQ(refusal(store_->attachments().add(hollow, by("paula"))), ErrorCode::broken_reference);
  EXPECT_EQ(names({}), Names{});
}

TEST_F(Attachments, AreRemovedWithAReasonAndTheRowStays) {
  const Id program = a_program();
  const Attachment first = must(attach({.program = program}, "sheet.pdf", "old"));
  EXPECT_EQ(refusal(attach({.program = program}, "sheet.pdf", "new")), ErrorCode::exists);
  EXPECT_EQ(refusal(store_->attachments().remove(first.id, "", by("paula"))), ErrorCode::invalid_value);
  const Attachment removed = must(store_->attachments().remove(first.id, "of the old fixture", by("olga", 70)));
  EXPECT_EQ(removed.removed_by, "olga");
  EXPECT_EQ(removed.removed_reason, "of the old fixture");
  EXPECT_EQ(removed.removed_at_ms, 70);
  EXPECT_EQ(removed.of.sha256, first.of.sha256);
  EXPECT_EQ(refusal(store_->attachments().remove(first.id, "again", by("olga"))), ErrorCode::refused_transition);
  EXPECT_EQ(refusal(store_->attachments().remove(99, "why", by("olga"))), ErrorCode::not_found);
  EXPECT_EQ(names({.program = program}), Names{});
  must(attach({.program = program}, "sheet.pdf", "new"));
  EXPECT_EQ(names({.program = program}), Names{"sheet.pdf"});
  EXPECT_EQ(must(store_->attachments().get(first.id)).of.name, "sheet.pdf");
  EXPECT_EQ(sql("UPDATE attachment SET name = 'another'"), "append-only");
  EXPECT_EQ(sql("UPDATE attachment SET removed_reason = 'another' WHERE removed_at_ms <> 0"), "append-only");
}

TEST_F(Attachments, KeepTheirBytesUntilTheyAreRemoved) {
  const Attachment one = must(attach({.program = a_program()}, "sheet.pdf", "bytes of a sheet"));
  EXPECT_EQ(sql("DELETE FROM content_chunk"), "append-only");
  reopen({.own = true});
  EXPECT_EQ(must(read_whole(store_->contents(), one.of.sha256, 100)), "bytes of a sheet");
  must(store_->check());
  must(store_->attachments().remove(one.id, "wrong part", by("paula")));
  reopen({.own = true});
  EXPECT_EQ(refusal(store_->contents().find(one.of.sha256)), ErrorCode::not_found) << "nothing else refers to them";
  EXPECT_EQ(must(store_->attachments().get(one.id)).of.sha256, one.of.sha256);
  must(store_->check());
}

}  // namespace
}  // namespace dripfeed::store_test
