// Validation of a feed's settings and the arithmetic of line time and budget.
#include "protocol/feed/settings.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "protocol/tape_code/parity.h"

namespace dripfeed::feed {
namespace {

constexpr std::uint32_t kMinBaud = 50;
constexpr std::uint32_t kMaxBaud = 4'000'000;
constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

constexpr std::array<std::pair<SettingsFault, std::string_view>, 14> kMessages{{
    {SettingsFault::baud, "the baud rate is not between 50 and 4000000"},
    {SettingsFault::framing, "the framing is not one of 7 or 8 data bits with 1 or 2 stop bits"},
    {SettingsFault::unsent, "unsent characters must be between 1 and 256"},
    {SettingsFault::budget, "characters, more than the overrun budget of "},
    {SettingsFault::fillers, "leader or trailer is longer than 100000 characters"},
    {SettingsFault::no_end_sign, "no end sign: neither DC3 nor an end character nor a quiet time"},
    {SettingsFault::eot_code, "the end character must have 7 bits and be none of NUL, DC1 to DC4, NAK, SYN, XON, XOFF"},
    {SettingsFault::flow_characters,
     "XON and XOFF must be two different characters of 7 bits and none of NUL, DC2, DC4, NAK, SYN"},
    {SettingsFault::start_unseen,
     "XOFF is honored below the host, where DC1 and DC3 are swallowed: a start by DC1 would never be seen; start at "
     "once or by a trigger text, or let the host honor XOFF"},
    {SettingsFault::trigger,
     "the start trigger must have 1 to 32 characters of 7 bits, without NUL, DC codes, NAK, SYN and the end character"},
    {SettingsFault::delay, "a delay is at most 1 s between characters and 60 s after a line, and not negative"},
    {SettingsFault::dsr_twice, "DSR off cannot both hold the feed (flow dtrdsr) and end it (watch_dsr)"},
    {SettingsFault::eia_framing, "EIA has its parity in the byte: the framing must be 8N1 or 8N2"},
    {SettingsFault::eia_specials, "a special character of EIA has an even code or one that another character has"},
}};

std::string_view table_text(SettingsFault fault) {
  for (const auto& [key, text] : kMessages) {
    if (key == fault) return text;
  }
  return {};
}

// Not what the machine understands by itself: DC1 to DC4, NAK, SYN.
bool is_free(std::uint8_t code) {
  return code <= tape_code::kLowSevenBits && code != 0 && (code < 0x11 || code > 0x16);
}
bool is_flow_code(std::uint8_t code) { return is_free(code) || code == 0x11 || code == 0x13; }

bool eot_is_free(std::uint8_t eot, const FlowCharacters& flow) {
  return is_free(eot) && eot != flow.xon && eot != flow.xoff;
}

bool trigger_is_usable(const Settings& settings) {
  if (settings.start != Start::on_trigger) return true;
  if (settings.trigger.empty() || settings.trigger.size() > kMaxTrigger) return false;
  return std::ranges::all_of(settings.trigger, [&](char c) {
    const auto code = static_cast<std::uint8_t>(c);
    return eot_is_free(code, settings.flow_characters) && code != settings.end.eot;
  });
}

bool delays_are_known(const Settings& settings) {
  const auto within = [](Time delay, Time most) { return delay >= Time::zero() && delay <= most; };
  return within(settings.char_delay, kMaxCharDelay) && within(settings.line_delay, kMaxLineDelay);
}

bool framing_takes_eia(const tape_code::Framing& framing) {
  return framing.data_bits == 8 && framing.parity == tape_code::Parity::none;
}

bool framing_is_known(const tape_code::Framing& framing) {
  return (framing.data_bits == 7 || framing.data_bits == 8) && (framing.stop_bits == 1 || framing.stop_bits == 2);
}

// Nanoseconds of one character, rounded up.
Time nominal_char_time(const tape_code::Framing& framing, std::uint32_t baud) {
  const std::int64_t bits = framing.bits_per_char();
  return Time((bits * kNanosecondsPerSecond + baud - 1) / baud);
}

}  // namespace

std::string message(const SettingsRefusal& refusal) {
  const std::string text(table_text(refusal.fault));
  if (refusal.fault != SettingsFault::budget) return text;
  const std::uint64_t sum = std::uint64_t{refusal.unsent} + refusal.latency_chars;
  return std::to_string(refusal.unsent) + " unsent + " + std::to_string(refusal.latency_chars) +
         " latency = " + std::to_string(sum) + " " + text + std::to_string(refusal.overrun_budget);
}

std::expected<void, SettingsRefusal> validate(const Settings& settings) {
  const auto refused = [&](SettingsFault fault) {
    return std::unexpected(SettingsRefusal{.fault = fault,
                                           .unsent = settings.unsent,
                                           .latency_chars = settings.latency_chars,
                                           .overrun_budget = settings.overrun_budget});
  };
  if (settings.baud < kMinBaud || settings.baud > kMaxBaud) return refused(SettingsFault::baud);
  if (!framing_is_known(settings.framing)) return refused(SettingsFault::framing);
  if (settings.wire.eia && !framing_takes_eia(settings.framing)) return refused(SettingsFault::eia_framing);
  if (settings.wire.eia && tape_code::validate(*settings.wire.eia)) return refused(SettingsFault::eia_specials);
  if (settings.unsent == 0 || settings.unsent > kMaxUnsent) return refused(SettingsFault::unsent);
  const std::uint64_t sum = std::uint64_t{settings.unsent} + settings.latency_chars;
  if (sum > settings.overrun_budget || settings.overrun_budget > kMaxBudget) return refused(SettingsFault::budget);
  if (settings.wire.leader_chars > kMaxFillers || settings.wire.trailer_chars > kMaxFillers) {
    return refused(SettingsFault::fillers);
  }
  const FlowCharacters& flow = settings.flow_characters;
  if (flow.xon == flow.xoff || !is_flow_code(flow.xon) || !is_flow_code(flow.xoff))
    return refused(SettingsFault::flow_characters);
  if (settings.end.eot && !eot_is_free(*settings.end.eot, flow)) return refused(SettingsFault::eot_code);
  const bool sees_dc3 = settings.end.dc3 && settings.xoff_by == XoffBy::host;
  if (!sees_dc3 && !settings.end.eot && !settings.end.quiet) return refused(SettingsFault::no_end_sign);
  if (settings.xoff_by != XoffBy::host && settings.start == Start::on_dc1) return refused(SettingsFault::start_unseen);
  if (!trigger_is_usable(settings)) return refused(SettingsFault::trigger);
  if (!delays_are_known(settings)) return refused(SettingsFault::delay);
  if (settings.watch_dsr && dsr_is_flow(settings.flow)) return refused(SettingsFault::dsr_twice);
  return {};
}

Time char_time(const Settings& settings) {
  const Time nominal = nominal_char_time(settings.framing, settings.baud);
  if (!settings.blind) return nominal + settings.char_delay;
  return Time(static_cast<std::int64_t>(static_cast<double>(nominal.count()) / kBlindRate) + 1) + settings.char_delay;
}

std::uint32_t latency_in_chars(Time delay, const tape_code::Framing& framing, std::uint32_t baud) {
  const Time one = nominal_char_time(framing, baud);
  if (delay <= Time::zero()) return 0;
  const std::int64_t chars = (delay.count() + one.count() - 1) / one.count();
  return chars > kMaxBudget ? kMaxBudget : static_cast<std::uint32_t>(chars);
}

}  // namespace dripfeed::feed
