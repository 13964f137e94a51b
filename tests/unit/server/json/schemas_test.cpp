// The tables of schemas: each name once, no reference to nothing, a sentence for each member, the words of each enum.
#include "server/json/schemas.h"

#include <algorithm>
#include <functional>
#include <set>

#include <gmock/gmock.h>

#include "server/json/enumerators.h"
#include "server/json/glossary.h"
#include "server/json/records.h"

namespace dripfeed::json {
namespace {

using ::testing::ElementsAre;

using Visit = std::function<void(const Schema&, const std::string& path)>;

void walk(const Schema& schema, const std::string& path, const Visit& visit) {
  visit(schema, path);
  for (const Member& member : schema.members) walk(member.schema, path + "/" + member.name, visit);
  for (const Schema& element : schema.of) walk(element, path + "/*", visit);
}

void walk_all(const Visit& visit) {
  for (const NamedSchema& one : all_schemas()) walk(one.schema, one.name, visit);
}

const Schema* find(const Schemas& all, std::string_view name) {
  const auto found = std::ranges::find(all, name, &NamedSchema::name);
  return found == all.end() ? nullptr : &found->schema;
}

const Schema* member_of(const Schema& schema, std::string_view name) {
  const auto found = std::ranges::find(schema.members, name, &Member::name);
  return found == schema.members.end() ? nullptr : &found->schema;
}

TEST(Schemas, NamesAreGivenOnceAndReferencesLeadSomewhere) {
  std::set<std::string> names;
  for (const NamedSchema& one : all_schemas()) EXPECT_TRUE(names.insert(one.name).second) << one.name;
  walk_all([&](const Schema& schema, const std::string& path) {
    EXPECT_TRUE(schema.kind != Schema::Kind::reference || names.contains(schema.name)) << path;
    std::set<std::string> members;
    for (const Member& member : schema.members) EXPECT_TRUE(members.insert(member.name).second) << path << member.name;
  });
}

TEST(Schemas, EveryMemberHasAMeaning) {
  walk_all([](const Schema& schema, const std::string& path) {
    const bool is_element = path.ends_with("/*");
    EXPECT_TRUE(is_element || schema.kind == Schema::Kind::reference || !schema.about.empty()) << path;
  });
}

TEST(Schemas, EveryRowOfTheGlossaryIsUsed) {
  std::set<std::string, std::less<>> sentence_of;
  walk_all([&](const Schema& schema, const std::string&) { sentence_of.insert(schema.about); });
  std::set<std::string_view> paths;
  for (const GlossaryRow& row : glossary()) {
    EXPECT_TRUE(sentence_of.contains(row.about)) << row.path;
    EXPECT_TRUE(paths.insert(row.path).second)
        << row.path << " has two rows: the first one takes the place of the other";
  }
}

TEST(Schemas, EveryKindOfEventHasOne) {
  const Schemas all = all_schemas();
  const Words kinds = names_of<app::EventKind>(event_name);
  EXPECT_THAT(kinds, ElementsAre("job", "machine", "verdict", "alarm", "receipt"));
  for (const std::string_view kind : kinds) {
    std::string name = "Event" + std::string(kind);
    name[5] = static_cast<char>(name[5] - 'a' + 'A');
    EXPECT_NE(find(all, name), nullptr) << name;
  }
}

// The readers describe themselves: what is refused by them is so in the schema.
TEST(Schemas, RequestsAreDescribedByTheirReaders) {
  const Schemas all = all_schemas();
  const Schema* const check = find(all, "CheckOrder");
  ASSERT_NE(check, nullptr);
  EXPECT_TRUE(check->is_closed);
  EXPECT_EQ(check->members[0].name, "program");
  EXPECT_EQ(check->members[0].presence, Presence::required);
  EXPECT_EQ(check->members[0].schema.least, 1.0);
  EXPECT_EQ(check->members[1].presence, Presence::optional);
  EXPECT_TRUE(check->members[1].schema.may_be_null);
  EXPECT_THAT(member_of(*check, "delivery")->words, ElementsAre("drip", "memory"));
  ASSERT_NE(member_of(*check, "nominal"), nullptr);
  EXPECT_NE(member_of(*member_of(*check, "nominal"), "family"), nullptr);
  EXPECT_EQ(member_of(*check, "baud"), nullptr);
  EXPECT_NE(member_of(*find(all, "TimingOrder"), "baud"), nullptr);
  const Schema* const axes = member_of(*find(all, "Profile"), "axes");
  ASSERT_NE(axes, nullptr);
  EXPECT_EQ(member_of(axes->of.front(), "name")->words.size(), 9U);
}

enum class Color : std::uint8_t { none, red, green };
std::string_view color_name(Color color) {
  static constexpr std::string_view kNames[] = {"", "red", "green"};
  return kNames[static_cast<std::size_t>(color)];
}

TEST(Enumerators, AreCountedByTheCompiler) {
  static_assert(enumerators<Color>() == 3);
  static_assert(enumerators<app::LineState>() == static_cast<std::size_t>(app::LineState::answering) + 1);
  EXPECT_THAT(names_of<Color>(color_name), ElementsAre("red", "green"));
}

}  // namespace
}  // namespace dripfeed::json
