// Orders in the database.
#pragma once

#include "store/jobs.h"
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

// Inside a transaction: refuses a job whose order is not open, is for another machine, or is of another part than the
// one that the job's program was rendered from. Errors: broken_reference, refused_transition.
store::Result<void> refuse_unfit(Session& session, const store::Job& job);
// Inside a transaction: how urgent it is; 0 without an order.
std::uint64_t priority_of(Session& session, store::Id order);

}  // namespace dripfeed::sql
