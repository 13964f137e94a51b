// The store gives the jobs in the order of their ends, so that a day or shift is one run of them.
#include "server/app/jobs/history.h"

#include <algorithm>
#include <map>

namespace dripfeed::app {

namespace {

using store::EndedJob;
using store::JobState;

void add_to(const EndedJob& job, Sums& sums) {
  ++sums.jobs;
  if (job.state == JobState::done) ++sums.done;
  if (job.state == JobState::failed) ++sums.failed;
  if (job.state == JobState::cancelled) ++sums.cancelled;
  if (job.state == JobState::interrupted) ++sums.interrupted;
  if (job.state == JobState::done) sums.bytes += job.bytes_total;
  if (job.started_at_ms == 0) return;
  const std::int64_t feeding_ms = job.ended_at_ms - job.started_at_ms;
  ++sums.fed;
  sums.feeding_ms += feeding_ms;
  if (job.held_ms) {
    ++sums.held_known;
    sums.held_ms += *job.held_ms;
  }
  if (job.holds) {
    ++sums.holds_known;
    sums.holds += *job.holds;
  }
  if (job.held_ms && job.line_ms) {
    ++sums.line_known;
    sums.line_ms += *job.line_ms;
    sums.line_free_ms += std::max<std::int64_t>(0, feeding_ms - *job.held_ms);
  }
  if (job.state == JobState::done && job.forecast_ms) {
    ++sums.forecasts;
    sums.forecast_ms += *job.forecast_ms;
    sums.forecast_took_ms += feeding_ms;
  }
}

class Grouping {
 public:
  Grouping(SumsBy by, const Shifts& shifts) : by_(by), shifts_(shifts) {}

  void take(const EndedJob& job) {
    add_to(job, sums_.all);
    if (by_ == SumsBy::machine || by_ == SumsBy::part) {
      add_to(job, named_[by_ == SumsBy::machine ? job.machine : job.part]);
    } else {
      add_to(job, run_of(job.ended_at_ms).sums);
    }
  }

  HistorySums finish() {
    for (auto& [name, sums] : named_) sums_.groups.push_back({.name = name, .sums = sums});
    if (named_.empty()) std::ranges::reverse(sums_.groups);
    return std::move(sums_);
  }

 private:
  SumGroup& run_of(std::int64_t at_ms) {
    if (!sums_.groups.empty() && at_ms < sums_.groups.back().to_ms) return sums_.groups.back();
    LocalTime time = by_ == SumsBy::day ? day_of(at_ms) : shifts_.shift_of(at_ms);
    sums_.groups.push_back({.name = std::move(time.name), .from_ms = time.from_ms, .to_ms = time.to_ms, .sums = {}});
    return sums_.groups.back();
  }

  SumsBy by_;
  const Shifts& shifts_;
  HistorySums sums_;
  std::map<std::string, Sums> named_;
};

}  // namespace

Result<HistorySums> history_sums(store::Store& store, const store::EndedFilter& filter, SumsBy by,
                                 const Shifts& shifts) {
  Grouping grouping(by, shifts);
  const auto read = lift(store.jobs().each_ended(filter, [&](const EndedJob& job) { grouping.take(job); }));
  if (!read) return std::unexpected(read.error());
  return grouping.finish();
}

}  // namespace dripfeed::app
