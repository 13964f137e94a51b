// A simulated device server: the control's line behind RFC 2217 on a socket.
#pragma once

#include <memory>

#include "server/simulator/wire.h"

namespace dripfeed::simulator {

// `socket`: a wire that listens.
std::unique_ptr<Wire> over_telnet(std::unique_ptr<Wire> socket);

}  // namespace dripfeed::simulator
