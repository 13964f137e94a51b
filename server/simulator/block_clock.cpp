// Words are letter, '=' where the control writes one, number. Anything else in a block makes it not plain.
#include "server/simulator/block_clock.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <string>

#include "dialects/text/number.h"

namespace dripfeed::simulator {

namespace {

constexpr std::size_t kMaxCodes = 16;
constexpr double kMmPerInch = 25.4;
constexpr std::string_view kNotPlain = "a block that is not plain";

constexpr std::size_t letter_index(char letter) { return static_cast<std::size_t>(letter - 'A'); }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr bool is_letter(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }
constexpr std::string_view kAxes = "XYZABCUVW";
constexpr double kLongestBlock_s = 1e6;  // a feed of next to nothing, a dwell of years: still a time

// A G or M number; -1 for one that no control has.
constexpr int code_of(double value) { return value >= 0.0 && value < 10'000.0 ? static_cast<int>(value) : -1; }

}  // namespace

// The values of a block's words by letter; codes apart, because several may stand in one block.
struct BlockClock::Words {
  std::array<double, 26> value{};
  std::array<bool, 26> given{};
  std::array<int, kMaxCodes> g{};
  std::size_t g_count = 0;
  std::array<int, kMaxCodes> m{};
  std::size_t m_count = 0;
};

double BlockClock::run(std::string_view block) {
  Words words;
  fault_ = {};
  if (!read(block, words)) return 0.0;
  const std::span<const int> codes(words.g.data(), words.g_count);
  const bool dwell = std::ranges::find(codes, 4) != codes.end();
  for (std::size_t i = 0; i < words.g_count; ++i) apply_code(words.g[i]);
  if (words.given[letter_index('F')] && !dwell) feed_ = words.value[letter_index('F')];
  if (words.given[letter_index('S')]) spindle_ = words.value[letter_index('S')];
  double seconds = settings_.block_ms * 1e-3;
  if (dwell) {
    if (words.given[letter_index('F')]) seconds += words.value[letter_index('F')];  // SINUMERIK: G4 F in seconds
    if (words.given[letter_index('P')]) seconds += words.value[letter_index('P')] * 1e-3;
    if (words.given[letter_index('X')]) seconds += words.value[letter_index('X')];
  } else {
    seconds += move_s(words);
  }
  for (std::size_t i = 0; i < words.m_count; ++i) apply_function(words.m[i]);
  if (!(seconds < kLongestBlock_s)) return kLongestBlock_s;  // also what is not a number any more
  return std::max(seconds, 0.0);
}

bool BlockClock::read(std::string_view block, Words& words) {
  std::size_t i = 0;
  bool first = true;
  while (i < block.size()) {
    const char c = block[i];
    if (c == ' ' || c == '\t' || c == '\r' || c == '\0') {
      ++i;
    } else if (c == ';' || c == '%' || (c == '<' && first)) {
      return true;  // a comment or a name takes the rest
    } else if (c == '(' && settings_.comment_open == '(') {
      i = std::min(block.find(')', i), block.size() - 1) + 1;
    } else if (c == '/' && first) {
      ++i;
    } else if (is_letter(c)) {
      if (!read_word(block, i, words)) return false;
    } else {
      fault_ = kNotPlain;
      return false;
    }
    first = false;
  }
  return true;
}

bool BlockClock::read_word(std::string_view block, std::size_t& i, Words& words) {
  const char letter = upper(block[i]);
  if (settings_.comment_open == ';' && i + 1 < block.size() && is_letter(block[i + 1])) return skip_name(block, i);
  if (++i < block.size() && block[i] == '=') ++i;
  if (i < block.size() && block[i] == '"') {
    i = std::min(block.find('"', i + 1), block.size() - 1) + 1;  // T="NAME": a tool change takes no time here
    return true;
  }
  const bool negative = i < block.size() && block[i] == '-';
  if (i < block.size() && (block[i] == '-' || block[i] == '+')) ++i;
  const auto number = text::read_decimal(block.substr(std::min(i, block.size())));
  if (!number) {
    fault_ = kNotPlain;
    return false;
  }
  i += number->length;
  const double value = negative ? -number->value : number->value;
  if (letter == 'G' && words.g_count < kMaxCodes) words.g[words.g_count++] = code_of(value);
  if (letter == 'M' && words.m_count < kMaxCodes) words.m[words.m_count++] = code_of(value);
  words.value[letter_index(letter)] = value;
  words.given[letter_index(letter)] = true;
  return true;
}

// DIAMON, MSG("…"), LIMS=3000: names that take no time. A jump or a loop is a name too, and no plain block.
bool BlockClock::skip_name(std::string_view block, std::size_t& i) {
  static constexpr std::string_view kFlow[] = {"IF",    "WHILE", "FOR",   "LOOP",     "REPEAT", "GOTO",   "GOTOF",
                                               "GOTOB", "CASE",  "UNTIL", "ENDWHILE", "ENDFOR", "ENDLOOP"};
  std::string name;
  while (i < block.size() && (is_letter(block[i]) || (block[i] >= '0' && block[i] <= '9') || block[i] == '_'))
    name += upper(block[i++]);
  if (std::ranges::find(kFlow, name) != std::end(kFlow)) {
    fault_ = kNotPlain;
    return false;
  }
  if (i < block.size() && block[i] == '(') i = std::min(block.find(')', i), block.size() - 1) + 1;
  if (i < block.size() && block[i] == '=') {
    const auto number = text::read_decimal(block.substr(++i));
    if (number) i += number->length;
  }
  return true;
}

void BlockClock::apply_code(int code) {
  struct Row {
    int code;
    void (*apply)(BlockClock&);
  };
  static constexpr Row kRows[] = {
      {0, [](BlockClock& c) { c.motion_ = 0; }},
      {1, [](BlockClock& c) { c.motion_ = 1; }},
      {2, [](BlockClock& c) { c.motion_ = 2; }},
      {3, [](BlockClock& c) { c.motion_ = 3; }},
      {20, [](BlockClock& c) { c.inch_ = true; }},
      {21, [](BlockClock& c) { c.inch_ = false; }},
      {70, [](BlockClock& c) { c.inch_ = true; }},
      {71, [](BlockClock& c) { c.inch_ = false; }},
      {90, [](BlockClock& c) { c.incremental_ = false; }},
      {91, [](BlockClock& c) { c.incremental_ = true; }},
      {94, [](BlockClock& c) { c.per_revolution_ = false; }},
      {95, [](BlockClock& c) { c.per_revolution_ = true; }},
      {96, [](BlockClock& c) { c.surface_speed_ = true; }},
      {97, [](BlockClock& c) { c.surface_speed_ = false; }},
      {98, [](BlockClock& c) { c.per_revolution_ = false; }},
      {99, [](BlockClock& c) { c.per_revolution_ = true; }},
  };
  for (const Row& row : kRows) {
    if (row.code == code) row.apply(*this);
  }
}

void BlockClock::apply_function(int code) {
  if (code == 30 || code == 2 || (code == 17 && settings_.comment_open == ';')) ended_ = true;
}

double BlockClock::speed_mm_s(double x_mm) const {
  if (motion_ == 0) return settings_.rapid_mm_min / 60.0;
  double rpm = spindle_;
  if (surface_speed_) {
    const double diameter_mm = std::max(std::abs(x_mm), 0.1);
    rpm = spindle_ * 1000.0 / (std::numbers::pi * diameter_mm);
  }
  const double mm_min = (per_revolution_ ? feed_ * rpm : feed_) * (inch_ ? kMmPerInch : 1.0);
  return mm_min / 60.0;
}

double BlockClock::move_s(const Words& words) {
  double square = 0.0;
  for (const char axis : kAxes) {
    const std::size_t i = letter_index(axis);
    if (!words.given[i]) continue;
    const double value = words.value[i] * (inch_ ? kMmPerInch : 1.0);
    const double target = incremental_ ? position_[i] + value : value;
    const double scale = axis == 'X' && settings_.x_is_diameter ? 0.5 : 1.0;
    square += (target - position_[i]) * (target - position_[i]) * scale * scale;
    position_[i] = target;
  }
  const double length_mm = std::sqrt(square);
  const double speed = speed_mm_s(position_[letter_index('X')]);
  if (length_mm == 0.0 || speed <= 0.0) return 0.0;
  const double ramp_mm = speed * speed / settings_.acceleration_mm_s2;
  if (length_mm < ramp_mm) return 2.0 * std::sqrt(length_mm / settings_.acceleration_mm_s2);
  return length_mm / speed + speed / settings_.acceleration_mm_s2;
}

}  // namespace dripfeed::simulator
