// The profile's section "receive".
#pragma once

#include "server/json/object_reader.h"
#include "server/machine/receive_settings.h"

namespace dripfeed::json {

void read_receive(ObjectReader& object, machine::ReceiveSettings& receive);

}  // namespace dripfeed::json
