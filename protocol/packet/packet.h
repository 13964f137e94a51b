// packet: programs in frames that the receiver acknowledges: XMODEM, YMODEM, Siemens 3964(R), the FANUC remote buffer's
// protocol A. Here live one sender and one receiver for all of them, each with its table of states, and the rules that
// each protocol adds. Neither does I/O: driven as protocol/feed says at its top. Not here: ports, clocks, threads, what
// a program means. This header brings all of the folder.
//
// To receive a text: make a Sink, Receiver::make(settings, sink), link(true, now), start(now); then give it what comes,
// write what pending_out() shows, call tick() at deadline() (and when the sink got room), until state() is `done`
// or `failed` (end_cause() says why; what the sink has then is no whole program).
#pragma once

#include "protocol/packet/check_sums.h"
#include "protocol/packet/event.h"
#include "protocol/packet/receiver.h"
#include "protocol/packet/sender.h"
#include "protocol/packet/settings.h"
