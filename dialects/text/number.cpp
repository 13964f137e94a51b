// Reading goes by an integer mantissa where that is exact; printing works on the decimal digits of the shortest form,
// so that what a person would round by hand is what comes out. Neither looks at a locale.
#include "dialects/text/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <system_error>

#include <fmt/format.h>

namespace dripfeed::text {

namespace {

constexpr int kExactDigits = 15;  // every 15-digit integer is a double
constexpr int kExactPower = 22;   // 10^22 is the largest power of ten that is a double
constexpr int kMaxDecimals = 9;
constexpr std::array<double, kExactPower + 1> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::uint8_t capped(std::size_t n) { return static_cast<std::uint8_t>(std::min<std::size_t>(n, 255)); }

// The general path: any length. What is too large for a double reads as infinity, what is too small as zero.
double read_long(std::string_view digits) {
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  if (error == std::errc{}) return value;
  const std::string_view whole = digits.substr(0, digits.find('.'));
  return whole.find_first_not_of('0') == std::string_view::npos ? 0.0 : std::numeric_limits<double>::infinity();
}

// The shortest form as digits d1 d2 … dn and an exponent: 0.d1d2…dn × 10^point. Zero has no digits.
struct Digits {
  std::array<char, 24> text{};
  int count = 0;
  int point = 0;
};

Digits shortest_digits(double magnitude) {
  Digits digits;
  if (magnitude == 0.0) return digits;
  std::array<char, 40> buffer{};
  const auto written =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude, std::chars_format::scientific);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(written.ptr - buffer.data()));
  const std::size_t e = text.find('e');
  for (const char c : text.substr(0, e)) {
    if (is_digit(c)) digits.text[static_cast<std::size_t>(digits.count++)] = c;
  }
  std::string_view exponent = text.substr(e + 1);
  if (exponent.front() == '+') exponent.remove_prefix(1);
  int value = 0;
  std::from_chars(exponent.data(), exponent.data() + exponent.size(), value);
  digits.point = value + 1;
  return digits;
}

// Keeps the first `keep` digits, half away from zero. A carry out of the first digit makes a new one.
void round_digits(Digits& digits, int keep) {
  if (keep >= digits.count) return;
  const bool up = keep >= 0 && digits.text[static_cast<std::size_t>(keep)] >= '5';
  digits.count = std::max(keep, 0);
  if (!up) return;
  while (digits.count > 0 && digits.text[static_cast<std::size_t>(digits.count - 1)] == '9') --digits.count;
  if (digits.count > 0) {
    ++digits.text[static_cast<std::size_t>(digits.count - 1)];
    return;
  }
  digits.text[0] = '1';
  digits.count = 1;
  ++digits.point;
}

void append_digits(std::string& out, const Digits& digits, int decimals) {
  const auto digit_at = [&](int i) {
    return i >= 0 && i < digits.count ? digits.text[static_cast<std::size_t>(i)] : '0';
  };
  if (digits.point <= 0 || digits.count == 0) out.push_back('0');
  if (digits.count > 0) {
    for (int i = 0; i < digits.point; ++i) out.push_back(digit_at(i));
  }
  if (decimals == 0) return;
  out.push_back('.');
  for (int i = 0; i < decimals; ++i) out.push_back(digits.count > 0 ? digit_at(digits.point + i) : '0');
}

// value × 10^decimals as a whole number where the product's rounding error cannot decide the last digit; -1 otherwise.
// The error is below 2^-53 × 1e12, a hundredth of the distance from a half that is asked for.
std::int64_t scaled_integer(double magnitude, int decimals) {
  constexpr double kLimit = 1e12;
  constexpr double kFromHalf = 0.01;
  const double scaled = magnitude * kPowers[static_cast<std::size_t>(decimals)];
  if (!(scaled < kLimit)) return -1;
  const double whole = std::floor(scaled);
  const double fraction = scaled - whole;
  if (std::fabs(fraction - 0.5) < kFromHalf) return -1;
  return static_cast<std::int64_t>(whole) + (fraction > 0.5 ? 1 : 0);
}

