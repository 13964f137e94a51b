// Orders in the database.
#pragma once

#include "store/orders.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class OrderTable final : public store::Orders {
 public:
  explicit OrderTable(Database& database) : database_(database) {}
  store::Result<store::Order> add(const store::NewOrder& order, const store::Stamp& by) override;
  store::Result<store::Order> change(store::Id order, store::Revision expected, const store::OrderPlan& plan,
                                     const store::Stamp& by) override;
  store::Result<store::Order> move(store::Id order, store::OrderState to, std::string_view reason,
                                   const store::Stamp& by) override;
  store::Result<store::Order> report(store::Id order, const store::PartsReport& parts, const store::Stamp& by) override;
  store::Result<store::Order> get(store::Id order) override;
  store::Result<store::Page<store::Order>> list(const store::PageRequest& page,
                                                const store::OrderFilter& filter) override;

 private:
  Database& database_;
};

// Inside a transaction: refuses an order that is not open, or is for another machine. 0 is none. Errors:
// broken_reference, refused_transition.
store::Result<void> refuse_closed(Session& session, store::Id order, std::string_view machine);

}  // namespace dripfeed::sql
