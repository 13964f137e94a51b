// One connection to the database file, and what opens them.
#pragma once

#include <optional>
#include <string>

#include "store/sql/connection.h"
#include "store/sqlite/open.h"
#include "store/sqlite/owner_lock.h"

struct sqlite3;

namespace dripfeed::sqlite {

enum class Access : std::uint8_t { read, write, create };

class Connection final : public sql::Connection {
 public:
  // Sets what SQLite keeps per connection: foreign keys, synchronous FULL, the busy timeout.
  static store::Result<std::unique_ptr<Connection>> open(const std::string& path, const OpenSettings& settings,
                                                         Access access);
  ~Connection() override;

  [[nodiscard]] sqlite3* handle() const { return handle_; }
  [[nodiscard]] const sql::Words& words() const override;
  store::Result<void> execute(const char* sql) override;
  [[nodiscard]] bool in_transaction() const override;
  [[nodiscard]] std::uint64_t changed_rows() const override;
  [[nodiscard]] store::Id last_id() const override;
  [[nodiscard]] store::Error fault(std::string_view about) const override;

 protected:
  std::unique_ptr<sql::Statement> prepare(std::string_view sql) override;

 private:
  explicit Connection(sqlite3* handle) : handle_(handle) {}
  sqlite3* handle_;
};

// The file exists and its schema is up to date.
class File final : public sql::Engine {
 public:
  explicit File(std::string path, OpenSettings settings = {}, std::optional<OwnerLock> lock = {})
      : lock_(std::move(lock)), path_(std::move(path)), settings_(std::move(settings)) {}
  store::Result<std::unique_ptr<sql::Connection>> connect_to_read() override;
  store::Result<std::unique_ptr<sql::Connection>> connect_to_write() override;

 private:
  std::optional<OwnerLock> lock_;  // until all connections are closed
  std::string path_;
  OpenSettings settings_;
};

}  // namespace dripfeed::sqlite
