// Transactions and the pool of readers.
#include "store/sqlite/database.h"

#include <fmt/format.h>

namespace dripfeed::sqlite {
namespace {

// The engine may end a transaction by itself (disk full, I/O error). What came after it would stand alone.
store::Error lost() { return {store::ErrorCode::io_failed, "the transaction was undone by an earlier error"}; }

store::Error only_read() { return {store::ErrorCode::append_only, "the store is open to be read only"}; }

// A statement about transactions, from the connection's cache.
store::Result<void> run(Connection& connection, std::string_view sql) {
  Session session(connection, {});
  if (session.run(sql)) return {};
  return std::unexpected(session.error());
}

}  // namespace

store::Result<std::unique_ptr<Database>> Database::open(const std::string& path, const OpenSettings& settings) {
  std::unique_ptr<Database> database(new Database(path, settings));
  if (settings.read_only) return database;
  auto writer = Connection::open(path, settings, Access::write);
  if (!writer) return std::unexpected(writer.error());
  database->writer_ = std::move(*writer);
  return database;
}

store::Result<void> Database::checkpoint_in_commits_from(std::uint32_t pages) {
  return writer_->execute(fmt::format("PRAGMA wal_autocheckpoint = {}", pages).c_str());
}

store::Result<std::unique_ptr<Connection>> Database::connect_to_read() const {
  return Connection::open(path_, settings_, Access::read);
}

// SQLite counts the commits of all connections but the one that asks.
store::Result<std::uint64_t> Database::version() {
  const std::lock_guard lock(version_mutex_);
  if (!version_reader_) {
    auto opened = connect_to_read();
    if (!opened) return std::unexpected(opened.error());
    version_reader_ = std::move(*opened);
  }
  Session session(*version_reader_, "version");
  std::uint64_t version = 0;
  {
    Query query(session, "PRAGMA data_version");
    if (query.next()) version = query.number();
  }
  if (!session.ok()) return std::unexpected(session.error());
  return version;
}

store::Result<void> Database::Writing::begin() {
  if (database_.settings_.read_only) return std::unexpected(only_read());
  if (!database_.writing_here()) {
    if (turn_ != Turn::taken) database_.lane_.enter(turn_);
    holds_lane_ = true;
    // IMMEDIATE: the write lock now, not in the middle, so that nothing read before can be outdated.
    if (auto begun = run(*database_.writer_, "BEGIN IMMEDIATE"); !begun) return begun;
    database_.writing_thread_.store(std::this_thread::get_id());
  } else {
    if (!database_.writer_->in_transaction()) return std::unexpected(lost());
    if (auto saved = run(*database_.writer_, "SAVEPOINT inner_one"); !saved) return saved;
  }
  ++database_.depth_;
  open_ = true;
  return {};
}

store::Result<void> Database::Writing::commit() {
  if (!database_.writer_->in_transaction()) return std::unexpected(lost());
  const bool outer = database_.depth_ == 1;
  auto done = run(*database_.writer_, outer ? "COMMIT" : "RELEASE inner_one");
  if (!done) return done;  // the destructor undoes
  open_ = false;
  --database_.depth_;
  if (outer) database_.writing_thread_.store(std::thread::id());
  return {};
}

Database::Writing::~Writing() {
  if (open_) undo();
  if (holds_lane_) database_.lane_.leave();
}

void Database::Writing::undo() {
  const bool outer = database_.depth_ == 1;
  // Fails only where the engine has undone everything already.
  if (database_.writer_->in_transaction()) {
    static_cast<void>(run(*database_.writer_, outer ? "ROLLBACK" : "ROLLBACK TO inner_one"));
    if (!outer) static_cast<void>(run(*database_.writer_, "RELEASE inner_one"));
  }
  --database_.depth_;
  if (outer) database_.writing_thread_.store(std::thread::id());
}

void Database::make_shared(SharedChange& change) {
  if (settings_.read_only) {
    change.committed = std::unexpected(only_read());
    return;
  }
  if (!lane_.enter_shared(change)) return;
  std::vector<SharedChange*> made;
  Writing writing(*this, Turn::taken);  // its end lets the others go on
  auto outcome = writing.begin();
  for (SharedChange* next = &change; outcome && next != nullptr; next = lane_.next_shared()) {
    made.push_back(next);
    next->make();
    // What the engine undid takes no more changes: those who still wait are made by the next one.
    if (!writer_->in_transaction()) outcome = std::unexpected(next->refused.value_or(lost()));
  }
  if (outcome) outcome = writing.commit();
  change.committed = outcome;
  for (SharedChange* const one : made) one->committed = outcome;
}

store::Result<void> Database::Reading::begin() {
  if (database_.writing_here()) {
    if (!database_.writer_->in_transaction()) return std::unexpected(lost());
    connection_ = database_.writer_.get();
    return {};
  }
  {
    const std::lock_guard lock(database_.pool_mutex_);
    if (!database_.pool_.empty()) {
      own_ = std::move(database_.pool_.back());
      database_.pool_.pop_back();
    }
  }
  if (!own_) {
    auto opened = database_.connect_to_read();
    if (!opened) return std::unexpected(opened.error());
    own_ = std::move(*opened);
  }
  connection_ = own_.get();
  return run(*connection_, "BEGIN");
}

Database::Reading::~Reading() {
  if (!own_) return;
  if (own_->in_transaction()) static_cast<void>(run(*own_, "COMMIT"));
  const std::lock_guard lock(database_.pool_mutex_);
  database_.pool_.push_back(std::move(own_));
}

}  // namespace dripfeed::sqlite
