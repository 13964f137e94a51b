// Modal drilling of the other controls as MCALL of the drilling cycles:
//
//   G99 G81 X10. Y10. Z-8. R3. F120.     F120
//   X30.                                 MCALL CYCLE81(3,3,,-8)
//   G80                                  G0 X10 Y10
//                                        G0 X30
//                                        MCALL
//
// RFP is R with no further clearance, RTP is R with G99 and the level where the cycle began with G98: a number where
// one is known, otherwise $P_EP, the programmed place at that block. The hole is the same; pecks go by the distances
// that the other control has in its parameters. What has no cycle with the same bottom is an error at its block.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "dialects/ir/cycle.h"
#include "dialects/passes/rewrite.h"
#include "dialects/sinumerik/back_boring.h"
#include "dialects/sinumerik/drill_block.h"
#include "dialects/sinumerik/drill_state.h"
#include "dialects/sinumerik/raise.h"
#include "dialects/sinumerik/system_variables.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

constexpr std::string_view kTwoWays = "two ways lead to this block and differ";
constexpr double kMostRepeats = 100.0;

// RTP, RFP and DP.
struct Levels {
  ExpressionId back = ExpressionId::none;
  ExpressionId reference = ExpressionId::none;
  ExpressionId depth = ExpressionId::none;
};

class CycleRaiser {
 public:
  explicit CycleRaiser(const Raising& raising)
      : raising_(raising), program_(raising.program), flow_(program_, raising.from), out_(program_) {}

