// A line on which a control punches one text in packets: a packet receiver over a link of bytes, on the links' thread.
// It feeds nothing. What came is a reception, for whoever judges it.
#pragma once

#include <memory>

#include "server/app/lines/line.h"
#include "server/app/ports/link_thread.h"

namespace dripfeed::app {

// The line of a profile whose protocol has packets; or why its settings cannot be kept. Its only command is `abort`:
// the sender gets what the protocol has for it, and what came so far is a broken reception. A text that ends by itself
// (XMODEM, YMODEM, the remote buffer) ends there; one of 3964 ends after its final '%', or when nothing more comes.
std::expected<std::unique_ptr<Line>, std::string> make_packet_receive_line(const machine::LineSettings& settings,
                                                                           LinkThread& thread, LineChanged changed);

}  // namespace dripfeed::app
