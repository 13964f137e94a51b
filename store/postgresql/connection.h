// One connection to the server.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "store/postgresql/open.h"
#include "store/postgresql/pulse.h"
#include "store/postgresql/waiting.h"
#include "store/sql/connection.h"

namespace dripfeed::postgresql {

class Connection final : public sql::Connection {
 public:
  // Sets what the server keeps per connection: commits are durable, times to wait. With a pulse nothing waits for a
  // silent database. Errors: cannot_open, no_answer.
  static store::Result<std::unique_ptr<Connection>> open(const std::string& url, const OpenSettings& settings,
                                                         std::shared_ptr<const Pulse> pulse = nullptr);
  ~Connection() override;

  [[nodiscard]] const sql::Words& words() const override;
  store::Result<void> execute(const char* sql) override;
  store::Result<void> transact(std::string_view sql) override;
  [[nodiscard]] bool in_transaction() const override;
  [[nodiscard]] bool is_usable() const override;
  [[nodiscard]] std::uint64_t changed_rows() const override { return changed_rows_; }
  [[nodiscard]] store::Id last_id() const override { return last_id_; }
  [[nodiscard]] store::Error fault(std::string_view about) const override;

  // Asks the server for the tables whose rows it numbers, so that last_id() knows them. After the schema was made.
  store::Result<void> learn_numbered_tables();

  // From now on, for one that was opened before there was a pulse.
  void heed(std::shared_ptr<const Pulse> pulse) { pulse_ = std::move(pulse); }

  // For its statements.
  [[nodiscard]] pg_conn* handle() const { return handle_.get(); }
  // Of what PQsend… returned.
  ResultPtr answer(int taken);
  std::string next_name();
  // False: the fault is kept for fault().
  bool note(const pg_result* result);
  void note_changed(const pg_result* result);
  void note_id(store::Id id) { last_id_ = id; }

 protected:
  std::unique_ptr<sql::Statement> prepare(std::string_view sql) override;

 private:
  Connection(pg_conn* handle, std::shared_ptr<const Pulse> pulse) : handle_(handle), pulse_(std::move(pulse)) {}
  store::Result<void> set_up(const OpenSettings& settings);

  HandlePtr handle_;
  std::shared_ptr<const Pulse> pulse_;                        // null: it waits as long as it takes
  std::map<std::string, std::string, std::less<>> numbered_;  // a table and the column of its rows' numbers
  std::uint64_t names_ = 0;
  std::uint64_t changed_rows_ = 0;
  store::Id last_id_ = 0;
  store::Error fault_;
};

}  // namespace dripfeed::postgresql
