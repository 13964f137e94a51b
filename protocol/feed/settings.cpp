// Validation of a feed's settings and the arithmetic of line time and budget.
#include "protocol/feed/settings.h"

#include <array>
#include <string_view>
#include <utility>

#include "protocol/tape_code/parity.h"

namespace dripfeed::feed {
namespace {

constexpr std::uint32_t kMinBaud = 50;
constexpr std::uint32_t kMaxBaud = 4'000'000;
constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

constexpr std::array<std::pair<SettingsFault, std::string_view>, 7> kMessages{{
    {SettingsFault::baud, "the baud rate is not between 50 and 4000000"},
    {SettingsFault::framing, "the framing is not one of 7 or 8 data bits with 1 or 2 stop bits"},
    {SettingsFault::unsent, "unsent characters must be between 1 and 256"},
    {SettingsFault::budget, "characters, more than the overrun budget of "},
    {SettingsFault::fillers, "leader or trailer is longer than 100000 NULs"},
    {SettingsFault::no_end_sign, "no end sign: neither DC3 nor an end character nor a quiet time"},
    {SettingsFault::eot_code, "the end character must have 7 bits and be none of NUL, DC1 to DC4, NAK, SYN"},
}};

std::string_view table_text(SettingsFault fault) {
  for (const auto& [key, text] : kMessages) {
    if (key == fault) return text;
  }
  return {};
}

bool eot_is_free(std::uint8_t eot) { return eot <= tape_code::kLowSevenBits && eot != 0 && (eot < 0x11 || eot > 0x16); }

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
  if (settings.unsent == 0 || settings.unsent > kMaxUnsent) return refused(SettingsFault::unsent);
  const std::uint64_t sum = std::uint64_t{settings.unsent} + settings.latency_chars;
  if (sum > settings.overrun_budget || settings.overrun_budget > kMaxBudget) return refused(SettingsFault::budget);
  if (settings.wire.leader_nuls > kMaxFillers || settings.wire.trailer_nuls > kMaxFillers) {
    return refused(SettingsFault::fillers);
  }
  if (settings.end.eot && !eot_is_free(*settings.end.eot)) return refused(SettingsFault::eot_code);
  if (!settings.end.dc3 && !settings.end.eot && !settings.end.quiet) return refused(SettingsFault::no_end_sign);
  return {};
}

Time char_time(const Settings& settings) {
  const Time nominal = nominal_char_time(settings.framing, settings.baud);
  if (!settings.blind) return nominal;
  return Time(static_cast<std::int64_t>(static_cast<double>(nominal.count()) / kBlindRate) + 1);
}

std::uint32_t latency_in_chars(Time delay, const tape_code::Framing& framing, std::uint32_t baud) {
  const Time one = nominal_char_time(framing, baud);
  if (delay <= Time::zero()) return 0;
  const std::int64_t chars = (delay.count() + one.count() - 1) / one.count();
  return chars > kMaxBudget ? kMaxBudget : static_cast<std::uint32_t>(chars);
}

}  // namespace dripfeed::feed
