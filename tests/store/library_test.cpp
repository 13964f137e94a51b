// What is found by which words, in which order, and which program calls which.
#include "store/sqlite/library.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <set>

#include <sqlite3.h>

#include "store/sqlite/library_words.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;
using Ids = std::vector<Id>;

class LibraryTest : public ::testing::Test {
 protected:
  LibraryTest() { open(); }
  void open() {
    library_.reset();
    library_ = must(sqlite::open_library(path()));
  }
  [[nodiscard]] std::string path() const { return folder_.file("dripfeed.db-library"); }
  void put(LibraryEntry entry) {
    entry.revision = 1;
    if (entry.names.empty()) entry.names = {entry.name};
    must(library_->put({entry}, ++change_));
  }
  Ids found(std::string_view words, bool with_archived = false) {
    Ids ids;
    for (const LibraryHit& hit : must(library_->search(words, {.limit = 100, .after = {}}, with_archived)).items)
      ids.push_back(hit.program);
    return ids;
  }
  std::string snippet(std::string_view words) {
    std::string out;
    const auto page = must(library_->search(words, {.limit = 1, .after = {}}, false));
    if (page.items.empty()) return out;
    for (const SnippetPart& part : page.items[0].snippet) out += part.is_hit ? "<" + part.text + ">" : part.text;
    return out;
  }

  TempFolder folder_{TempFolder::Where::memory};
  std::unique_ptr<Library> library_;
  std::uint64_t change_ = 0;
};

TEST_F(LibraryTest, WordsAreFoundWhereverTheyStand) {
  put({.program = 1, .name = "PUMP-HOUSING", .comments = "Gehäuse außen", .text = "G01 X12.5 F100\nT0505"});
  put({.program = 2,
       .name = "O0012",
       .numbers = "O0012",
       .labels = "rush acme/pumps",
       .part = "R-17",
       .machines = "mill-3",
       .text = "M98 P34"});
  put({.program = 3, .name = "FLANGE", .text = "G01 X12.75"});
  EXPECT_EQ(found("pump"), (Ids{1, 2}));
  EXPECT_EQ(found("hous"), Ids{1}) << "a word stands for those that begin so";
  EXPECT_EQ(found("GEHAUSE"), Ids{1}) << "and marks over letters do not count";
  EXPECT_EQ(found("R-17"), Ids{2});
  EXPECT_EQ(found("mill-3 rush"), Ids{2}) << "all words, each anywhere";
  EXPECT_EQ(found("mill-3 flange"), Ids{});
  EXPECT_EQ(found("\"X12.5\""), Ids{1});
  EXPECT_EQ(found("\"G01 X12\""), (Ids{3, 1}));
  EXPECT_EQ(found("AND OR NOT"), Ids{}) << "words, not operators";
  EXPECT_EQ(found("pump) OR (flange"), Ids{});
}

TEST_F(LibraryTest, WordsOfAProgramAreFoundWithAndWithoutZeros) {
  put({.program = 1, .name = "A", .text = "G01 T0505 M06"});
  put({.program = 2, .name = "B", .text = "G1 T505 M6"});
  put({.program = 3, .name = "C", .text = "G10 M60 T5050"});
  for (const char* words : {"G1", "g01", "T505", "T0505", "M6", "M06"}) EXPECT_EQ(found(words), (Ids{2, 1})) << words;
  EXPECT_EQ(found("M6*"), (Ids{3, 2, 1})) << "with an asterisk all that begin so";
  put({.program = 4, .name = "O0012", .numbers = "O0012"});
  EXPECT_EQ(found("O12"), Ids{4});
}

TEST_F(LibraryTest, NamesComeBeforeCommentsAndThoseBeforeTexts) {
  put({.program = 1, .name = "SHAFT-OLD"});
  put({.program = 2, .name = "SHAFT"});
  put({.program = 3, .name = "X", .comments = "SHAFT"});
  put({.program = 4, .name = "Y", .text = "SHAFT SHAFT SHAFT"});
  put({.program = 5, .name = "SHAFD", .comments = "SHAFT", .text = "SHAFT"});
  put({.program = 6, .name = "SHAFD"});
  EXPECT_EQ(found("shaft"), (Ids{2, 1, 5, 3, 4, 6})) << "and the newest first among those";
}

TEST_F(LibraryTest, ShortBeginningsAreLookedForInNamesOnly) {
  put({.program = 1, .name = "PUMP", .text = "X100 GROOVE"});
  put({.program = 2, .name = "X-PLATE", .comments = "10 HOLES"});
  EXPECT_EQ(found("x"), Ids{2});
  EXPECT_EQ(found("x*"), Ids{2});
  EXPECT_EQ(found("1"), Ids{2}) << "digits, too";
  EXPECT_EQ(found("gro"), Ids{1});
  EXPECT_EQ(found("gr*"), Ids{1});
}

