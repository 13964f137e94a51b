// The scheme table says which parts each kind of link has; everything else follows from it.
#include "server/machine/link_url.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

namespace dripfeed::machine {

namespace {

struct Scheme {
  std::string_view name;
  LinkKind kind;
  std::string_view prefix;  // between scheme and address
  bool has_path;            // a path, otherwise host:port
  bool has_unit;            // …/unit after the port
};
constexpr std::array kSchemes = {
    Scheme{"serial", LinkKind::serial, "", true, false},
    Scheme{"pty", LinkKind::pty, "", true, false},
    Scheme{"tcp", LinkKind::tcp, "//", false, false},
    Scheme{"tcp-listen", LinkKind::tcp_listen, "//", false, false},
    Scheme{"dir", LinkKind::dir, "", true, false},
    Scheme{"rfc2217", LinkKind::rfc2217, "//", false, false},
    Scheme{"rfc2217-listen", LinkKind::rfc2217_listen, "//", false, false},
    Scheme{"modbus-tcp", LinkKind::modbus_tcp, "//", false, true},
    Scheme{"modbus-rtu", LinkKind::modbus_rtu, "", true, false},
};

constexpr auto kOptions = std::to_array<std::string_view>(
    {"baud",          "framing",       "flow",     "latency_chars", "budget",  "unsent",    "start", "eob",
     "char_delay_ms", "line_delay_ms", "code",     "close",         "ext",     "overwrite", "unit",  "timeout_ms",
     "poll_ms",       "protocol",      "answer_s", "payload",       "counted", "peers"});

std::optional<std::int64_t> integer_between(std::string_view text, std::int64_t low, std::int64_t high) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < low || value > high) return std::nullopt;
  return value;
}

std::expected<void, std::string> read_options(std::string_view query, LinkUrl& url) {
  while (!query.empty()) {
    const std::string_view item = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), item.size() + 1));
    const std::size_t equals = item.find('=');
    const std::string name(item.substr(0, equals));
    if (equals == std::string_view::npos || equals + 1 == item.size()) {
      return std::unexpected(fmt::format("option \"{}\" has no value", name));
    }
    if (std::ranges::find(kOptions, name) == kOptions.end()) {
      return std::unexpected(fmt::format("unknown option \"{}\"; known are {}", name, fmt::join(kOptions, ", ")));
    }
    if (!url.options.emplace(name, item.substr(equals + 1)).second) {
      return std::unexpected(fmt::format("option \"{}\" is given twice", name));
    }
  }
  return {};
}

std::expected<void, std::string> read_address(std::string_view address, const Scheme& scheme, LinkUrl& url) {
  if (scheme.has_path) {
    if (!address.starts_with('/')) return std::unexpected(fmt::format("\"{}\" is not an absolute path", address));
    url.path = address;
    return {};
  }
  if (scheme.has_unit) {
    const std::size_t slash = address.find('/');
    if (slash != std::string_view::npos) {
      const auto unit = integer_between(address.substr(slash + 1), 0, 255);
      if (!unit) return std::unexpected(fmt::format("unit \"{}\" is not 0..255", address.substr(slash + 1)));
      url.unit = static_cast<std::uint8_t>(*unit);
      address = address.substr(0, slash);
    }
  }
  const std::size_t colon = address.rfind(':');
  if (colon == std::string_view::npos) return std::unexpected(fmt::format("\"{}\" has no port", address));
  const auto port = integer_between(address.substr(colon + 1), 1, 65535);
  if (!port) return std::unexpected(fmt::format("port \"{}\" is not 1..65535", address.substr(colon + 1)));
  url.port = static_cast<std::uint16_t>(*port);
  url.host = address.substr(0, colon);
  if (url.host.starts_with('[') && url.host.ends_with(']')) url.host = url.host.substr(1, url.host.size() - 2);
  const bool may_listen = scheme.kind == LinkKind::tcp_listen || scheme.kind == LinkKind::rfc2217_listen ||
                          scheme.kind == LinkKind::modbus_tcp;
  if (url.host.empty() && !may_listen) return std::unexpected(std::string("there is no host"));
  return {};
}

}  // namespace

std::string_view name_of(LinkKind kind) { return std::ranges::find(kSchemes, kind, &Scheme::kind)->name; }

bool is_modbus(LinkKind kind) { return kind == LinkKind::modbus_tcp || kind == LinkKind::modbus_rtu; }

bool feeds_characters(LinkKind kind) { return !is_modbus(kind) && kind != LinkKind::dir; }

bool is_blind(LinkKind kind) {
  return kind == LinkKind::tcp || kind == LinkKind::tcp_listen || kind == LinkKind::rfc2217;
}

std::expected<LinkUrl, std::string> parse_link_url(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  const auto scheme = std::ranges::find(kSchemes, name, &Scheme::name);
  if (colon == std::string_view::npos || scheme == kSchemes.end()) {
    return std::unexpected(
        fmt::format("\"{}\" is not a link: it must begin with serial:, pty:, tcp://, tcp-listen://, dir:, "
                    "rfc2217://, modbus-tcp:// or modbus-rtu:",
                    text));
  }
  std::string_view rest = text.substr(colon + 1);
  if (!rest.starts_with(scheme->prefix)) {
    return std::unexpected(fmt::format("\"{}\" must be followed by {}", name, scheme->prefix));
  }
  rest.remove_prefix(scheme->prefix.size());
  const std::size_t question = rest.find('?');
  LinkUrl url;
  url.kind = scheme->kind;
  url.text = text;
  const auto address = read_address(rest.substr(0, question), *scheme, url);
  if (!address) return std::unexpected(fmt::format("link \"{}\": {}", text, address.error()));
  if (question != std::string_view::npos) {
    const auto options = read_options(rest.substr(question + 1), url);
    if (!options) return std::unexpected(fmt::format("link \"{}\": {}", text, options.error()));
  }
  return url;
}

}  // namespace dripfeed::machine
