// Links of bytes on Asio: a tty or pty by its path, a socket as client or as listener for one peer.
#pragma once

#include <expected>
#include <memory>
#include <string>

#include <boost/asio/io_context.hpp>

#include "server/app/ports/link.h"
#include "server/machine/profile.h"

namespace dripfeed::io {

// Opens the line's link. Callbacks come from the context's thread, never from inside this call or write().
std::expected<std::unique_ptr<app::Link>, std::string> open_link(boost::asio::io_context& context,
                                                                 const machine::LineSettings& line,
                                                                 app::LinkListener& listener);

}  // namespace dripfeed::io
