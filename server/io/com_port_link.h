// A serial port behind a device server that speaks RFC 2217: a socket below, the COM-port client of protocol/telnet on
// it, its modem lines and line errors handed on.
#pragma once

#include <expected>
#include <memory>
#include <string>

#include <boost/asio/io_context.hpp>

#include "server/app/ports/link.h"
#include "server/machine/profile.h"

namespace dripfeed::io {

std::expected<std::unique_ptr<app::Link>, std::string> open_com_port_link(boost::asio::io_context& context,
                                                                          const machine::LineSettings& line,
                                                                          app::LinkListener& listener);

}  // namespace dripfeed::io
