// Register buses over Modbus TCP or RTU (libmodbus): one connection and one thread for each address or serial line,
// which carries the requests of all who have a unit there, in turn.
#pragma once

#include <cstddef>
#include <expected>
#include <memory>
#include <string>

#include "server/app/ports/register_bus.h"

namespace dripfeed::io {

// Buses at the same time. A seat on one more is refused.
inline constexpr std::size_t kMaxBuses = 16;

// See BusSeatMaker. Refused: wrong options, one bus too many, a line that another machine uses with other settings.
std::expected<std::unique_ptr<app::BusSeat>, std::string> take_modbus_seat(const machine::LinkUrl& url,
                                                                           app::BusUser& user);

}  // namespace dripfeed::io
