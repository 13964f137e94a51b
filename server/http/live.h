// Live events as text/event-stream: transitions with their ids, and the newest progress of each machine at most five
// times a second.
#pragma once

#include <cstdint>
#include <memory>

#include "server/app/events.h"
#include "server/http/event_stream.h"

namespace dripfeed::http {

// Everything after event `after`. The events must outlive the subscription.
std::shared_ptr<EventSubscription> watch_events(app::Events& events, std::uint64_t after);

}  // namespace dripfeed::http
