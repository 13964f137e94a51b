// The path is followed from place to place: each foot is sought from the one before. The distance of a place from a
// curve changes no more than the place moves, so a foot that is farther than that has been lost, and is sought again;
// so is one that is beyond the tolerance, because at a cusp the path may have gone on along another branch.
#include "checks/accuracy/plane_accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "checks/arcs.h"
#include "dialects/curves/gap.h"
#include "dialects/text/number.h"

namespace dripfeed::accuracy {

namespace {

constexpr double kSamePlace_mm = 1e-6;
constexpr double kSameFoot_mm = 1e-9;
constexpr std::size_t kMostPassed = 1U << 18U;
constexpr int kGapPoints = 64;         // of a gap, that are compared with the whole path
constexpr std::size_t kMostGaps = 64;  // that are
constexpr double kJoin_mm = 0.01;      // ends of a contour that are given in hundredths meet
constexpr double kShort_mm = 0.25;
constexpr double kPieceLength_mm = 1.0;
constexpr int kMostPlaces = 128;
constexpr int kSearchPieces = 256;  // of a curve, where a foot is sought anywhere
constexpr double kSmallCorner_mm = 1e-7;
constexpr int kEndSteps = 30;

curves::PathPiece piece_of(const ir::Motion& motion) {
  const curves::Point start{motion.start[0], motion.start[1]};
  const curves::Point end{motion.end[0], motion.end[1]};
  if (!checks::is_arc(motion)) return curves::Segment{start, end};
  const curves::Point center = start + curves::Point{motion.center[0], motion.center[1]};
  const auto turn = motion.kind == ir::MotionKind::arc_ccw ? curves::Turn::counterclockwise : curves::Turn::clockwise;
  return curves::arc_between(start, end, center, turn);
}

// "" for a cutting move that can be measured.
std::string_view why_unmeasured(const ir::Motion& motion) {
  if (!checks::has_places(motion)) return "a cutting move leads beyond 1000 km";
  if ((motion.axes_unknown & 3U) != 0) return "a cutting move starts at a position that is not known";
  if ((motion.gaps & ir::kFrameLost) != 0)
    return "a cut in a swivelled plane or under a transformation was not measured";
  if (checks::is_turned(motion)) return "a cut with a turned rotary axis was not measured";
  if (checks::is_arc(motion) && motion.plane != ir::Plane::xy) return "an arc lies in another plane than x-y";
  return {};
}

int places_of(double length) {
  if (length < kShort_mm) return 2;
  const double wanted = std::ceil(length / kPieceLength_mm);
  return wanted >= kMostPlaces ? kMostPlaces : std::max(4, 2 * static_cast<int>(std::ceil(0.5 * wanted)));
}

std::vector<std::string> value_place_limit(const curves::Extreme& worst) {
  return {text::format_fixed(worst.value, 4),
          fmt::format("x {} y {}", text::format_fixed(worst.at.z, 3), text::format_fixed(worst.at.x, 3)),
          text::format_shortest(worst.tolerance)};
}

// Whether ends of the nominal are one place of a contour.
bool joins(curves::Point a, curves::Point b) { return curves::distance(a, b) < kJoin_mm; }

void include(curves::Deviation& deviation, const curves::Extreme& here) {
  if (deviation.points++ == 0) deviation.highest = deviation.lowest = here;
  if (here.value > deviation.highest.value) deviation.highest = here;
  if (here.value < deviation.lowest.value) deviation.lowest = here;
}

}  // namespace

PlaneAccuracy::PlaneAccuracy(PlaneSettings settings)
    : settings_(std::move(settings)), covered_(settings_.nominal.size()) {
  report_.in_plane = true;
  for (const PlaneNominal& one : settings_.nominal) {
    const curves::Point low = one.curve.at(one.curve.t.low).point;
    const curves::Point high = one.curve.at(one.curve.t.high).point;
    closed_.push_back(curves::distance(low, high) < kSamePlace_mm);
    for (const curves::Point end : {low, high}) {
      const bool again = std::ranges::any_of(ends_, [&](const End& other) { return joins(end, other.at); });
      for (End& other : ends_) other.joined = other.joined || joins(end, other.at);
      ends_.push_back({end, again});
    }
  }
}

void PlaneAccuracy::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) {
    if (motion.kind == ir::MotionKind::tool) {
      const auto tool = std::ranges::find(settings_.tools, motion.number, &checks::Tool::number);
      radius_known_ = tool != settings_.tools.end() && tool->diameter_mm > 0.0;
      radius_ = radius_known_ ? 0.5 * tool->diameter_mm : 0.0;
    }
    if (settings_.nominal.empty() || !is_profile(motion, settings_.lines)) continue;
    if (const std::string_view why = why_unmeasured(motion); !why.empty()) {
      report_.not_checked.add(why, motion.place.line);
      report_.has_unmeasured_cuts = true;
    } else {
      add_move(motion);
    }
  }
}

