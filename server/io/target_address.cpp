// The special-purpose registries of IANA (RFC 6890 and its updates), as far as they distinguish the three.
#include "server/io/target_address.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include <boost/asio/ip/network_v4.hpp>
#include <boost/asio/ip/network_v6.hpp>

namespace dripfeed::io {

namespace {

namespace ip = boost::asio::ip;

struct Row {
  std::string_view network;
  Reach reach;
};

// The first row that holds the address counts.
constexpr std::array kV4 = {
    Row{"0.0.0.0/8", Reach::never},          Row{"169.254.0.0/16", Reach::never},  // link-local, metadata of clouds
    Row{"100.100.100.200/32", Reach::never},                                       // metadata of a cloud
    Row{"192.0.0.192/32", Reach::never},                                           // the same
    Row{"224.0.0.0/4", Reach::never},        Row{"240.0.0.0/4", Reach::never},  // many receivers; reserved, broadcast
    Row{"127.0.0.0/8", Reach::local},        Row{"10.0.0.0/8", Reach::local},     Row{"172.16.0.0/12", Reach::local},
    Row{"192.168.0.0/16", Reach::local},     Row{"100.64.0.0/10", Reach::local},  Row{"192.0.0.0/24", Reach::local},
    Row{"198.18.0.0/15", Reach::local},
};
constexpr std::array kV6 = {
    Row{"::/128", Reach::never},    Row{"fe80::/10", Reach::never}, Row{"fd00:ec2::254/128", Reach::never},
    Row{"ff00::/8", Reach::never},  Row{"::1/128", Reach::local},   Row{"fc00::/7", Reach::local},
    Row{"fec0::/10", Reach::local},
};
// IPv4 addresses inside IPv6 ones, and where they begin there: mapped, translated (RFC 6052), 6to4.
struct Wrapped {
  std::string_view network;
  std::size_t at;
};
constexpr std::array kWrapped = {Wrapped{"::ffff:0:0/96", 12}, Wrapped{"64:ff9b::/96", 12}, Wrapped{"2002::/16", 2},
                                 Wrapped{"::/96", 12}};

bool holds(const ip::address_v4& address, std::string_view network) {
  const auto row = ip::make_network_v4(network);
  return ip::network_v4(address, row.prefix_length()).canonical() == row.canonical();
}

bool holds(const ip::address_v6& address, std::string_view network) {
  const auto row = ip::make_network_v6(network);
  return ip::network_v6(address, row.prefix_length()).canonical() == row.canonical();
}

template <class Address, std::size_t N>
const Row* row_of(const Address& address, const std::array<Row, N>& rows) {
  const auto found = std::ranges::find_if(rows, [&](const Row& row) { return holds(address, row.network); });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

Reach reach_of(const ip::address& address) {
  if (address.is_v4()) {
    const Row* const row = row_of(address.to_v4(), kV4);
    return row == nullptr ? Reach::open : row->reach;
  }
  ip::address_v6 v6 = address.to_v6();
  v6.scope_id(0);
  if (const Row* const row = row_of(v6, kV6)) return row->reach;
  for (const Wrapped& wrapped : kWrapped) {
    if (!holds(v6, wrapped.network)) continue;
    const auto bytes = v6.to_bytes();
    ip::address_v4::bytes_type inner{};
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(wrapped.at), inner.size(), inner.begin());
    return reach_of(ip::address_v4(inner));
  }
  return Reach::open;
}

}  // namespace dripfeed::io
