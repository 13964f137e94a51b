// From a profile to what the dialects and the feed work with.
#include "server/machine/profile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/ir/axis_letters.h"
#include "server/machine/file_drop.h"

namespace dripfeed::machine {

namespace {

using Applied = std::expected<void, std::string>;

Applied set_number(std::string_view name, std::string_view value, std::uint32_t& into) {
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), into);
  if (error == std::errc{} && end == value.data() + value.size()) return {};
  return std::unexpected(fmt::format("{} \"{}\" is not a whole number", name, value));
}

Applied set_baud(std::string_view value, LineSettings& line) {
  std::uint32_t baud = 0;
  if (auto read = set_number("baud", value, baud); !read) return read;
  if (baud < kLeastBaud || baud > kMostBaud)
    return std::unexpected(fmt::format("baud {} is not from {} to {}", baud, kLeastBaud, kMostBaud));
  line.baud = baud;
  return {};
}
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
  // A profile that says EIA means the characters, not what the line carries them in: with 7 bits it is refused later.
  if (line.code == tape_code::Code::eia) return {};
  line.code = framing->data_bits == 7 ? tape_code::Code::iso : tape_code::Code::ascii;
  return {};
}

template <class Value>
using Names = std::initializer_list<std::pair<std::string_view, Value>>;

template <class Value>
Applied set_choice(std::string_view option, std::string_view value, Names<Value> names, Value& into) {
  std::string known;
  for (const auto& [name, meaning] : names) {
    if (name == value) {
      into = meaning;
      return {};
    }
    known += known.empty() ? "" : ", ";
    known += name;
  }
  return std::unexpected(fmt::format("{} \"{}\" is none of {}", option, value, known));
}

Applied set_start(std::string_view value, LineSettings& line) {
  return set_choice(
      "start", value,
      {{"dc1", feed::Start::on_dc1}, {"at-once", feed::Start::at_once}, {"trigger", feed::Start::on_trigger}},
      line.start);
}

Applied set_flow(std::string_view value, LineSettings& line) {
  return set_choice("flow", value,
                    {{"xonxoff", feed::Flow::xonxoff},
                     {"rtscts", feed::Flow::rtscts},
                     {"dtrdsr", feed::Flow::dtrdsr},
                     {"both", feed::Flow::both},
                     {"none", feed::Flow::none}},
                    line.flow);
}

Applied set_delay(std::string_view name, std::string_view value, double& into) {
  std::uint32_t ms = 0;
  if (auto read = set_number(name, value, ms); !read) return read;
  into = ms;
  return {};
}
Applied set_char_delay(std::string_view value, LineSettings& line) {
  return set_delay("char_delay_ms", value, line.char_delay_ms);
}
Applied set_line_delay(std::string_view value, LineSettings& line) {
  return set_delay("line_delay_ms", value, line.line_delay_ms);
}

Applied set_eob(std::string_view value, LineSettings& line) {
  std::string name(value);
  for (char& c : name) c = c == '-' || c == '_' ? ' ' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  const auto eob = tape_code::parse_eob(name);
  if (!eob) {
    return std::unexpected(fmt::format(
        "eob \"{}\" is not lf, cr-lf, lf-cr-cr, cr or up to four of lf, cr and hex codes of control characters",
        value));
  }
  line.eob = *eob;
  return {};
}

// `auto` is for what comes in; what goes out keeps the code that the framing brings.
Applied set_code(std::string_view value, LineSettings& line) {
  line.receive.find_code = value == "auto";
  if (line.receive.find_code) return {};
  static constexpr std::array<std::string_view, 3> kNames = {"ascii", "iso", "eia"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] != value) continue;
    line.code = static_cast<tape_code::Code>(i);
    return {};
  }
  return std::unexpected(fmt::format("code \"{}\" is not ascii, iso, eia or auto", value));
}

// How the connection ends is the driver's work; here only the word is checked.
Applied set_close(std::string_view value, LineSettings&) {
  if (value == "finish" || value == "reset") return {};
  return std::unexpected(fmt::format("close \"{}\" is not finish or reset", value));
}

