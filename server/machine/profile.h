// A machine profile: what the shop knows of one machine. Values that were not given keep the control's usual ones;
// `confirmed` fields say that a person looked at the machine.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "checks/machine.h"
#include "dialects/ir/control.h"
#include "dialects/ir/stage.h"
#include "protocol/feed/program_check.h"
#include "protocol/feed/settings.h"
#include "protocol/tape_code/character_set.h"
#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/framing.h"
#include "protocol/tape_code/wire_decoder.h"
#include "server/machine/line_protocol.h"
#include "server/machine/link_url.h"
#include "server/machine/receive_settings.h"

namespace dripfeed::machine {

// Laid over the dialect's usual control by `control_of`.
struct ControlSettings {
  std::string dialect;  // "fanuc", "sinumerik-840d"
  std::string title;    // "Fanuc 0i-TF"
  ir::MachineKind kind = ir::MachineKind::mill;
  ir::GSystem g_system = ir::GSystem::a;
  std::optional<ir::DecimalMode> decimal_mode;
  bool decimal_mode_confirmed = false;
  double increment_mm = 0.0;                  // printed and traced positions are rounded to it; 0: not stated
  std::optional<ir::Function> power_on_unit;  // these four: the machine's power-on state
  std::optional<ir::Function> power_on_distance;
  std::optional<ir::Function> power_on_feed;
  std::optional<ir::Function> power_on_plane;
  bool power_on_confirmed = false;
  std::vector<ir::VariableRange> variables;  // empty: the control's usual ranges
  std::optional<std::uint32_t> block_length_bytes;
  std::vector<std::uint16_t> machine_functions;  // M numbers of the machine; empty: any may be
  std::vector<ir::CodeCall> code_calls;          // G and M codes that parameters turn into calls
  // Nesting that the control takes; not given: its usual one.
  std::optional<std::uint32_t> call_nesting;
  std::optional<std::uint32_t> macro_nesting;
  std::optional<std::uint32_t> loop_nesting;
  std::optional<std::uint32_t> axes_at_once;   // that the control moves in one block; not given: all of them
  std::optional<double> arc_tolerance_mm;      // by which an arc's radius may change from start to end (3410, MD21000)
  std::optional<double> arc_tolerance_factor;  // … as a part of the radius, where that is more (MD21010)
  std::optional<std::uint32_t> reference_fixed_point;  // G75 FP= of it is where the other controls go by G28 (MD30600)
  bool splines_confirmed = false;                      // a person compared a spline of the machine with ours
  // ISO mode of a SINUMERIK.
  std::optional<ir::DecimalMode> iso_decimal_mode;  // MD10884
  bool iso_decimal_mode_confirmed = false;
  bool starts_in_iso_mode = false;                 // G291 is in effect where a program begins
  std::optional<bool> arc_without_center_is_line;  // Fanuc 3403#5 = 0; otherwise an alarm
  // Parameters of cycles, mm.
  std::optional<double> chip_break_mm;
  std::optional<double> peck_clearance_mm;
  std::optional<double> turning_depth_mm;
  std::optional<double> turning_retract_mm;
};

inline constexpr std::uint32_t kLeastBaud = 50;
inline constexpr std::uint32_t kMostBaud = 4'000'000;

// How the line is spoken to; becomes feed::Settings together with the URL's options, which win.
struct LineSettings {
  LinkUrl link;
  LineProtocol protocol = LineProtocol::dc_codes;
  std::uint32_t baud = 9600;
  tape_code::Framing framing;
  tape_code::Code code = tape_code::Code::iso;
  tape_code::Eob eob = tape_code::Eob::lf;
  std::uint32_t leader_chars = 0;
  std::uint32_t trailer_chars = 0;
  tape_code::Filler filler = tape_code::Filler::nul;  // of leader and trailer
  tape_code::EiaSpecials eia_specials;                // for code eia
  bool pad_tv = false;                                // a blank makes the number of characters of a block even
  feed::Start start = feed::Start::on_dc1;
  std::string start_trigger;  // of a start by trigger
  feed::Flow flow = feed::Flow::xonxoff;
  std::uint8_t xon = 0x11;
  std::uint8_t xoff = 0x13;
  feed::XoffBy xoff_by = feed::XoffBy::host;
  double char_delay_ms = 0.0;  // additional, between two characters
  double line_delay_ms = 0.0;  // additional, after each EOB
  bool end_by_dc3 = true;
  std::optional<std::uint8_t> end_by_character;
  std::optional<double> end_by_quiet_s = 5.0;
  std::uint32_t overrun_budget = 10;
  std::uint32_t unsent = 4;
  std::uint32_t latency_chars = 5;
  bool watch_cts = false;
  bool watch_dsr = false;
  double arming_minutes = 10.0;
  // Packet protocols only. answer_s: how long an answer may take; not given: without limit, as a held machine needs it.
  std::optional<double> answer_s;
  std::uint32_t payload_bytes = 128;    // 3964, remote buffer
  bool counted_frames = false;          // 3964: frames carry a number; both sides must know of it
  bool yields_on_collision = true;      // 3964: withdraws where both call at once
  bool messages_end_with_cr = false;    // remote buffer: CR instead of ETX
  std::string character_set = "ascii";  // a name of tape_code::character_sets()
  ReceiveSettings receive;
};

struct Profile {
  std::string name;  // what the shop calls the machine; also its id
  std::string title;
  std::string end_check;           // what a person confirms after each job, before the next one; "": nothing
  std::vector<std::string> notes;  // where the values are from, and what is assumed
  ControlSettings control;
  checks::Machine machine;
  LineSettings line;
};

// The control's tables with the profile's settings laid over them; marked as coming from a profile.
ir::Control control_of(const Profile& profile, ir::Control usual);

// A flow line (CTS, DSR) that only we can look at is looked at this often: its share of the latency.
inline constexpr double kLinePoll_ms = 2.0;
// DSR as a flow line, on any link: no driver honors it for us.
bool polls_flow_lines(const LineSettings& line);

// The line with its URL's options laid over it (baud, framing, flow, latency_chars, budget, unsent, start, eob,
// char_delay_ms, line_delay_ms, code, protocol, answer_s, payload, counted); or which option is wrong. A packet
// protocol in the URL brings 8N1, plain ASCII and no flow control along where the URL does not say otherwise.
std::expected<LineSettings, std::string> effective_line(const LineSettings& line);

// The feed's settings for this line, URL options included;
// or one sentence that says which is wrong, the budget's sum shown where it cannot hold.
std::expected<feed::Settings, std::string> feed_settings_of(const LineSettings& line);

// What goes over this line, URL options not looked at (see effective_line): leader, code, EOB, trailer.
tape_code::WireFormat wire_format_of(const LineSettings& line);
// How what comes over it is read.
tape_code::DecodeFormat decode_format_of(const LineSettings& line);
// What the control takes and its code has; URL options not looked at. `ascii` where the set has no such name.
tape_code::CharacterSet characters_of(const LineSettings& line);
// Why a character is refused: "the control does not take the character 0x61", "EIA has no code for ':'".
std::string character_refusal(const LineSettings& line, const tape_code::IllegalCharacter& character);

// What a text for this machine must look like to be fed.
feed::ProgramSyntax program_syntax_of(const Profile& profile, ir::Delivery delivery);

}  // namespace dripfeed::machine
