// What makes two links one line.
#include <algorithm>
#include <array>
#include <cctype>

#include <arpa/inet.h>
#include <fmt/format.h>

#include "server/io/line_claim.h"
#include "server/io/serial_identity.h"

namespace dripfeed::io {

namespace {

// One spelling of each address: lower case, numbers as the system writes them. Names are not looked up, because a name
// server may take its time or answer differently tomorrow.
std::string plain_host(std::string host) {
  std::ranges::transform(host, host.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (host.empty() || host == "localhost") return "127.0.0.1";
  for (const int family : {AF_INET, AF_INET6}) {
    std::array<unsigned char, sizeof(in6_addr)> address{};
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (::inet_pton(family, host.c_str(), address.data()) == 1 &&
        ::inet_ntop(family, address.data(), text.data(), text.size()) != nullptr)
      return text.data();
  }
  return host;
}

std::string unit_of(const machine::LinkUrl& link) {
  const auto given = link.options.find("unit");
  return given != link.options.end() ? given->second : std::to_string(link.unit);
}

// The device that is there now, and the path as written: an adapter without a serial number gets another ttyUSB number
// when it is plugged in again, but its by-id name stays; one with a serial number is found under any name.
LineNames serial_names(const machine::LinkUrl& link, const std::string& sysfs) {
  const bool is_bus = link.kind == machine::LinkKind::modbus_rtu;
  const std::string scheme = is_bus ? "modbus-rtu" : "serial";
  const std::string end = is_bus ? "/" + unit_of(link) : std::string();
  const SerialIdentity found = identify_serial(link.path, sysfs);
  const std::string written = plain_path(link.path);
  LineNames line{.names = {fmt::format("{}:{}{}", scheme, written, end)}, .device = found.text};
  if (found.device.empty() || is_pty(found.device)) return line;
  std::string device = found.unique_key.empty() ? fmt::format("{}:{}{}", scheme, found.device, end)
                                                : fmt::format("{}:{}{}", scheme, found.unique_key, end);
  if (device != line.names.front()) line.names.push_back(std::move(device));
  return line;
}

}  // namespace

LineNames names_of(const machine::LinkUrl& link, const std::string& sysfs) {
  const auto at_host = [&](std::string_view scheme) {
    return fmt::format("{}:{}:{}", scheme, plain_host(link.host), link.port);
  };
  switch (link.kind) {
    case machine::LinkKind::serial:
    case machine::LinkKind::pty:
    case machine::LinkKind::modbus_rtu: return serial_names(link, sysfs);
    // The same port of a device server, whether it speaks Telnet there or not.
    case machine::LinkKind::tcp:
    case machine::LinkKind::rfc2217: return {.names = {at_host("net")}, .device = {}};
    case machine::LinkKind::tcp_listen:
    case machine::LinkKind::rfc2217_listen: return {.names = {at_host("listen")}, .device = {}};
    case machine::LinkKind::modbus_tcp: return {.names = {at_host("modbus") + "/" + unit_of(link)}, .device = {}};
    // The folder is not looked at: a network drive that hangs would hang whoever claims.
    case machine::LinkKind::dir: return {.names = {"dir:" + plain_path(link.path)}, .device = {}};
  }
  return {};
}

}  // namespace dripfeed::io