// Arcs in parts of less than a quarter turn, so that both ends of each show which part of a curve lies next to it.
void PlaneAccuracy::add_move(const ir::Motion& motion) {
  const curves::PathPiece piece = piece_of(motion);
  if (!(curves::length_of(piece) > 0.0)) return;  // a plunge
  ++report_.blocks;
  last_place_ = motion.place;
  compensated_ = motion.comp != ir::CompSide::off;
  if (passed_.size() < kMostPassed) passed_.push_back(piece);
  add_corner(motion, curves::point_at(piece, 0.0), curves::direction_at(piece, 0.0));
  int parts = 1;
  if (const auto* arc = std::get_if<curves::Arc>(&piece)) {
    parts = 1 + static_cast<int>(std::fabs(arc->sweep) / (0.45 * std::numbers::pi));
  }
  for (int i = 0; i < parts; ++i) {
    const double from = static_cast<double>(i) / parts;
    add_piece(motion, parts == 1 ? piece : curves::part_of(piece, from, static_cast<double>(i + 1) / parts));
  }
  heading_ = curves::direction_at(piece, 1.0);
}

PlaneAccuracy::Side PlaneAccuracy::side_of(const ir::Motion& motion, const PlaneNominal& nominal) {
  if (motion.comp == ir::CompSide::left) return {0.0, -1.0};
  if (motion.comp == ir::CompSide::right || nominal.of_center) return {0.0, 1.0};
  if (radius_known_) return {radius_, 1.0};
  surface_known_ = false;
  report_.not_checked.add("the tool's diameter is not known: it was taken as a point", motion.place.line);
  return {0.0, 1.0};
}

PlaneAccuracy::Place PlaneAccuracy::place_of(curves::Point at, const Place* near, double step_mm) const {
  Place place{at, 0, {}, false};
  bool found = false;
  double followed = 1e300;
  if (near != nullptr) {
    place.curve = near->curve;
    place.foot = curves::closest_from(settings_.nominal[near->curve].curve, at, near->foot.t);
    const double lost = std::fabs(near->foot.distance) + step_mm * 1.0001 + 1e-9;
    const PlaneNominal& nominal = settings_.nominal[place.curve];
    const double off = std::fabs(std::fabs(place.foot.distance) - expected(nominal));
    found = place.foot.settled && std::fabs(place.foot.distance) <= lost && !place.foot.at_end &&
            off <= nominal.tolerance_mm;
    if (place.foot.settled) followed = std::fabs(place.foot.distance);
  }
  for (std::size_t i = 0; !found && i < settings_.nominal.size(); ++i) {
    const curves::ParametricFoot foot = curves::closest(settings_.nominal[i].curve, at, kSearchPieces);
    if ((i == 0 && near == nullptr) || std::fabs(foot.distance) < std::fabs(place.foot.distance)) {
      place.curve = i;
      place.foot = foot;
      place.sought = near != nullptr && std::fabs(foot.distance) < followed - kSameFoot_mm;
    }
  }
  // A closed curve has no ends to lie beyond.
  const double least = 1e-9 + 1e-7 * std::fabs(place.foot.distance);
  place.on = !place.foot.at_end || closed_[place.curve] || place.foot.overhang <= least;
  return place;
}

