// The tables of the two engines have the same names and columns, so the catalog of the one that is filled leads. Rules
// that look at single rows as they come (a content takes no more bytes once it has its hash) are off meanwhile; those
// of the tables (keys, references, values) hold.
#include "store/postgresql/filling.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "store/postgresql/connection.h"
#include "store/postgresql/migrations.h"
#include "store/postgresql/server.h"
#include "store/sql/session.h"

namespace dripfeed::postgresql {
namespace {

using sql::Query;
using sql::Session;
using store::Error;
using store::ErrorCode;
using store::Result;

// What another engine has not: what marks the store, counts its events, and knows its servers.
constexpr std::string_view kShopTables =
    "SELECT CAST(relname AS TEXT) FROM pg_class WHERE relnamespace = CAST(current_schema() AS regnamespace) AND "
    "relkind "
    "= 'r' AND relname NOT IN ('migration', 'counter', 'owner', 'journal', 'node', 'line_lease') ORDER BY relname";
constexpr std::string_view kColumns =
    "SELECT CAST(attname AS TEXT), CAST(coalesce(nullif(t.typbasetype, 0), t.oid) AS regtype) = CAST('bigint' AS "
    "regtype), CAST(t.oid AS regtype) = CAST('bytea' AS regtype), a.attidentity <> '' FROM pg_attribute a JOIN pg_type "
    "t "
    "ON t.oid = a.atttypid WHERE attrelid = CAST(CAST(? AS TEXT) AS regclass) AND attnum > 0 AND NOT attisdropped AND "
    "attgenerated = '' AND (attrelid, attname) <> (CAST('event' AS regclass), 'node') ORDER BY attnum";
constexpr std::string_view kReferences =
    "SELECT DISTINCT CAST(f.relname AS TEXT) FROM pg_constraint c JOIN pg_class f ON f.oid = c.confrelid WHERE "
    "c.contype "
    "= 'f' AND c.conrelid = CAST(CAST(? AS TEXT) AS regclass) AND c.confrelid <> c.conrelid";
constexpr std::size_t kRowsAtOnce = 500;

enum class Kind : std::uint8_t { text, number, bytes };
struct Column {
  std::string name;
  Kind kind = Kind::text;
};
struct Table {
  std::string name;
  std::vector<Column> columns;
  std::set<std::string> refers_to;
  bool is_numbered = false;  // its first column numbers the rows
};

std::vector<std::string> texts_of(Session& session, std::string_view sql, std::string_view parameter) {
  std::vector<std::string> found;
  Query query(session, sql, parameter);
  while (query.next()) found.push_back(query.text());
  return found;
}

void read_columns(Session& session, Table& table) {
  Query query(session, kColumns, table.name);
  while (query.next()) {
    Column& column = table.columns.emplace_back();
    column.name = query.text();
    const bool is_number = query.flag();
    const bool is_bytes = query.flag();
    column.kind = is_number ? Kind::number : is_bytes ? Kind::bytes : Kind::text;
    table.is_numbered = query.flag() || table.is_numbered;
  }
}

Result<std::vector<Table>> tables_of(Connection& connection) {
  Session session(connection, "tables");
  std::vector<Table> tables;
  {
    Query query(session, kShopTables);
    while (query.next()) tables.emplace_back().name = query.text();
  }
  for (Table& table : tables) {
    read_columns(session, table);
    for (std::string& other : texts_of(session, kReferences, table.name)) table.refers_to.insert(std::move(other));
  }
  if (!session.ok()) return std::unexpected(session.error());
  return tables;
}

// Each one after those that its rows refer to.
Result<std::vector<Table>> in_order(std::vector<Table> tables) {
  std::vector<Table> ordered;
  std::set<std::string> done;
  while (!tables.empty()) {
    const auto ready =
        std::ranges::find_if(tables, [&](const Table& one) { return std::ranges::includes(done, one.refers_to); });
    if (ready == tables.end())
      return std::unexpected(Error{ErrorCode::internal, "tables refer to each other in a ring"});
    done.insert(ready->name);
    ordered.push_back(std::move(*ready));
    tables.erase(ready);
  }
  return ordered;
}

// "a, b" with a column's name, or what stands for it, in the place of {}.
std::string list_of(const Table& table, std::string_view form) {
  std::string out;
  for (const Column& column : table.columns)
    out += fmt::format("{}{}", out.empty() ? "" : ", ", fmt::format(fmt::runtime(form), column.name));
  return out;
}

std::string insert_of(const Table& table, std::size_t rows) {
  const std::string row = fmt::format("({})", list_of(table, "?"));
  return fmt::format("INSERT INTO {} ({}) VALUES {}", table.name, list_of(table, "{}"),
                     fmt::join(std::vector<std::string_view>(rows, row), ", "));
}

// Rows that wait for one statement.
class Rows {
 public:
  Rows(Connection& to, const Table& table) : to_(to), table_(table), whole_(insert_of(table, kRowsAtOnce)) {}

