// From a profile to what the receiver works with.
#include "server/machine/receive_settings.h"

#include <fmt/format.h>

#include "server/machine/profile.h"

namespace dripfeed::machine {

namespace {

// XON and XOFF never come up to us: the driver or the device server takes them.
bool flow_is_below(const LineSettings& line) {
  const bool by_characters = line.flow == feed::Flow::xonxoff || line.flow == feed::Flow::both;
  return by_characters && line.xoff_by != feed::XoffBy::host;
}

std::expected<void, std::string> hold_is_possible(const LineSettings& line) {
  const receive::Hold hold = line.receive.hold;
  const LinkKind kind = line.link.kind;
  const bool no_rts = kind == LinkKind::tcp || kind == LinkKind::tcp_listen || kind == LinkKind::pty;
  if (hold == receive::Hold::rts && no_rts)
    return std::unexpected(fmt::format("{}: receive.hold \"rts\": this link has no RTS", line.link.text));
  if (hold == receive::Hold::dc3 && line.code == tape_code::Code::eia)
    return std::unexpected(
        std::string("receive.hold \"dc3\": on a line of EIA 13h is the digit 3; hold by RTS, or not at all"));
  return {};
}

}  // namespace

std::expected<void, std::string> can_receive(const LineSettings& line) {
  const bool by_characters = feeds_characters(line.link.kind) && !packet_protocol_of(line.protocol);
  // The partner of 3964 sends of its own, too.
  const bool both_send = line.protocol == LineProtocol::s3964 || line.protocol == LineProtocol::s3964r;
  const bool punches = feeds_characters(line.link.kind) && (by_characters || both_send);
  if (line.receive.read_back && (!line.receive.enabled || !punches))
    return std::unexpected(std::string("receive.read_back: nothing that the control punches is received on this line"));
  if (!line.receive.enabled || !by_characters) return {};
  if (line.code == tape_code::Code::eia && flow_is_below(line))
    return std::unexpected(std::string(
        "code \"eia\" with XON/XOFF taken below us (xoff_by \"kernel\" or \"device\"): the digit 3 of a punch "
        "is DC3 (13h) and would be lost; use flow \"rtscts\", xoff_by \"host\", or receive.enabled false"));
  return hold_is_possible(line);
}

receive::Settings receive_settings_of(const LineSettings& line) {
  const ReceiveSettings& given = line.receive;
  receive::Settings settings;
  settings.eighth_bit = tape_code::eighth_bit(line.framing, line.code, tape_code::ParityBy::software);
  settings.eia = line.code == tape_code::Code::eia;
  settings.eia_known = settings.eia && !given.find_code;
  settings.find_code = given.find_code;
  settings.eia_specials = line.eia_specials;
  settings.quiet = receive::Time(static_cast<std::int64_t>(given.quiet_s * 1e9));
  settings.short_quiet = receive::Time(static_cast<std::int64_t>(given.quiet_after_end_s * 1e9));
  settings.end_character = given.end_character;
  settings.hold = given.hold;
  settings.xon = line.xon;
  settings.xoff = line.xoff;
  settings.flow_below = flow_is_below(line);
  return settings;
}

receive::RequestGrammar request_grammar_of(const ReceiveSettings& settings) {
  return {
      .program_number = settings.request_number, .marker = settings.request_marker, .scan_lines = settings.scan_lines};
}

}  // namespace dripfeed::machine
