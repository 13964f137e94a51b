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
#include <optional>
#include <string>
#include <vector>

#include "dialects/facts/axis_words.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/sinumerik/writer/back_boring.h"
#include "dialects/sinumerik/writer/drill_block.h"
#include "dialects/sinumerik/writer/drill_call.h"
#include "dialects/sinumerik/writer/drill_state.h"
#include "dialects/sinumerik/writer/raise.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::Function;
using ir::StatementKind;

constexpr double kMostRepeats = 100.0;

class CycleRaiser {
 public:
  explicit CycleRaiser(const Raising& raising)
      : raising_(raising), program_(raising.program), facts_(program_, raising.from), out_(program_) {}

  void run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      const ir::Statement s = program_.statements[i];
      const facts::Facts* before = facts_.before(i);
      if (s.kind != StatementKind::block || before == nullptr)
        out_.keep();
      else
        block(s, drill_state(program_, *before), drill_state(program_, *facts_.at(i)));
    }
    out_.finish();
  }

 private:
  void block(const ir::Statement& s, const DrillState& before, const DrillState& after) {
    const ir::Block block = program_.blocks[s.payload];
    const bool was = !before.cycle.is(DrillState::kNone);
    const bool is = !after.cycle.is(DrillState::kNone);
    if (!was && !is) return out_.keep();
    statement_ = &s;
    if (block.rest_level != 0) return raising_.cannot(passes::at_switch("block skip inside a block"), s.span);
    if (!after.cycle.known) return undecided(block);
    if (!is) return end(before, block);
    if (facts::has_own_words(program_, block)) return with_own_words(block);
    drill(before, after, block);
  }

  // A block that may or may not drill: words of shifts, data and the like never do.
  void undecided(const ir::Block& block) {
    const auto words = program_.words_of(block);
    const bool own_words = facts::has_own_words(program_, block);
    if (!own_words &&
        std::ranges::any_of(words, [](const ir::Word& w) { return ir::is_axis(w.address) || w.address == Address::r; }))
      raising_.report(text::DiagnosticId::unknown_modal_state, statement_->span,
                      {"the drilling cycle", std::string(kTwoPaths)});
    out_.keep();
  }

  // A dwell, a shift or data while a cycle is in effect: no position, and no hole. What moves by rules of its own would
  // be followed by one here.
  void with_own_words(const ir::Block& block) {
    for (const ir::Code& c : program_.codes_of(block)) {
      const bool stays = c.group == ir::ModalGroup::frame || std::ranges::find(kStaying, c.function) != kStaying.end();
      if (facts::has_own_words(c) && !stays) return refuse_in_cycle(c);
      if (c.function == Function::drill || changes_return(c)) return refuse_in_cycle(c);
    }
    out_.keep();
  }
  static constexpr std::array kStaying = {Function::no_effect, Function::dwell, Function::local_shift,
                                          Function::data_input, Function::set_coordinates};
  static bool changes_return(const ir::Code& c) {
    return c.function == Function::return_to_initial || c.function == Function::return_to_r;
  }
  void refuse_in_cycle(const ir::Code& c) {
    raising_.cannot(std::string(raising_.text_of(c.span)) + " in a block of a drilling cycle", c.span);
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
                      {"the motion after the cycle", std::string(kTwoPaths)});
    }
    out_.emit_block(codes, words);
  }

  void drill(const DrillState& before, const DrillState& after, const ir::Block& block) {
    if (after.cycle.value >= ir::kDrillAlongZ) return raising_.cannot("a drilling cycle of a lathe", statement_->span);
    if (!after.plane.known)
      raising_.report(text::DiagnosticId::unknown_modal_state, statement_->span,
                      {"the plane of the cycle", std::string(kTwoPaths)});
    DrillBlock parts =
        drill_block(raising_, block, drilling_axis(after.plane.value), static_cast<DrillCycle>(after.cycle.value));
    parts.redefines |= changes_tap(before, after) || changes_level(before, after);
    if (!parts.begins && parts.positions.empty() && !parts.drills && !parts.redefines) return out_.keep();
    parts.redefines |= parts.begins || !before.to_level.known;
    if (!parts.rest_codes.empty() || !parts.rest_words.empty()) out_.emit_block(parts.rest_codes, parts.rest_words);
    if (parts.repeats > kMostRepeats)
      return raising_.cannot("a cycle that is repeated " + text::format_shortest(parts.repeats) + " times",
                             statement_->span);
    if (after.cycle.is(kBackBore)) return back_bore(before, after, block, parts);
    if (parts.redefines) {
      const std::optional<std::uint32_t> call = DrillCall(raising_, statement_->span, block, before, after).make();
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

  // G98 or G99 by itself.
  static bool changes_level(const DrillState& before, const DrillState& after) {
    return before.to_level.known != after.to_level.known || before.to_level.value != after.to_level.value;
  }
  // CYCLE84 has the lead and the speed among its arguments.
  static bool changes_tap(const DrillState& before, const DrillState& after) {
    const bool taps = after.cycle.is(static_cast<std::int16_t>(DrillCycle::tap_right)) ||
                      after.cycle.is(static_cast<std::int16_t>(DrillCycle::tap_left));
    const auto same = [](const auto& a, const auto& b) { return a.known == b.known && a.value == b.value; };
    return taps && !(same(before.feed, after.feed) && same(before.speed, after.speed) &&
                     same(before.feed_mode, after.feed_mode) && same(before.spindle, after.spindle));
  }

  // Whether a modal call is in effect.
  static bool is_modal(const DrillState& state) {
    return !state.cycle.is(DrillState::kNone) && !state.cycle.is(kBackBore);
  }

  void back_bore(const DrillState& before, const DrillState& after, const ir::Block& block, const DrillBlock& parts) {
    if (is_modal(before)) end_modal();
    if (!parts.drills) return;
    const std::optional<BackBoring> hole = DrillCall(raising_, statement_->span, block, before, after).back_boring();
    for (int n = 0; hole && n < parts.repeats; ++n) {
      if (!parts.positions.empty()) out_.emit_block({motion_code(Function::rapid)}, parts.positions);
      emit_back_boring(*hole, program_, out_);
    }
  }

  static bool leaves_spindle_stopped(const Fact<std::int16_t>& cycle) {
    return cycle.is(static_cast<std::int16_t>(DrillCycle::stop_out)) ||
           cycle.is(static_cast<std::int16_t>(DrillCycle::manual_out)) ||
           cycle.is(static_cast<std::int16_t>(DrillCycle::fine_bore));
  }
  // … where the other control starts it again.
  void start_again(const DrillState& state) {
    if (!state.spindle.known || !turns_spindle(state.spindle.value)) return;
    ir::Code code;
    code.function = state.spindle.value;
    code.group = ir::ModalGroup::spindle;
    code.letter = 'M';
    out_.emit_block({code}, {});
  }

  static ir::Code motion_code(Function function) {
    ir::Code code;
    code.function = function;
    code.group = ir::ModalGroup::motion;
    return code;
  }

  const Raising& raising_;
  ir::Program& program_;
  facts::Resolved facts_;
  passes::Rewrite out_;
  const ir::Statement* statement_ = nullptr;
};

}  // namespace

void raise_cycles(const Raising& raising) {
  const auto& codes = raising.program.codes;
  if (std::ranges::find(codes, Function::drill, &ir::Code::function) != codes.end()) CycleRaiser(raising).run();
}

}  // namespace dripfeed::sinumerik
