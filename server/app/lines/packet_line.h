// A line fed in packets: a packet sender over a link of bytes, on the links' thread. It opens the link, opens it again
// after a loss (an idle link sends nothing), pumps, and keeps a report whose `confirmed` the receiver acknowledged.
#pragma once

#include <memory>

#include "server/app/lines/line.h"
#include "server/app/ports/link_thread.h"

namespace dripfeed::app {

// The line of a profile whose protocol has packets; or why its settings cannot be kept.
std::expected<std::unique_ptr<Line>, std::string> make_packet_line(const machine::LineSettings& settings,
                                                                   LinkThread& thread, LineChanged changed,
                                                                   feed::LeftAs left = feed::LeftAs::whole);

}  // namespace dripfeed::app
