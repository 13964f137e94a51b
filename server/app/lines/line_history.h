// How a line was left, as the store and the line's own record have it. A line is made with this knowledge, so that
// there is no moment in which it could complete a torn block.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "server/app/base/error.h"
#include "server/app/ports/line_claims.h"
#include "store/store.h"

namespace dripfeed::app {

// A block that may be torn at the control, until a person confirms that it was reset.
struct TornBlock {
  store::Id job = 0;        // 0: an answer to the operator, or another program on the line
  std::string text;         // why
  std::string reason_id{};  // why as one word or name: the job's, "answer_torn", "line_record" or "line_torn"
};

struct LineHistory {
  // The block that may be torn at this machine's control. An error makes no line.
  std::function<Result<std::optional<TornBlock>>(const std::string& machine)> torn;
  // Takes the line for this process; empty: lines are not claimed, as in a test without a system.
  ClaimLine claim;
};

// What the store has of a machine: a torn job, or a torn answer.
Result<std::optional<TornBlock>> torn_in_store(store::Store& store, const std::string& machine);

LineHistory history_of(store::Store& store, ClaimLine claim);

}  // namespace dripfeed::app