double PlaneAccuracy::value_of(const Place& place, curves::Point direction, const Side& side) const {
  const double size = std::fabs(place.foot.distance);
  if (side.offset_mm > 0.0) return size - side.offset_mm;
  // To the left of the path: the nominal lies where, seen by the tool, there still is material or no more.
  const double nominal_left = curves::cross(direction, place.foot.point - place.at) >= 0.0 ? 1.0 : -1.0;
  return side.left * nominal_left * size;
}

// In a corner that is hollow towards the material a cutter leaves what its radius cannot reach.
void PlaneAccuracy::add_corner(const ir::Motion& motion, curves::Point at, curves::Point direction) {
  const bool joins = last_ && heading_ && curves::distance(last_->at, at) < kSamePlace_mm;
  if (!joins || motion.comp == ir::CompSide::off || !radius_known_) return;
  const double turn = curves::cross(*heading_, direction);
  const bool hollow = motion.comp == ir::CompSide::left ? turn > 0.0 : turn < 0.0;
  const double cosine = curves::dot(*heading_, direction);
  if (!hollow || !(cosine > -0.999)) return;
  const double left = radius_ * (std::sqrt(2.0 / (1.0 + std::min(1.0, cosine))) - 1.0);
  if (left < kSmallCorner_mm || !last_->on) return;
  curves::Deviation deviation;
  include(deviation, {left, at, settings_.nominal[last_->curve].tolerance_mm});
  surface_.add(deviation, motion.place.line);
  judge(deviation, motion.place);
}

void PlaneAccuracy::add_piece(const ir::Motion& motion, const curves::PathPiece& piece) {
  const double length = curves::length_of(piece);
  const int count = places_of(length);
  const double step = length / count;
  const curves::Point start = curves::point_at(piece, 0.0);
  const bool joins = last_ && curves::distance(last_->at, start) < kSamePlace_mm;
  Place here = joins ? *last_ : place_of(start, nullptr, 0.0);
  Place first = here;
  Visit last{0.0, here};
  const Side side = side_of(motion, settings_.nominal[first.curve]);
  curves::Deviation deviation;
  std::array<double, kMostPlaces + 1> values{};
  std::array<bool, kMostPlaces + 1> on{};
  for (int i = 0; i <= count; ++i) {
    const double part = static_cast<double>(i) / count;
    Place before = here;
    if (i > 0) here = place_of(curves::point_at(piece, part), &before, step);
    const auto k = static_cast<std::size_t>(i);
    const auto measure = [&](const Place& place, double at) {
      const double value = value_of(place, curves::direction_at(piece, at), side);
      include(deviation, {value, place.at, settings_.nominal[place.curve].tolerance_mm});
      return value;
    };
    on[k] = here.on;
    if (here.on) values[k] = measure(here, part);
    if (!here.on && !is_joined(here)) report_.overrun_mm = std::max(report_.overrun_mm, here.foot.overhang);
    if (i == 0) continue;
    const Visit from{part - 1.0 / count, before};
    const Visit to{part, here};
    if (before.on && here.on && before.curve == here.curve) {
      const bool over_seam = closed_[here.curve] && std::fabs(here.foot.t - before.foot.t) >
                                                        0.5 * settings_.nominal[here.curve].curve.t.width();
      if (here.sought && !over_seam)
        cover(here.curve, {here.foot.t, here.foot.t});
      else
        cover_between(before, here);
      last = to;
      continue;
    }
    // Over the end of a curve, and perhaps on to another: each as far as the path passes it.
    if (before.on) {
      last = last_on(piece, from, part, step);
      measure(last.place, last.part);
      cover_between(before, last.place);
    }
    if (here.on) {
      const Visit entered = last_on(piece, to, from.part, step);
      measure(entered.place, entered.part);
      cover_between(entered.place, here);
      // A join at an end of the piece belongs to the curve that the piece follows.
      if (i == 1 && entered.part * length < kSamePlace_mm) first = entered.place;
      const bool ends_at_join = i == count && before.on && (1.0 - last.part) * length < kSamePlace_mm;
      if (!ends_at_join) last = to;
    } else {
      last = to;
    }
  }
  for (std::size_t i = 0; i + 2 <= static_cast<std::size_t>(count); i += 2) {
    if (!on[i] || !on[i + 1] || !on[i + 2]) continue;
    const double a = std::fabs(values[i]);
    const double b = std::fabs(values[i + 1]);
    const double c = std::fabs(values[i + 2]);
    deviation.length += 2.0 * step;
    deviation.integral += 2.0 * step / 6.0 * (a + 4.0 * b + c);
    deviation.integral_square += 2.0 * step / 6.0 * (a * a + 4.0 * b * b + c * c);
  }
  add_bound(piece, first, last.place, side, deviation.points > 0 ? deviation.largest() : 0.0);
  along_ += length;
  last_ = here;
  path_.add(deviation, motion.place.line);
  surface_.add(deviation, motion.place.line);
  judge(deviation, motion.place);
}

