// The machine stands still while a tool is changed: the times of the tools are timings of their own, one after the
// other.
#include "server/app/checks/statistics.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "checks/timing/timing.h"
#include "server/app/checks/tool_list.h"

namespace dripfeed::app {

namespace {

class ToolTimes final : public ir::MotionSink {
 public:
  explicit ToolTimes(timing::Settings settings) : settings_(std::move(settings)) {}

  void consume(std::span<const ir::Motion> motions) override {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (motions[i].kind != ir::MotionKind::tool) continue;
      const std::uint32_t before = tools_.current();
      if (!tools_.take(motions[i])) continue;
      put(motions.subspan(begin, i - begin));
      end_of(before);
      begin = i;
    }
    put(motions.subspan(begin));
  }

  // By tool; what was not counted goes to `not_checked`.
  std::vector<double> finish(checks::NotCheckedList& not_checked) {
    end_of(tools_.current());
    times_s_.resize(tools_.all().size());
    for (const checks::NotChecked& one : not_counted_.list()) not_checked.add(one.text, one.line);
    return std::move(times_s_);
  }

 private:
  void put(std::span<const ir::Motion> motions) {
    if (motions.empty()) return;
    if (!timing_) timing_.emplace(settings_);
    timing_->consume(motions);
  }

  void end_of(std::uint32_t tool) {
    if (!timing_) return;
    const timing::Report report = timing_->finish();
    timing_.reset();
    times_s_.resize(std::max<std::size_t>(times_s_.size(), tool + 1));
    times_s_[tool] += report.motion_s;
    for (const checks::NotChecked& one : report.not_checked.list()) not_counted_.add(one.text, one.line);
  }

  timing::Settings settings_;
  std::optional<timing::Timing> timing_;
  ToolList tools_;
  std::vector<double> times_s_;
  checks::NotCheckedList not_counted_;
};

// Lines as an editor counts them: a last one without an end is one, too.
std::uint64_t lines_of(const text::Source& source) {
  const std::string_view text = source.text();
  if (text.empty()) return 0;
  const bool ends = text.back() == '\n' || text.back() == '\r';
  return source.position(static_cast<std::uint32_t>(text.size())).line - (ends ? 1 : 0);
}

}  // namespace

Result<Statistics> statistics_of(const DiagnoseOrder& order, const Documents& documents, const CheckBudget& budget) {
  const auto opened = open_text(order, documents);
  if (!opened) return std::unexpected(opened.error());
  Examination& e = (*opened)->examination;
  Statistics out;
  out.lines = lines_of(e.source);
  out.bytes = e.source.text().size();
  std::optional<ToolTimes> times;
  if (e.profile == nullptr) {
    out.why_no_time = "no machine is named: its axes decide";
  } else if (auto settings = timing_settings(e, e.source.text())) {
    times.emplace(std::move(*settings));
  } else {
    out.why_no_time = settings.error();
  }
  out.path = record_path(e, budget, times ? std::vector<ir::MotionSink*>{&*times} : std::vector<ir::MotionSink*>{});
  out.path.points_mm = {};
  out.path.lines = {};
  out.path.feeds = {};
  out.path.origins = {};
  if (times) {
    out.tool_times_s = times->finish(out.path.report.checks.not_checked);
    out.time_s = std::accumulate(out.tool_times_s.begin(), out.tool_times_s.end(), 0.0);
  }
  return out;
}

}  // namespace dripfeed::app
