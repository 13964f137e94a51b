// The transitions of orders, as a table.
#include "store/orders.h"

#include <array>

namespace dripfeed::store {
namespace {

using enum OrderState;

// What was cancelled stays so; what was done too soon is opened again.
constexpr std::array kTransitions{OrderTransition{open, held},      OrderTransition{held, open},
                                  OrderTransition{open, done},      OrderTransition{done, open},
                                  OrderTransition{open, cancelled}, OrderTransition{held, cancelled}};

}  // namespace

std::span<const OrderTransition> order_transitions() { return kTransitions; }

}  // namespace dripfeed::store
