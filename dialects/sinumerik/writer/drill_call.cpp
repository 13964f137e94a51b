// Levels, pecks, leads and shifts of the other controls' words as the arguments that CYCLE81 to CYCLE88 have for them.
#include "dialects/sinumerik/writer/drill_call.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "dialects/sinumerik/tables/system_variables.h"
#include "dialects/sinumerik/writer/drill_block.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;

constexpr std::string_view kStandingSpindle = "a boring cycle whose spindle does not turn, as far as is known here,";
// Places of arguments, behind RTP, RFP, SDIS, DP and DPR; the cycles that have them.
constexpr std::size_t kDwell = 5;         // DTB: CYCLE82, 84 to 86, 88
constexpr std::size_t kPeck = 6;          // FDPR: CYCLE83
constexpr std::size_t kClears = 11;       // VARI
constexpr std::size_t kRetract = 14;      // VRT
constexpr std::size_t kLastDwell = 15;    // DTD
constexpr std::size_t kClearance = 16;    // DIS1
constexpr std::size_t kSpindleTurns = 6;  // SDAC of CYCLE84, SDIR of CYCLE86 and CYCLE88
constexpr std::size_t kLead = 8;          // PIT: CYCLE84
constexpr std::size_t kTapSpeed = 10;     // SST
constexpr std::size_t kShiftX = 7;        // RPA and RPO: CYCLE86
constexpr std::size_t kShiftY = 8;

struct Row {
  DrillCycle cycle;
  std::string_view name;
};
constexpr auto kRows = std::to_array<Row>({
    {DrillCycle::drill, "CYCLE81"},
    {DrillCycle::drill_dwell, "CYCLE82"},
    {DrillCycle::deep_hole, "CYCLE83"},
    {DrillCycle::chip_break, "CYCLE83"},
    {DrillCycle::tap_right, "CYCLE84"},
    {DrillCycle::tap_left, "CYCLE84"},
    {DrillCycle::feed_out, "CYCLE85"},
    {DrillCycle::feed_out_dwell, "CYCLE85"},
    {DrillCycle::stop_out, "CYCLE86"},
    {DrillCycle::manual_out, "CYCLE88"},
    {DrillCycle::fine_bore, "CYCLE86"},
});

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
  const auto row = std::ranges::find(kRows, cycle, &Row::cycle);
  if (row == kRows.end()) return refuse("a boring cycle that shifts the tool at the bottom");
  const std::optional<Levels> at = levels();
  if (!at) return std::nullopt;
  arguments_ = {at->back, at->reference, ExpressionId::none, at->depth};
  switch (cycle) {
    case DrillCycle::drill_dwell: put(kDwell, seconds()); break;
    case DrillCycle::deep_hole:
    case DrillCycle::chip_break:
      if (!pecks(cycle)) return std::nullopt;
      break;
    case DrillCycle::tap_right:
    case DrillCycle::tap_left:
      if (!tap(cycle)) return std::nullopt;
      break;
    case DrillCycle::feed_out_dwell: put(kDwell, seconds()); break;
    case DrillCycle::stop_out:
    case DrillCycle::manual_out:
      if (!stops(cycle)) return std::nullopt;
      break;
    case DrillCycle::fine_bore:
      if (!stops(cycle) || !shift_aside()) return std::nullopt;
      break;
    case DrillCycle::drill:
    case DrillCycle::feed_out:
    case DrillCycle::back_bore:
    case DrillCycle::count_: break;
  }
  ir::Call call;
  call.name = program_.strings.add(row->name);
  call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
  call.argument_count = static_cast<std::uint32_t>(arguments_.size());
  for (const ExpressionId value : arguments_) program_.arguments.push_back({0, value});
  program_.calls.push_back(call);
  return static_cast<std::uint32_t>(program_.calls.size() - 1);
}