Applied set_extension(std::string_view value, LineSettings&) {
  constexpr std::size_t kMost = 8;
  const bool plain = std::ranges::all_of(
      value, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); });
  if (plain && value.size() <= kMost) return {};
  return std::unexpected(
      fmt::format("ext \"{}\" is not a word of at most {} letters and digits, or none", value, kMost));
}

Applied set_overwrite(std::string_view value, LineSettings&) {
  if (value == "yes" || value == "no") return {};
  return std::unexpected(fmt::format("overwrite \"{}\" is not yes or no", value));
}

// The line of a packet protocol has 8 bits and no flow control by characters, whatever the profile says of the same
// machine's DC codes.
Applied set_protocol(std::string_view value, LineSettings& line) {
  const auto protocol = parse_line_protocol(value);
  if (!protocol) {
    return std::unexpected(fmt::format("protocol \"{}\" is none of {}", value, fmt::join(line_protocol_names(), ", ")));
  }
  line.protocol = *protocol;
  if (!packet_protocol_of(*protocol)) return {};
  line.flow = feed::Flow::none;
  return set_framing("8N1", line);
}

Applied set_answer(std::string_view value, LineSettings& line) {
  std::uint32_t seconds_given = 0;
  if (const auto read = set_number("answer_s", value, seconds_given); !read) return read;
  line.answer_s = seconds_given == 0 ? std::nullopt : std::optional<double>(seconds_given);
  return {};
}

Applied set_payload(std::string_view value, LineSettings& line) {
  return set_number("payload", value, line.payload_bytes);
}

Applied set_counted(std::string_view value, LineSettings& line) {
  return set_choice("counted", value, {{"yes", true}, {"no", false}}, line.counted_frames);
}

struct Option {
  std::string_view name;
  Applied (*apply)(std::string_view value, LineSettings& line);
};
// In this order: `protocol` brings along what `framing`, `flow` and `code` may change.
constexpr std::array kOptions = {
    Option{"protocol", set_protocol},
    Option{"answer_s", set_answer},
    Option{"payload", set_payload},
    Option{"counted", set_counted},
    Option{"baud", set_baud},
    Option{"framing", set_framing},
    Option{"latency_chars", set_latency},
    Option{"budget", set_budget},
    Option{"unsent", set_unsent},
    Option{"start", set_start},
    Option{"eob", set_eob},
    Option{"flow", set_flow},
    Option{"char_delay_ms", set_char_delay},
    Option{"line_delay_ms", set_line_delay},
    Option{"code", set_code},
    Option{"close", set_close},
    Option{"ext", set_extension},
    Option{"overwrite", set_overwrite},
};

Applied apply_options(LineSettings& line) {
  for (const Option& option : kOptions) {
    const auto given = line.link.options.find(std::string(option.name));
    if (given == line.link.options.end()) continue;
    if (const auto applied = option.apply(given->second, line); !applied) return applied;
  }
  return {};
}

// Characters between a flow line's change and our look at it: they pass whatever the profile says.
std::uint32_t poll_chars(const LineSettings& line) {
  if (!polls_flow_lines(line)) return 0;
  const feed::Time poll(static_cast<std::int64_t>(kLinePoll_ms * 1e6));
  return feed::latency_in_chars(poll, line.framing, line.baud);
}

// A raw socket has no lines: only the device server can hold by them.
Applied lines_can_be_seen(const LineSettings& line) {
  const bool raw = line.link.kind == LinkKind::tcp || line.link.kind == LinkKind::tcp_listen;
  const bool by_lines = feed::cts_is_flow(line.flow) || feed::dsr_is_flow(line.flow);
  if (!raw || !by_lines || line.xoff_by == feed::XoffBy::device) return {};
  return std::unexpected(fmt::format(
      "{}: CTS and DSR cannot be seen through a raw socket; let the device server hold (xoff_by \"device\")",
      line.link.text));
}

