// The locks of a connection go a moment after it was closed: the process of the server that served it ends by itself.
// Who starts right after another has ended would be refused for the sake of one that is not there.
#pragma once

#include <functional>

#include "store/store.h"

namespace dripfeed::postgresql {

// Calls `attempt` again and again while it is refused with `code`, for two seconds at most.
store::Result<void> wait_for_the_ended(store::ErrorCode code, const std::function<store::Result<void>()>& attempt);

}  // namespace dripfeed::postgresql
