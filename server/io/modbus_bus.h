// A register bus over Modbus TCP (libmodbus). Blocking: each bus is used from one thread of its own.
#pragma once

#include <memory>

#include "server/app/ports/register_bus.h"

namespace dripfeed::io {

std::unique_ptr<app::RegisterBus> make_modbus_bus(const machine::LinkUrl& url);

}  // namespace dripfeed::io
