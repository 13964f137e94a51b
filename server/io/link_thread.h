// The thread that all links share, on Asio.
#pragma once

#include <memory>

#include "server/app/ports/link_thread.h"

namespace dripfeed::io {

// Starts the thread; the destructor stops and joins it. All links and tickers must be gone before.
std::unique_ptr<app::LinkThread> start_link_thread();

}  // namespace dripfeed::io
