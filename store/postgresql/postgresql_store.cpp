// Opening a store, and what concerns the whole of it.
#include <fmt/format.h>

#include "store/postgresql/open.h"
#include "store/postgresql/server.h"
#include "store/sql/table_store.h"
#include "store/sql/verifier.h"

namespace dripfeed::postgresql {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

class PostgresqlStore final : public sql::TableStore {
 public:
  using TableStore::TableStore;

  // The server has its own means, which know its files and its log.
  Result<void> backup(const std::string& /*path*/) override {
    return std::unexpected(Error{ErrorCode::invalid_value, "a store on PostgreSQL is backed up with pg_dump"});
  }

  Result<void> check() override {
    const auto found = sql::verify(database());
    if (!found) return std::unexpected(found.error());
    if (found->faults.empty()) return {};
    const sql::VerifyFault& first = found->faults.front();
    return std::unexpected(Error{ErrorCode::corrupt, fmt::format("{}: {}", first.subject, first.what)});
  }
};

}  // namespace

Result<std::unique_ptr<store::Store>> open(const std::string& url, const OpenSettings& settings) {
  auto server = Server::open(url, settings);
  if (!server) return std::unexpected(server.error());
  auto database = sql::Database::open(std::move(*server));
  if (!database) return std::unexpected(database.error());
  auto opened = std::make_unique<PostgresqlStore>(std::move(*database));
  if (settings.own) {
    if (auto dropped = opened->contents().drop_unused(); !dropped) return std::unexpected(dropped.error());
  }
  return opened;
}

}  // namespace dripfeed::postgresql
