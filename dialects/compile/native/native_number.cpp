// Decimals beyond the ninth are noise of the conversion through stored units.
#include "dialects/compile/native/native_number.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

constexpr int kMostDecimals = 9;

constexpr double kNoise = 1e-9;
constexpr int kNoLimit = 1000;

bool is_digit_of_number(char c) { return c >= '0' && c <= '9'; }

NativeNumber refused(std::string why) { return {.text = std::nullopt, .why = std::move(why)}; }

int whole_digits(double value) {
  const std::string written = text::format_fixed(std::abs(value), kMostDecimals);
  return written.starts_with('0') ? 0 : static_cast<int>(written.find('.'));
}

}  // namespace

NativeNumber number_in_place(const NativeConstant& old, std::string_view old_text, double value,
                             std::uint32_t most_digits) {
  if (text::format_fixed(value, kMostDecimals) == text::format_fixed(old.value, kMostDecimals))
    return {.text = std::string(old_text), .why = {}};
  if (old.takes_integer && std::abs(value - std::nearbyint(value)) > kNoise)
    return refused(fmt::format("it takes whole numbers (INT), and {} is not one", text::format_shortest(value)));
  // What the program has by itself, the control reads.
  const int most = most_digits == 0 ? kNoLimit : std::max(static_cast<int>(most_digits), int{old.digits});
  std::string out;
  text::append_word_number(out, value, std::clamp(most - whole_digits(value), 0, kMostDecimals), !old.has_point);
  if (std::ranges::count_if(out, is_digit_of_number) > most + (std::abs(value) < 1.0 ? 1 : 0))
    return refused(
        fmt::format("{} has more than the {} digits that the control reads", text::format_shortest(value), most));
  return {.text = std::move(out), .why = {}};
}

}  // namespace dripfeed::compile
