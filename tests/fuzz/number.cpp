// The number reader against the standard's, and the writers against the reader.
#include "dialects/text/number.h"

#include <charconv>
#include <cmath>

#include "tests/fuzz/target.h"

using namespace dripfeed;

namespace {

void require_decimal(std::string_view text) {
  const auto read = text::read_decimal(text);
  if (!read) return fuzz::require(text.find_first_of("0123456789") != 0, "a digit begins a number");
  fuzz::require(read->length > 0 && read->length <= text.size(), "a number's length is in the text");
  const std::string_view written = text.substr(0, read->length);
  fuzz::require(written.find_first_not_of("0123456789.") == std::string_view::npos, "a number is digits and a point");
  double expected = 0.0;
  const auto parsed =
      std::from_chars(written.data(), written.data() + written.size(), expected, std::chars_format::fixed);
  if (parsed.ec == std::errc::result_out_of_range) {
    return fuzz::require(read->value == 0.0 || std::isinf(read->value), "a number beyond doubles is 0 or infinite");
  }
  fuzz::require(read->value == expected, "a number is the nearest double");
}

void require_written(double value) {
  const std::string shortest = text::format_shortest(value);
  fuzz::require(text::parse_number(shortest) == value, "the shortest form reads back as the same double");
  if (std::abs(value) >= 1e15) return;
  for (const int decimals : {0, 3, 9}) {
    const std::string fixed = text::format_fixed(value, decimals);
    const auto back = text::parse_number(fixed);
    const double half = 0.5 * std::pow(10.0, -decimals);
    fuzz::require(back && std::abs(*back - value) <= half * (1 + 1e-6) + std::abs(value) * 1e-15,
                  "fixed point is off by half a unit at most");
    fuzz::require(*back != 0.0 || !fixed.starts_with('-'), "fixed point has no negative zero");
    std::string word;
    text::append_word_number(word, value, decimals, false);
    fuzz::require(word.contains('.'), "a word's number has a point");
    fuzz::require(text::parse_number(word) == back, "a word's number is the fixed one");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  require_decimal(text);
  static_cast<void>(text::parse_integer(text));
  if (const auto value = text::parse_number(text)) {
    fuzz::require(std::isfinite(*value), "a parsed number is finite");
    require_written(*value);
  }
  return 0;
}