// Up to `end`, with a point before the last `decimals` digits. Returns where it begins.
char* write_scaled(char* end, std::uint64_t scaled, int decimals) {
  const auto write_digit = [&] {
    *--end = static_cast<char>('0' + scaled % 10);
    scaled /= 10;
  };
  for (int i = 0; i < decimals; ++i) write_digit();
  if (decimals > 0) *--end = '.';
  do write_digit();
  while (scaled > 0);
  return end;
}

// False, and nothing is appended, where the digits have to be looked at. `trims`: without zeros at the end of a
// fraction.
bool append_scaled(std::string& out, double value, int decimals, bool trims) {
  const std::int64_t scaled = scaled_integer(std::fabs(value), decimals);
  if (scaled < 0) return false;
  std::array<char, 24> room{};  // a sign, a point and 13 digits
  const char* end = room.data() + room.size();
  char* begin = write_scaled(room.data() + room.size(), static_cast<std::uint64_t>(scaled), decimals);
  if (value < 0.0 && scaled != 0) *--begin = '-';
  while (trims && decimals > 0 && end[-1] == '0') --end;
  out.append(begin, static_cast<std::size_t>(end - begin));
  return true;
}

}  // namespace

std::optional<Decimal> read_decimal(std::string_view text) {
  std::uint64_t mantissa = 0;
  std::size_t significant = 0;  // digits from the first that is not zero
  std::size_t written = 0;
  std::size_t fraction = 0;
  bool has_point = false;
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (is_digit(c)) {
      ++written;
      if (has_point) ++fraction;
      if (significant > 0 || c != '0') ++significant;
      if (significant <= kExactDigits) mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
    } else if (c == '.' && !has_point) {
      has_point = true;
    } else {
      break;
    }
  }
  if (written == 0) return std::nullopt;
  Decimal decimal{0.0, capped(significant), capped(fraction), has_point, i};
  if (significant <= kExactDigits && fraction <= kExactPower) {
    decimal.value = static_cast<double>(mantissa) / kPowers[fraction];
  } else if (significant > 0) {
    decimal.value = read_long(text.substr(0, i));
  }
  return decimal;
}

std::optional<double> parse_number(std::string_view text) {
  const bool has_sign = !text.empty() && (text.front() == '-' || text.front() == '+');
  const bool negative = has_sign && text.front() == '-';
  if (has_sign) text.remove_prefix(1);
  // from_chars would also take "inf" and "nan".
  if (text.empty() || !(is_digit(text.front()) || text.front() == '.')) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return negative ? -value : value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string format_shortest(double value) { return fmt::format("{}", value); }

std::string format_fixed(double value, int decimals) {
  std::string out;
  append_fixed(out, value, decimals);
  return out;
}

void append_fixed(std::string& out, double value, int decimals) {
  decimals = std::clamp(decimals, 0, kMaxDecimals);
  if (append_scaled(out, value, decimals, false)) return;
  if (!std::isfinite(value)) {
    fmt::format_to(std::back_inserter(out), "{}", value);
    return;
  }
  Digits digits = shortest_digits(std::fabs(value));
  round_digits(digits, digits.point + decimals);
  if (value < 0.0 && digits.count > 0) out.push_back('-');
  append_digits(out, digits, decimals);
}

void append_word_number(std::string& out, double value, int decimals, bool bare_integer) {
  decimals = std::clamp(decimals, 0, kMaxDecimals);
  if (!append_scaled(out, value, decimals, true)) {
    append_fixed(out, value, decimals);
    if (!std::isfinite(value)) return;
    if (decimals > 0) out.erase(out.find_last_not_of('0') + 1);
  }
  if (decimals == 0 && !bare_integer) out.push_back('.');
  if (decimals > 0 && bare_integer && out.back() == '.') out.pop_back();
}

}  // namespace dripfeed::text
