// A cycle where its levels are numbers and the tool stands where it would begin; otherwise its moves one by one.
#include "dialects/macro_b/writer/hole_writer.h"

#include "dialects/facts/needs.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::ExpressionId;
using ir::Function;

constexpr double kMsPerSecond = 1000.0;

ir::Code code(Function function) {
  ir::Code c;
  c.function = function;
  return c;
}

// As the number of its M function.
Function spindle_code(int number) {
  return number == 3 ? Function::spindle_cw : number == 4 ? Function::spindle_ccw : Function::spindle_stop;
}

bool drills_by_cycle(const Hole& hole) {
  return hole.cycle == DrillCycle::deep_hole || hole.lead != 0.0 || hole.floats;
}

}  // namespace

bool HoleWriter::fits_modal_cycle(const Hole& hole) const {
  if (!hole.constant || to_.kind != ir::MachineKind::mill || place_.plane() != Function::plane_xy) return false;
  if (hole.lead != 0.0 && !place_.turning().is_known()) return false;
  if (hole.floats && !cutting_direction(hole)) return false;
  if (hole.feed_in != 0.0 || hole.feed_out != 0.0 || hole.spindle != 0) return false;
  const double back = *number(hole.back);
  const double level = *number(hole.level);
  if (*number(hole.depth) >= level) return false;
  return back == level || place_.height() == back;
}

bool HoleWriter::has_moves(const Hole& hole) {
  if (hole.floats && !cutting_direction(hole)) {
    place_.cannot(passes::not_known(hole.name + " where it is not known how the spindle turns"));
    return false;
  }
  if (hole.lead != 0.0 && !place_.turning().is_known()) {
    place_.cannot(passes::not_known(hole.name + " after a feed or speed that is not known"));
    return false;
  }
  if (drills_by_cycle(hole) && (to_.kind != ir::MachineKind::mill || place_.plane() != Function::plane_xy)) {
    place_.cannot(hole.name + " on a lathe or in another plane than G17");
    return false;
  }
  return true;
}

// --- by a cycle

void HoleWriter::write_hole(const Hole& hole) {
  write_cycle(hole, false, false);
  emit_code(Function::cycle_off);
  end_hole(hole);
}

void HoleWriter::end_hole(const Hole& hole) {
  turn_again(hole);
  motion_again(true);
  place_.leave_at(number(hole.back));
}

void HoleWriter::end_modal(const Hole& hole) {
  emit_code(Function::cycle_off);
  emit_code(Function::rapid);
  turn_again(hole);
}

// `modal`: the holes follow (K0); otherwise one is drilled here. `to_level`: it ends there (G99).
void HoleWriter::write_cycle(const Hole& hole, bool modal, bool to_level) {
  state_distance();
  DrillCycle cycle = hole.cycle;
  if (hole.floats && cutting_direction(hole) == Function::spindle_ccw) cycle = DrillCycle::tap_left;
  if (hole.breaks_chips) {
    cycle = DrillCycle::chip_break;
    place_.warn("the retract between the pecks at the feed, which G73 makes at rapid,");
  }
  if (hole.pecks_below_level) place_.warn("pecks from the reference plane, which a cycle here counts from R,");
  ir::Code drill = code(Function::drill);
  drill.argument = ir::drill_argument(cycle);
  std::vector<ir::Word> words = {absolute(Address::z, hole.depth), absolute(Address::r, hole.level)};
  if (hole.peck > 0.0) words.push_back(word(Address::q, constant(hole.peck)));
  if (hole.dwell_s > 0.0) words.push_back(word(Address::p, whole(hole.dwell_s * kMsPerSecond)));
  if (modal) words.push_back(word(Address::k, whole(0.0)));
  if (hole.lead != 0.0) add_tap(hole, drill, words);
  const std::optional<double> back = number(hole.back);
  to_level |= back && back == number(hole.level);
  out_.emit_block({code(to_level ? Function::return_to_r : Function::return_to_initial), drill}, words);
}

void HoleWriter::add_tap(const Hole& hole, ir::Code& drill, std::vector<ir::Word>& words) {
  const Turning& turning = place_.turning();
  const bool per_turn = turning.feed_mode == Function::feed_per_rev;
  if (hole.floats) {
    words.push_back(word(Address::f, constant(per_turn ? hole.lead : hole.lead * *turning.speed)));
    return;
  }
  out_.emit_block({}, {word(Address::s, whole(hole.speed))});
  words.push_back(
      word(Address::f, constant(per_turn || passes::feeds_taps_by_lead(to_) ? hole.lead : hole.lead * hole.speed)));
  passes::add_rigid(program_, to_, drill, words, out_);
}

