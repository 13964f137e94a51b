// read_decimal for the inner loop of scanners: short decimals only, no bounds to check, all inline. What it refuses is
// left to read_decimal.
#pragma once

#include <array>
#include <cstdint>

namespace dripfeed::text {

struct ScannedDecimal {
  double value = 0.0;
  std::uint32_t digits = 0;  // digits written, leading zeros not counted
  std::uint32_t fraction = 0;
  bool has_point = false;
  std::uint64_t mantissa = 0;  // value × 10^fraction
  const char* end = nullptr;   // after the last digit or the point; nullptr: no digit, or more than kScannedDigits
};
inline constexpr std::uint32_t kScannedDigits = 15;  // every integer of so many is a double, and so is 10^15

// The decimal at `at`, of which some byte is no digit and no point. Rounded to nearest, as one quotient of two exact
// doubles.
// Inlined by order: its result is then never a struct in memory, which doubles the speed of a scan.
[[gnu::always_inline]] inline ScannedDecimal scan_decimal(const char* at) {
  static constexpr std::array<double, kScannedDigits + 1> kPowers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const auto digit_of = [](char c) { return static_cast<std::uint32_t>(static_cast<unsigned char>(c)) - '0'; };
  const char* const begin = at;
  while (*at == '0') ++at;
  const char* first = at;
  std::uint64_t mantissa = 0;  // wraps where there are too many digits; it is not used then
  std::uint32_t digit = digit_of(*at);
  for (; digit < 10; digit = digit_of(*++at)) mantissa = mantissa * 10 + digit;
  auto written = static_cast<std::uint32_t>(at - begin);
  auto digits = static_cast<std::uint32_t>(at - first);
  std::uint32_t fraction = 0;
  const bool has_point = *at == '.';
  if (has_point) {
    const char* const point = ++at;
    // Zeros after the point of 0.05 lead, too.
    if (digits == 0)
      while (*at == '0') ++at;
    first = at;
    for (digit = digit_of(*at); digit < 10; digit = digit_of(*++at)) mantissa = mantissa * 10 + digit;
    fraction = static_cast<std::uint32_t>(at - point);
    digits += static_cast<std::uint32_t>(at - first);
    written += fraction;
  }
  if (written == 0 || written > kScannedDigits) return {};
  // A whole number needs no quotient: most words of codes and many of feeds are.
  const auto whole = static_cast<double>(static_cast<std::int64_t>(mantissa));  // a signed one converts in one step
  const double value = fraction == 0 ? whole : whole / kPowers[fraction];
  return {
      .value = value, .digits = digits, .fraction = fraction, .has_point = has_point, .mantissa = mantissa, .end = at};
}

}  // namespace dripfeed::text