bool PlaneAccuracy::is_joined(const Place& place) const {
  const curves::Range t = settings_.nominal[place.curve].curve.t;
  const bool low = std::fabs(place.foot.t - t.low) < std::fabs(t.high - place.foot.t);
  return place.foot.at_end && ends_[2 * place.curve + (low ? 0 : 1)].joined;
}

PlaneAccuracy::Visit PlaneAccuracy::last_on(const curves::PathPiece& piece, Visit inside, double outside,
                                            double step_mm) const {
  const std::size_t curve = inside.place.curve;
  for (int i = 0; i < kEndSteps; ++i) {
    const double middle = 0.5 * (inside.part + outside);
    const Place tried = place_of(curves::point_at(piece, middle), &inside.place, step_mm);
    if (tried.on && tried.curve == curve)
      inside = {middle, tried};
    else
      outside = middle;
  }
  return inside;
}

void PlaneAccuracy::cover_between(const Place& a, const Place& b) {
  const auto [low, high] = std::minmax(a.foot.t, b.foot.t);
  const curves::Range whole = settings_.nominal[a.curve].curve.t;
  if (closed_[a.curve] && high - low > 0.5 * whole.width()) {  // over the seam
    cover(a.curve, {whole.low, low});
    cover(a.curve, {high, whole.high});
  } else {
    cover(a.curve, {low, high});
  }
}

void PlaneAccuracy::add_bound(const curves::PathPiece& piece, const Place& first, const Place& last, const Side& side,
                              double largest) {
  bound_ = std::max(bound_, largest);
  if (!first.on && !last.on && largest == 0.0) return;  // all of it beyond the curve
  if (first.curve != last.curve) {
    proved_ = false;
    return;
  }
  const curves::ParametricCurve& curve = settings_.nominal[first.curve].curve;
  const auto [low, high] = std::minmax(first.foot.t, last.foot.t);
  const bool over_seam = closed_[first.curve] && high - low > 0.5 * curve.t.width();
  const auto add = [&](curves::Range t) {
    if (!(t.low < t.high)) return;
    const std::optional<curves::Range> range = curves::gap_range(curve, t, piece);
    const bool one_side = range && (side.offset_mm == 0.0 || range->low > 0.0 || range->high < 0.0);
    proved_ = proved_ && one_side;
    if (!one_side) return;
    for (const double gap : {range->low, range->high}) {
      bound_ = std::max(bound_, std::fabs(std::fabs(gap) - side.offset_mm));
    }
  };
  add(over_seam ? curves::Range{curve.t.low, low} : curves::Range{low, high});
  if (over_seam) add({high, curve.t.high});
}