// Speed and feed were the tap's own there; they are modal here.
void HoleWriter::turn_again(const Hole& hole) {
  if (hole.lead == 0.0 && !hole.floats) return;
  const Turning& turning = place_.turning();
  const Function after = spindle_code(hole.after);
  place_.leave_turning(hole.after == 5 ? std::nullopt : std::optional(after));
  if (hole.lead == 0.0) return emit_code(after);
  out_.emit_block({code(after)}, {word(Address::s, whole(*turning.speed)), word(Address::f, constant(*turning.feed))});
}

std::optional<Function> HoleWriter::cutting_direction(const Hole& hole) const {
  if (hole.reversed != 0) return hole.reversed == 4 ? Function::spindle_cw : Function::spindle_ccw;
  return place_.turning().spindle;
}

// --- by moves

void HoleWriter::write_moves(const Hole& hole) {
  if (drills_by_cycle(hole)) return write_by_cycle(hole);
  state_distance();
  const PlaneAxes axes = axes_of(place_.plane());
  cut(hole, axes.normal);
  draw_out(hole, axes);
  motion_again(false);
  place_.leave_at(number(hole.back));
}

// Where the initial level of G98 is no RTP, it ends at the level, and goes on to RTP.
void HoleWriter::write_by_cycle(const Hole& hole) {
  if (number(hole.back) && place_.height() == number(hole.back)) return write_hole(hole);
  write_cycle(hole, false, true);
  emit_code(Function::cycle_off);
  out_.emit_block({code(Function::rapid)}, {absolute(Address::z, hole.back)});
  end_hole(hole);
}

void HoleWriter::cut(const Hole& hole, Address axis) {
  if (hole.spindle != 0) {
    place_.leave_turning(std::nullopt);  // it ends stopped
    emit_code(spindle_code(hole.spindle));
  }
  out_.emit_block({code(Function::rapid)}, {absolute(axis, hole.level)});
  std::vector<ir::Word> in = {absolute(axis, hole.depth)};
  if (hole.feed_in > 0.0) in.push_back(feed(hole.feed_in));
  out_.emit_block({code(Function::linear)}, in);
  if (hole.dwell_s > 0.0) out_.emit_block({code(Function::dwell)}, {word(Address::f, constant(hole.dwell_s))});
}

// Away from the wall at the bottom, up, and over the hole again.
void HoleWriter::draw_out(const Hole& hole, const PlaneAxes& axes) {
  if (hole.spindle != 0) emit_code(hole.orients ? Function::spindle_orient : Function::spindle_stop);
  if (hole.holds) emit_code(Function::program_stop);
  shift(hole, axes, 1.0, hole.lift);
  if (hole.cycle == DrillCycle::feed_out || hole.cycle == DrillCycle::feed_out_dwell) {
    std::vector<ir::Word> out = {absolute(axes.normal, hole.level)};
    if (hole.feed_out > 0.0) out.push_back(feed(hole.feed_out));
    out_.emit_block({code(Function::linear)}, out);
  }
  out_.emit_block({code(Function::rapid)}, {absolute(axes.normal, hole.back)});
  shift(hole, axes, -1.0, 0.0);
}

void HoleWriter::shift(const Hole& hole, const PlaneAxes& axes, double sign, double lift) {
  std::vector<ir::Word> words;
  if (hole.shift_first != 0.0) words.push_back(by(axes.first, sign * hole.shift_first));
  if (hole.shift_second != 0.0) words.push_back(by(axes.second, sign * hole.shift_second));
  if (lift != 0.0) words.push_back(by(axes.normal, lift));
  if (!words.empty()) out_.emit_block({code(Function::rapid)}, words);
}

// --- small parts

HoleWriter::PlaneAxes HoleWriter::axes_of(Function plane) {
  if (plane == Function::plane_zx) return {Address::z, Address::x, Address::y};
  if (plane == Function::plane_yz) return {Address::y, Address::z, Address::x};
  return {Address::x, Address::y, Address::z};
}

void HoleWriter::state_distance() {
  if (const std::optional<Function> distance = place_.state_distance()) emit_code(*distance);
}

void HoleWriter::motion_again(bool always) {
  const std::optional<Function> motion = place_.motion();
  if (motion && (always || *motion != Function::rapid)) emit_code(*motion);
  if (!motion && facts::needs_motion(program_, place_.index()))
    place_.cannot(passes::not_known("the motion code in effect after a cycle, which is not known here,"));
}

void HoleWriter::emit_code(Function function) { out_.emit_block({code(function)}, {}); }

ir::Word HoleWriter::feed(double value) { return word(Address::f, constant(value)); }

ir::Word HoleWriter::absolute(Address address, ExpressionId value) {
  ir::Word w = word(address, value);
  w.mode = ir::WordMode::absolute;
  return w;
}

ir::Word HoleWriter::by(Address axis, double distance) {
  ir::Word w = word(axis, constant(distance));
  w.mode = ir::WordMode::incremental;
  return w;
}

}  // namespace dripfeed::macro_b
