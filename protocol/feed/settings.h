// What a feed must know of its line and its machine, and the rule that a link must keep the machine's overrun budget.
// Plain data; the server fills it from the machine profile and the link.
#pragma once

#include <chrono>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>

#include "protocol/tape_code/framing.h"
#include "protocol/tape_code/wire_encoder.h"

namespace dripfeed::feed {

// Time since an epoch of the driver's choice that never steps back (a steady clock's). Protocol code reads no clock.
using Time = std::chrono::nanoseconds;

enum class Start : std::uint8_t {
  on_dc1,      // the control asks for the program with XON (DC1)
  at_once,     // sending begins with the arming, as soon as the flow lines allow
  on_trigger,  // the control asks with a text of its own
};

// What stops the sender. An XOFF that comes is believed in every kind: a stop sign is never argued with.
enum class Flow : std::uint8_t {
  none,     // nothing is expected to stop it
  xonxoff,  // XOFF (DC3) holds, XON (DC1) goes on
  rtscts,   // CTS off holds
  dtrdsr,   // DSR off holds
  both,     // xonxoff and rtscts
};
constexpr bool cts_is_flow(Flow flow) { return flow == Flow::rtscts || flow == Flow::both; }
constexpr bool dsr_is_flow(Flow flow) { return flow == Flow::dtrdsr; }

// Who honors XOFF. Below us it stops sooner, but XON and XOFF are swallowed there: no start by DC1, no end by DC3, and
// a hold is known only by a queue that stands still.
enum class XoffBy : std::uint8_t { host, kernel, device };

// By what the end of the reading is seen once the whole program is handed.
struct EndSigns {
  bool dc3 = true;                    // the control's last DC3
  std::optional<std::uint8_t> eot{};  // a character such as 04 or 1A (7 bits)
  std::optional<Time> quiet{};        // this long nothing came in after the line drained
};

struct FlowCharacters {  // 7 bits; on the line with or without a parity bit
  std::uint8_t xon = 0x11;
  std::uint8_t xoff = 0x13;
};

struct Settings {
  tape_code::Framing framing{};  // what a character takes on the line
  std::uint32_t baud = 9600;
  tape_code::WireFormat wire{};
  Start start = Start::on_dc1;
  std::string trigger{};  // of Start::on_trigger: 1 to kMaxTrigger characters of 7 bits
  EndSigns end{};

  Flow flow = Flow::xonxoff;
  FlowCharacters flow_characters{};
  XoffBy xoff_by = XoffBy::host;
  Time char_delay{};  // additional, between two characters
  Time line_delay{};  // additional, after each EOB

  // Budget: unsent + latency_chars <= overrun_budget. overrun_budget: characters that the machine takes after its DC3.
  // unsent: characters that may lie below the feed (driver, UART). latency_chars: characters that pass on the line
  // between the control's decision to stop and receive() being called, DC3's own time included.
  std::uint32_t overrun_budget = 10;
  std::uint32_t unsent = 4;
  std::uint32_t latency_chars = 5;
  bool blind = false;  // the queue below cannot be read: pace at kBlindRate, the budget is estimated

  bool watch_cts = false;  // CTS off holds the feed and disarms; a flow by CTS does so anyway
  bool watch_dsr = false;  // DSR off ends the feed and disarms; not together with a flow by DSR
};

// A clock may be off by 2 %, so a link that never shows how much is unsent is paced this much slower.
inline constexpr double kBlindRate = 0.98;
// What a blind link (a device server and the network before it) may hold of what was clocked, and loses when it is
// lost: a buffer of 1 KB is usual. As characters at the paced rate.
inline constexpr std::uint32_t kBlindHold = 1024;
// Limit of Settings::unsent: the size of the feed's only byte buffer.
inline constexpr std::uint32_t kMaxUnsent = 256;
// Limit of Settings::latency_chars and overrun_budget.
inline constexpr std::uint32_t kMaxBudget = 1U << 20;
// Limit of leader and trailer.
inline constexpr std::uint32_t kMaxFillers = 100'000;
// Limit of Settings::trigger.
inline constexpr std::size_t kMaxTrigger = 32;
// Limits of the delays.
inline constexpr Time kMaxCharDelay = std::chrono::seconds(1);
inline constexpr Time kMaxLineDelay = std::chrono::seconds(60);
// So long nothing moves below before it counts as held there.
inline constexpr Time kStandstill = std::chrono::milliseconds(250);
// The line gets its next characters so long before it runs out of them: a host that has much to do wakes late.
inline constexpr Time kRefillAhead = std::chrono::milliseconds(2);
// How often a source that was not ready is asked again.
inline constexpr Time kSourceRetry = std::chrono::milliseconds(5);
// How often a network that has not confirmed everything is asked again.
inline constexpr Time kNetworkRetry = std::chrono::milliseconds(5);

enum class SettingsFault : std::uint8_t {
  baud,
  framing,
  unsent,
  budget,
  fillers,
  no_end_sign,
  eot_code,
  flow_characters,
  start_unseen,  // XOFF is honored below, so a DC1 never comes up
  trigger,
  delay,
  dsr_twice,  // DSR cannot both hold and end the feed
  eia_framing,
  eia_specials,
};

struct SettingsRefusal {
  SettingsFault fault = SettingsFault::baud;
  // For `budget` and `unsent`: the sum that was refused.
  std::uint32_t unsent = 0;
  std::uint32_t latency_chars = 0;
  std::uint32_t overrun_budget = 0;
};
// With the sum shown: "4 unsent + 14 latency = 18 characters, more than the budget of 10".
std::string message(const SettingsRefusal& refusal);

std::expected<void, SettingsRefusal> validate(const Settings& settings);

// Time that one character takes on the line, as the feed paces it (slower where blind or delayed). Rounded up to 1 ns.
Time char_time(const Settings& settings);
// Characters that may lie below at a time: one where a delay is wanted between any two.
constexpr std::uint32_t burst(const Settings& settings) {
  return settings.char_delay > Time::zero() ? 1 : settings.unsent;
}
// A link's delay as characters on this line, rounded up.
std::uint32_t latency_in_chars(Time delay, const tape_code::Framing& framing, std::uint32_t baud);

}  // namespace dripfeed::feed
