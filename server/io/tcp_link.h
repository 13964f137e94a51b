// A socket as a link: to a device server (client), or from one (listener for one peer). What stands below
// rfc2217:// links, too.
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "server/io/stream_core.h"
#include "server/machine/profile.h"

namespace dripfeed::io {

using TcpCore = Core<boost::asio::ip::tcp::socket>;

// Looks the name up, tries its addresses one after the other and begins; gives up after 10 s.
void connect(const std::shared_ptr<TcpCore>& core, const std::string& host, std::uint16_t port);

// Bytes that were written and not acknowledged by the peer's TCP.
std::optional<std::uint64_t> read_unconfirmed(int descriptor);

// What was not acknowledged when the link closes must not follow later: then, and where `always` asks for it (device
// servers that keep a half-open connection), the connection is reset instead of closed.
void reset_on_close(TcpCore& core, bool always);

std::expected<std::unique_ptr<app::Link>, std::string> open_tcp_link(boost::asio::io_context& context,
                                                                     const machine::LineSettings& line,
                                                                     app::LinkListener& listener);
std::expected<std::unique_ptr<app::Link>, std::string> open_tcp_listener(boost::asio::io_context& context,
                                                                         const machine::LineSettings& line,
                                                                         app::LinkListener& listener);

}  // namespace dripfeed::io
