// Work of callers as one transaction.
#include "store/sql/table_store.h"

namespace dripfeed::sql {

using store::Result;

Result<void> TableStore::atomically(const std::function<Result<void>()>& work) {
  return database_->write("transaction", [&](Session& /*session*/) { return work(); });
}

Result<void> TableStore::atomically_shared(const std::function<Result<void>()>& work) {
  return database_->write_shared("transaction", [&](Session& /*session*/) { return work(); });
}

}  // namespace dripfeed::sql
