// A tty or pty as a link: bytes, modem lines and what the receiver counted.
#pragma once

#include <expected>
#include <memory>
#include <string>

#include <boost/asio/io_context.hpp>

#include "server/app/ports/link.h"
#include "server/machine/profile.h"

namespace dripfeed::io {

std::expected<std::unique_ptr<app::Link>, std::string> open_serial_link(boost::asio::io_context& context,
                                                                        const machine::LineSettings& line,
                                                                        app::LinkListener& listener);

}  // namespace dripfeed::io
