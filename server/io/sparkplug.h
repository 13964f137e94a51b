// Payloads of Sparkplug B as bytes: Protocol Buffers, as Sparkplug 3.0, section 6.4, has them.
#pragma once

#include <string>
#include <string_view>

#include "server/app/ports/sparkplug_payload.h"

namespace dripfeed::io {

std::string write_sparkplug(const app::SparkplugPayload& payload);

// Whether it is a command to a node that asks for all births again. False for all else, also for what is no payload.
bool asks_for_rebirth(std::string_view payload);

}  // namespace dripfeed::io