TEST_F(LibraryTest, NearlyRightNamesComeLast) {
  put({.program = 1, .name = "PUMPENGEHAEUSE"});
  put({.program = 2, .name = "FLANGE-LEFT"});
  put({.program = 3, .name = "SHAFT"});
  EXPECT_EQ(found("PUMPNEGEHAEUSE"), Ids{1}) << "two letters exchanged";
  EXPECT_EQ(found("FLANSE"), Ids{2}) << "one is wrong";
  EXPECT_EQ(found("FLANG LEFFT"), Ids{2}) << "each word";
  EXPECT_EQ(found("SHFT"), Ids{3}) << "one is missing";
  EXPECT_EQ(found("SHIRT"), Ids{}) << "another word";
  EXPECT_EQ(found("FLA"), Ids{2}) << "right as far as it goes";
  const auto page = must(library_->search("FLANSE", {}, false));
  EXPECT_TRUE(page.items[0].is_similar);
  EXPECT_FALSE(must(library_->search("FLANGE", {}, false)).items[0].is_similar);
}

TEST_F(LibraryTest, SnippetsMarkWhatWasFound) {
  put({.program = 1, .name = "A", .text = "G00 X0\nG76 P010060\nM30"});
  EXPECT_EQ(snippet("g76"), "G00 X0\n<G76> P010060\nM30");
  put({.program = 2, .name = "PUMP"});
  EXPECT_EQ(snippet("pu"), "<PUMP>");
}

TEST_F(LibraryTest, PagesHaveEachOnce) {
  for (Id id = 1; id <= 57; ++id)
    put({.program = id, .name = id % 3 == 0 ? "PUMQ" : "PUMP", .text = std::string(id, 'x')});
  std::set<Id> seen;
  store::PageRequest page{.limit = 5, .after = {}};
  std::size_t pages = 0;
  std::vector<bool> similar;
  for (;; ++pages) {
    const auto got = must(library_->search("PUMP", page, false));
    for (const LibraryHit& hit : got.items) {
      EXPECT_TRUE(seen.insert(hit.program).second) << hit.program;
      similar.push_back(hit.is_similar);
    }
    if (got.next.empty()) break;
    page.after = got.next;
  }
  EXPECT_EQ(seen.size(), 57U);
  EXPECT_EQ(pages, 11U);
  EXPECT_TRUE(std::ranges::is_sorted(similar)) << "what is right comes first";
  for (const char* bad : {"x", "w1", "w1.2x", "n.1", "w99999999999999999999.1"})
    EXPECT_EQ(refusal(library_->search("PUMP", {.limit = 5, .after = bad}, false)), ErrorCode::invalid_value) << bad;
  for (const char* nothing : {"", "  ", "\"\"", "-- *", "()"})
    EXPECT_EQ(refusal(library_->search(nothing, {}, false)), ErrorCode::invalid_value) << nothing;
}

TEST_F(LibraryTest, AnEntryIsReplaced) {
  put({.program = 1, .name = "PUMP", .text = "T1", .calls = {{"O9", CallKind::macro, 3}}});
  put({.program = 1, .name = "PUMP", .text = "T2", .is_archived = true});
  EXPECT_EQ(found("T1"), Ids{});
  EXPECT_EQ(found("T2"), Ids{}) << "archived";
  EXPECT_EQ(found("T2", true), Ids{1});
  EXPECT_TRUE(must(library_->calls_of(1)).calls.empty());
  EXPECT_EQ(must(library_->state()).change, 2U);
  EXPECT_EQ(must(library_->state()).programs, 1U);
  must(library_->clear());
  EXPECT_EQ(must(library_->state()).change, 0U);
  EXPECT_EQ(found("pump", true), Ids{});
}

TEST_F(LibraryTest, CountsWhatIsInIt) {
  const auto counts = [&] {
    const LibraryState state = must(library_->state());
    return std::array{state.programs, state.cut, state.not_read};
  };
  put({.program = 1, .name = "PUMP", .is_cut = true});
  put({.program = 2, .name = "GEAR", .is_cut = true, .not_read = "it is so long"});
  put({.program = 3, .name = "VALVE"});
  EXPECT_EQ(counts(), (std::array<std::uint64_t, 3>{3, 2, 1}));
  put({.program = 1, .name = "PUMP"});
  EXPECT_EQ(counts(), (std::array<std::uint64_t, 3>{3, 1, 1})) << "its new revision is in it whole";
  must(library_->put({{.program = 2, .revision = 0}}, ++change_));
  EXPECT_EQ(counts(), (std::array<std::uint64_t, 3>{2, 0, 0})) << "a program that went";
  must(library_->put({{.program = 2, .revision = 0}}, ++change_));
  EXPECT_EQ(counts(), (std::array<std::uint64_t, 3>{2, 0, 0})) << "it was not in it";
  must(library_->clear());
  EXPECT_EQ(counts(), (std::array<std::uint64_t, 3>{0, 0, 0}));
}

