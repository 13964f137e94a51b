// A store of this program's schema; an older one is not brought up to date, because that would write.
#include "store/postgresql/verify.h"

#include "store/postgresql/migrations.h"
#include "store/postgresql/server.h"

namespace dripfeed::postgresql {
using store::Result;

Result<sql::Verification> verify(const std::string& url) {
  {
    auto connection = Connection::open(url, {});
    if (!connection) return std::unexpected(connection.error());
    if (auto known = know_schema(**connection); !known) return std::unexpected(known.error());
  }
  auto database = sql::Database::open(Server::only_read(url), sql::Database::May::read);
  if (!database) return std::unexpected(database.error());
  return sql::verify(**database);
}

}  // namespace dripfeed::postgresql
