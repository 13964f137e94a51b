// A Modbus TCP server on an address of its own, for PLCs that read what the machines do. Frames and answers are
// those of protocol/modbus; the registers come from whoever gives the view.
#pragma once

#include <expected>
#include <memory>
#include <string>

#include "protocol/modbus/register_server.h"
#include "server/io/peer_listener.h"

namespace dripfeed::io {

// The view is used on the listener's thread alone and must outlive it. Errors: as PeerListener::listen().
std::expected<std::unique_ptr<PeerListener>, std::string> listen_modbus(const PeerSettings& settings,
                                                                        modbus::RegisterView& view);

}  // namespace dripfeed::io