  void run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      const ir::Statement s = program_.statements[i];
      const DrillState* before = flow_.before(i);
      if (s.kind != StatementKind::block || before == nullptr)
        out_.keep();
      else
        block(s, *before);
    }
    out_.finish();
  }

 private:
  void block(const ir::Statement& s, const DrillState& before) {
    const ir::Block block = program_.blocks[s.payload];
    const DrillState after = flow_.after(before, block);
    const bool was = !before.cycle.is(DrillState::kNone);
    const bool is = !after.cycle.is(DrillState::kNone);
    if (!was && !is) return out_.keep();
    statement_ = &s;
    if (block.rest_level != 0) return raising_.cannot("block skip inside a block", s.span);
    if (!after.cycle.known) return undecided(block);
    if (!is) return end(before, block);
    drill(before, after, block);
  }

  // A block that may or may not drill: words of shifts, data and the like never do.
  void undecided(const ir::Block& block) {
    const auto words = program_.words_of(block);
    const bool own_words = std::ranges::any_of(program_.codes_of(block), [](const ir::Code& c) {
      return c.group == ir::ModalGroup::non_modal || c.group == ir::ModalGroup::frame ||
             c.function == Function::data_input || c.function == Function::set_coordinates;
    });
    if (!own_words &&
        std::ranges::any_of(words, [](const ir::Word& w) { return ir::is_axis(w.address) || w.address == Address::r; }))
      raising_.report(text::DiagnosticId::unknown_modal_state, statement_->span,
                      {"the drilling cycle", std::string(kTwoWays)});
    out_.keep();
  }

  void end_modal() {
    out_.emit(StatementKind::modal_call_end, ir::kNoIndex);
    out_.last().span = {};
  }

  // The motion that was in effect before the cycle is again.
  void end(const DrillState& before, const ir::Block& block) {
    if (is_modal(before)) end_modal();
    if (leaves_spindle_stopped(before.cycle)) start_again(before);
    std::vector<ir::Code> codes;
    bool motion = false;
    for (const ir::Code& c : program_.codes_of(block)) {
      if (c.function == Function::cycle_off) continue;
      motion |= c.group == ir::ModalGroup::motion;
      codes.push_back(c);
    }
    const std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    if (!motion && before.motion.known) {
      codes.push_back(motion_code(before.motion.value));
    } else if (!motion) {
      raising_.report(text::DiagnosticId::unknown_modal_state, statement_->span,
                      {"the motion behind the cycle", std::string(kTwoWays)});
    }
    out_.emit_block(codes, words);
  }

  void drill(const DrillState& before, const DrillState& after, const ir::Block& block) {
    if (after.cycle.value >= ir::kDrillAlongZ) return raising_.cannot("a drilling cycle of a lathe", statement_->span);
    if (!after.plane.known)
      raising_.report(text::DiagnosticId::unknown_modal_state, statement_->span,
                      {"the plane of the cycle", std::string(kTwoWays)});
    DrillBlock parts =
        drill_block(raising_, block, drilling_axis(after.plane.value), static_cast<DrillCycle>(after.cycle.value));
    parts.redefines |= changes_tap(before, after);
    if (!parts.begins && parts.positions.empty() && !parts.drills && !parts.redefines) return out_.keep();
    parts.redefines |= parts.begins || !before.to_level.known || before.to_level.value != after.to_level.value;
    if (!parts.rest_codes.empty() || !parts.rest_words.empty()) out_.emit_block(parts.rest_codes, parts.rest_words);
    if (parts.repeats > kMostRepeats)
      return raising_.cannot("a cycle that is repeated " + text::format_shortest(parts.repeats) + " times",
                             statement_->span);
    if (after.cycle.is(kBackBore)) return back_bore(before, after, block, parts);
    if (parts.redefines) {
      const std::optional<std::uint32_t> call = call_of(before, after, block);
      if (!call) return;
      // A modal call would follow the blocks of a call in place, too.
      const bool in_place = parts.drills && parts.positions.empty();
      if (in_place && is_modal(before)) end_modal();
      if (leaves_spindle_stopped(before.cycle) && before.cycle.value != after.cycle.value) start_again(before);
      for (int n = 0; in_place && n < parts.repeats; ++n) out_.emit(StatementKind::call, *call);
      out_.emit(StatementKind::modal_call, *call);
    }
    if (!parts.drills || parts.positions.empty()) return;
    for (int n = 0; n < parts.repeats; ++n) out_.emit_block({motion_code(Function::rapid)}, parts.positions);
  }

  // CYCLE84 has the lead and the speed among its arguments.
  static bool changes_tap(const DrillState& before, const DrillState& after) {
    const bool taps = after.cycle.is(static_cast<std::int16_t>(DrillCycle::tap_right)) ||
                      after.cycle.is(static_cast<std::int16_t>(DrillCycle::tap_left));
    const auto same = [](const auto& a, const auto& b) { return a.known == b.known && a.value == b.value; };
    return taps && !(same(before.feed, after.feed) && same(before.speed, after.speed) &&
                     same(before.feed_mode, after.feed_mode) && same(before.spindle, after.spindle));
  }

  static constexpr auto kBackBore = static_cast<std::int16_t>(DrillCycle::back_bore);
  // Whether a modal call is in effect.
  static bool is_modal(const DrillState& state) {
    return !state.cycle.is(DrillState::kNone) && !state.cycle.is(kBackBore);
  }

  void back_bore(const DrillState& before, const DrillState& after, const ir::Block& block, const DrillBlock& parts) {
    if (is_modal(before)) end_modal();
    if (!parts.drills) return;
    own_ = program_.words_of(block);
    inch_ = after.inch.value;
    arguments_.clear();
    if (!after.initial.known) {
      refuse("back boring from a level that is not known here");
      return;
    }
    if (!after.spindle.known || !turns(after.spindle.value)) {
      refuse("a boring cycle whose spindle does not turn, as far as is known here,");
      return;
    }
    const std::optional<Levels> levels = levels_of(before, after);
    arguments_.resize(9, ExpressionId::none);
    if (!levels || !shift_aside(after)) return;
    const BackBoring hole{.initial = constant(after.initial.value),
                          .level = levels->reference,
                          .depth = levels->depth,
                          .shift_x = arguments_[7],
                          .shift_y = arguments_[8],
                          .dwell_s = seconds(after),
                          .spindle = after.spindle.value};
    for (int n = 0; n < parts.repeats; ++n) {
      if (!parts.positions.empty()) out_.emit_block({motion_code(Function::rapid)}, parts.positions);
      emit_back_boring(hole, program_, out_);
    }
  }

  // --- the call

  struct Row {
    DrillCycle cycle;
    std::string_view name;
  };
  static constexpr auto kRows = std::to_array<Row>({
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

  std::optional<std::uint32_t> call_of(const DrillState& before, const DrillState& after, const ir::Block& block) {
    const auto cycle = static_cast<DrillCycle>(after.cycle.value);
    const auto row = std::ranges::find(kRows, cycle, &Row::cycle);
    if (row == kRows.end()) return refuse("a boring cycle that shifts the tool at the bottom");
    own_ = program_.words_of(block);
    inch_ = after.inch.value;
    const std::optional<Levels> levels = levels_of(before, after);
    if (!levels) return std::nullopt;
    arguments_ = {levels->back, levels->reference, ExpressionId::none, levels->depth};
    switch (cycle) {
      case DrillCycle::drill_dwell: put(5, seconds(after)); break;
      case DrillCycle::deep_hole:
      case DrillCycle::chip_break:
        if (!pecks(after, cycle)) return std::nullopt;
        break;
      case DrillCycle::tap_right:
      case DrillCycle::tap_left:
        if (!tap(after, cycle)) return std::nullopt;
        break;
      case DrillCycle::feed_out_dwell: put(5, seconds(after)); break;
      case DrillCycle::stop_out:
      case DrillCycle::manual_out:
        if (!stops(after, cycle)) return std::nullopt;
        break;
      case DrillCycle::fine_bore:
        if (!stops(after, cycle) || !shift_aside(after)) return std::nullopt;
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

  std::nullopt_t refuse(std::string_view what) {
    raising_.cannot(std::string(what), statement_->span);
    return std::nullopt;
  }

  // What is said so all the same.
  void tell(std::string_view what) {
    raising_.cannot(std::string(what), statement_->span);
    raising_.diagnostics.back().severity = text::Severity::warning;
  }

  // CYCLE83: FDPR is each peck, without degression; DTD dwells at the last depth; VRT and DIS1 are the distances of the
  // other control's parameters.
  bool pecks(const DrillState& after, DrillCycle cycle) {
    if (after.peck.is(ExpressionId::none)) return refuse("a cycle that drills by pecks without their depth"), false;
    const std::optional<ExpressionId> peck = word(after.peck, "Q");
    if (!peck) return false;
    const ir::Semantics& from = raising_.from.semantics;
    const bool clears = cycle == DrillCycle::deep_hole;
    put(6, of(Operator::abs, *peck));
    put(11, constant(clears ? 1.0 : 0.0));
    const double in_units = inch_ ? 1.0 / 25.4 : 1.0;
    if (!clears) put(14, constant(from.chip_break_retract_mm * in_units));
    if (!clears) tell("the way back between the pecks at rapid, which CYCLE83 goes at the feed,");
    const ExpressionId dwell = seconds(after);
    if (dwell != ExpressionId::none) put(15, dwell);
    if (clears) put(16, constant(from.peck_clearance_mm * in_units));
    return true;
  }

  // CYCLE84: the lead is the feed of a turn; the spindle turns again behind it as it did before.
  bool tap(const DrillState& after, DrillCycle cycle) {
    const bool known = after.feed.known && after.speed.known && after.feed_mode.known && after.spindle.known;
    if (!known || after.feed.value == ExpressionId::none || after.speed.value == ExpressionId::none)
      return refuse("a tap whose feed or speed is not known here"), false;
    if (!after.speed.known || program_.at(after.speed.value).op != Operator::constant ||
        program_.at(after.feed.value).op != Operator::constant)
      return refuse("a tap whose feed or speed is computed"), false;
    const double speed = program_.at(after.speed.value).value;
    double lead = program_.at(after.feed.value).value;
    if (after.feed_mode.value == Function::feed_per_min) lead /= speed;
    if (!(speed > 0.0) || !(lead > 0.0)) return refuse("a tap without a feed or speed"), false;
    const bool pecks = std::ranges::find(own_, Address::q, &ir::Word::address) != own_.end();
    if (pecks) return refuse("a tap by pecks (Q)"), false;
    put(5, seconds(after));
    const Function spindle = after.spindle.value;
    put(6, constant(spindle == Function::spindle_cw ? 3.0 : spindle == Function::spindle_ccw ? 4.0 : 5.0));
    put(8, constant(cycle == DrillCycle::tap_left ? -lead : lead));
    put(10, constant(speed));
    return true;
  }

  // CYCLE86 and CYCLE88 start the spindle themselves and leave it stopped.
  bool stops(const DrillState& after, DrillCycle cycle) {
    if (!after.spindle.known || !turns(after.spindle.value))
      return refuse("a boring cycle whose spindle does not turn, as far as is known here,"), false;
    if (cycle != DrillCycle::stop_out) put(5, seconds(after));
    put(6, constant(after.spindle.value == Function::spindle_cw ? 3.0 : 4.0));
    return true;
  }
  // RPA and RPO of CYCLE86: I and J, or Q along a direction that a parameter of the other machine says.
  bool shift_aside(const DrillState& after) {
    if (!after.plane.is(Function::plane_xy)) return refuse("a fine boring cycle in another plane than G17"), false;
    const bool by_words = !after.shift_i.is(ExpressionId::none) || !after.shift_j.is(ExpressionId::none);
    const auto take = [&](const Fact<ExpressionId>& fact, std::string_view address, std::size_t place) {
      if (fact.is(ExpressionId::none)) return true;
      const std::optional<ExpressionId> value = word(fact, address);
      if (value) put(place, *value);
      return value.has_value();
    };
    if (by_words) return take(after.shift_i, "I", 7) && take(after.shift_j, "J", 8);
    if (after.peck.is(ExpressionId::none)) return true;
    const std::optional<ExpressionId> q = word(after.peck, "Q");
    if (!q) return false;
    put(7, of(Operator::abs, *q));
    tell("the direction of the shift Q, which a parameter of the machine says and which is taken as X+,");
    return true;
  }
  static bool turns(Function spindle) { return spindle == Function::spindle_cw || spindle == Function::spindle_ccw; }
  static bool leaves_spindle_stopped(const Fact<std::int16_t>& cycle) {
    return cycle.is(static_cast<std::int16_t>(DrillCycle::stop_out)) ||
           cycle.is(static_cast<std::int16_t>(DrillCycle::manual_out)) ||
           cycle.is(static_cast<std::int16_t>(DrillCycle::fine_bore));
  }
  // … where the other control starts it again.
  void start_again(const DrillState& state) {
    if (!state.spindle.known || !turns(state.spindle.value)) return;
    ir::Code code;
    code.function = state.spindle.value;
    code.group = ir::ModalGroup::spindle;
    code.letter = 'M';
    out_.emit_block({code}, {});
  }

  void put(std::size_t place, ExpressionId value) {
    if (value == ExpressionId::none) return;
    if (arguments_.size() <= place) arguments_.resize(place + 1, ExpressionId::none);
    arguments_[place] = value;
  }

  // P in milliseconds.
  ExpressionId seconds(const DrillState& after) {
    if (after.dwell.is(ExpressionId::none)) return ExpressionId::none;
    const std::optional<ExpressionId> written = carried(after.dwell, "P");
    if (!written) return ExpressionId::none;
    const ir::Expression& e = program_.at(*written);
    if (e.op == Operator::constant) return constant(e.value / 1000.0);
    return of(Operator::divide, *written, constant(1000.0));
  }

  // --- levels

  std::optional<Levels> levels_of(const DrillState& before, const DrillState& after) {
    if (after.depth.is(ExpressionId::none)) return refuse("a drilling cycle without a depth");
    if (!after.to_level.known) return refuse("a return level (G98 or G99) that is not the same on all ways");
    const std::optional<ExpressionId> z = word(after.depth, "Z");
    if (!z) return std::nullopt;
    const bool no_level = after.level.is(ExpressionId::none);
    std::optional<ExpressionId> r;
    if (!no_level) r = word(after.level, "R");
    if (!no_level && !r) return std::nullopt;
    if (!after.depth_by_distance.known || (!no_level && !after.level_by_distance.known))
      return refuse("a cycle whose words are absolute on one way and incremental on another");
    const bool needs_initial = no_level || after.level_by_distance.value || !after.to_level.value;
    ExpressionId initial = ExpressionId::none;
    if (needs_initial) {
      initial = initial_level(before, after);
      if (initial == ExpressionId::none) return refuse("the level where the drilling cycle began, not known here,");
    }
    Levels levels;
    levels.reference = no_level ? initial : after.level_by_distance.value ? sum(initial, *r) : *r;
    levels.depth = after.depth_by_distance.value ? sum(levels.reference, *z) : *z;
    levels.back = after.to_level.value ? levels.reference : initial;
    const ir::Expression& bottom = program_.at(levels.depth);
    const ir::Expression& top = program_.at(levels.reference);
    const bool upward = bottom.op == Operator::constant && top.op == Operator::constant && bottom.value > top.value;
    if (upward && !after.cycle.is(kBackBore)) return refuse("a hole that is drilled upward");
    return levels;
  }

  // A number where it is known; otherwise where the tool stands, when that is the level.
  ExpressionId initial_level(const DrillState& before, const DrillState& after) {
    if (after.initial.known) return constant(after.initial.value);
    const bool enters = before.cycle.is(DrillState::kNone);
    if (!enters && !before.at_initial.is(true)) return ExpressionId::none;
    ir::Variable place;
    place.bank = ir::Bank::system;
    place.number = find_system_variable("$P_EP");
    const Address axis = drilling_axis(after.plane.value);
    place.index = constant(axis == Address::x ? 0.0 : axis == Address::y ? 1.0 : 2.0);
    return program_.add_variable(place);
  }

  // A word of the cycle in units of the program. What an earlier block computed may be another value by now.
  std::optional<ExpressionId> word(const Fact<ExpressionId>& fact, std::string_view address) {
    const std::optional<ExpressionId> written = carried(fact, address);
    if (!written) return std::nullopt;
    const ir::Expression& e = program_.at(*written);
    const bool counts = raising_.from.semantics.decimal_mode == ir::DecimalMode::least_increment;
    if (e.op != Operator::constant || e.has_point || !counts) return written;
    const double increment = raising_.from.semantics.least_increment_mm;
    return constant(e.value / std::nearbyint(inch_ ? 10.0 / increment : 1.0 / increment));
  }
  std::optional<ExpressionId> carried(const Fact<ExpressionId>& fact, std::string_view address) {
    if (!fact.known) {
      raising_.report(text::DiagnosticId::unknown_modal_state, statement_->span,
                      {std::string(address) + " of the drilling cycle", std::string(kTwoWays)});
      return std::nullopt;
    }
    const bool written_here = std::ranges::find(own_, fact.value, &ir::Word::value) != own_.end();
    if (written_here || program_.at(fact.value).op == Operator::constant) return fact.value;
    return refuse(std::string(address) + " of the drilling cycle, computed in an earlier block,");
  }

  // --- small parts

  ExpressionId constant(double value) { return program_.add_constant(value, {}, false); }
  ExpressionId of(Operator op, ExpressionId a, ExpressionId b = ExpressionId::none) {
    const ir::Expression& e = program_.at(a);
    if (op == Operator::abs && e.op == Operator::constant) return constant(std::abs(e.value));
    return program_.add_operator(op, a, b);
  }
  ExpressionId sum(ExpressionId a, ExpressionId b) {
    const ir::Expression& left = program_.at(a);
    const ir::Expression& right = program_.at(b);
    if (left.op == Operator::constant && right.op == Operator::constant) return constant(left.value + right.value);
    return program_.add_operator(Operator::add, a, b);
  }

  static ir::Code motion_code(Function function) {
    ir::Code code;
    code.function = function;
    code.group = ir::ModalGroup::motion;
    return code;
  }

  const Raising& raising_;
  ir::Program& program_;
  DrillFlow flow_;
  passes::Rewrite out_;
  const ir::Statement* statement_ = nullptr;
  std::span<const ir::Word> own_;  // of the block
  std::vector<ExpressionId> arguments_;
  bool inch_ = false;
};

}  // namespace

void raise_cycles(const Raising& raising) {
  const auto& codes = raising.program.codes;
  if (std::ranges::find(codes, Function::drill, &ir::Code::function) != codes.end()) CycleRaiser(raising).run();
}

}  // namespace dripfeed::sinumerik
