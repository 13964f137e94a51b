// From motions to the three times. Motions become rows and pieces; a window of them is planned and run as far as its
// plan is certain. A program that is kept whole is one window.
//
// The backward sweep needs the path's end, which a window does not have. So it is done twice: once as if the path ended
// there at rest, once as if it went on without limit. The truth lies between. Going back, the two meet at the first
// junction whose own limit is below both, and from there on they are equal bit for bit: certain. Where they never meet
// (a path that needs more than the window to stop), more is kept.
#include "checks/timing/timing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "checks/timing/advice.h"
#include "checks/timing/execution.h"
#include "checks/timing/intake.h"
#include "checks/timing/look_ahead.h"
#include "checks/timing/sweep.h"
#include "dialects/text/number.h"

namespace dripfeed::timing {

namespace {

constexpr std::size_t kWindow = 16'384;

// What no line can be is not counted: sums of it would be no numbers.
double seconds_or_0(double s) {
  constexpr double kLongest_s = 1e9;
  return s > 0.0 && s < kLongest_s ? s : 0.0;
}

SupplySettings supply_of(const Settings& settings) {
  SupplySettings supply;
  supply.buffer = settings.machine.buffer;
  // In the memory nothing but the look-ahead limits how far computing runs ahead of motion.
  if (!settings.line && supply.buffer.blocks == 0) supply.buffer.blocks = settings.machine.timing.look_ahead_blocks;
  if (!settings.line) return supply;
  const Line& line = *settings.line;
  supply.char_s = seconds_or_0(line.char_s(line.baud));
  supply.latency_s = seconds_or_0(line.latency_s);
  supply.line_delay_s = seconds_or_0(line.line_delay_s);
  return supply;
}

}  // namespace

class Timing::Work final : public RanSink {
 public:
  explicit Work(Settings settings)
      : settings_(std::move(settings)),
        intake_(settings_, report_),
        supply_(supply_of(settings_)),
        execution_(supply_),
        keeps_whole_(settings_.keep_whole) {
    report_.is_fed = supply_.char_s > 0.0;
    rows_.reserve(kWindow);
  }

  void add(const ir::Motion& motion);
  void leave_out(const ir::Motion& motion);
  void give_up(const ir::Motion& motion);
  Report finish();

 private:
  bool ran(const Row& row, const Ran& how) override;
  void count_stall(const Row& row, const Ran& how);
  void run_window();
  void count_motion(std::size_t rows);
  void run_rest();

