// Receipts and requests in the database.
#pragma once

#include "store/receipts.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class ReceiptTable final : public store::Receipts {
 public:
  explicit ReceiptTable(Database& database) : database_(database) {}
  store::Result<store::Receipt> add(const store::NewReceipt& receipt, const store::Stamp& by) override;
  store::Result<store::Receipt> accept(store::Id receipt, store::Id program, store::Revision revision,
                                       std::string_view reason, const store::Stamp& by) override;
  store::Result<store::Receipt> discard(store::Id receipt, std::string_view reason, const store::Stamp& by) override;
  store::Result<store::Receipt> get(store::Id receipt) override;
  store::Result<store::Page<store::Receipt>> list(const store::PageRequest& page,
                                                  const store::ReceiptFilter& filter) override;
  store::Result<store::Request> add_request(const store::NewRequest& request, const store::Stamp& by) override;
  store::Result<store::Page<store::Request>> requests(const store::PageRequest& page,
                                                      std::string_view machine) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
