// Levels, pecks, leads and shifts of the other controls' words as the arguments that CYCLE81 to CYCLE88 have for them.
#include "dialects/sinumerik/writer/drill_call.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "dialects/passes/refusal.h"
#include "dialects/sinumerik/tables/called_cycles.h"
#include "dialects/sinumerik/tables/system_variables.h"
#include "dialects/sinumerik/writer/drill_block.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::CycleValue;
using ir::DrillCycle;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;

constexpr std::string_view kStandingSpindle = "a boring cycle whose spindle does not turn, as far as is known here,";

}  // namespace

DrillCall::DrillCall(const Raising& raising, text::Span span, const ir::Block& block, const DrillState& before,
                     const DrillState& after)
    : raising_(raising),
      program_(raising.program),
      span_(span),
      own_(program_.words_of(block)),
      before_(before),
      after_(after),
      inch_(after.inch.value) {}

bool turns_spindle(Function function) { return function == Function::spindle_cw || function == Function::spindle_ccw; }

std::optional<std::uint32_t> DrillCall::make() {
  const auto cycle = static_cast<DrillCycle>(after_.cycle.value);
  called_ = cycle_for(cycle);
  if (called_ == nullptr) return refuse("a boring cycle that shifts the tool at the bottom");
  const std::optional<Levels> at = levels();
  if (!at) return std::nullopt;
  put(CycleValue::return_level, at->back);
  put(CycleValue::surface, at->reference);
  put(CycleValue::depth, at->depth);
  switch (cycle) {
    case DrillCycle::drill_dwell: put(CycleValue::dwell, seconds()); break;
    case DrillCycle::deep_hole:
    case DrillCycle::chip_break:
      if (!pecks(cycle)) return std::nullopt;
      break;
    case DrillCycle::tap_right:
    case DrillCycle::tap_left:
      if (!tap(cycle)) return std::nullopt;
      break;
    case DrillCycle::feed_out_dwell: put(CycleValue::dwell, seconds()); break;
    case DrillCycle::stop_out:
    case DrillCycle::manual_out:
      if (!stops(cycle)) return std::nullopt;
      break;
    case DrillCycle::fine_bore:
      if (!fine_bore(cycle)) return std::nullopt;
      break;
    case DrillCycle::drill:
    case DrillCycle::feed_out:
    case DrillCycle::back_bore:
    case DrillCycle::count_: break;
  }
  ir::Call call;
  call.name = program_.strings.add(called_->name);
  call.cycle = called_;
  call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
  call.argument_count = static_cast<std::uint32_t>(arguments_.size());
  for (const ExpressionId value : arguments_) program_.arguments.push_back({0, value});
  program_.calls.push_back(call);
  return static_cast<std::uint32_t>(program_.calls.size() - 1);
}

std::optional<BackBoring> DrillCall::back_boring() {
  if (!after_.initial.number.known) return refuse(passes::not_known("back boring from a level that is not known here"));
  if (!after_.spindle.known || !turns_spindle(after_.spindle.value)) return refuse(kStandingSpindle);
  const std::optional<Levels> at = levels();
  const std::optional<Shift> shift = at ? shift_aside() : std::nullopt;
  if (!shift) return std::nullopt;
  return BackBoring{.initial = constant(after_.initial.number.value),
                    .level = at->reference,
                    .depth = at->depth,
                    .shift_x = shift->x,
                    .shift_y = shift->y,
                    .dwell_s = seconds(),
                    .spindle = after_.spindle.value};
}

// CYCLE83: FDPR is each peck, without degression; DTD dwells at the last depth; VRT and DIS1 are the distances of the
// other control's parameters.
bool DrillCall::pecks(DrillCycle cycle) {
  if (after_.peck.is(ExpressionId::none)) return refuse("a cycle that drills by pecks without their depth"), false;
  const std::optional<ExpressionId> peck = word(after_.peck, "Q");
  if (!peck) return false;
  const ir::Semantics& from = raising_.from.semantics;
  const bool clears = cycle == DrillCycle::deep_hole;
  put(CycleValue::first_peck, of(Operator::abs, *peck));
  put(CycleValue::removes_chips, constant(clears ? 1.0 : 0.0));
  const double in_units = inch_ ? 1.0 / 25.4 : 1.0;
  if (!clears) put(CycleValue::peck_retract, constant(from.chip_break_retract_mm * in_units));
  const bool of_family = raising_.from.dialect == "family";  // breaks chips as the control does
  if (!clears && !of_family) warn("the retract between the pecks at rapid, which CYCLE83 makes at the feed,");
  const ExpressionId dwell = seconds();
  if (dwell != ExpressionId::none) put(CycleValue::last_dwell, dwell);
  if (clears) put(CycleValue::peck_clearance, constant(from.peck_clearance_mm * in_units));
  return true;
}

