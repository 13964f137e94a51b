// The only conversion between numbers and text in the whole project. It knows no locale: a decimal comma in a feed is a
// crash. Signs, points and exponents that a dialect adds on top (EX, 'H1F') are the dialect's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dripfeed::text {

// A decimal as programs write it: digits with at most one point, no sign, no exponent ("10", "10.", ".5", "0.25").
struct Decimal {
  double value = 0.0;
  std::uint8_t digits = 0;    // digits written, leading zeros not counted, capped at 255
  std::uint8_t fraction = 0;  // digits after the point, capped at 255
  bool has_point = false;
  std::size_t length = 0;  // bytes read
};

// Reads the longest decimal at the start of `text`; nothing when there is no digit. Too large reads as infinity. Up to
// 15 significant digits go by integer mantissa and a power of ten (exact product or quotient of two doubles), more go
// through std::from_chars: both round to nearest.
std::optional<Decimal> read_decimal(std::string_view text);

// A whole number in text with optional sign, point and e-exponent, all of it: nothing when a byte is left over or it is
// not finite.
std::optional<double> parse_number(std::string_view text);
std::optional<std::int64_t> parse_integer(std::string_view text);

// Shortest decimal that reads back as the same double ("0.1", "1e+300"); for JSON and messages.
std::string format_shortest(double value);

// Fixed point with exactly `decimals` (0..9) digits, rounded half away from zero on the decimal expansion that
// format_shortest shows; never "-0.000".
std::string format_fixed(double value, int decimals);
void append_fixed(std::string& out, double value, int decimals);

// As programs are written: at most `decimals` digits, trailing zeros dropped, always a point ("10.", "0.25", "-3.5").
// `bare_integer` drops the point of whole numbers ("10"), as SINUMERIK programs are written.
void append_word_number(std::string& out, double value, int decimals, bool bare_integer);

}  // namespace dripfeed::text