  Settings settings_;
  Report report_;
  Intake intake_;
  SupplySettings supply_;
  Execution execution_;
  bool keeps_whole_;
  Rows rows_;
  PieceArrays pieces_;
  std::vector<double> feed_mm_s_;  // with keeps_whole_ alone
  std::vector<double> limit_mm_s_;
  std::size_t wanted_ = kWindow;
  SpeedPlan plan_;
  std::vector<double> high2_;
  std::vector<double> sums_;
  double speed2_ = 0.0;  // of the plan, at the first kept piece
  double ran_s_ = 0.0;   // rows' durations as they ran
  bool began_ = false;
  StretchList stretches_;
  Course course_;
};

void Timing::Work::add(const ir::Motion& motion) {
  if (!report_.is_whole) return;
  if (motion.place.program != 0) course_.give_up();
  const Intaken taken = intake_.take(motion);
  if (taken.piece) {
    pieces_.push_back(*taken.piece);
    if (keeps_whole_) {
      feed_mm_s_.push_back(taken.feed_mm_s);
      limit_mm_s_.push_back(taken.limit_mm_s);
    }
  }
  rows_.push_back(taken.row);
  if (keeps_whole_ && rows_.size() > settings_.most_kept) {
    keeps_whole_ = false;
    report_.not_checked.add("the program is too long to be kept whole: no curve, and no advice");
    report_.curve = {};
    feed_mm_s_ = {};
    limit_mm_s_ = {};
  }
  if (keeps_whole_ || rows_.size() < wanted_) return;
  run_window();
  if (rows_.size() > settings_.most_kept) give_up(motion);
}

void Timing::Work::give_up(const ir::Motion& motion) {
  report_.is_whole = false;
  report_.not_checked.add("blocks make too many moves to be timed: the time ends here", motion.place.line);
}

void Timing::Work::leave_out(const ir::Motion& motion) {
  report_.not_checked.add("a move beyond 1000 km was not timed", motion.place.line);
}

void Timing::Work::run_window() {
  const std::size_t count = pieces_.size();
  const Range all{0, count};
  plan_.speed2.resize(count + 1);
  junction_limits(pieces_, all, plan_.speed2.data());
  plan_.speed2[count] = 0.0;
  change_sums(pieces_, sums_);
  const std::size_t seen = settings_.machine.timing.look_ahead_blocks;
  if (seen > 0) {
    // What ends after the window is not limited by it.
    horizon_limits(sums_.data(), count, seen, {0, count > seen ? count - seen : 0}, plan_.speed2.data());
  }
  high2_ = plan_.speed2;
  sweep_back(pieces_, all, 0.0, plan_.speed2.data());
  sweep_back(pieces_, all, kNoLimit, high2_.data());
  std::size_t certain = count;
  while (certain > 0 && (certain == count || plan_.speed2[certain] != high2_[certain])) --certain;
  if (count > 0) {
    plan_.speed2[0] = speed2_;
    sweep_ahead(pieces_, {0, certain + 1}, plan_.speed2.data());
  }
  plan_.duration_s.resize(count);
  durations(pieces_, {0, certain}, plan_.speed2.data(), plan_.duration_s.data());
  const std::size_t ran =
      execution_.run({rows_, pieces_, plan_.speed2, plan_.duration_s, sums_, certain, false}, *this);
  const std::size_t pieces = execution_.pieces_run();
  count_motion(ran);
  speed2_ = count > 0 ? plan_.speed2[pieces] : 0.0;
  rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(ran));
  pieces_.erase_front(pieces);
  execution_.drop_front(ran, pieces);
  // Seldom less than half: otherwise the sweeps would be repeated over the same pieces too often.
  wanted_ = std::max(kWindow, 2 * rows_.size());
}

// The plan's own times of the first rows, as if nothing had to be waited for.
void Timing::Work::count_motion(std::size_t rows) {
  std::size_t piece = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const Row& row = rows_[i];
    const double duration_s = row.is_piece ? plan_.duration_s[piece++] : row.event_s;
    if (row.is_rapid) report_.rapid_s += duration_s;
    report_.motion_s += duration_s;
  }
}

void Timing::Work::run_rest() {
  change_sums(pieces_, sums_);
  const LookAhead look_ahead{settings_.machine.timing.look_ahead_blocks, settings_.threads};
  if (speed2_ > 0.0) {
    // Begins in motion: the plan from rest would not do.
    plan_.speed2.resize(pieces_.size() + 1);
    const Range all{0, pieces_.size()};
    junction_limits(pieces_, all, plan_.speed2.data());
    if (look_ahead.blocks > 0)
      horizon_limits(sums_.data(), pieces_.size(), look_ahead.blocks, all, plan_.speed2.data());
    plan_.speed2.back() = 0.0;
    sweep_back(pieces_, all, 0.0, plan_.speed2.data());
    plan_.speed2[0] = speed2_;
    sweep_ahead(pieces_, all, plan_.speed2.data());
    plan_.duration_s.resize(pieces_.size());
    durations(pieces_, all, plan_.speed2.data(), plan_.duration_s.data());
  } else {
    plan_path(pieces_, look_ahead, plan_);
  }
  execution_.run({rows_, pieces_, plan_.speed2, plan_.duration_s, sums_, pieces_.size(), true}, *this);
  count_motion(rows_.size());
}

