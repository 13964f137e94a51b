// The ledger in the database.
#pragma once

#include "store/ledger.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class LedgerTable final : public store::Ledger {
 public:
  explicit LedgerTable(Database& database) : database_(database) {}
  store::Result<std::vector<store::LedgerFault>> append(std::span<const store::NewLedgerRow> rows,
                                                        std::int64_t at_ms) override;
  store::Result<store::Page<store::LedgerRow>> rows(store::Id job, const store::PageRequest& page) override;
  store::Result<store::LedgerInterval> interval(store::Id job) override;
  store::Result<std::uint64_t> verify(store::Id job) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
