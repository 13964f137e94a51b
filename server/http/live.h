// Live events as text/event-stream: transitions with their ids, and the newest progress of each machine at most five
// times a second.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "server/app/application.h"
#include "server/http/event_stream.h"

namespace dripfeed::http {

// Where a machine stands now, with its program and block: asked for when its line's report has changed.
using Describe = std::function<app::MachineStatus(const std::string& machine)>;

// Everything after event `after`. The events and what `describe` refers to must outlive the subscription.
std::shared_ptr<EventSubscription> watch_events(app::Events& events, std::uint64_t after, Describe describe);

}  // namespace dripfeed::http
