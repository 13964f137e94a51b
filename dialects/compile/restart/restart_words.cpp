// Codes are looked up in the tables of the control, and by name where it has no number for one.
#include "dialects/compile/restart/restart_words.h"

#include <algorithm>
#include <cmath>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/interpreter/machine/trace.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/sinumerik/tables/code_names.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

constexpr int kFeedDecimals = 4;
constexpr int kFeedPerTurnDecimals = 6;
constexpr int kValueDecimals = 9;

}  // namespace

std::string RestartWords::code(ir::Function function, std::int16_t argument) const {
  for (const auto& table : {control_.g_codes, control_.m_codes}) {
    const auto row = std::ranges::find_if(table, [&](const ir::CodeRow& one) {
      return one.function == function && one.argument == argument && one.number10 >= 0;
    });
    if (row != table.end()) return std::string(row->name);
  }
  if (by_number_) return {};
  ir::Code named;
  named.function = function;
  named.argument = argument;
  return sinumerik::name_of_code(named);
}

std::string RestartWords::number(double value, int decimals) const {
  std::string out;
  text::append_word_number(out, value, decimals, !by_number_);
  return out;
}

std::string RestartWords::axis(std::size_t axis, double position) const {
  const char letter = ir::kAxisLetters[axis];
  const double programmed = axis == 0 ? position / rules_.x_factor(modes_, false) : position;
  const bool turns = letter <= 'C';
  return letter + number(turns ? programmed : programmed / unit_mm(), turns ? 3 : decimals());
}

std::string RestartWords::feed(double feed) const {
  const bool per_turn = modes_.feed_mode == ir::FeedMode::per_rev;
  return "F" + number(modes_.inch_feed ? feed / 25.4 : feed, per_turn ? kFeedPerTurnDecimals : kFeedDecimals);
}

std::string RestartWords::count(char letter, double value) const {
  std::string out(1, letter);
  text::append_word_number(out, value, 3, true);
  return out;
}

std::string RestartWords::comment(std::string_view words) const {
  const bool brackets = find_dialect(control_.dialect)->comments == CommentStyle::brackets;
  return brackets ? "(" + std::string(words) + ")" : "; " + std::string(words);
}

std::string RestartWords::assignment(std::string_view name, double value) const {
  // As many digits as the control reads in a number.
  const double whole = std::abs(value) < 1.0 ? 0.0 : std::floor(std::log10(std::abs(value))) + 1.0;
  const int digits = static_cast<int>(control_.limits.digits == 0 ? 15 : control_.limits.digits);
  const int decimals = std::clamp(digits - static_cast<int>(whole), 0, kValueDecimals);
  return std::string(name) + "=" + number(value, decimals);
}

double RestartWords::rounding_mm() const { return 0.5 * std::pow(10.0, -decimals()) * unit_mm() * 1.001; }

std::string block_of(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) {
    if (word.empty()) continue;
    if (!out.empty()) out += ' ';
    out += word;
  }
  return out;
}

}  // namespace dripfeed::compile
