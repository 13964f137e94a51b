// Stores of every old schema, as SQL, are opened, brought up to date and read. schema/vN.sql is a store as version N
// wrote it; UPDATE_GOLDEN=1 writes the newest version's, which is then never changed again.
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include <fmt/format.h>
#include <sqlite3.h>

#include "store/sqlite/migrations.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class SchemaTest : public StoreTest {};

std::string fixture(std::uint32_t version) {
  return fmt::format("{}/tests/store/schema/v{}.sql", DRIPFEED_SOURCE_DIR, version);
}

// Tables, then their rows, then what watches over them. What SQLite keeps for itself it makes again.
std::string dump(const std::string& path) {
  sqlite3* connection = nullptr;
  sqlite3_open(path.c_str(), &connection);
  std::string text = "PRAGMA foreign_keys = OFF;\nPRAGMA application_id = 0x44524950;\n";
  const auto each = [&](const std::string& query, const std::function<void(std::string)>& row) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(connection, query.c_str(), -1, &statement, nullptr), SQLITE_OK) << query;
    while (sqlite3_step(statement) == SQLITE_ROW) row(reinterpret_cast<const char*>(sqlite3_column_text(statement, 0)));
    sqlite3_finalize(statement);
  };
  const auto schema = [&](std::string_view type) {
    each(fmt::format("SELECT sql FROM sqlite_master WHERE type {} 'table' AND sql IS NOT NULL AND name NOT LIKE "
                     "'sqlite_%' ORDER BY rowid",
                     type),
         [&](const std::string& sql) { text += sql + ";\n"; });
  };
  schema("=");
  each("SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%' ORDER BY rowid",
       [&](const std::string& table) {
         std::string columns;
         each(fmt::format("SELECT group_concat('quote(' || name || ')', '||'',''||') FROM pragma_table_info('{}')",
                          table),
              [&](const std::string& list) { columns = list; });
         each(fmt::format("SELECT {} FROM {}", columns, table),
              [&](const std::string& row) { text += fmt::format("INSERT INTO {} VALUES ({});\n", table, row); });
       });
  schema("<>");
  sqlite3_close(connection);
  return text;
}

void write_newest(Store& store, const std::string& path) {
  const Job job = add_job(store, "mill-1");
  bring(store, job.id, JobState::held);
  const std::array rows{NewLedgerRow{job.id, {0, 0, 0, 96}, "armed"}};
  must(store.ledger().append(rows, 5));
  must(store.users().put_group({.name = "mills", .machines = {"mill-1"}, .four_eyes = true}, by("tester")));
  must(store.users().add("olga", {.role = Role::viewer, .grants = {{"mills", Role::operator_}}}, by("tester")));
  must(store.users().set_secret("olga", SecretKind::pin, "pin's hash", by("tester")));
  must(store.users().add_of_provider("dora", {"https://login.shop", "s-3"}, {.role = Role::operator_}, false,
                                     by("dripfeed")));
  must(store.orders().add({.number = "A-1", .operation = "20", .plan = {.part = "R-1", .quantity = 5}}, by("tester")));
  must(store.orders().report(1, {.good = 2}, by("tester")));
  must(store.tokens().add({.name = "mes", .role = Role::operator_, .hash = "hash"}, by("tester")));
  must(store.replies().keep({"mes", "POST /jobs", "k", "x"}, {201, "", "body", 5}));
  const Content received = must(store.contents().put("%\nO7\nM30\n%\n"));
  must(store.receipts().add({.machine = "mill-1",
                             .name = "O7",
                             .style = "number",
                             .sha256 = received.sha256,
                             .raw_bytes = 14,
                             .code = "iso",
                             .ended_by = "punch_off",
                             .quarantined = false,
                             .reason = ""},
                            by("mill-1")));
  must(store.receipts().add_request({.machine = "mill-1",
                                     .verb = "load",
                                     .argument = "42",
                                     .text = "%",
                                     .outcome = "armed",
                                     .detail = "job 1",
                                     .job = job.id},
                                    by("mill-1")));
  must(store.answers().begin("mill-1", 40, by("dripfeed", 6)));
  const Alarm raised = must(store.alarms().raise(
      {.machine = "mill-1", .kind = "torn_block", .text = "a block is torn", .lasts = true, .job = job.id}, 7));
  must(store.alarms().acknowledge(raised.id, by("olga", 8)));
  must(store.browser_sessions().open("cookie", {.token_hash = "hash"}, 8, 9));
  must(store.browser_sessions().open("of dora", {.user = "dora", .by_provider = true}, 8, 9));
  must(store.programs().label(job.program, {.tags = {{"pump"}}, .folder = "acme"}, by("tester")));
  const Program old = add_program(store, "%\nO9\nM30\n%\n", "O9");
  must(store.releases().add(
      {.program = old.id, .revision = 1, .machine = "mill-1", .restart = {.release = job.release, .line = 2}},
      by("tester")));
  must(store.programs().archive(old.id, "of an old machine", by("tester")));
  const Webhook hook =
      must(store.webhooks().add({.url = "https://mes.shop/in", .types = {"job.*"}}, "whsec_x", 8, by("tester", 9)));
  must(store.webhooks().ping(hook.id, by("tester", 10)));
  must(store.event_log().note_seen("mqtt", 1));
  must(store.attachments().add({.to = {.program = job.program},
                                .name = "sheet.pdf",
                                .media_type = "application/pdf",
                                .sha256 = must(store.contents().put("a setup sheet")).sha256},
                               by("tester", 11)));
  const Program gone = add_program(store, "%\nO8\nM30\n%\n", "O8");
  must(store.programs().archive(gone.id, "sold", by("tester", 12)));
  must(store.programs().erase(gone.id, 12, "nothing is left of it", by("tester", 13)));
  std::ofstream(fixture(sqlite::migrations().back().version), std::ios::binary) << dump(path);
}

