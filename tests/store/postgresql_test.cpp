// What only a store on a server has: a database that others use, connections that break, an owner that lost its lock.
#include <thread>

#include <fmt/format.h>

#include "store/postgresql/open.h"
#include "store/postgresql/verify.h"
#include "tests/store/fixture.h"
#include "tests/store/postgresql_server.h"

namespace dripfeed::store_test {
namespace {

using namespace store;
using namespace std::chrono_literals;

class PostgresqlTest : public StoreTest {
 protected:
  PostgresqlTest() { EXPECT_EQ(engine(), EngineKind::postgresql); }
  [[nodiscard]] std::string add_machine(const std::string& name) const {
    const auto added = store_->machines().add(name, "profile", by("anna"));
    return added ? "" : std::string(name_of(added.error().code));
  }
};

TEST_F(PostgresqlTest, TablesAreMadeOnlyWhenAsked) {
  make_database("made_when_asked");
  const std::string url = database_url("made_when_asked");
  EXPECT_EQ(refusal(postgresql::open(url, {.create = false})), ErrorCode::cannot_open);
  EXPECT_EQ(refusal(postgresql::verify(url)), ErrorCode::cannot_open);
  must(postgresql::open(url));
  must(postgresql::open(url, {.create = false}));
  EXPECT_EQ(refusal(postgresql::open(database_url("no_such"))), ErrorCode::cannot_open);
}

TEST_F(PostgresqlTest, AnotherProgramsTablesAreLeftAlone) {
  make_database("of_others");
  EXPECT_EQ(run_sql("of_others", "CREATE TABLE migration (id INTEGER)"), "");
  EXPECT_EQ(refusal(postgresql::open(database_url("of_others"))), ErrorCode::not_a_store);
  EXPECT_EQ(run_sql("of_others", "ALTER TABLE migration DROP COLUMN id; DROP TABLE migration"), "");
}

TEST_F(PostgresqlTest, AConnectionThatBreaksIsMadeAgain) {
  reopen({.own = true});
  EXPECT_EQ(add_machine("mill-1"), "");
  const std::uint64_t before = must(store_->version());
  cut_connections(database_);
  EXPECT_EQ(must(store_->machines().get("mill-1")).revision, 1U);
  EXPECT_EQ(add_machine("mill-2"), "");
  EXPECT_NE(must(store_->version()), before);
}

TEST_F(PostgresqlTest, WhatWasBegunWhenItBrokeIsUndone) {
  const auto broken = store_->atomically([&]() -> Result<void> {
    EXPECT_EQ(add_machine("mill-1"), "");
    cut_connections(database_);
    const auto late = store_->machines().add("mill-2", "profile", by("anna"));
    return late ? Result<void>() : std::unexpected(late.error());
  });
  EXPECT_EQ(refusal(broken), ErrorCode::no_answer);
  EXPECT_EQ(refusal(store_->machines().get("mill-1")), ErrorCode::not_found);
  EXPECT_EQ(add_machine("mill-1"), "");
}

TEST_F(PostgresqlTest, AnOwnerWhomAnotherOneReplacedWritesNoMore) {
  reopen({.own = true});
  EXPECT_EQ(add_machine("mill-1"), "");
  cut_connections(database_);
  must(open_second({.own = true}));  // it has come, and gone
  EXPECT_EQ(add_machine("mill-2"), "in-use");
  EXPECT_EQ(add_machine("mill-2"), "in-use") << "for good";
  must(store_->machines().get("mill-1"));
  reopen({.own = true});
  EXPECT_EQ(add_machine("mill-2"), "");
}

// A server ends a connection's process, and with it the locks, a moment after the connection was closed.
TEST_F(PostgresqlTest, AStartWaitsAMomentForTheLocksOfTheOneBefore) {
  reopen({.own = true});
  const std::jthread ends([this] {
    std::this_thread::sleep_for(300ms);
    store_.reset();
  });
  must(open_second({.own = true}));
}

TEST_F(PostgresqlTest, TextsAreComparedByTheirBytes) {
  for (const char* name : {"b", "a", "B", "ä", "Z", "_"}) EXPECT_EQ(add_machine(name), "");
  std::string names;
  for (const Machine& machine : must(store_->machines().list({})).items) names += machine.name;
  EXPECT_EQ(names, "BZ_abä");
}

TEST_F(PostgresqlTest, ATextMayHaveAnyBytesAlsoInAPattern) {
  const std::string odd("a\xff\0%b", 5);
  const Program program = add_program(*store_, "text");
  must(store_->programs().label(program.id, {.tags = {{odd}}, .folder = odd}, by("anna")));
  EXPECT_EQ(must(store_->programs().list({}, {.folder = odd})).items.at(0).folder, odd);
  EXPECT_EQ(must(store_->programs().list({}, {.tag = odd})).items.at(0).tags.at(0), odd);
}

TEST_F(PostgresqlTest, EventsHaveNoGapsAfterWhatWasUndone) {
  const NewEvent event{.topic = EventTopic::job, .word = "done"};
  const std::uint64_t first = must(store_->event_log().append(event, by("anna"))).seq;
  const auto undone = store_->atomically([&]() -> Result<void> {
    must(store_->event_log().append(event, by("anna")));
    return std::unexpected(Error{ErrorCode::busy, ""});
  });
  EXPECT_EQ(refusal(undone), ErrorCode::busy);
  EXPECT_EQ(must(store_->event_log().newest()), first);
  EXPECT_EQ(must(store_->event_log().append(event, by("anna"))).seq, first + 1);
}

TEST_F(PostgresqlTest, ACheckFindsWhatWasAltered) {
  add_job(*store_, "mill-1");
  must(store_->check());
  EXPECT_TRUE(must(postgresql::verify(database_url(database_))).faults.empty());
  drop_trigger("audit_update", "audit");
  EXPECT_EQ(sql("UPDATE audit SET detail = 'other' WHERE seq = 2"), "");
  EXPECT_EQ(refusal(store_->check()), ErrorCode::corrupt);
  EXPECT_EQ(must(postgresql::verify(database_url(database_))).faults.at(0).subject, "audit/2");
}

TEST_F(PostgresqlTest, ItIsBackedUpByItsServer) {
  EXPECT_EQ(refusal(store_->backup(folder_.file("copy.db"))), ErrorCode::invalid_value);
}

}  // namespace
}  // namespace dripfeed::store_test
