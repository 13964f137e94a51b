// The computer: its clock, and what it lets this user have.
#include <algorithm>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/timex.h>
#include <unistd.h>

#include "server/cli/doctor.h"
#include "server/io/line_record.h"
#include "server/io/steady_clock.h"

namespace dripfeed::cli {

namespace {

constexpr std::int64_t kClocksDiffer_ms = 1000;
constexpr rlim_t kFilesWanted = 1024;

}  // namespace

void look_at_clock(const sqlite::StoreState& state, Findings& found) {
  const std::int64_t now_ms = io::SteadyClock().wall_ms();
  if (state.newest_row_ms > now_ms + kClocksDiffer_ms) {
    found.push_back({Health::fault, "clock",
                     fmt::format("it is {} here, and the store has rows of {}", io::text_of_time(now_ms),
                                 io::text_of_time(state.newest_row_ms)),
                     "set the clock (timedatectl set-ntp true)"});
    return;
  }
  timex time{};
  const int clock = ::adjtimex(&time);  // without modes it only reads
  if (clock == TIME_ERROR || (time.status & STA_UNSYNC) != 0) {
    found.push_back({Health::warning, "clock",
                     fmt::format("{}, by a clock that is not synchronized", io::text_of_time(now_ms)),
                     "timedatectl set-ntp true, or another NTP client: ledger and audit have this clock's times"});
    return;
  }
  found.push_back(
      {Health::ok, "clock", fmt::format("{}, by a clock that is synchronized", io::text_of_time(now_ms)), ""});
}

void look_at_limits(Findings& found) {
  rlimit files{};
  ::getrlimit(RLIMIT_NOFILE, &files);
  const bool few = files.rlim_max < kFilesWanted;
  found.push_back({few ? Health::warning : Health::ok, "files",
                   fmt::format("a process of this user may open {} files", files.rlim_max),
                   few ? "LimitNOFILE=8192 in the unit: connections take half of them" : ""});
  rlimit priority{};
  ::getrlimit(RLIMIT_RTPRIO, &priority);
  const bool may = priority.rlim_max > 0 || ::geteuid() == 0;
  found.push_back({may ? Health::ok : Health::warning, "priority",
                   may ? "threads of lines may have real-time priority" : "threads of lines get no real-time priority",
                   may ? "" : "LimitRTPRIO=1 in the unit, see docs/scheduling.md"});
}

}  // namespace dripfeed::cli