feed::Time seconds(double s) { return feed::Time(static_cast<std::int64_t>(s * 1e9)); }

}  // namespace

namespace {

// "XZC": the machine's axes by letter, in the order of the trace.
std::string letters_of(const std::vector<checks::MachineAxis>& axes) {
  std::string letters;
  for (std::size_t i = 0; i < ir::kAxisCount; ++i)
    if (std::ranges::find(axes, static_cast<ir::Axis>(i), &checks::MachineAxis::axis) != axes.end())
      letters.push_back(ir::kAxisLetters[i]);
  return letters;
}

}  // namespace

namespace {

// What the control itself knows of the tools. Edges of one tool have one name.
void take_tools(const std::vector<checks::Tool>& tools, ir::Control& control) {
  for (const checks::Tool& tool : tools) {
    if (tool.diameter_mm > 0.0) control.tool_radii.push_back({tool.number, tool.offset, 0.5 * tool.diameter_mm});
    if (tool.length_mm) control.tool_lengths.push_back({tool.number, tool.offset, *tool.length_mm});
    if (!tool.name.empty()) control.tool_names.push_back({tool.name, tool.number});
  }
  std::ranges::sort(control.tool_names, {}, &ir::ToolName::name);
}

}  // namespace

ir::Control control_of(const Profile& profile, ir::Control control) {
  const ControlSettings& settings = profile.control;
  ir::Semantics& semantics = control.semantics;
  control.from_profile = true;
  if (!profile.machine.axes.empty()) control.axes = letters_of(profile.machine.axes);
  take_tools(profile.machine.tools, control);
  if (!settings.title.empty()) control.title = settings.title;
  if (settings.decimal_mode) semantics.decimal_mode = *settings.decimal_mode;
  semantics.decimal_mode_confirmed = settings.decimal_mode_confirmed;
  if (settings.iso_decimal_mode) semantics.iso_decimal_mode = *settings.iso_decimal_mode;
  semantics.iso_decimal_mode_confirmed = settings.iso_decimal_mode_confirmed;
  semantics.starts_in_iso_mode = settings.starts_in_iso_mode;
  if (settings.power_on_unit) semantics.power_on_unit = *settings.power_on_unit;
  if (settings.power_on_distance) semantics.power_on_distance = *settings.power_on_distance;
  if (settings.power_on_feed) semantics.power_on_feed = *settings.power_on_feed;
  if (settings.power_on_plane) semantics.power_on_plane = *settings.power_on_plane;
  semantics.power_on_known = settings.power_on_confirmed;
  if (settings.increment_mm > 0) {
    semantics.least_increment_mm = settings.increment_mm;
    control.limits.linear_decimals = static_cast<int>(std::ceil(-std::log10(settings.increment_mm) - 1e-9));
  }
  if (!settings.variables.empty()) {
    control.variables = settings.variables;
    control.variables_stated = true;
  }
  if (settings.block_length_bytes) control.limits.block_length_bytes = *settings.block_length_bytes;
  control.code_calls = settings.code_calls;
  control.machine_functions = settings.machine_functions;
  if (settings.call_nesting) control.limits.call_nesting = *settings.call_nesting;
  if (settings.macro_nesting) control.limits.macro_nesting = *settings.macro_nesting;
  if (settings.loop_nesting) control.limits.loop_nesting = *settings.loop_nesting;
  if (settings.axes_at_once) control.limits.axes_at_once = *settings.axes_at_once;
  if (settings.chip_break_mm) semantics.chip_break_retract_mm = *settings.chip_break_mm;
  if (settings.peck_clearance_mm) semantics.peck_clearance_mm = *settings.peck_clearance_mm;
  if (settings.arc_tolerance_mm) semantics.arc_tolerance_mm = *settings.arc_tolerance_mm;
  if (settings.arc_tolerance_factor) semantics.arc_tolerance_factor = *settings.arc_tolerance_factor;
  if (settings.reference_fixed_point)
    semantics.reference_fixed_point = static_cast<int>(*settings.reference_fixed_point);
  semantics.spline_form_known = settings.splines_confirmed;
  if (settings.turning_depth_mm) semantics.cycle_depth_mm = *settings.turning_depth_mm;
  if (settings.arc_without_center_is_line) semantics.arc_without_center_is_line = *settings.arc_without_center_is_line;
  if (settings.turning_retract_mm) semantics.cycle_retract_mm = *settings.turning_retract_mm;
  return control;
}

