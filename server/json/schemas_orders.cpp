// What orders.cpp writes.
#include "server/json/orders.h"

namespace dripfeed::json {

Schemas order_schemas() {
  return {{"Order",
           object("what is to be made, as a MES or a planner says",
                  {{"id", integer("of the order")},
                   {"number", text("of the planner; with the operation there is one order of it")},
                   {"operation", or_null(text("of the routing; null: there is none"))},
                   {"part", text("its number")},
                   {"quantity", integer("good parts that are wanted")},
                   {"machine", or_null(text("for which it is; null: not decided"))},
                   {"due_at_ms", or_null(time_ms("until then"))},
                   {"priority", integer("the higher the sooner")},
                   {"metadata", map_of(any("of the planner"), "as it came")},
                   {"state", one_of(store::kNames<store::OrderState>, "jobs are queued and armed while it is open")},
                   {"reason", or_null(text("of the last change of its state"))},
                   {"good", integer("parts that were reported good")},
                   {"scrap", integer("parts that were reported as scrap")},
                   {"open", integer("good parts that are missing")},
                   {"transfers", integer("jobs of it that are done; no count of parts")},
                   {"waiting", integer("jobs of it that are queued")},
                   {"revision", integer("of the plan")},
                   {"created_by", text("who made it")},
                   {"created_at_ms", time_ms("when")},
                   {"changed_at_ms", time_ms("of plan or state")}})}};
}

}  // namespace dripfeed::json
