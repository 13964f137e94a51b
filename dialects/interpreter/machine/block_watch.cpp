// Each finding once: of a tool, of a feed, of a cycle.
#include "dialects/interpreter/machine/block_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dialects/ir/cycle.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;
using text::DiagnosticId;

constexpr std::size_t kZ = 2;
constexpr double kSame_mm = 1e-9;
// Beyond any cut, and below any feed of a lathe that turns.
constexpr double kHighestPerRev_mm = 10.0;
constexpr double kLowestPerMin_mm = 1.0;

bool is_tap(ir::DrillCycle cycle) { return cycle == ir::DrillCycle::tap_right || cycle == ir::DrillCycle::tap_left; }

// As people read it: 4 decimals at most.
std::string figure(double value) { return text::format_shortest(std::round(value * 1e4) / 1e4); }

}  // namespace

void BlockWatch::look_at(const Instruction& i, const PlainBlock& block, bool moved) {
  take_tool(block);
  if (moved) {
    length(i, block);
    cut(i, block);
    feed(i, block);
  }
  if (state_.drilling.active && has_code(block, Function::drill)) hole(i, block);
}

void BlockWatch::take_tool(const PlainBlock& block) {
  for (const PlainCode& code : block.codes) feed_mode_stated_ |= code.group == ir::ModalGroup::feed;
  if (state_.tool.number != tool_) {
    tool_ = state_.tool.number;
    length_known_ = tool_ != 0;
    // Mills stop the spindle to change the tool.
    if (control_.kind == ir::MachineKind::mill) spindle_known_ = tool_ != 0;
    reported_length_ = reported_spindle_ = false;
  }
  spindle_ran_ |= state_.spindle != ir::SpindleState::stopped;
  if ((block.present & bit_of(Address::t)) != 0) selected_ = static_cast<std::int32_t>(block.at(Address::t));
  // M13, say, starts it with the coolant, and a builder's M100 may change tools.
  spindle_known_ &= !has_code(block, Function::machine_function);
  // A spindle of a lathe that is turned as an axis stands, and the tool that cuts then has a drive of its own.
  if (control_.kind == ir::MachineKind::lathe && ((block.present | block.unknown) & bit_of(Address::c)) != 0)
    spindle_known_ = false;
  const bool other_length = std::ranges::any_of(block.codes, [](const PlainCode& c) {
    return c.group == ir::ModalGroup::length_offset && c.function == Function::not_modelled;
  });
  if (other_length || (block.unknown & (bit_of(Address::h) | bit_of(Address::t))) != 0) length_known_ = false;
}

// Moves along the spindle in the part's coordinates need the tool length that was changed in.
void BlockWatch::length(const Instruction& i, const PlainBlock& block) {
  if (control_.kind != ir::MachineKind::mill || !length_known_ || reported_length_) return;
  if ((block.present & bit_of(Address::z)) == 0 || has_code(block, Function::machine_coordinates)) return;
  const bool none = state_.length_offset == ir::LengthOffset::off || state_.length_offset_number == 0;
  if (none) {
    if (!control_.semantics.length_needs_code) return;
    report_.say(i, DiagnosticId::length_offset_missing, {"Z", "T" + std::to_string(tool_)});
  } else if (static_cast<std::int32_t>(state_.length_offset_number) != tool_) {
    report_.say(i, DiagnosticId::length_offset_of_other_tool,
                {std::to_string(state_.length_offset_number), "T" + std::to_string(tool_), ""});
  } else {
    return;
  }
  reported_length_ = true;
}

// On mills in moves across the spindle: straight down, G01 positions as often as not. On lathes until the spindle has
// turned once: later on it stands while a bar is pulled.
void BlockWatch::cut(const Instruction& i, const PlainBlock& block) {
  const Function motion = state_.modes.motion;
  const bool cuts = motion == Function::linear || motion == Function::arc_cw || motion == Function::arc_ccw;
  const bool is_lathe = control_.kind == ir::MachineKind::lathe;
  const std::uint64_t letters = bit_of(Address::x) | bit_of(is_lathe ? Address::z : Address::y);
  if (control_.kind != ir::MachineKind::mill && !is_lathe) return;
  if (!spindle_known_ || !cuts || (block.present & letters) == 0 || state_.drilling.active) return;
  if (has_code(block, Function::machine_coordinates)) return;
  if (tool_ == 0) return selected(i);
  if (state_.spindle == ir::SpindleState::stopped) {
    if (state_.spindles.any_turns()) return;  // it drives the tool
    if (state_.speed_unknown) return;         // a caller's
    if ((!is_lathe || !spindle_ran_) && !std::exchange(reported_spindle_, true))
      report_.say(i, DiagnosticId::spindle_not_turning);
    return;
  }
  const bool has_speed = state_.speed_unknown || state_.rpm != 0.0 || state_.surface_speed_m_min != 0.0;
  if (!has_speed && !std::exchange(reported_speed_, true))
    report_.count({.name = "the speed of the spindle (S), which the program does not state", .is_input = true});
}

void BlockWatch::selected(const Instruction& i) {
  if (!control_.semantics.change_needs_code || selected_ == 0 || std::exchange(reported_selected_, true)) return;
  report_.warn(i, DiagnosticId::tool_not_called, {}, "T" + std::to_string(selected_) + " is not changed in by M06");
}

void BlockWatch::feed(const Instruction& i, const PlainBlock& block) {
  if (!feed_mode_stated_ || state_.feed_unknown || !(state_.feed > 0.0) || state_.feed == reported_feed_) return;
  const Function motion = state_.modes.motion;
  const bool drills = state_.drilling.active && !is_tap(state_.drilling.cycle);
  if (!drills && motion != Function::linear && motion != Function::arc_cw && motion != Function::arc_ccw) return;
  const bool turns = (block.present & (bit_of(Address::a) | bit_of(Address::b) | bit_of(Address::c))) != 0;
  if (state_.modes.feed_mode == ir::FeedMode::per_rev && state_.feed > kHighestPerRev_mm) {
    report_.say(i, DiagnosticId::feed_suspicion, {figure(state_.feed) + " mm", "revolution"});
  } else if (state_.modes.feed_mode == ir::FeedMode::per_min && control_.kind == ir::MachineKind::lathe && !turns &&
             state_.feed < kLowestPerMin_mm) {
    report_.say(i, DiagnosticId::feed_suspicion, {figure(state_.feed) + " mm", "minute"});
  } else {
    return;
  }
  reported_feed_ = state_.feed;
}

// On mills; a lathe's R is left out as often as not.
void BlockWatch::hole(const Instruction& i, const PlainBlock& block) {
  const Drilling& d = state_.drilling;
  const bool not_known = (block.unknown & (bit_of(Address::z) | bit_of(Address::r))) != 0;
  if (control_.kind != ir::MachineKind::mill || !d.entered || d.axis != kZ || not_known) return;
  if (d.cycle == ir::DrillCycle::back_bore || !d.has_depth) return;
  if (!d.has_r) {
    report_.say(i, DiagnosticId::hole_levels, {"has no R: the feed begins at the level where the cycle was called"});
    return;
  }
  const bool above = d.depth_by_distance ? d.depth > kSame_mm : !d.r_by_distance && d.depth > d.r + kSame_mm;
  if (!above) return;
  const std::string r = d.r_by_distance ? "above its R" : "above its R " + figure(d.r);
  report_.say(i, DiagnosticId::hole_levels, {"ends at Z " + figure(d.depth) + ", " + r});
}

}  // namespace dripfeed::interpreter