bool polls_flow_lines(const LineSettings& line) { return feed::dsr_is_flow(line.flow); }

std::expected<LineSettings, std::string> effective_line(const LineSettings& given) {
  LineSettings line = given;
  if (const auto applied = apply_options(line); !applied) return std::unexpected(applied.error());
  return line;
}

tape_code::WireFormat wire_format_of(const LineSettings& line) {
  tape_code::WireFormat format;
  format.eighth_bit = tape_code::eighth_bit(line.framing, line.code, tape_code::ParityBy::software);
  format.eob = line.eob;
  format.leader_chars = line.leader_chars;
  format.trailer_chars = line.trailer_chars;
  format.filler = line.filler;
  format.pad_tv = line.pad_tv;
  if (line.code == tape_code::Code::eia) format.eia = line.eia_specials;
  return format;
}

tape_code::DecodeFormat decode_format_of(const LineSettings& line) {
  const tape_code::WireFormat format = wire_format_of(line);
  return {.eighth_bit = format.eighth_bit, .eia = format.eia, .eob = format.eob};
}

tape_code::CharacterSet characters_of(const LineSettings& line) {
  const tape_code::WireFormat format = wire_format_of(line);
  const auto named = tape_code::find_character_set(line.character_set);
  return named.value_or(*tape_code::find_character_set("ascii")) &
         tape_code::characters_of(tape_code::EncodeTable(format.eighth_bit, format.eia));
}

std::string character_refusal(const LineSettings& line, const tape_code::IllegalCharacter& character) {
  const bool printable = character.byte > ' ' && character.byte < 0x7F;
  const std::string shown =
      printable ? fmt::format("'{}'", static_cast<char>(character.byte)) : fmt::format("0x{:02X}", character.byte);
  const auto named = tape_code::find_character_set(line.character_set);
  if (line.code == tape_code::Code::eia && named && named->has(character.byte)) {
    return fmt::format("EIA has no code for the character {}", shown);
  }
  return fmt::format("the control does not take the character {}", shown);
}

std::expected<feed::Settings, std::string> feed_settings_of(const LineSettings& given) {
  const auto effective = effective_line(given);
  if (!effective) return std::unexpected(effective.error());
  const LineSettings& line = *effective;
  if (const auto seen = lines_can_be_seen(line); !seen) return std::unexpected(seen.error());
  feed::Settings settings;
  settings.framing = line.framing;
  settings.baud = line.baud;
  // Seven bits with parity are made here and sent as eight: the wire is the same, and a pty or a socket has eight only.
  settings.wire = wire_format_of(line);
  settings.start = line.start;
  settings.trigger = line.start_trigger;
  settings.flow = line.flow;
  settings.flow_characters = {.xon = line.xon, .xoff = line.xoff};
  settings.xoff_by = line.xoff_by;
  settings.char_delay = seconds(line.char_delay_ms * 1e-3);
  settings.line_delay = seconds(line.line_delay_ms * 1e-3);
  settings.end.dc3 = line.end_by_dc3;
  settings.end.eot = line.end_by_character;
  if (line.end_by_quiet_s) settings.end.quiet = seconds(*line.end_by_quiet_s);
  settings.overrun_budget = line.overrun_budget;
  settings.unsent = line.unsent;
  settings.latency_chars = std::max(line.latency_chars, poll_chars(line));
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
  if (drops_bare_files(profile)) syntax.start_percent = syntax.final_percent = false;
  return syntax;
}

}  // namespace dripfeed::machine