// CYCLE84: the lead is the feed of a turn; the spindle turns again after it as it did before.
bool DrillCall::tap(DrillCycle cycle) {
  if (!after_.feed.known || !after_.feed_mode.known || !after_.spindle.known || after_.feed.value == ExpressionId::none)
    return refuse(passes::not_known("a tap whose feed is not known here")), false;
  const bool by_turn = after_.feed_mode.value == Function::feed_per_rev;
  const bool has_speed = after_.speed.known && after_.speed.value != ExpressionId::none;
  if (!by_turn && !has_speed) return refuse(passes::not_known("a tap whose speed is not known here")), false;
  const auto is_number = [&](ExpressionId id) { return program_.at(id).op == Operator::constant; };
  const bool states_speed = has_speed && is_number(after_.speed.value);
  if (!is_number(after_.feed.value) || (!by_turn && !states_speed))
    return refuse(passes::computed("a tap whose feed or speed is computed")), false;
  const double speed = states_speed ? program_.at(after_.speed.value).value : 1.0;
  double lead = program_.at(after_.feed.value).value;
  if (!by_turn) lead /= speed;
  if (!(speed > 0.0) || !(lead > 0.0)) return refuse("a tap without a feed or speed"), false;
  const bool pecks = std::ranges::find(own_, Address::q, &ir::Word::address) != own_.end();
  if (pecks) return refuse("a tap by pecks (Q)"), false;
  put(CycleValue::dwell, seconds());
  const Function spindle = after_.spindle.value;
  put(CycleValue::spindle_after, constant(spindle == Function::spindle_cw    ? 3.0
                                          : spindle == Function::spindle_ccw ? 4.0
                                                                             : 5.0));
  put(CycleValue::lead, constant(cycle == DrillCycle::tap_left ? -lead : lead));
  put(CycleValue::speed, states_speed ? constant(speed) : system_value("$P_S"));
  return true;
}

ExpressionId DrillCall::system_value(std::string_view name) {
  ir::Variable variable;
  variable.bank = ir::Bank::system;
  variable.number = find_system_variable(name);
  return program_.add_variable(variable);
}

// CYCLE86 and CYCLE88 start the spindle themselves and leave it stopped.
bool DrillCall::stops(DrillCycle cycle) {
  if (!after_.spindle.known || !turns_spindle(after_.spindle.value)) return refuse(kStandingSpindle), false;
  if (cycle != DrillCycle::stop_out) put(CycleValue::dwell, seconds());
  put(CycleValue::spindle, constant(after_.spindle.value == Function::spindle_cw ? 3.0 : 4.0));
  return true;
}

// I and J, or Q along a direction that a parameter of the other machine states.
std::optional<DrillCall::Shift> DrillCall::shift_aside() {
  if (!after_.plane.is(Function::plane_xy)) return refuse("a fine boring cycle in another plane than G17");
  Shift shift;
  const auto take = [&](const Fact<ExpressionId>& fact, std::string_view address, ExpressionId& to) {
    if (fact.is(ExpressionId::none)) return true;
    const std::optional<ExpressionId> value = word(fact, address);
    if (value) to = *value;
    return value.has_value();
  };
  const bool by_words = !after_.shift_i.is(ExpressionId::none) || !after_.shift_j.is(ExpressionId::none);
  if (by_words) {
    const bool known = take(after_.shift_i, "I", shift.x) && take(after_.shift_j, "J", shift.y);
    return known ? std::optional(shift) : std::nullopt;
  }
  if (after_.peck.is(ExpressionId::none)) return shift;
  const std::optional<ExpressionId> q = word(after_.peck, "Q");
  if (!q) return std::nullopt;
  shift.x = of(Operator::abs, *q);
  warn(
      passes::by_parameter("the direction of the shift Q, which a machine parameter states and which is taken as X+,"));
  return shift;
}

bool DrillCall::fine_bore(DrillCycle cycle) {
  if (!stops(cycle)) return false;
  const std::optional<Shift> shift = shift_aside();
  if (!shift) return false;
  put(CycleValue::shift_first, shift->x);
  put(CycleValue::shift_second, shift->y);
  return true;
}

void DrillCall::put(CycleValue which, ExpressionId value) {
  const std::size_t place = ir::place_of(*called_, which);
  if (value == ExpressionId::none || place == ir::kNoPlace) return;
  if (arguments_.size() <= place) arguments_.resize(place + 1, ExpressionId::none);
  arguments_[place] = value;
}

// P in milliseconds.
ExpressionId DrillCall::seconds() {
  if (after_.dwell.is(ExpressionId::none)) return ExpressionId::none;
  const std::optional<ExpressionId> written = carried(after_.dwell, "P");
  if (!written) return ExpressionId::none;
  const ir::Expression& e = program_.at(*written);
  if (e.op == Operator::constant) return constant(e.value / 1000.0);
  return of(Operator::divide, *written, constant(1000.0));
}

// --- levels