  // Takes the row that `from` stands at: each column, and whether it is NULL.
  bool add(sql::Statement& from) {
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      Value& value = values_.emplace_back();
      const int at = static_cast<int>(2 * i);
      value.is_null = from.number(at + 1) != 0;
      if (value.is_null) continue;
      if (table_.columns[i].kind == Kind::number) {
        value.number = from.number(at);
        continue;
      }
      const auto bytes = from.bytes(at);
      value.bytes.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    return ++count_ < kRowsAtOnce || write();
  }
  bool write() {
    if (count_ == 0) return true;
    const std::string rest = count_ == kRowsAtOnce ? std::string() : insert_of(table_, count_);
    const std::string_view sql = rest.empty() ? std::string_view(whole_) : std::string_view(rest);
    auto statement = to_.take(sql);
    if (!statement) return false;
    bool fine = true;
    for (std::size_t i = 0; i < values_.size() && fine; ++i)
      fine = bind(*statement, static_cast<int>(i) + 1, table_.columns[i % table_.columns.size()].kind, values_[i]);
    fine = fine && statement->step() != sql::Statement::Step::fault;
    statement->reset();
    to_.give_back(sql, std::move(statement));
    values_.clear();
    count_ = 0;
    return fine;
  }

 private:
  struct Value {
    bool is_null = false;
    std::int64_t number = 0;
    std::string bytes{};
  };
  static bool bind(sql::Statement& statement, int at, Kind kind, const Value& value) {
    if (value.is_null) return statement.bind_null(at);
    if (kind == Kind::number) return statement.bind_number(at, value.number);
    return kind == Kind::text ? statement.bind_text(at, value.bytes) : statement.bind_bytes(at, value.bytes);
  }

  Connection& to_;
  const Table& table_;
  std::string whole_;
  std::vector<Value> values_;
  std::size_t count_ = 0;
};

// Rows that refer to rows of their own table refer to older ones.
Result<void> copy_rows(sql::Connection& from, Connection& to, const Table& table) {
  const std::string select =
      fmt::format("SELECT {} FROM {} ORDER BY 1", list_of(table, "{0}, {0} IS NULL"), table.name);
  const auto statement = from.take(select);
  if (!statement) return std::unexpected(Error{ErrorCode::internal, from.fault(table.name).detail});
  Rows rows(to, table);
  for (auto step = statement->step(); step != sql::Statement::Step::end; step = statement->step()) {
    if (step == sql::Statement::Step::fault) return std::unexpected(from.fault(table.name));
    if (!rows.add(*statement)) return std::unexpected(to.fault(table.name));
  }
  return rows.write() ? Result<void>() : std::unexpected(to.fault(table.name));
}

Result<std::uint64_t> newest_event(sql::Connection& from) {
  Session session(from, "event");
  Query query(session, from.words().newest_event);
  const std::uint64_t newest = query.next() ? query.number() : 0;
  if (!session.ok()) return std::unexpected(session.error());
  return newest;
}

// New rows are numbered after those that came.
Result<void> set_counters(sql::Connection& from, Connection& to, const std::vector<Table>& tables) {
  const auto newest = newest_event(from);
  if (!newest) return std::unexpected(newest.error());
  Session session(to, "counters");
  session.run("UPDATE counter SET last = ? WHERE name = 'event'", *newest);
  for (const Table& table : tables) {
    if (!table.is_numbered) continue;
    const std::string& number = table.columns.front().name;
    session.run(
        fmt::format("SELECT setval(pg_get_serial_sequence('{0}', '{1}'), max({1})) FROM {0} HAVING max({1}) > 0",
                    table.name, number));
  }
  if (!session.ok()) return std::unexpected(session.error());
  return {};
}

// `how`: DISABLE or ENABLE.
Result<void> set_rules(Connection& to, const std::vector<Table>& tables, std::string_view how) {
  for (const Table& table : tables) {
    if (auto set = to.execute(fmt::format("ALTER TABLE {} {} TRIGGER USER", table.name, how).c_str()); !set) return set;
  }
  return {};
}

Result<void> copy_all(sql::Connection& from, Connection& to) {
  auto found = tables_of(to);
  if (!found) return std::unexpected(found.error());
  const auto tables = in_order(std::move(*found));
  if (!tables) return std::unexpected(tables.error());
  if (auto off = set_rules(to, *tables, "DISABLE"); !off) return off;
  for (const Table& table : *tables) {
    if (auto copied = copy_rows(from, to, table); !copied) return copied;
  }
  if (auto on = set_rules(to, *tables, "ENABLE"); !on) return on;
  return set_counters(from, to, *tables);
}

// Whatever happens in a store has a row in its audit.
Result<void> refuse_a_shop(Connection& to) {
  Session session(to, "store");
  Query query(session, "SELECT count(*) FROM audit");
  const bool has_rows = query.next() && query.number() > 0;
  if (!session.ok()) return std::unexpected(session.error());
  if (has_rows) return std::unexpected(Error{ErrorCode::exists, "the database has a shop already"});
  return {};
}

}  // namespace

Result<void> fill(const std::string& url, sql::Connection& from, std::span<const sql::Migration> known) {
  const auto to = connect_alone(url);
  if (!to) return std::unexpected(to.error());
  if (auto made = bring_up_to_date(**to, {}, known); !made) return made;
  if (auto empty = refuse_a_shop(**to); !empty) return empty;
  if (auto begun = (*to)->transact((*to)->words().begin_to_write); !begun) return begun;
  if (auto copied = copy_all(from, **to); !copied) return copied;  // the connection ends, and with it the transaction
  return (*to)->transact("COMMIT");
}

}  // namespace dripfeed::postgresql