void PlaneAccuracy::judge(const curves::Deviation& deviation, const ir::Place& place) {
  if (deviation.points == 0) return;
  const curves::Extreme& worst =
      deviation.highest.value >= -deviation.lowest.value ? deviation.highest : deviation.lowest;
  trace_.add(along_, worst.value);
  if (settings_.keeps_blocks) report_.of_blocks.push_back({place.ordinal, worst.value});
  const double size = std::fabs(worst.value);
  if (size <= worst.tolerance) return;
  report_.findings.add(text::DiagnosticId::deviation_beyond_tolerance, place, size, worst.tolerance,
                       [&] { return value_place_limit(worst); });
}

void PlaneAccuracy::cover(std::size_t curve, curves::Range t) {
  std::vector<curves::Range>& covered = covered_[curve];
  const auto first = std::ranges::find_if(covered, [&](const curves::Range& one) { return one.high >= t.low; });
  auto last = first;
  for (; last != covered.end() && last->low <= t.high; ++last) {
    t = {std::min(t.low, last->low), std::max(t.high, last->high)};
  }
  covered.insert(covered.erase(first, last), t);
}

bool PlaneAccuracy::is_passed(std::size_t curve, curves::Range t) const {
  const PlaneNominal& nominal = settings_.nominal[curve];
  const double enough = expected(nominal) + nominal.tolerance_mm;
  for (int i = 0; i <= kGapPoints; ++i) {
    const curves::Point at = nominal.curve.at(t.low + t.width() * i / kGapPoints).point;
    const bool near = std::ranges::any_of(passed_, [&](const curves::PathPiece& piece) {
      return std::visit([&](const auto& one) { return curves::distance(one, at) <= enough; }, piece);
    });
    if (!near) return false;
  }
  return true;
}

void PlaneAccuracy::find_gaps() {
  std::size_t compared = 0;
  for (std::size_t i = 0; i < settings_.nominal.size(); ++i) {
    const curves::ParametricCurve& curve = settings_.nominal[i].curve;
    double reached = curve.t.low;
    const auto gap_to = [&](double t) {
      if (!(t > reached)) return;
      const curves::Point from = curve.at(reached).point;
      const curves::Point middle = curve.at(0.5 * (reached + t)).point;
      const curves::Point to = curve.at(t).point;
      const double width = curves::distance(from, middle) + curves::distance(middle, to);
      if (width <= settings_.coverage_mm) return;
      if (compared++ < kMostGaps && is_passed(i, {reached, t})) return;
      report_.gaps.push_back({0.0, width});
      if (report_.has_unmeasured_cuts) return;
      report_.findings.add(text::DiagnosticId::nominal_not_covered, last_place_, width, 0.0, [&] {
        const auto written = [](curves::Point at) {
          return fmt::format("x {} y {}", text::format_fixed(at.z, 3), text::format_fixed(at.x, 3));
        };
        return std::vector<std::string>{written(from), written(to)};
      });
    };
    for (const curves::Range& one : covered_[i]) {
      gap_to(one.low);
      reached = std::max(reached, one.high);
    }
    gap_to(curve.t.high);
  }
  report_.covered = report_.gaps.empty();
  if (report_.has_unmeasured_cuts && !report_.covered) report_.not_checked.add(kCoverageNotChecked);
}

Report PlaneAccuracy::finish() {
  report_.path = path_.result();
  report_.trace = trace_.points();
  if (settings_.nominal.empty()) {
    report_.not_checked.add("no nominal is given: the accuracy was not checked");
    return std::move(report_);
  }
  if (report_.blocks > 0 && surface_known_) report_.surface = surface_.result();
  if (report_.blocks > 0 && proved_) report_.chord_bound_mm = bound_;
  if (report_.blocks > 0 && !proved_) report_.not_checked.add("the chord error is measured, but no bound is proved");
  find_gaps();
  return std::move(report_);
}

}  // namespace dripfeed::accuracy
