// The steps that every test of the store takes first.
#include "tests/store/fixture.h"

#include <array>
#include <cstdlib>

#include <fmt/format.h>
#include <sqlite3.h>
#include <stdlib.h>

#include "store/postgresql/open.h"
#include "tests/store/postgresql_server.h"

namespace dripfeed::store {

void PrintTo(ErrorCode code, std::ostream* out) { *out << name_of(code); }

}  // namespace dripfeed::store

namespace dripfeed::store_test {

using namespace store;

TempFolder::TempFolder(Where where) {
  const std::filesystem::path memory = "/dev/shm";
  const bool there = where == Where::memory && std::filesystem::is_directory(memory);
  std::string name = ((there ? memory : std::filesystem::temp_directory_path()) / "dripfeed-store-XXXXXX").string();
  path_ = mkdtemp(name.data());
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TempFolder::file(std::string_view name) const { return (path_ / name).string(); }

Program add_program(Store& store, const std::string& text, const std::string& name) {
  const Content content = must(store.contents().put(text));
  NewProgramText added;
  added.sha256 = content.sha256;
  added.blocks = 1;
  return must(store.programs().add(name, "fanuc", added, by("tester")));
}

Program add_rendered(Store& store, const std::string& text, const std::string& machine) {
  if (!store.families().get("roll")) must(store.families().add("roll", "family roll\n", by("tester")));
  if (!store.parts().get("R-100")) must(store.parts().add("R-100", {"roll", 1, "{}"}, by("tester")));
  NewProgramText added;
  added.sha256 = must(store.contents().put(text)).sha256;
  added.places_sha256 = must(store.contents().put("places of " + text)).sha256;
  added.blocks = 2;
  added.facts = "facts";
  added.origin = {.kind = OriginKind::rendered,
                  .family = "roll",
                  .family_revision = 1,
                  .part = "R-100",
                  .part_revision = 1,
                  .values = "{}",
                  .machine = machine,
                  .machine_revision = 1,
                  .mode = "explicit"};
  return must(store.programs().add("O0100", "fanuc", added, by("tester")));
}

Verdict add_verdict(Store& store, const Program& program, const std::string& machine, Outcome outcome) {
  NewVerdict verdict;
  verdict.program = program.id;
  verdict.revision = program.newest.revision;
  verdict.machine = machine;
  verdict.machine_revision = must(store.machines().get(machine)).revision;
  verdict.outcome = outcome;
  verdict.report = "report";
  return must(store.verdicts().add(verdict, by("tester")));
}

void waive_operators(Store& store, const std::string& machine) {
  must(store.users().put_group({"of " + machine, {machine}, false, false}, by("tester")));
}

Release approve(Store& store, const Program& program, const std::string& machine) {
  const Release release =
      must(store.releases().add({program.id, program.newest.revision, machine, Delivery::drip}, by("tester")));
  must(store.releases().move(release.id, {ReleaseState::in_review, "", 0}, by("tester")));
  must(store.releases().move(release.id, {ReleaseState::proving, "", 1}, by("reviewer")));
  waive_operators(store, machine);
  const Release approved =
      must(store.releases().move(release.id, {ReleaseState::approved, "first piece measured", 0}, by("approver")));
  must(store.users().remove_group("of " + machine, by("tester")));
  return approved;
}

Released add_released(Store& store, const std::string& machine, const std::string& text) {
  must(store.machines().add(machine, "profile", by("tester")));
  Released made;
  made.program = add_rendered(store, text, machine);
  made.verdict = add_verdict(store, made.program, machine);
  made.release = approve(store, made.program, machine);
  return made;
}

Job add_job(Store& store, const std::string& machine) {
  const Released released = add_released(store, machine, "%\n(" + machine + ")\nM30\n%\n");
  return must(store.jobs().add({released.release.id, "serial:/dev/ttyS0", 100}, by("tester")));
}

void bring(Store& store, Id job, JobState state) {
  using enum JobState;
  static const std::array<std::vector<JobState>, kJobStates> kStepsTo{{
      {},
      {armed},
      {armed, feeding},
      {armed, feeding, held},
      {armed, feeding, draining},
      {armed, feeding, draining, done},
      {armed, failed},
      {cancelled},
      {armed, interrupted},
  }};
  for (const JobState step : kStepsTo[static_cast<std::size_t>(state)]) {
    must(store.jobs().move(job, {step, "step of a test", false}, by("tester")));
  }
}

EngineKind engine() {
  const char* const wanted = std::getenv("DRIPFEED_STORE_ENGINE");
  return wanted != nullptr && std::string_view(wanted) == "postgresql" ? EngineKind::postgresql : EngineKind::sqlite;
}

namespace {

Result<std::unique_ptr<Store>> open_postgresql(const std::string& database, const sqlite::OpenSettings& settings) {
  return postgresql::open(
      database_url(database),
      {.own = settings.own, .create = settings.create, .busy_timeout_ms = settings.busy_timeout_ms});
}

// A copy of one with an empty store: that takes a fraction of the time of making the tables.
std::string make_store_database() {
  static int made = 0;
  if (made == 0) {
    make_database("empty_store");
    must(open_postgresql("empty_store", {}));
  }
  std::string name = fmt::format("store_{}", ++made);
  make_database(name, "empty_store");
  return name;
}

}  // namespace

StoreTest::StoreTest(TempFolder::Where where) : folder_(where) {
  if (engine() == EngineKind::postgresql) database_ = make_store_database();
  reopen();
}

StoreTest::~StoreTest() {
  store_.reset();
  if (!database_.empty()) run_sql("postgres", fmt::format("DROP DATABASE {} WITH (FORCE)", database_));
}

void StoreTest::reopen(const sqlite::OpenSettings& settings) {
  store_.reset();
  store_ = must(open_second(settings));
}

Result<std::unique_ptr<Store>> StoreTest::open_second(const sqlite::OpenSettings& settings) const {
  return database_.empty() ? sqlite::open(path(), settings) : open_postgresql(database_, settings);
}

void StoreTest::drop_trigger(const std::string& name, const std::string& table) const {
  const std::string on = database_.empty() ? std::string() : " ON " + table;
  EXPECT_EQ(sql(fmt::format("DROP TRIGGER {}{}", name, on)), "");
}

std::string StoreTest::sql(const std::string& text) const {
  if (!database_.empty()) return run_sql(database_, text);
  sqlite3* connection = nullptr;
  sqlite3_open(path().c_str(), &connection);
  sqlite3_exec(connection, "PRAGMA foreign_keys = ON; PRAGMA recursive_triggers = ON", nullptr, nullptr, nullptr);
  const int result = sqlite3_exec(connection, text.c_str(), nullptr, nullptr, nullptr);
  std::string words = result == SQLITE_OK ? "" : sqlite3_errmsg(connection);
  sqlite3_close(connection);
  return words;
}

}  // namespace dripfeed::store_test
