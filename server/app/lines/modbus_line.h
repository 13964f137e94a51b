// A line that transfers blocks by registers: the mailbox sender in turns on its bus's thread. Exactly once: what is
// confirmed was read back. While no job is on it, it looks at the machine's words and listens to its doorbell.
#pragma once

#include <chrono>
#include <expected>
#include <memory>
#include <string>

#include "server/app/lines/line.h"
#include "server/app/ports/clock.h"
#include "server/app/ports/register_bus.h"

namespace dripfeed::app {

struct ModbusLineSettings {
  machine::LinkUrl link;
  std::chrono::nanoseconds idle_poll = std::chrono::milliseconds(500);
  feed::LeftAs left = feed::LeftAs::whole;  // torn: no job before a person confirms the reset
};

// Or one sentence that says why the bus has no seat for it.
std::expected<std::unique_ptr<Line>, std::string> make_modbus_line(const ModbusLineSettings& settings,
                                                                   BusSeatMaker take_seat, const Clock& clock,
                                                                   LineChanged changed);

}  // namespace dripfeed::app
