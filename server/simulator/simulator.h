// server/simulator: simulated controls and a simulated PLC, for trying a line without a machine. A control has its own
// buffer, line time, flow control, alarms and motion time; it shares no code with the checks that predict it, and none
// with the feed that it judges. It never runs an unfinished block.
#pragma once

#include "server/simulator/block_clock.h"
#include "server/simulator/control.h"
#include "server/simulator/fault.h"
#include "server/simulator/fleet.h"
#include "server/simulator/plc.h"
#include "server/simulator/simulated_control.h"
#include "server/simulator/uart.h"