std::optional<BackBoring> DrillCall::back_boring() {
  if (!after_.initial.number.known) return refuse("back boring from a level that is not known here");
  if (!after_.spindle.known || !turns_spindle(after_.spindle.value)) return refuse(kStandingSpindle);
  const std::optional<Levels> at = levels();
  arguments_.assign(kShiftY + 1, ExpressionId::none);
  if (!at || !shift_aside()) return std::nullopt;
  return BackBoring{.initial = constant(after_.initial.number.value),
                    .level = at->reference,
                    .depth = at->depth,
                    .shift_x = arguments_[kShiftX],
                    .shift_y = arguments_[kShiftY],
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
  put(kPeck, of(Operator::abs, *peck));
  put(kClears, constant(clears ? 1.0 : 0.0));
  const double in_units = inch_ ? 1.0 / 25.4 : 1.0;
  if (!clears) put(kRetract, constant(from.chip_break_retract_mm * in_units));
  const bool of_family = raising_.from.dialect == "family";  // breaks chips as the control does
  if (!clears && !of_family) tell("the retract between the pecks at rapid, which CYCLE83 makes at the feed,");
  const ExpressionId dwell = seconds();
  if (dwell != ExpressionId::none) put(kLastDwell, dwell);
  if (clears) put(kClearance, constant(from.peck_clearance_mm * in_units));
  return true;
}

// CYCLE84: the lead is the feed of a turn; the spindle turns again behind it as it did before.
bool DrillCall::tap(DrillCycle cycle) {
  if (!after_.feed.known || !after_.feed_mode.known || !after_.spindle.known || after_.feed.value == ExpressionId::none)
    return refuse("a tap whose feed is not known here"), false;
  const bool by_turn = after_.feed_mode.value == Function::feed_per_rev;
  const bool has_speed = after_.speed.known && after_.speed.value != ExpressionId::none;
  if (!by_turn && !has_speed) return refuse("a tap whose speed is not known here"), false;
  const auto is_number = [&](ExpressionId id) { return program_.at(id).op == Operator::constant; };
  const bool says_speed = has_speed && is_number(after_.speed.value);
  if (!is_number(after_.feed.value) || (!by_turn && !says_speed))
    return refuse("a tap whose feed or speed is computed"), false;
  const double speed = says_speed ? program_.at(after_.speed.value).value : 1.0;
  double lead = program_.at(after_.feed.value).value;
  if (!by_turn) lead /= speed;
  if (!(speed > 0.0) || !(lead > 0.0)) return refuse("a tap without a feed or speed"), false;
  const bool pecks = std::ranges::find(own_, Address::q, &ir::Word::address) != own_.end();
  if (pecks) return refuse("a tap by pecks (Q)"), false;
  put(kDwell, seconds());
  const Function spindle = after_.spindle.value;
  put(kSpindleTurns, constant(spindle == Function::spindle_cw ? 3.0 : spindle == Function::spindle_ccw ? 4.0 : 5.0));
  put(kLead, constant(cycle == DrillCycle::tap_left ? -lead : lead));
  put(kTapSpeed, says_speed ? constant(speed) : system_value("$P_S"));
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
  if (cycle != DrillCycle::stop_out) put(kDwell, seconds());
  put(kSpindleTurns, constant(after_.spindle.value == Function::spindle_cw ? 3.0 : 4.0));
  return true;
}
// RPA and RPO of CYCLE86: I and J, or Q along a direction that a parameter of the other machine says.
bool DrillCall::shift_aside() {
  if (!after_.plane.is(Function::plane_xy)) return refuse("a fine boring cycle in another plane than G17"), false;
  const bool by_words = !after_.shift_i.is(ExpressionId::none) || !after_.shift_j.is(ExpressionId::none);
  const auto take = [&](const Fact<ExpressionId>& fact, std::string_view address, std::size_t place) {
    if (fact.is(ExpressionId::none)) return true;
    const std::optional<ExpressionId> value = word(fact, address);
    if (value) put(place, *value);
    return value.has_value();
  };
  if (by_words) return take(after_.shift_i, "I", kShiftX) && take(after_.shift_j, "J", kShiftY);
  if (after_.peck.is(ExpressionId::none)) return true;
  const std::optional<ExpressionId> q = word(after_.peck, "Q");
  if (!q) return false;
  put(kShiftX, of(Operator::abs, *q));
  tell("the direction of the shift Q, which a machine parameter states and which is taken as X+,");
  return true;
}

void DrillCall::put(std::size_t place, ExpressionId value) {
  if (value == ExpressionId::none) return;
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
    return refuse("a return level (G98 or G99) that is not the same on all control-flow paths");
  const std::optional<ExpressionId> z = word(after_.depth, "Z");
  if (!z) return std::nullopt;
  const bool no_level = after_.level.is(ExpressionId::none);
  std::optional<ExpressionId> r;
  if (!no_level) r = word(after_.level, "R");
  if (!no_level && !r) return std::nullopt;
  if (!after_.depth_by_distance.known || (!no_level && !after_.level_by_distance.known))
    return refuse("a cycle whose words are absolute on one control-flow path and incremental on another");
  const bool needs_initial = no_level || after_.level_by_distance.value || !after_.to_level.value;
  ExpressionId initial = ExpressionId::none;
  if (needs_initial) {
    initial = initial_level();
    if (initial == ExpressionId::none) return refuse("the level where the drilling cycle began, not known here,");
  }
  Levels levels;
  levels.reference = no_level ? initial : after_.level_by_distance.value ? sum(initial, *r) : *r;
  levels.depth = after_.depth_by_distance.value ? sum(levels.reference, *z) : *z;
  levels.back = after_.to_level.value ? levels.reference : initial;
  const ir::Expression& bottom = program_.at(levels.depth);
  const ir::Expression& top = program_.at(levels.reference);
  const bool upward = bottom.op == Operator::constant && top.op == Operator::constant && bottom.value > top.value;
  if (upward && !after_.cycle.is(kBackBore)) return refuse("a hole that is drilled upward");
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
                    {std::string(address) + " of the drilling cycle", std::string(kTwoWays)});
    return std::nullopt;
  }
  const bool written_here = std::ranges::find(own_, fact.value, &ir::Word::value) != own_.end();
  if (written_here || program_.at(fact.value).op == Operator::constant) return fact.value;
  return refuse(std::string(address) + " of the drilling cycle, computed in an earlier block,");
}

// --- small parts

std::nullopt_t DrillCall::refuse(std::string_view what) {
  raising_.cannot(std::string(what), span_);
  return std::nullopt;
}

// What is said so all the same.
void DrillCall::tell(std::string_view what) {
  raising_.cannot(std::string(what), span_);
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
