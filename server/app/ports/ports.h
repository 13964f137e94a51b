// server/app/ports: what the application needs from outside, as interfaces: clocks, links, the links' thread, a
// register bus. Server/io implements them with Asio and libmodbus, tests with fakes in virtual time. No implementation
// lives here.
#pragma once

#include "server/app/ports/clock.h"
#include "server/app/ports/link.h"
#include "server/app/ports/link_thread.h"
#include "server/app/ports/register_bus.h"
