// Where a machine is reached, as a URL: serial:/dev/ttyS0?baud=9600&framing=7E2, tcp://host:port, tcp-listen://:port,
// rfc2217://host:port?baud=9600, modbus-tcp://host:port/unit, modbus-rtu:/dev/ttyS1?unit=1, pty:/path,
// dir:/path?ext=NC. Which of them a program end may use (server, simulator) is the opener's decision.
#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <string>
#include <string_view>

namespace dripfeed::machine {

enum class LinkKind : std::uint8_t {
  serial,
  tcp,
  tcp_listen,
  rfc2217,
  rfc2217_listen,
  modbus_tcp,
  pty,
  dir,
  modbus_rtu
};
std::string_view name_of(LinkKind kind);

struct LinkUrl {
  LinkKind kind = LinkKind::serial;
  std::string path;  // serial, pty
  std::string host;  // tcp, tcp_listen (empty: loopback), modbus_tcp
  std::uint16_t port = 0;
  std::uint8_t unit = 1;                       // modbus_tcp
  std::map<std::string, std::string> options;  // by their names, as written
  std::string text;                            // as written

  friend bool operator==(const LinkUrl&, const LinkUrl&) = default;
};

// The URL, or one sentence that says what is wrong and where ("unknown scheme \"ftp\" …", "port \"99999\" is
// not 1..65535"). Options are checked by name here, by value where they are used.
std::expected<LinkUrl, std::string> parse_link_url(std::string_view text);

// A program goes over it character by character, paced by us; the others take blocks or a whole file.
bool feeds_characters(LinkKind kind);

// Blind links do not show what is still unsent below the socket.
bool is_blind(LinkKind kind);
// A bus of registers, not a link of bytes.
bool is_modbus(LinkKind kind);

}  // namespace dripfeed::machine