TEST_F(SchemaTest, EveryOldOneIsReadByThisProgram) {
  if (std::getenv("UPDATE_GOLDEN") != nullptr) write_newest(*store_, path());
  for (const sqlite::Migration& migration : sqlite::migrations()) {
    std::ifstream file(fixture(migration.version), std::ios::binary);
    ASSERT_TRUE(file) << fixture(migration.version);
    std::stringstream text;
    text << file.rdbuf();
    store_.reset();
    for (const char* ending : {"", "-wal", "-shm"}) std::filesystem::remove(path() + ending);
    ASSERT_EQ(sql(text.str()), "");
    reopen({.own = true});
    must(store_->check());
    EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
    const Job job = must(store_->jobs().on_line("mill-1")).value();
    EXPECT_EQ(job.state, JobState::held);
    EXPECT_EQ(job.rank, migration.version >= 8 ? 1U : 0U);
    EXPECT_EQ(job.held_ms, std::nullopt);
    EXPECT_EQ(must(store_->ledger().interval(job.id)).high, 96U);
    EXPECT_EQ(must(store_->ledger().verify(job.id)), 1U);
    must(store_->contents().verify(job.text_sha256));
    EXPECT_EQ(must(store_->tokens().find("hash")).role, Role::operator_);
    if (migration.version >= 3) {
      const auto receipts = must(store_->receipts().list({}, {}));
      ASSERT_EQ(receipts.items.size(), 1U);
      must(store_->contents().verify(receipts.items[0].of.sha256));
      EXPECT_EQ(must(store_->receipts().requests({}, "mill-1")).items.size(), 1U);
    }
    const std::size_t answers = migration.version >= 5 ? 1 : 0;
    EXPECT_EQ(must(store_->answers().tear_unfinished(by("server"))).size(), answers);
    const auto alarms = must(store_->alarms().lasting());
    ASSERT_EQ(alarms.size(), migration.version >= 6 ? 1U : 0U);
    for (const Alarm& alarm : alarms) EXPECT_EQ(alarm.acknowledged_by, "olga");
    must(store_->alarms().raise({.machine = "mill-1", .kind = "torn_block", .text = "a block is torn"}, 9));
    EXPECT_EQ(must(store_->alarms().list({})).items.size(), 1U) << "folded, or the first of a store that had no table";
    EXPECT_EQ(store_->browser_sessions().find("cookie").has_value(), migration.version >= 7);
    const bool has_providers = migration.version >= 18;
    EXPECT_EQ(store_->users().of_provider({"https://login.shop", "s-3"}).has_value(), has_providers);
    EXPECT_EQ(store_->browser_sessions().find("of dora").has_value(), has_providers);
    must(store_->browser_sessions().open("another", {.token_hash = "hash"}, 8, 10));
    const Program program = must(store_->programs().get(job.program));
    EXPECT_EQ(program.tags.size(), migration.version >= 9 ? 1U : 0U);
    EXPECT_EQ(program.folder, migration.version >= 9 ? "acme" : "");
    EXPECT_NE(program.change, 0U) << "what is derived from programs is made anew";
    EXPECT_EQ(must(store_->programs().list({}, {.shelf = Shelf::archived})).items.size(),
              migration.version >= 9 ? 1U : 0U);
    const Program changed = must(store_->programs().label(job.program, {.tags = {{"new"}}}, by("server")));
    EXPECT_EQ(must(store_->programs().changed_after(program.change, 9)).back().change, changed.change);
    const bool has_webhooks = migration.version >= 11;
    ASSERT_EQ(must(store_->webhooks().enabled()).size(), has_webhooks ? 1U : 0U);
    EXPECT_EQ(must(store_->event_log().seen_by("mqtt")).has_value(), has_webhooks);
    const auto waits = must(store_->webhooks().due(1, 10));
    EXPECT_EQ(waits ? waits->event.of.word : "", has_webhooks ? "ping" : "");
    EXPECT_EQ(must(store_->releases().list({})).items.at(0).of.restart.line, migration.version >= 13 ? 2U : 0U);
    EXPECT_EQ(store_->programs().get(3).has_value(), migration.version >= 16) << "its row stays";
    const auto attached = must(store_->attachments().list({}, {.program = job.program})).items;
    ASSERT_EQ(attached.size(), migration.version >= 15 ? 1U : 0U);
    for (const Attachment& one : attached) must(store_->contents().verify(one.of.sha256));
    must(store_->releases().released_for(job.text_sha256, "mill-1", Delivery::drip, 0));
    EXPECT_EQ(must(store_->jobs().interrupt_unfinished(by("server"))).size(), 1U);
    EXPECT_EQ(sql("DELETE FROM audit"), "append-only");
  }
}

}  // namespace
}  // namespace dripfeed::store_test
