// Opening a connection, transactions, and what statements leave in it.
#include "store/postgresql/connection.h"

#include <array>
#include <charconv>
#include <utility>

#include <fmt/format.h>
#include <libpq-fe.h>

#include "store/postgresql/fault.h"
#include "store/postgresql/placeholders.h"
#include "store/postgresql/statement.h"

namespace dripfeed::postgresql {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

// Two numbers name an advisory lock; the first is "DRIP". Who writes has the lock until the end of its transaction, so
// changes wait for each other as they do in SQLite; each statement after it reads what was committed before. The
// version changes with each transaction of the server that ends: more often than it must.
constexpr sql::Words kWords{
    .begin_to_write = "BEGIN ISOLATION LEVEL READ COMMITTED READ WRITE; SELECT pg_advisory_xact_lock(1146243408, 1)",
    .begin_to_read = "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY",
    .version = "SELECT hashtextextended(CAST(pg_current_snapshot() AS TEXT), 0)",
    .newest_event = "SELECT last FROM counter WHERE name = 'event'"};

// What an administrator set for more safety stays; less is not enough for what is acknowledged here.
constexpr const char* kSettings =
    "SET client_min_messages = warning;"
    "SET standard_conforming_strings = on;"
    "SET escape_string_warning = on;"
    "SELECT set_config('synchronous_commit', 'on', false) WHERE current_setting('synchronous_commit') IN ('off', "
    "'local')";

constexpr std::string_view kNumbered =
    "SELECT c.relname, a.attname FROM pg_index i JOIN pg_class c ON c.oid = i.indrelid JOIN pg_attribute a ON "
    "a.attrelid = c.oid AND a.attnum = i.indkey[0] WHERE i.indisprimary AND i.indnatts = 1 AND a.atttypid = "
    "CAST('bigint' AS regtype) AND c.relnamespace = CAST(current_schema() AS regnamespace)";

// libpq ends its messages with a line break, and may give several lines.
std::string one_line(std::string_view words) {
  std::string line(words.substr(0, words.find_last_not_of(" \n") + 1));
  for (char& c : line) {
    if (c == '\n') c = ' ';
  }
  return line;
}

Error silence() { return {ErrorCode::no_answer, fmt::format("nothing for {} s", Pulse::kPatience.count())}; }

void ignore_notice(void* /*to*/, const char* /*notice*/) {}

}  // namespace

Result<std::unique_ptr<Connection>> Connection::open(const std::string& url, const OpenSettings& settings,
                                                     std::shared_ptr<const Pulse> pulse) {
  if (pulse && pulse->is_silent()) return std::unexpected(silence());
  // Before dbname: what the URL says of them counts.
  constexpr std::array<const char*, 7> kNames{"connect_timeout",
                                              "fallback_application_name",
                                              "tcp_user_timeout",
                                              "keepalives_idle",
                                              "dbname",
                                              "client_encoding",
                                              nullptr};
  const std::array<const char*, 7> values{"5", "dripfeed", "10000", "30", url.c_str(), "UTF8", nullptr};
  pg_conn* const handle = PQconnectdbParams(kNames.data(), values.data(), 1);
  if (handle == nullptr) return std::unexpected(Error{ErrorCode::internal, "out of memory"});
  std::unique_ptr<Connection> connection(new Connection(handle, std::move(pulse)));
  if (PQstatus(handle) != CONNECTION_OK)
    return std::unexpected(Error{ErrorCode::cannot_open, one_line(PQerrorMessage(handle))});
  PQsetNoticeProcessor(handle, ignore_notice, nullptr);
  make_waitable(handle);
  if (auto ready = connection->set_up(settings); !ready) return std::unexpected(ready.error());
  return connection;
}

Connection::~Connection() { drop_statements(); }

Result<void> Connection::set_up(const OpenSettings& settings) {
  constexpr int kOldest = 140000;
  if (PQserverVersion(handle()) < kOldest)
    return std::unexpected(Error{ErrorCode::cannot_open, "the server is older than PostgreSQL 14"});
  const char* const encoding = PQparameterStatus(handle(), "server_encoding");
  if (encoding == nullptr || std::string_view(encoding) != "UTF8")
    return std::unexpected(Error{ErrorCode::cannot_open, "the encoding of the database is not UTF8"});
  if (auto set = execute(kSettings); !set) return set;
  return execute(fmt::format("SET lock_timeout = {}", settings.busy_timeout_ms).c_str());
}

