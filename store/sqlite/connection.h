// One connection to the database file, used by one thread at a time, with its prepared statements.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "store/error.h"
#include "store/sqlite/open.h"

struct sqlite3;
struct sqlite3_stmt;

namespace dripfeed::sqlite {

enum class Access : std::uint8_t { read, write, create };

class Connection {
 public:
  // Sets what SQLite keeps per connection: foreign keys, synchronous FULL, the busy timeout.
  static store::Result<std::unique_ptr<Connection>> open(const std::string& path, const OpenSettings& settings,
                                                         Access access);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection();

  [[nodiscard]] sqlite3* handle() const { return handle_; }
  // Several statements without parameters or results.
  store::Result<void> execute(const char* sql);
  // A statement that nobody else runs, from the cache or new; null when SQLite refuses it. give_back() returns it
  // reset.
  sqlite3_stmt* take(std::string_view sql);
  void give_back(std::string_view sql, sqlite3_stmt* statement);
  [[nodiscard]] bool in_transaction() const;

 private:
  explicit Connection(sqlite3* handle) : handle_(handle) {}

  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };
  sqlite3* handle_;
  // Mostly one statement an SQL text; more when a statement runs inside itself.
  std::unordered_map<std::string, std::vector<sqlite3_stmt*>, Hash, std::equal_to<>> idle_;
};

}  // namespace dripfeed::sqlite
