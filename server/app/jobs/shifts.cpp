// mktime() knows when the clock is changed: each begin is asked for by its day and time.
#include "server/app/jobs/shifts.h"

#include <algorithm>
#include <charconv>
#include <ctime>
#include <optional>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

// So many minutes after the midnight that begins the day so many days after that of `at_ms`.
std::int64_t moment(std::int64_t at_ms, int days_after, int minutes) {
  const auto seconds = static_cast<std::time_t>(at_ms / 1000);
  std::tm day{};
  ::localtime_r(&seconds, &day);
  day.tm_sec = 0;
  day.tm_hour = minutes / 60;
  day.tm_min = minutes % 60;
  day.tm_mday += days_after;
  day.tm_isdst = -1;
  return static_cast<std::int64_t>(std::mktime(&day)) * 1000;
}

std::string day_name(std::int64_t at_ms) {
  const auto seconds = static_cast<std::time_t>(at_ms / 1000);
  std::tm day{};
  ::localtime_r(&seconds, &day);
  return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

// Two digits, a colon, two digits.
std::optional<int> minutes_of(std::string_view text) {
  if (text.size() != 5 || text[2] != ':') return std::nullopt;
  const auto number = [&](std::size_t at) {
    int value = -1;
    const char* const end = text.data() + at + 2;
    return std::from_chars(text.data() + at, end, value).ptr == end ? value : -1;
  };
  const int hours = number(0);
  const int minutes = number(3);
  if (hours < 0 || hours > 23 || minutes < 0 || minutes > 59) return std::nullopt;
  return hours * 60 + minutes;
}

}  // namespace

std::expected<Shifts, std::string> Shifts::of(std::span<const std::string> begins) {
  Shifts shifts;
  if (begins.empty()) return shifts;
  shifts.begins_min_.clear();
  for (const std::string& begin : begins) {
    const auto minutes = minutes_of(begin);
    if (!minutes) return std::unexpected(fmt::format("\"{}\" is not a time of day: use HH:MM", begin));
    shifts.begins_min_.push_back(*minutes);
  }
  std::ranges::sort(shifts.begins_min_);
  if (std::ranges::adjacent_find(shifts.begins_min_) != shifts.begins_min_.end())
    return std::unexpected(std::string("two shifts begin at the same time"));
  return shifts;
}

LocalTime Shifts::shift_of(std::int64_t at_ms) const {
  struct Begin {
    std::int64_t at_ms;
    int minutes;
  };
  LocalTime shift;
  std::vector<Begin> begins;
  for (int day = -1; day <= 1; ++day)
    for (const int minutes : begins_min_) begins.push_back({moment(at_ms, day, minutes), minutes});
  // A day without this time of day, as the clock jumps over it, has two begins at one moment.
  std::ranges::stable_sort(begins, {}, &Begin::at_ms);
  const auto next = std::ranges::upper_bound(begins, at_ms, {}, &Begin::at_ms);
  const Begin& own = *(next - 1);
  shift.from_ms = own.at_ms;
  shift.to_ms = next->at_ms;
  shift.name = fmt::format("{} {:02}:{:02}", day_name(own.at_ms), own.minutes / 60, own.minutes % 60);
  return shift;
}

LocalTime day_of(std::int64_t at_ms) {
  return {.from_ms = moment(at_ms, 0, 0), .to_ms = moment(at_ms, 1, 0), .name = day_name(at_ms)};
}

}  // namespace dripfeed::app
