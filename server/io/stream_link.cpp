// Which driver opens which kind of link.
#include "server/io/stream_link.h"

#include <array>

#include <boost/system/system_error.hpp>
#include <fmt/format.h>

#include "server/io/com_port_link.h"
#include "server/io/serial_link.h"
#include "server/io/tcp_link.h"

namespace dripfeed::io {

namespace {

using Opened = std::expected<std::unique_ptr<app::Link>, std::string>;

struct OpenerRow {
  machine::LinkKind kind;
  Opened (*open)(boost::asio::io_context&, const machine::LineSettings&, app::LinkListener&);
};
constexpr std::array kOpeners = {
    OpenerRow{machine::LinkKind::serial, open_serial_link},
    OpenerRow{machine::LinkKind::pty, open_serial_link},
    OpenerRow{machine::LinkKind::tcp, open_tcp_link},
    OpenerRow{machine::LinkKind::tcp_listen, open_tcp_listener},
    OpenerRow{machine::LinkKind::rfc2217, open_com_port_link},
};

}  // namespace

Opened open_link(boost::asio::io_context& context, const machine::LineSettings& line, app::LinkListener& listener) {
  for (const OpenerRow& row : kOpeners) {
    if (row.kind != line.link.kind) continue;
    try {
      return row.open(context, line, listener);
    } catch (const boost::system::system_error& error) {
      return std::unexpected(fmt::format("{}: {}", line.link.text, error.code().message()));
    }
  }
  return std::unexpected(fmt::format("{} is not a link of bytes", line.link.text));
}

}  // namespace dripfeed::io