TEST_F(LibraryTest, CallsLeadInBothDirections) {
  put({.program = 1,
       .name = "MAIN.NC",
       .names = {"MAIN", "O1"},
       .calls = {{"O9010", CallKind::macro, 4}, {"O2", CallKind::subprogram, 2}},
       .computed_calls = 1});
  put({.program = 2, .name = "O9010", .names = {"O9010"}});
  put({.program = 3, .name = "O9010", .names = {"O9010"}});  // one name, two programs
  const auto callers = must(library_->callers_of(2));
  ASSERT_EQ(callers.size(), 1U);
  EXPECT_EQ(callers[0].program, 1U);
  EXPECT_EQ(callers[0].call.line, 4U);
  EXPECT_EQ(callers[0].call.kind, CallKind::macro);
  EXPECT_EQ(must(library_->named("O9010")), (Ids{2, 3}));
  const KnownCalls calls = must(library_->calls_of(1));
  ASSERT_EQ(calls.calls.size(), 2U);
  EXPECT_EQ(calls.calls[0].name, "O2");
  EXPECT_EQ(calls.computed, 1U);
  EXPECT_TRUE(must(library_->callers_of(1)).empty());
  EXPECT_FALSE(must(library_->calls_of(77)).is_known);
}

TEST_F(LibraryTest, IsKeptAndMadeAgainWhereItCannotBeUsed) {
  put({.program = 1, .name = "PUMP"});
  open();
  EXPECT_EQ(found("pump"), Ids{1});
  library_.reset();
  for (const char* ending : {"-wal", "-shm"}) std::filesystem::remove(path() + ending);
  std::ofstream(path(), std::ios::binary | std::ios::trunc) << std::string(8192, 'x');
  open();
  EXPECT_EQ(found("pump"), Ids{});
  EXPECT_EQ(must(library_->state()).change, 0U) << "all is to be put in again";
  put({.program = 1, .name = "PUMP"});
  EXPECT_EQ(found("pump"), Ids{1});
}

TEST_F(LibraryTest, OfAnotherVersionIsMadeAgain) {
  put({.program = 1, .name = "PUMP"});
  library_.reset();
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open(path().c_str(), &connection), SQLITE_OK);
  const char* const older =
      "DROP TRIGGER entry_comes; DROP TRIGGER entry_goes; ALTER TABLE reached DROP COLUMN programs; "
      "PRAGMA user_version = 1";
  EXPECT_EQ(sqlite3_exec(connection, older, nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(connection);
  open();
  EXPECT_EQ(must(library_->state()).change, 0U) << "all is to be put in again";
  put({.program = 1, .name = "PUMP"});
  EXPECT_EQ(must(library_->state()).programs, 1U);
}

std::string match(std::string_view words, sqlite::Reach reach = sqlite::Reach::text) {
  return sqlite::match_of(sqlite::terms_of(words), reach);
}

TEST(LibraryWords, AreNeverOperators) {
  EXPECT_EQ(match("pump xyz\"y"), "\"pump\"* AND \"xyz\"* AND \"y\"");
  EXPECT_EQ(match("NEAR(a)"), "\"NEAR(a)\"*");
  EXPECT_EQ(match("g1"), "(\"g1\" OR \"g01\" OR \"g0001\")");
  EXPECT_EQ(match("17", sqlite::Reach::head), "(\"17\"* OR \"0017\"*)");
  EXPECT_EQ(match("17"), "(\"17\" OR \"0017\")");
  EXPECT_EQ(match("  ^ "), "");
}

TEST(LibraryWords, OneLetterOfFourMayBeWrong) {
  EXPECT_TRUE(sqlite::is_near("pump", "pump"));
  EXPECT_TRUE(sqlite::is_near("pmup", "pump"));
  EXPECT_TRUE(sqlite::is_near("pxmp", "pump"));
  EXPECT_TRUE(sqlite::is_near("pxmp", "pumping"));
  EXPECT_FALSE(sqlite::is_near("pxmx", "pump"));
  EXPECT_TRUE(sqlite::is_near("housnig", "housing"));
  EXPECT_TRUE(sqlite::is_near("maniofld", "manifold"));
  EXPECT_FALSE(sqlite::is_near("abc", "abd")) << "three letters are too few for a fault";
  EXPECT_FALSE(sqlite::may_have_a_fault("4711"));
}

}  // namespace
}  // namespace dripfeed::store_test
