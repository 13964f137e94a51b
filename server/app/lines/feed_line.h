// A line fed character by character: a feed machine over a link of bytes, on the links' thread. It opens the link,
// opens it again after a loss (an idle link sends nothing), pumps, and keeps a report for the others.
#pragma once

#include <memory>
#include <mutex>

#include "server/app/lines/line.h"
#include "server/app/ports/link_thread.h"

namespace dripfeed::app {

// The line of a profile, in the state in which its last user left it; or why its settings cannot be kept (the budget's
// sum, a bad option). `changed` wakes whoever looks at reports.
std::expected<std::unique_ptr<Line>, std::string> make_feed_line(const machine::LineSettings& settings,
                                                                 LinkThread& thread, LineChanged changed,
                                                                 feed::LeftAs left = feed::LeftAs::whole);

}  // namespace dripfeed::app
