// A tap is found by its two moves: the second one leads back to where the first began. (SINUMERIK PG, "Rigid tapping
// (G331, G332)": SPOS before them, M3 after; "Tapping with compensating chuck (G63)": F is the speed times the lead, a
// minute, and M4 stands in the block of the retract. Fanuc 0i-F B-64604EN-1, "Front tapping cycle (G84), side tapping
// cycle (G88)"; R is a distance from the initial level there.)
#include "dialects/compile/translate/tap_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::Motion;
using ir::MotionKind;
using ir::SpindleState;

constexpr double kSame_mm = 1e-6;

std::unexpected<std::string> cannot(std::string_view what) { return std::unexpected(std::string(what)); }

bool near(const std::array<double, ir::kAxisCount>& a, const std::array<double, ir::kAxisCount>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= kSame_mm; });
}
bool cuts(const Motion& m) { return m.kind == MotionKind::linear || m.kind == MotionKind::thread; }

// mm a turn; 0 where that is not known.
double lead_of(const Motion& m) {
  if (m.kind == MotionKind::thread || m.feed_mode == ir::FeedMode::per_rev) return m.feed;
  const bool known = m.feed_mode == ir::FeedMode::per_min && m.spindle_rpm > 0.0;
  return known ? m.feed / m.spindle_rpm : 0.0;
}

// The only axis of the move; nothing where there are several.
std::optional<std::size_t> axis_of(const Motion& m) {
  std::optional<std::size_t> found;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    if (std::abs(m.end[axis] - m.start[axis]) <= kSame_mm) continue;
    if (found) return std::nullopt;
    found = axis;
  }
  return found;
}

Function function_of(SpindleState state) {
  return state == SpindleState::clockwise          ? Function::spindle_cw
         : state == SpindleState::counterclockwise ? Function::spindle_ccw
                                                   : Function::spindle_stop;
}

}  // namespace

std::expected<std::optional<TapCut>, std::string> tap_at(std::span<const Motion> motions) {
  const Motion& in = motions.front();
  if (!cuts(in)) return std::optional<TapCut>();
  TapCut tap;
  std::size_t next = 1;
  for (; next < motions.size() && !ir::is_move(motions[next].kind); ++next) {
    if (motions[next].kind == MotionKind::dwell)
      tap.dwell_s += motions[next].feed;
    else if (motions[next].kind != MotionKind::spindle)
      return cannot("an event at the bottom of its hole");
  }
  const bool back = next < motions.size() && motions[next].kind == in.kind && near(motions[next].end, in.start);
  if (!back && in.kind == MotionKind::linear) return std::optional<TapCut>();
  if (!back) return cannot("a retract that does not lead back");
  const Motion& out = motions[next];
  const std::optional<std::size_t> axis = axis_of(in);
  if (!axis || (*axis != 0 && *axis != 2)) return cannot("a move along another axis than X or Z");
  const std::uint16_t unknown = in.axes_unknown | out.axes_unknown;
  if ((unknown & (1U << *axis)) != 0 || in.machine_coordinates || ((in.gaps | out.gaps) & ir::kEndUnknown) != 0)
    return cannot("a position that is not known here");
  if (in.surface_speed_m_min != 0.0 || in.spindle_rpm <= 0.0 || in.spindle_rpm != out.spindle_rpm)
    return cannot("a speed that is not known or not the same in and out");
  tap.axis = *axis;
  tap.level = in.start[*axis];
  tap.depth = in.end[*axis];
  tap.lead_mm = lead_of(in);
  if (tap.lead_mm == 0.0 || std::abs(lead_of(out) - tap.lead_mm) > 1e-9 * std::abs(tap.lead_mm))
    return cannot("a lead that is not known or not the same in and out");
  tap.speed_rpm = in.spindle_rpm;
  tap.in = in.spindle;
  tap.out = out.spindle;
  tap.count = next + 1;
  return tap;
}

// Rapids and plain cuts are kept together, so that PlainMoves has what stands next to the first of them.
std::expected<void, std::string> TapMoves::write(std::span<const Motion> motions, BlockRest rest) {
  const std::vector<ir::Code> after = std::exchange(rest.after, {});
  std::vector<Motion> plain;
  const auto flush = [&]() -> std::expected<void, std::string> {
    if (changed_feed_mode_ && std::ranges::any_of(plain, cuts)) return cannot("a cut off its thread");
    return plain_.write(std::exchange(plain, {}), std::exchange(rest, {}));
  };
  // A rigid tap says its speed itself.
  if (rigid_ && !motions.empty()) std::erase_if(rest.words, [](const ir::Word& w) { return w.address == Address::s; });
  if (!motions.empty() && motions.front().kind != MotionKind::spindle) state_ = motions.front().spindle;
  for (std::size_t i = 0; i < motions.size();) {
    const auto tap = tap_at(motions.subspan(i));
    if (!tap) return std::unexpected(tap.error());
    if (!*tap && motions[i].kind != MotionKind::spindle) {
      plain.push_back(motions[i++]);
      continue;
    }
    if (const auto done = flush(); !done) return done;
    if (*tap) {
      if (const auto done = write(**tap); !done) return done;
      i += (*tap)->count;
    } else {
      if (!rigid_) turn(motions[i].spindle, motions[i].spindle_rpm);
      ++i;
    }
  }
  if (const auto done = flush(); !done) return done;
  if (!motions.empty() && state_ != motions.back().spindle) turn(motions.back().spindle, motions.back().spindle_rpm);
  if (changed_feed_mode_) out_.emit_block({code_of(Function::feed_per_rev, ModalGroup::feed)}, {});
  if (!after.empty()) out_.emit_block(after, {});
  return {};
}

