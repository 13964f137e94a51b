// Orders: what a shop is to make, as its MES or planner says: part, operation, quantity, date. Jobs may belong to one.
// An order moves by one table of states; while it is not open, none of its jobs is armed. Nothing here starts anything.
#pragma once

#include <optional>
#include <span>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

enum class OrderState : std::uint8_t { open, held, done, cancelled };
template <>
inline constexpr std::array<std::string_view, 4> kNames<OrderState>{"open", "held", "done", "cancelled"};

struct OrderTransition {
  OrderState from = OrderState::open;
  OrderState to = OrderState::open;
};
// All that are allowed.
std::span<const OrderTransition> order_transitions();

// What may change while the order is open or held.
struct OrderPlan {
  std::string part{};
  std::uint64_t quantity = 1;
  std::string machine{};        // "": not decided
  std::int64_t due_at_ms = 0;   // 0: no date
  std::uint32_t priority = 0;   // the higher the sooner
  std::string metadata = "{}";  // a document, not read here
  friend bool operator==(const OrderPlan&, const OrderPlan&) = default;
};

struct NewOrder {
  std::string number;
  std::string operation{};
  OrderPlan plan{};
};

struct Order {
  Id id = 0;
  NewOrder of;
  OrderState state = OrderState::open;
  std::string reason;      // of the last move
  std::uint64_t good = 0;  // parts, as people, controls or the MES reported
  std::uint64_t scrap = 0;
  std::uint64_t transfers = 0;  // jobs of it that are done
  std::uint64_t waiting = 0;    // jobs of it that are queued; a choice of jobs counts once
  Revision revision = 0;        // of the plan
  std::string created_by;
  std::int64_t created_at_ms = 0;
  std::int64_t changed_at_ms = 0;
};

// Parts that were made since the last report.
struct PartsReport {
  std::uint64_t good = 0;
  std::uint64_t scrap = 0;
  std::string note{};
};

struct OrderFilter {
  std::string number{};
  std::string part{};
  std::string machine{};
  std::optional<OrderState> state{};
};

class Orders : public Repository {
 public:
  // Open. The same number, operation and plan again is the order that is there. Errors: exists (with another plan),
  // invalid_value (no number, no part, no quantity), broken_reference (no such machine).
  virtual Result<Order> add(const NewOrder& order, const Stamp& by) = 0;
  // Errors: not_found, stale_revision, refused_transition (done or cancelled), and those of add.
  virtual Result<Order> change(Id order, Revision expected, const OrderPlan& plan, const Stamp& by) = 0;
  // Errors: not_found, refused_transition, machine_busy (cancelled or done while a job of it has a line).
  virtual Result<Order> move(Id order, OrderState to, std::string_view reason, const Stamp& by) = 0;
  // Errors: not_found, refused_transition (cancelled), invalid_value (nothing).
  virtual Result<Order> report(Id order, const PartsReport& parts, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<Order> get(Id order) = 0;
  // Newest first.
  virtual Result<Page<Order>> list(const PageRequest& page, const OrderFilter& filter = {}) = 0;
};

}  // namespace dripfeed::store
