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
#include "tests/store/old_shop.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class SchemaTest : public StoreTest {};

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
  store.verdicts().judge_by("rules 1");
  const Job job = add_job(store, "mill-1");
  bring(store, job.id, JobState::held);
  const std::array rows{NewLedgerRow{job.id, {0, 0, 0, 96}, "armed"}};
  must(store.ledger().append(rows, 5));
  must(store.users().put_group({.name = "mills", .machines = {"mill-1"}, .four_eyes = true, .operator_sign_off = false},
                               by("tester")));
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
  std::ofstream(old_shop_file(sqlite::migrations().back().version), std::ios::binary) << dump(path);
}

TEST_F(SchemaTest, EveryOldOneIsReadByThisProgram) {
  if (std::getenv("UPDATE_GOLDEN") != nullptr) write_newest(*store_, path());
  for (const sqlite::Migration& migration : sqlite::migrations()) {
    store_.reset();
    for (const char* ending : {"", "-wal", "-shm"}) std::filesystem::remove(path() + ending);
    ASSERT_EQ(sql(old_shop(migration.version)), "");
    reopen({.own = true});
    expect_old_shop(*store_, migration.version);
    EXPECT_EQ(sql("DELETE FROM audit"), "append-only");
  }
}

}  // namespace
}  // namespace dripfeed::store_test