const sql::Words& Connection::words() const { return kWords; }

Result<void> Connection::execute(const char* sql) {
  const ResultPtr result = answer(PQsendQuery(handle(), sql));
  if (note(result.get())) return {};
  return std::unexpected(fault_);
}

// Not prepared: the server takes no prepared statements once a transaction has failed, and begin_to_write is two.
Result<void> Connection::transact(std::string_view sql) {
  const ResultPtr result = answer(PQsendQuery(handle(), std::string(sql).c_str()));
  if (!note(result.get())) {
    // It has begun, but the lock did not come in time.
    if (sql == kWords.begin_to_write && in_transaction()) answer(PQsendQuery(handle(), "ROLLBACK"));
    return std::unexpected(fault_);
  }
  // It ends a transaction that has failed by undoing it, and reports no fault.
  if (sql == "COMMIT" && std::string_view(PQcmdStatus(result.get())) != "COMMIT")
    return std::unexpected(Error{ErrorCode::io_failed, "the transaction was undone by an earlier error"});
  return {};
}

bool Connection::in_transaction() const {
  const PGTransactionStatusType status = PQtransactionStatus(handle());
  return status == PQTRANS_INTRANS || status == PQTRANS_INERROR || status == PQTRANS_ACTIVE;
}

bool Connection::is_usable() const { return PQstatus(handle()) == CONNECTION_OK; }

store::Error Connection::fault(std::string_view about) const {
  return {fault_.code, about.empty() ? fault_.detail : fmt::format("{}: {}", about, fault_.detail)};
}

Result<void> Connection::learn_numbered_tables() {
  const ResultPtr result = answer(PQsendQuery(handle(), std::string(kNumbered).c_str()));
  if (!note(result.get())) return std::unexpected(fault_);
  numbered_.clear();
  for (int row = 0; row < PQntuples(result.get()); ++row)
    numbered_.emplace(PQgetvalue(result.get(), row, 0), PQgetvalue(result.get(), row, 1));
  return {};
}

ResultPtr Connection::answer(int taken) {
  return wait_for_result(handle(), taken == 1, [this] { return pulse_ && pulse_->is_silent(); });
}

std::string Connection::next_name() { return fmt::format("s{}", ++names_); }

bool Connection::note(const pg_result* result) {
  const ExecStatusType status = PQresultStatus(result);  // of null: a fatal error
  if (status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK || status == PGRES_EMPTY_QUERY) return true;
  if (pulse_ && pulse_->is_silent() && !is_usable()) {
    fault_ = silence();
    return false;
  }
  const char* const state = result == nullptr ? nullptr : PQresultErrorField(result, PG_DIAG_SQLSTATE);
  const char* const words = state == nullptr ? nullptr : PQresultErrorField(result, PG_DIAG_MESSAGE_PRIMARY);
  fault_ = {code_of(state == nullptr ? "" : state), one_line(words == nullptr ? PQerrorMessage(handle()) : words)};
  return false;
}

// The words of a query are "SELECT 12"; it changes nothing.
void Connection::note_changed(const pg_result* result) {
  pg_result* const command = const_cast<pg_result*>(result);  // libpq only reads it
  if (std::string_view(PQcmdStatus(command)).starts_with("SELECT")) return;
  const std::string_view rows = PQcmdTuples(command);
  changed_rows_ = 0;
  std::from_chars(rows.data(), rows.data() + rows.size(), changed_rows_);
}

// An INSERT gives the number of its row back, as far as the table numbers its rows.
std::unique_ptr<sql::Statement> Connection::prepare(std::string_view sql) {
  const auto numbered = numbered_.find(table_of_insert(sql));
  std::string text = numbered_parameters(sql);
  if (numbered == numbered_.end()) return std::make_unique<Statement>(*this, std::move(text), false);
  return std::make_unique<Statement>(*this, fmt::format("{} RETURNING {}", text, numbered->second), true);
}

}  // namespace dripfeed::postgresql
