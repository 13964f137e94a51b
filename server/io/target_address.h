// Which addresses a request to another system may go to. A URL is written by a person, or comes from one who found a
// token: it must not reach what only this computer may reach unless an admin meant it.
#pragma once

#include <string>

#include <boost/asio/ip/address.hpp>

namespace dripfeed::io {

enum class Reach : std::uint8_t {
  open,   // a network that everybody reaches
  local,  // this computer, a private network: where an admin says so
  never,  // the computer's own metadata, link-local, many receivers, none
};

// An IPv4 address in an IPv6 one counts as that.
Reach reach_of(const boost::asio::ip::address& address);

}  // namespace dripfeed::io