std::optional<DrillCall::Levels> DrillCall::levels() {
  if (after_.depth.is(ExpressionId::none)) return refuse("a drilling cycle without a depth");
  if (!after_.to_level.known)
    return refuse(passes::not_known("a return level (G98 or G99) that is not the same on all control-flow paths"));
  const std::optional<ExpressionId> z = word(after_.depth, "Z");
  if (!z) return std::nullopt;
  const bool no_level = after_.level.is(ExpressionId::none);
  std::optional<ExpressionId> r;
  if (!no_level) r = word(after_.level, "R");
  if (!no_level && !r) return std::nullopt;
  if (!after_.depth_by_distance.known || (!no_level && !after_.level_by_distance.known))
    return refuse(
        passes::not_known("a cycle whose words are absolute on one control-flow path and incremental on another"));
  const bool needs_initial = no_level || after_.level_by_distance.value || !after_.to_level.value;
  ExpressionId initial = ExpressionId::none;
  if (needs_initial) {
    initial = initial_level();
    if (initial == ExpressionId::none)
      return refuse(passes::not_known("the level where the drilling cycle began, not known here,"));
  }
  Levels levels;
  levels.reference = no_level ? initial : after_.level_by_distance.value ? sum(initial, *r) : *r;
  levels.depth = after_.depth_by_distance.value ? sum(levels.reference, *z) : *z;
  levels.back = after_.to_level.value ? levels.reference : initial;
  const ir::Expression& bottom = program_.at(levels.depth);
  const ir::Expression& top = program_.at(levels.reference);
  const bool upward = bottom.op == Operator::constant && top.op == Operator::constant && bottom.value > top.value;
  if (upward && !after_.cycle.is(kBackBore)) return refuse(passes::of_shape("a hole that is drilled upward"));
  return levels;
}

// A number where it is known; otherwise where the tool stands, when that is the level.
ExpressionId DrillCall::initial_level() {
  if (after_.initial.number.known) return constant(after_.initial.number.value);
  if (after_.initial.name.known) {
    ir::Variable named;
    named.bank = ir::Bank::named;
    named.symbol = after_.initial.name.value;
    return program_.add_variable(named);
  }
  const bool enters = before_.cycle.is(DrillState::kNone);
  if (!enters && !before_.at_initial.is(true)) return ExpressionId::none;
  ir::Variable place;
  place.bank = ir::Bank::system;
  place.number = find_system_variable("$P_EP");
  const Address axis = drilling_axis(after_.plane.value);
  place.index = constant(axis == Address::x ? 0.0 : axis == Address::y ? 1.0 : 2.0);
  return program_.add_variable(place);
}

// A word of the cycle in units of the program. What an earlier block computed may be another value by now.
std::optional<ExpressionId> DrillCall::word(const Fact<ExpressionId>& fact, std::string_view address) {
  const std::optional<ExpressionId> written = carried(fact, address);
  if (!written) return std::nullopt;
  const ir::Expression& e = program_.at(*written);
  const bool counts = raising_.from.semantics.decimal_mode == ir::DecimalMode::least_increment;
  if (e.op != Operator::constant || e.has_point || !counts) return written;
  const double increment = raising_.from.semantics.least_increment_mm;
  return constant(e.value / std::nearbyint(inch_ ? 10.0 / increment : 1.0 / increment));
}
std::optional<ExpressionId> DrillCall::carried(const Fact<ExpressionId>& fact, std::string_view address) {
  if (!fact.known) {
    raising_.report(text::DiagnosticId::unknown_modal_state, span_,
                    {std::string(address) + " of the drilling cycle", std::string(kTwoPaths)});
    return std::nullopt;
  }
  const bool written_here = std::ranges::find(own_, fact.value, &ir::Word::value) != own_.end();
  if (written_here || program_.at(fact.value).op == Operator::constant) return fact.value;
  return refuse(passes::computed(std::string(address) + " of the drilling cycle, computed in an earlier block,"));
}

// --- small parts

std::nullopt_t DrillCall::refuse(passes::Refusal what) {
  raising_.cannot(std::move(what), span_);
  return std::nullopt;
}

// What is written so all the same.
void DrillCall::warn(passes::Refusal what) {
  raising_.cannot(std::move(what), span_);
  raising_.diagnostics.back().severity = text::Severity::warning;
}

ExpressionId DrillCall::constant(double value) { return program_.add_constant(value, {}, false); }
ExpressionId DrillCall::of(Operator op, ExpressionId a, ExpressionId b) {
  const ir::Expression& e = program_.at(a);
  if (op == Operator::abs && e.op == Operator::constant) return constant(std::abs(e.value));
  return program_.add_operator(op, a, b);
}
ExpressionId DrillCall::sum(ExpressionId a, ExpressionId b) {
  const ir::Expression& left = program_.at(a);
  const ir::Expression& right = program_.at(b);
  if (left.op == Operator::constant && right.op == Operator::constant) return constant(left.value + right.value);
  return program_.add_operator(Operator::add, a, b);
}

}  // namespace dripfeed::sinumerik
