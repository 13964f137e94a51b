// Constant surface speed turns fastest at the smallest diameter of a move; across the centre it asks for more than any
// spindle has.
#include "checks/envelope/speeds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dialects/ir/thread_lead.h"
#include "dialects/text/number.h"

namespace dripfeed::envelope {

namespace {

constexpr double kSpeedSlack = 1e-9;           // relative
constexpr double kSmallestDiameter_mm = 0.01;  // taken at the centre, where the speed has no end

bool is_beyond(double value, double limit) { return limit > 0.0 && value > limit * (1.0 + kSpeedSlack); }

double rpm_of(double surface_m_min, double diameter_mm) {
  return 1000.0 * surface_m_min / (std::numbers::pi * diameter_mm);
}

}  // namespace

void Speeds::check_spindle_event(const ir::Motion& event) {
  if (event.surface_speed_m_min > 0.0) return;  // what it comes to depends on the diameter
  check_spindle(event, 0.0);
  const double lowest = settings_.machine.spindle_min_rpm;
  const double rpm = event.spindle_rpm;
  if (event.spindle != ir::SpindleState::stopped && !(rpm > 0.0))
    report_.not_checked.add("the spindle turns at a speed that is not known: it was not checked", event.place.line);
  if (event.spindle == ir::SpindleState::stopped || !(rpm > 0.0) || rpm >= lowest * (1.0 - kSpeedSlack)) return;
  report_.findings.add(text::DiagnosticId::spindle_too_slow, event.place, rpm, lowest,
                       [&] { return std::vector<std::string>{figure(rpm), figure(lowest)}; });
}

void Speeds::check_spindle(const ir::Motion& motion, double diameter_mm) {
  const double highest = settings_.machine.spindle_max_rpm;
  double rpm = motion.spindle_rpm;
  if (motion.surface_speed_m_min > 0.0) {
    if (!(diameter_mm > 0.0)) return;
    const double asked = rpm_of(motion.surface_speed_m_min, diameter_mm);
    if (!(motion.spindle_rpm > 0.0)) {
      report_.spindle_max_rpm = std::max(report_.spindle_max_rpm, asked);
      if (!is_beyond(asked, highest)) return;
      report_.findings.add(text::DiagnosticId::surface_speed_unlimited, motion.place, asked, highest, [&] {
        return std::vector<std::string>{text::format_fixed(asked, 0), figure(diameter_mm), figure(highest)};
      });
      return;
    }
    rpm = std::min(asked, motion.spindle_rpm);
  }
  report_.spindle_max_rpm = std::max(report_.spindle_max_rpm, rpm);
  if (!is_beyond(rpm, highest)) return;
  report_.findings.add(text::DiagnosticId::spindle_too_fast, motion.place, rpm, highest,
                       [&] { return std::vector<std::string>{text::format_fixed(rpm, 0), figure(highest)}; });
}

double Speeds::smallest_diameter_mm(const ir::Motion& cut) const {
  const checks::MachineAxis* x = travel_.axis(0);
  const double factor = x != nullptr && x->is_diameter ? 1.0 : 2.0;
  const bool from_known = (cut.axes_unknown & 1U) == 0;
  const double start_mm = factor * (from_known ? cut.start[0] : cut.end[0]);
  const double end_mm = factor * cut.end[0];
  if (start_mm * end_mm <= 0.0) return kSmallestDiameter_mm;
  return std::max(kSmallestDiameter_mm, std::min(std::fabs(start_mm), std::fabs(end_mm)));
}

double Speeds::feed_of_turns(const ir::Motion& cut, double diameter_mm) {
  double rpm = cut.spindle_rpm;
  if (cut.surface_speed_m_min > 0.0) {
    const double asked = rpm_of(cut.surface_speed_m_min, diameter_mm);
    rpm = rpm > 0.0 ? std::min(asked, rpm) : asked;
    if (settings_.machine.spindle_max_rpm > 0.0) rpm = std::min(rpm, settings_.machine.spindle_max_rpm);
  }
  if (!(rpm > 0.0)) {
    report_.not_checked.add("a feed per revolution has no spindle speed: its feed was not checked", cut.place.line);
  }
  return highest_lead(cut) * rpm;
}

// Of a thread whose lead grows, at its end.
double Speeds::highest_lead(const ir::Motion& cut) const {
  if (cut.kind != ir::MotionKind::thread || !(cut.center[0] > 0.0)) return cut.feed;
  double longest_mm = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    if ((cut.axes_unknown >> i & 1U) == 0)
      longest_mm = std::max(longest_mm, std::fabs(travel_.slide(i, cut.end[i] - cut.start[i])));
  return ir::lead_after(cut.feed, cut.center[0], longest_mm);
}

// Along all axes whose start is known, in a straight line.
double Speeds::distance_mm(const ir::Motion& cut) const {
  double square = 0.0;
  for (std::size_t i = 0; i < ir::kAxisCount; ++i) {
    if ((cut.axes_unknown >> i & 1U) != 0) continue;
    const double travel_mm = travel_.slide(i, cut.end[i] - cut.start[i]);
    square += travel_mm * travel_mm;
  }
  return std::sqrt(square);
}

// Each axis has its share of a straight move; on arcs and where a start is not known no share is.
void Speeds::check_axis_feeds(const ir::Motion& cut, double feed_mm_min) {
  if (cut.kind != ir::MotionKind::linear || (cut.axes_unknown & cut.axes_commanded) != 0) return;
  const double length_mm = distance_mm(cut);
  if (!(length_mm > 0.0)) return;
  for (const checks::MachineAxis& axis : settings_.machine.axes) {
    const auto i = static_cast<std::size_t>(axis.axis);
    if (!(axis.feed_limit_mm_min > 0.0) || (cut.axes_unknown >> i & 1U) != 0) continue;
    const double share = std::fabs(travel_.slide(i, cut.end[i] - cut.start[i])) / length_mm;
    if (!is_beyond(share * feed_mm_min, axis.feed_limit_mm_min)) continue;
    report_.findings.add(
        text::DiagnosticId::axis_feed_too_high, cut.place, share * feed_mm_min, axis.feed_limit_mm_min, [&] {
          return std::vector<std::string>{std::string(1, ir::kAxisLetters[i]),
                                          text::format_fixed(share * feed_mm_min, 0), figure(axis.feed_limit_mm_min)};
        });
  }
}

void Speeds::check_cut(const ir::Motion& cut) {
  const double diameter_mm = smallest_diameter_mm(cut);
  if (cut.spindle != ir::SpindleState::stopped) check_spindle(cut, diameter_mm);
  double feed_mm_min = 0.0;
  switch (cut.feed_mode) {
    case ir::FeedMode::per_min:
      feed_mm_min = cut.feed;
      highest_per_min_ = std::max(highest_per_min_, cut.feed);
      break;
    case ir::FeedMode::per_rev: feed_mm_min = feed_of_turns(cut, diameter_mm); break;
    case ir::FeedMode::inverse_time: feed_mm_min = distance_mm(cut) * cut.feed; break;
  }
  report_.feed_max_mm_min = std::max(report_.feed_max_mm_min, feed_mm_min);
  check_axis_feeds(cut, feed_mm_min);
  const double limit = settings_.machine.feed_limit_mm_min;
  if (!is_beyond(feed_mm_min, limit)) return;
  report_.findings.add(text::DiagnosticId::feed_too_high, cut.place, feed_mm_min, limit,
                       [&] { return std::vector<std::string>{text::format_fixed(feed_mm_min, 0), figure(limit)}; });
}

}  // namespace dripfeed::envelope
