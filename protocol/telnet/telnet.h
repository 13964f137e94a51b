// telnet: a serial port behind a Telnet connection (RFC 854, 855, 856, 858 and the COM-PORT option of RFC 2217). Here
// live the stream of data and commands in both directions, the negotiation of options, and the two ends of a COM port:
// the client that sets a line and the server that has one. Not here: sockets, clocks, what the characters mean, when
// one may go out (protocol/feed). This header brings the folder.
//
// A driver's loop, as for every machine of protocol/: after each call write pending_out() and mark_sent() what was
// taken, drain next_event(), set a timer to deadline() and call tick(now) when it fires.
#pragma once

#include "protocol/telnet/codes.h"
#include "protocol/telnet/com_port_client.h"
#include "protocol/telnet/com_port_server.h"
#include "protocol/telnet/decoder.h"
#include "protocol/telnet/options.h"
#include "protocol/telnet/output.h"
