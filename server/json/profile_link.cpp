// One function a group of members.
#include "server/json/profile_link.h"

#include <array>
#include <string>
#include <string_view>

#include "protocol/tape_code/character_set.h"
#include "server/machine/bus_settings.h"

namespace dripfeed::json {

namespace {

constexpr std::array<std::string_view, 3> kStarts = {"dc1", "at-once", "trigger"};
constexpr std::array<std::string_view, 5> kFlows = {"none", "xonxoff", "rtscts", "dtrdsr", "both"};
constexpr std::array<std::string_view, 3> kXoffBys = {"host", "kernel", "device"};
constexpr std::array<std::string_view, 3> kTapeCodes = {"ascii", "iso", "eia"};
constexpr std::array<std::string_view, 2> kFillers = {"nul", "del"};

void read_framing(ObjectReader& object, machine::LineSettings& line) {
  std::string framing;
  object.text("framing", framing);
  if (framing.empty()) return;
  const auto parsed = tape_code::parse_framing(framing);
  if (!parsed) return object.fault("framing", std::string(tape_code::message(parsed.error())));
  line.framing = *parsed;
}

void read_character_set(ObjectReader& object, machine::LineSettings& line) {
  Words names;
  for (const auto& set : tape_code::character_sets()) names.push_back(set.name);
  if (const auto set = object.choice("character_set", names)) line.character_set = names[*set];
}

// What holds the sender, and how slowly it goes otherwise.
void read_flow(ObjectReader& object, machine::LineSettings& line) {
  if (const auto flow = object.choice("flow", kFlows)) line.flow = static_cast<feed::Flow>(*flow);
  if (const auto by = object.choice("xoff_by", kXoffBys)) line.xoff_by = static_cast<feed::XoffBy>(*by);
  object.integer("xon", line.xon, 1, 127);
  object.integer("xoff", line.xoff, 1, 127);
  object.number("char_delay_ms", line.char_delay_ms, 0.0, 1000.0);
  object.number("line_delay_ms", line.line_delay_ms, 0.0, 60'000.0);
}

// "lf", "cr-lf", "lf-cr-cr", "cr", or any of lf, cr and hex codes: "cr-lf-lf", "1e".
void read_eob(ObjectReader& object, machine::LineSettings& line) {
  std::string name;
  object.text("eob", name);
  if (name.empty()) return;
  for (char& c : name) c = c == '-' ? ' ' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  const auto eob = tape_code::parse_eob(name);
  if (!eob)
    return object.fault("eob", "must be lf, cr-lf, lf-cr-cr, cr or up to four of lf, cr and hex codes, as cr-lf-lf");
  line.eob = *eob;
}

// {"[": 76, "#": 94}: the codes of the characters that the standard does not have.
void read_eia_specials(ObjectReader& object, machine::LineSettings& line) {
  for (std::size_t i = 0; i < tape_code::kEiaSpecials.size(); ++i) {
    object.integer(tape_code::kEiaSpecials.substr(i, 1), line.eia_specials.codes[i], 1, 255);
  }
  const auto wrong = tape_code::validate(line.eia_specials);
  if (wrong) object.fault(std::string(1, wrong->character), std::string(tape_code::message(wrong->fault)));
}

}  // namespace

void read_link(ObjectReader& object, machine::LineSettings& line) {
  std::string url;
  object.text("url", url, true);
  if (!url.empty()) {
    auto link = machine::parse_link_url(url);
    if (link) {
      line.link = std::move(*link);
    } else {
      object.fault("url", link.error());
    }
  }
  if (const auto protocol = object.choice("protocol", machine::line_protocol_names()))
    line.protocol = static_cast<machine::LineProtocol>(*protocol);
  if (machine::packet_protocol_of(line.protocol)) {
    line.framing = {.data_bits = 8, .parity = tape_code::Parity::none, .stop_bits = 1};
    line.code = tape_code::Code::ascii;
    line.flow = feed::Flow::none;
  }
  object.integer("baud", line.baud, machine::kLeastBaud, machine::kMostBaud);
  read_framing(object, line);
  if (const auto code = object.choice("code", kTapeCodes)) line.code = static_cast<tape_code::Code>(*code);
  object.object("eia_specials", [&](ObjectReader& o) { read_eia_specials(o, line); });
  read_eob(object, line);
  object.flag("pad_tv", line.pad_tv);
  if (const auto filler = object.choice("filler", kFillers)) line.filler = static_cast<tape_code::Filler>(*filler);
  object.integer("leader", line.leader_chars, 0, 10'000);
  object.integer("trailer", line.trailer_chars, 0, 10'000);
  if (const auto start = object.choice("start", kStarts)) line.start = static_cast<feed::Start>(*start);
  object.text("start_trigger", line.start_trigger);
  read_flow(object, line);
  object.flag("end_by_dc3", line.end_by_dc3);
  object.integer("end_by_character", line.end_by_character, 1, 127);
  object.number("end_by_quiet_s", line.end_by_quiet_s, 0.1, 3600.0);
  object.integer("overrun_budget", line.overrun_budget, 1, 100'000);
  object.integer("unsent", line.unsent, 1, 256);
  object.integer("latency_chars", line.latency_chars, 0, 100'000);
  object.flag("watch_cts", line.watch_cts);
  object.flag("watch_dsr", line.watch_dsr);
  object.number("answer_s", line.answer_s, 1.0, 86'400.0);
  object.integer("payload_bytes", line.payload_bytes, 1, packet::kMaxPayload);
  object.flag("counted_frames", line.counted_frames);
  object.flag("gives_way", line.yields_on_collision);
  object.flag("messages_end_with_cr", line.messages_end_with_cr);
  object.number("arming_minutes", line.arming_minutes, 0.1, 60.0);
  read_character_set(object, line);
}

void read_receive(ObjectReader& object, machine::ReceiveSettings& receive) {
  static constexpr std::array<std::string_view, 3> kHolds = {"none", "dc3", "rts"};
  static constexpr std::array<std::string_view, 2> kReceiveCodes = {"line", "auto"};
  object.flag("enabled", receive.enabled);
  object.number("quiet_s", receive.quiet_s, 0.2, 60.0);
  object.number("quiet_after_end_s", receive.quiet_after_end_s, 0.05, 10.0);
  object.integer("end_character", receive.end_character, 1, 31);
  if (const auto code = object.choice("code", kReceiveCodes)) receive.find_code = *code == 1;
  if (const auto hold = object.choice("hold", kHolds)) receive.hold = static_cast<receive::Hold>(*hold);
  object.flag("read_back", receive.read_back);
  object.number("read_back_minutes", receive.read_back_minutes, 0.01, 1440.0);
  object.flag("requests", receive.requests);
  object.integer("request_number", receive.request_number, 1, 99'999'999);
  object.integer("answer_number", receive.answer_number, 1, 99'999'999);
  object.text("request_marker", receive.request_marker);
  object.integer("scan_lines", receive.scan_lines, 1, 100);
  object.number("request_delay_s", receive.request_delay_s, 0.0, 60.0);
  object.flag("remote_drip", receive.remote_drip);
  object.flag("remote_arm", receive.remote_arm);
  if (receive.remote_arm && !receive.remote_drip) object.fault("remote_arm", "needs remote_drip");
}

std::expected<void, std::string> line_is_possible(const machine::LineSettings& line) {
  if (const auto laid_over = machine::effective_line(line); laid_over) {
    if (const auto receives = machine::can_receive(*laid_over); !receives) return receives;
  }
  if (machine::is_modbus(line.link.kind)) {
    if (const auto settings = machine::bus_settings_of(line.link); !settings) return std::unexpected(settings.error());
    return {};
  }
  if (!machine::feeds_characters(line.link.kind)) return {};
  const auto effective = machine::effective_line(line);
  if (!effective) return std::unexpected(effective.error());
  if (machine::packet_protocol_of(effective->protocol)) {
    if (const auto settings = machine::packet_settings_of(line); !settings) return std::unexpected(settings.error());
    return {};
  }
  if (const auto settings = machine::feed_settings_of(line); !settings) return std::unexpected(settings.error());
  return {};
}

}  // namespace dripfeed::json
