// Transactions and the pool of readers.
#include "store/sql/database.h"

#include <utility>

namespace dripfeed::sql {
namespace {

// The engine may end a transaction by itself (disk full, I/O error). What came after it would stand alone.
store::Error lost() { return {store::ErrorCode::io_failed, "the transaction was undone by an earlier error"}; }

store::Error only_read() { return {store::ErrorCode::append_only, "the store is open to be read only"}; }

}  // namespace

store::Result<std::unique_ptr<Database>> Database::open(std::unique_ptr<Engine> engine, May may) {
  std::unique_ptr<Database> database(new Database(std::move(engine)));
  if (may == May::read) return database;
  auto writer = database->engine_->connect_to_write();
  if (!writer) return std::unexpected(writer.error());
  database->writer_ = std::move(*writer);
  database->may_write_ = true;
  return database;
}

store::Result<std::uint64_t> Database::version() {
  const std::lock_guard lock(version_mutex_);
  auto version = ask_version();
  if (!version && version_reader_ && !version_reader_->is_usable()) {
    version_reader_.reset();
    version = ask_version();
  }
  return version;
}

store::Result<std::uint64_t> Database::ask_version() {
  if (!version_reader_) {
    auto opened = engine_->connect_to_read();
    if (!opened) return std::unexpected(opened.error());
    version_reader_ = std::move(*opened);
  }
  Session session(*version_reader_, "version");
  std::uint64_t version = 0;
  {
    Query query(session, version_reader_->words().version);
    if (query.next()) version = static_cast<std::uint64_t>(query.signed_number());
  }
  if (!session.ok()) return std::unexpected(session.error());
  return version;
}

// Nothing of a transaction is lost where it cannot begin: a connection that broke meanwhile is replaced.
store::Result<void> Database::begin_to_write() {
  if (writer_->is_usable()) {
    auto begun = writer_->transact(writer_->words().begin_to_write);
    if (begun || writer_->is_usable()) return begun;
  }
  auto opened = engine_->connect_to_write();
  if (!opened) return std::unexpected(opened.error());
  writer_ = std::move(*opened);
  return writer_->transact(writer_->words().begin_to_write);
}

store::Result<void> Database::Writing::begin() {
  if (!database_.may_write_) return std::unexpected(only_read());
  if (!database_.writing_here()) {
    if (turn_ != Turn::taken) database_.lane_.enter(turn_);
    holds_lane_ = true;
    if (auto begun = database_.begin_to_write(); !begun) return begun;
    database_.writing_thread_.store(std::this_thread::get_id());
  } else {
    if (!database_.writer_->in_transaction()) return std::unexpected(lost());
    if (auto saved = database_.writer_->transact("SAVEPOINT inner_one"); !saved) return saved;
  }
  ++database_.depth_;
  open_ = true;
  return {};
}

store::Result<void> Database::Writing::commit() {
  if (!database_.writer_->in_transaction()) return std::unexpected(lost());
  const bool outer = database_.depth_ == 1;
  auto done = database_.writer_->transact(outer ? "COMMIT" : "RELEASE inner_one");
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
    static_cast<void>(database_.writer_->transact(outer ? "ROLLBACK" : "ROLLBACK TO inner_one"));
    if (!outer) static_cast<void>(database_.writer_->transact("RELEASE inner_one"));
  }
  --database_.depth_;
  if (outer) database_.writing_thread_.store(std::thread::id());
}

void Database::make_shared(SharedChange& change) {
  if (!may_write_) {
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
  if (own_) {
    auto begun = begin_on(*own_);
    if (begun || own_->is_usable()) return begun;
  }
  auto opened = database_.engine_->connect_to_read();
  if (!opened) return std::unexpected(opened.error());
  own_ = std::move(*opened);
  return begin_on(*own_);
}

store::Result<void> Database::Reading::begin_on(Connection& connection) {
  connection_ = &connection;
  return connection.transact(connection.words().begin_to_read);
}

Database::Reading::~Reading() {
  if (!own_ || !own_->is_usable()) return;
  if (own_->in_transaction()) static_cast<void>(own_->transact("COMMIT"));
  const std::lock_guard lock(database_.pool_mutex_);
  database_.pool_.push_back(std::move(own_));
}

}  // namespace dripfeed::sql
