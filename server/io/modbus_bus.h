// A register bus over Modbus TCP or RTU (libmodbus). Blocking: each bus object is used from one thread of its own.
// Units behind one address or on one serial line share its connection; their requests queue up in their order.
#pragma once

#include <cstddef>
#include <memory>

#include "server/app/ports/register_bus.h"

namespace dripfeed::io {

// Connections at the same time, each an address or a serial line. Calls on a bus beyond them fail and say so.
inline constexpr std::size_t kMaxBuses = 16;

std::unique_ptr<app::RegisterBus> make_modbus_bus(const machine::LinkUrl& url);

}  // namespace dripfeed::io
