// A line that transfers blocks by registers: the mailbox sender over a register bus, on a thread of its own because the
// bus blocks. Exactly once: what is confirmed was read back.
#pragma once

#include <memory>

#include "server/app/line.h"
#include "server/app/ports/clock.h"
#include "server/app/ports/register_bus.h"

namespace dripfeed::app {

std::unique_ptr<Line> make_mailbox_line(std::unique_ptr<RegisterBus> bus, const Clock& clock, LineChanged changed);

}  // namespace dripfeed::app
