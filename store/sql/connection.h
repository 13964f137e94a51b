// What an engine gives the tables: connections with prepared statements, and the few words of SQL that engines do not
// share. All other SQL is in the tables, and each engine runs it as it stands there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::sql {

// A prepared statement; one run at a time. Parameters count from 1, columns from 0. What returns false leaves its fault
// in the connection.
class Statement {
 public:
  enum class Step : std::uint8_t { row, end, fault };

  Statement() = default;
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  virtual ~Statement() = default;

  virtual bool bind_text(int parameter, std::string_view text) = 0;    // keeps a copy
  virtual bool bind_bytes(int parameter, std::string_view bytes) = 0;  // they must live until reset()
  virtual bool bind_number(int parameter, std::int64_t number) = 0;
  virtual bool bind_null(int parameter) = 0;
  // The first one runs it.
  virtual Step step() = 0;
  // Of the row that step() found; NULL is 0 and "". The bytes hold until the next step().
  virtual std::int64_t number(int column) = 0;
  virtual std::span<const std::byte> bytes(int column) = 0;
  // Ends the run and forgets the parameters.
  virtual void reset() = 0;
};

struct Words {
  std::string_view begin_to_write;  // from here on no one else changes anything: what is read is not outdated
  std::string_view begin_to_read;   // all reads see one state
  std::string_view version;         // one number, another one after every commit of other connections
  std::string_view newest_event;    // number of the newest row that the table event ever had; no row: 0
};

// Used by one thread at a time.
class Connection {
 public:
  Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  virtual ~Connection() = default;

  [[nodiscard]] virtual const Words& words() const = 0;
  // Several statements without parameters or results.
  virtual store::Result<void> execute(const char* sql) = 0;
  // One statement that begins or ends a transaction, or a savepoint.
  virtual store::Result<void> transact(std::string_view sql);
  [[nodiscard]] virtual bool in_transaction() const = 0;
  // False: it is broken for good, as when the server is gone. Another one may be opened.
  [[nodiscard]] virtual bool is_usable() const { return true; }
  // Of the last INSERT, UPDATE or DELETE; of the last INSERT into a table with numbered rows.
  [[nodiscard]] virtual std::uint64_t changed_rows() const = 0;
  [[nodiscard]] virtual store::Id last_id() const = 0;
  // Of the last call. `about` names what it was for; the engine's own words follow it.
  [[nodiscard]] virtual store::Error fault(std::string_view about) const = 0;

  // A statement that no one else runs, from those that were given back or new; null when the engine refuses it.
  std::unique_ptr<Statement> take(std::string_view sql);
  void give_back(std::string_view sql, std::unique_ptr<Statement> statement);

 protected:
  // Null: the fault is in the connection.
  virtual std::unique_ptr<Statement> prepare(std::string_view sql) = 0;
  // Before what they were prepared on is closed.
  void drop_statements() { idle_.clear(); }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };
  // Mostly one statement an SQL text; more when a statement runs inside itself.
  std::unordered_map<std::string, std::vector<std::unique_ptr<Statement>>, Hash, std::equal_to<>> idle_;
};

// Opens connections to one store.
class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;
  virtual store::Result<std::unique_ptr<Connection>> connect_to_read() = 0;
  // For the one connection that writes.
  virtual store::Result<std::unique_ptr<Connection>> connect_to_write() = 0;
};

}  // namespace dripfeed::sql
