// server/io: the drivers of the application's ports: the links' thread, ttys, sockets (Asio) and the register bus
// (libmodbus). They move bytes and report what the system said; what may be sent, and when, is decided above.
#pragma once

#include "server/io/line_claim.h"
#include "server/io/link_thread.h"
#include "server/io/modbus_bus.h"
#include "server/io/steady_clock.h"