bool Timing::Work::ran(const Row& row, const Ran& how) {
  ran_s_ += how.duration_s;
  if (!began_ && how.duration_s > 0.0) {
    began_ = true;
    report_.first_move_s = how.start_s;
    if (report_.is_fed) {
      report_.lowest_buffer_bytes = how.buffered_bytes;
      report_.lowest_buffer_blocks = how.buffered_blocks;
    }
  }
  if (how.limiter != Limiter::motion) count_stall(rows_[how.late_row], how);
  if (report_.is_fed && began_ && !how.all_arrived) {
    report_.lowest_buffer_bytes = std::min(report_.lowest_buffer_bytes, how.buffered_bytes);
    report_.lowest_buffer_blocks = std::min(report_.lowest_buffer_blocks, how.buffered_blocks);
  }
  if (report_.motion_times.size() < settings_.most_motion_times)
    report_.motion_times.push_back({how.start_s, how.start_s + how.duration_s, how.buffered_bytes});
  course_.add(row.line, how.start_s);
  stretches_.add(how.limiter, row.line, how.start_s - how.waited_s, how.waited_s + how.duration_s);
  if (settings_.wants_curve && keeps_whole_) {
    const auto point = [&](double time_s, double speed_mm_s) {
      report_.curve.push_back({time_s, speed_mm_s, how.buffered_bytes, how.buffered_blocks});
    };
    point(how.start_s, std::sqrt(how.start2));
    if (row.is_piece) {
      const double peak = trapezoid_of(pieces_.at(how.piece), how.start2, how.end2).peak;
      if (peak * peak > std::max(how.start2, how.end2)) point(how.start_s + 0.5 * how.duration_s, peak);
    }
    if (!(how.end2 > 0.0)) point(how.start_s + how.duration_s, 0.0);
  }
  return true;
}

void Timing::Work::count_stall(const Row& row, const Ran& how) {
  if (report_.stalls++ == 0) {
    report_.first_stall_line = row.line;
    report_.first_stall_at_s = how.start_s - how.waited_s;
  }
  report_.standstill_s += how.waited_s;
  if (how.waited_s > report_.longest_stall_s) {
    report_.longest_stall_s = how.waited_s;
    report_.longest_stall_line = row.line;
  }
  const double lost_s = how.waited_s + how.lost_s;
  report_.findings.add(text::DiagnosticId::line_starves, {0, row.line, 0}, lost_s, 0.0,
                       [&] { return std::vector<std::string>{text::format_fixed(lost_s, 3)}; });
}

Report Timing::Work::finish() {
  run_rest();
  if (report_.is_fed) {
    report_.line_s = supply_.latency_s + static_cast<double>(intake_.all_bytes()) * supply_.char_s +
                     static_cast<double>(settings_.line_bytes.size()) * supply_.line_delay_s;
  }
  stretches_.finish();
  report_.stretches = stretches_.list();
  report_.stretch_count = stretches_.count();
  report_.course = course_.points();
  report_.limited_s = stretches_.sums_s();
  report_.cycle_s = execution_.end_s();
  report_.stall_s = std::max(0.0, report_.standstill_s + ran_s_ - report_.motion_s);
  if (keeps_whole_ && report_.stalls > 0) {
    report_.advice = advise({rows_, pieces_, feed_mm_s_, limit_mm_s_}, supply_, settings_.line,
                            settings_.machine.timing.look_ahead_blocks, settings_.threads);
  }
  return std::move(report_);
}

Timing::Timing(Settings settings) : work_(std::make_unique<Work>(std::move(settings))) {}
Timing::~Timing() = default;

void Timing::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) {
    if (checks::has_places(motion)) [[likely]]
      work_->add(motion);
    else
      work_->leave_out(motion);
  }
}

Report Timing::finish() { return work_->finish(); }

}  // namespace dripfeed::timing