std::expected<void, std::string> TapMoves::write(const TapCut& tap) {
  const bool right =
      tap.lead_mm > 0.0 && (rigid_ || (tap.in == SpindleState::clockwise && tap.out == SpindleState::counterclockwise));
  if (!right) return cannot("a thread that is not right-handed, as far as is known here");
  if (terms_.feed_mode == ir::FeedMode::inverse_time) return cannot("feeds as times (G93)");
  if (ir::has_numbered_variables(to_)) return write_cycle(tap);
  rigid_ ? write_rigid(tap) : write_floating(tap);
  return {};
}

// The tool stands at R already, so that the cycle begins and ends there.
std::expected<void, std::string> TapMoves::write_cycle(const TapCut& tap) {
  ir::Code cycle = code_of(Function::drill, ModalGroup::cycle);
  cycle.argument = ir::drill_argument(ir::DrillCycle::tap_right, tap.axis == 0 ? ir::kDrillAlongX : ir::kDrillAlongZ);
  const bool diameter = to_.semantics.power_on_diameter != ir::DiameterMode::radius;
  const double level_mm = tap.axis == 0 && diameter ? tap.level / 2.0 : tap.level;
  std::vector<ir::Word> words = {plain_.position(tap.axis, tap.depth),
                                 length(Address::r, to_.semantics.drill_r_from_initial ? 0.0 : level_mm)};
  words.back().mode = ir::WordMode::absolute;
  if (tap.dwell_s > 0.0) words.push_back(number(Address::p, std::nearbyint(tap.dwell_s * 1000.0)));
  const bool by_lead = terms_.feed_mode == ir::FeedMode::per_rev || (rigid_ && passes::feeds_taps_by_lead(to_));
  const double feed = by_lead ? tap.lead_mm : tap.lead_mm * tap.speed_rpm;
  words.push_back(plain_.feed_word(feed));
  plain_.set_last_feed(feed);
  if (rigid_) {
    out_.emit_block({}, {number(Address::s, tap.speed_rpm)});
    passes::add_rigid(program_, to_, cycle, words, out_);
  }
  std::vector<ir::Code> codes = {cycle};
  const bool has_levels = std::ranges::any_of(
      to_.g_codes, [](const ir::CodeRow& row) { return row.function == Function::return_to_initial; });
  if (has_levels) codes.insert(codes.begin(), code_of(Function::return_to_initial, ModalGroup::return_level));
  out_.emit_block(codes, words);
  out_.emit_block({code_of(Function::cycle_off, ModalGroup::cycle)}, {});
  state_.reset();
  if (!rigid_) state_ = tap.in;
  return {};
}

void TapMoves::write_rigid(const TapCut& tap) {
  feed_per_minute();
  const Address lead = tap.axis == 0 ? Address::i : Address::k;
  out_.emit_block({code_of(Function::spindle_orient, ModalGroup::spindle)}, {});
  out_.emit_block({code_of(Function::tap, ModalGroup::motion)},
                  {plain_.position(tap.axis, tap.depth), length(lead, tap.lead_mm), number(Address::s, tap.speed_rpm)});
  if (tap.dwell_s > 0.0) plain_.dwell(tap.dwell_s);
  out_.emit_block({code_of(Function::tap_retract, ModalGroup::motion)},
                  {plain_.position(tap.axis, tap.level), length(lead, tap.lead_mm)});
  state_.reset();
}

void TapMoves::write_floating(const TapCut& tap) {
  feed_per_minute();
  const double feed = tap.lead_mm * tap.speed_rpm;
  const ir::Code once = code_of(Function::linear, ModalGroup::non_modal);
  out_.emit_block({once}, {plain_.position(tap.axis, tap.depth), length(Address::f, feed)});
  if (tap.dwell_s > 0.0) plain_.dwell(tap.dwell_s);
  out_.emit_block({once, code_of(function_of(tap.out), ModalGroup::spindle)}, {plain_.position(tap.axis, tap.level)});
  state_ = tap.out;
  if (!changed_feed_mode_) plain_.set_last_feed(feed);
}

// After a change of its mode the feed is to be stated again (PG, "Feedrate (G93, G94, G95, F, FGROUP, FL, FGREF)").
void TapMoves::feed_per_minute() {
  if (terms_.feed_mode == ir::FeedMode::per_min || std::exchange(changed_feed_mode_, true)) return;
  out_.emit_block({code_of(Function::feed_per_min, ModalGroup::feed)}, {});
  plain_.set_last_feed(std::nullopt);
}

void TapMoves::turn(SpindleState to, double speed_rpm) {
  std::vector<ir::Word> words;
  if (to != SpindleState::stopped && speed_rpm > 0.0) words.push_back(number(Address::s, speed_rpm));
  out_.emit_block({code_of(function_of(to), ModalGroup::spindle)}, words);
  state_ = to;
}

ir::Word TapMoves::length(Address address, double value_mm) {
  return ir::word(address, program_.add_constant(value_mm / terms_.unit_mm));
}
ir::Word TapMoves::number(Address address, double value) {
  return ir::word(address, program_.add_constant(value, {}, false));
}

}  // namespace dripfeed::compile
