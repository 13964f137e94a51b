// From a profile to what the dialects and the feed work with.
#include "server/machine/profile.h"

#include <array>
#include <charconv>
#include <chrono>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::machine {

namespace {

using Applied = std::expected<void, std::string>;

Applied set_number(std::string_view name, std::string_view value, std::uint32_t& into) {
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), into);
  if (error == std::errc{} && end == value.data() + value.size()) return {};
  return std::unexpected(fmt::format("{} \"{}\" is not a whole number", name, value));
}

Applied set_baud(std::string_view value, LineSettings& line) { return set_number("baud", value, line.baud); }
Applied set_budget(std::string_view value, LineSettings& line) {
  return set_number("budget", value, line.overrun_budget);
}
Applied set_unsent(std::string_view value, LineSettings& line) { return set_number("unsent", value, line.unsent); }
Applied set_latency(std::string_view value, LineSettings& line) {
  return set_number("latency_chars", value, line.latency_chars);
}

Applied set_framing(std::string_view value, LineSettings& line) {
  const auto framing = tape_code::parse_framing(value);
  if (!framing) return std::unexpected(fmt::format("framing \"{}\": {}", value, tape_code::message(framing.error())));
  line.framing = *framing;
  line.code = framing->data_bits == 7 ? tape_code::Code::iso : tape_code::Code::ascii;
  return {};
}

Applied set_start(std::string_view value, LineSettings& line) {
  if (value != "dc1" && value != "at-once")
    return std::unexpected(fmt::format("start \"{}\" is not dc1 or at-once", value));
  line.start = value == "dc1" ? feed::Start::on_dc1 : feed::Start::at_once;
  return {};
}

Applied set_eob(std::string_view value, LineSettings& line) {
  std::string name(value);
  for (char& c : name) c = c == '-' || c == '_' ? ' ' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  const auto eob = tape_code::parse_eob(name);
  if (!eob) return std::unexpected(fmt::format("eob \"{}\" is not lf, cr-lf, lf-cr-cr or cr", value));
  line.eob = *eob;
  return {};
}

// XON/XOFF is honored in user space on every link; the option exists so that a URL can say what the machine expects.
Applied set_flow(std::string_view value, LineSettings&) {
  if (value == "xonxoff") return {};
  return std::unexpected(fmt::format("flow \"{}\" is not xonxoff", value));
}

struct Option {
  std::string_view name;
  Applied (*apply)(std::string_view value, LineSettings& line);
};
constexpr std::array kOptions = {
    Option{"baud", set_baud},     Option{"framing", set_framing}, Option{"latency_chars", set_latency},
    Option{"budget", set_budget}, Option{"unsent", set_unsent},   Option{"start", set_start},
    Option{"eob", set_eob},       Option{"flow", set_flow},
};

Applied apply_options(LineSettings& line) {
  for (const Option& option : kOptions) {
    const auto given = line.link.options.find(std::string(option.name));
    if (given == line.link.options.end()) continue;
    if (const auto applied = option.apply(given->second, line); !applied) return applied;
  }
  return {};
}

feed::Time seconds(double s) { return feed::Time(static_cast<std::int64_t>(s * 1e9)); }

}  // namespace

ir::Control control_of(const Profile& profile, ir::Control control) {
  const ControlSettings& settings = profile.control;
  ir::Semantics& semantics = control.semantics;
  control.from_profile = true;
  if (!settings.title.empty()) control.title = settings.title;
  if (settings.decimal_mode) semantics.decimal_mode = *settings.decimal_mode;
  semantics.decimal_mode_confirmed = settings.decimal_mode_confirmed;
  if (settings.power_on_unit) semantics.power_on_unit = *settings.power_on_unit;
  if (settings.power_on_distance) semantics.power_on_distance = *settings.power_on_distance;
  if (settings.power_on_feed) semantics.power_on_feed = *settings.power_on_feed;
  if (settings.power_on_plane) semantics.power_on_plane = *settings.power_on_plane;
  semantics.power_on_known = settings.power_on_confirmed;
  if (settings.increment_mm > 0) semantics.least_increment_mm = settings.increment_mm;
  if (!settings.variables.empty()) control.variables = settings.variables;
  if (settings.block_length_bytes) control.limits.block_length_bytes = *settings.block_length_bytes;
  control.code_calls = settings.code_calls;
  if (settings.call_nesting) control.limits.call_nesting = *settings.call_nesting;
  if (settings.macro_nesting) control.limits.macro_nesting = *settings.macro_nesting;
  if (settings.loop_nesting) control.limits.loop_nesting = *settings.loop_nesting;
  if (settings.chip_break_mm) semantics.chip_break_retract_mm = *settings.chip_break_mm;
  if (settings.peck_clearance_mm) semantics.peck_clearance_mm = *settings.peck_clearance_mm;
  if (settings.turning_depth_mm) semantics.cycle_depth_mm = *settings.turning_depth_mm;
  if (settings.turning_retract_mm) semantics.cycle_retract_mm = *settings.turning_retract_mm;
  return control;
}

std::expected<LineSettings, std::string> effective_line(const LineSettings& given) {
  LineSettings line = given;
  if (const auto applied = apply_options(line); !applied) return std::unexpected(applied.error());
  return line;
}

std::expected<feed::Settings, std::string> feed_settings_of(const LineSettings& given) {
  const auto effective = effective_line(given);
  if (!effective) return std::unexpected(effective.error());
  const LineSettings& line = *effective;
  feed::Settings settings;
  settings.framing = line.framing;
  settings.baud = line.baud;
  // Seven bits with parity are made here and sent as eight: the wire is the same, and a pty or a socket has eight only.
  settings.wire.eighth_bit = tape_code::eighth_bit(line.framing, line.code, tape_code::ParityBy::software);
  settings.wire.eob = line.eob;
  settings.wire.leader_nuls = line.leader_nuls;
  settings.wire.trailer_nuls = line.trailer_nuls;
  settings.start = line.start;
  settings.end.dc3 = line.end_by_dc3;
  settings.end.eot = line.end_by_character;
  if (line.end_by_quiet_s) settings.end.quiet = seconds(*line.end_by_quiet_s);
  settings.overrun_budget = line.overrun_budget;
  settings.unsent = line.unsent;
  settings.latency_chars = line.latency_chars;
  settings.blind = is_blind(line.link.kind);
  settings.watch_cts = line.watch_cts;
  settings.watch_dsr = line.watch_dsr;
  if (const auto valid = feed::validate(settings); !valid) return std::unexpected(feed::message(valid.error()));
  return settings;
}

feed::ProgramSyntax program_syntax_of(const Profile& profile, ir::Delivery delivery) {
  feed::ProgramSyntax syntax =
      profile.control.dialect.starts_with("sinumerik") ? feed::kSemicolonSyntax : feed::kParenthesesSyntax;
  syntax.end_code = delivery == ir::Delivery::drip;
  return syntax;
}

}  // namespace dripfeed::machine
