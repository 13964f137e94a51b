// Certain only where every code of the block is one that is known to take no such word. (Fanuc, multi-spindle control:
// P of S and of the spindle's M functions.)
#include "dialects/interpreter/block/idle_words.h"

#include <algorithm>
#include <array>

#include "dialects/interpreter/state/axis_words.h"
#include "dialects/interpreter/state/block_result.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;

constexpr std::uint64_t kWordsOfArc =
    bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k) | bit_of(Address::r) | bit_of(Address::l);

constexpr std::array kTakeNone = {
    Function::rapid,
    Function::linear,
    Function::arc_cw,
    Function::arc_ccw,
    Function::plane_xy,
    Function::plane_zx,
    Function::plane_yz,
    Function::unit_inch,
    Function::unit_mm,
    Function::absolute,
    Function::incremental,
    Function::feed_per_min,
    Function::feed_per_rev,
    Function::comp_off,
    Function::length_offset_off,
    Function::machine_coordinates,
    Function::tool_change,
    Function::work_offset,
    Function::dwell,
    Function::spindle_cw,
    Function::spindle_ccw,
    Function::spindle_stop,
    Function::coolant_mist,
    Function::coolant_flood,
    Function::coolant_off,
    Function::surface_speed_on,
    Function::surface_speed_off,
    Function::program_stop,
    Function::optional_stop,
    Function::cycle_off,
    Function::exact_stop_once,
    Function::return_to_initial,
    Function::return_to_r,
};

bool takes_none(const PlainCode& code) { return std::ranges::find(kTakeNone, code.function) != kTakeNone.end(); }

// Words of the modal motion; others than these four are not judged here. A corner stands at the end of a move.
std::uint64_t taken_by_motion(const PlainBlock& block, const BlockRules& rules, Function motion) {
  constexpr std::uint64_t kCorner = bit_of(Address::i) | bit_of(Address::k) | bit_of(Address::r);
  const bool moves = axis_letters(block, rules) != 0 && !has_code(block, Function::dwell);
  if (motion == Function::rapid) return 0;
  if (motion == Function::linear) return rules.corner_letters && moves ? kCorner : 0;
  return motion == Function::arc_cw || motion == Function::arc_ccw ? kWordsOfArc : kIdleLetters;
}

// P of G96 is the axis whose diameter counts; a larger one is a spindle's. That of a dwell is its time, and that of G54
// is looked at elsewhere.
std::uint64_t taken_by_codes(const PlainBlock& block) {
  constexpr double kLastAxis = 9.0;
  const bool names_axis = has_code(block, Function::surface_speed_on) && block.at(Address::p) <= kLastAxis;
  const bool takes_p = names_axis || has_code(block, Function::dwell) || has_code(block, Function::work_offset);
  return block.has(Address::p) && takes_p ? bit_of(Address::p) : 0;
}

// Axis letters of a dwell's block that are not its time: whether the control moves them, drops them or stops with an
// alarm is not known.
bool names_axes_with_dwell(const PlainBlock& block, const BlockRules& rules, const Effects& effects) {
  if (effects.one_shot != Function::dwell || !rules.semantics.dwell_p_is_ms) return false;
  constexpr std::array kTimes = {Address::p, Address::x, Address::u};
  const auto time = std::ranges::find_if(kTimes, [&](Address address) { return block.has(address); });
  const std::uint64_t taken = time == kTimes.end() ? 0 : bit_of(*time);
  return (axis_letters(block, rules) & ~taken) != 0;
}

// Q of a thread is the spindle's angle where it begins: a second start, which positions do not show.
bool states_thread_start(const PlainBlock& block, const BlockRules& rules, const Effects& effects,
                         const ModalState& state) {
  const bool is_zero = block.has(Address::q) && block.at(Address::q) == 0.0;
  if (((block.present | block.unknown) & bit_of(Address::q)) == 0 || is_zero || effects.one_shot != Function::none)
    return false;
  if (state.turning.active) return state.turning.cycle == ir::TurningCycle::thread;
  const bool threads = state.modes.motion == Function::thread || state.modes.motion == Function::thread_changing;
  return threads && axis_letters(block, rules) != 0;
}

}  // namespace

std::uint64_t idle_notes(const PlainBlock& block, const BlockRules& rules, const Effects& effects,
                         const ModalState& state) {
  if (names_axes_with_dwell(block, rules, effects)) return kNoteIdleWord;
  constexpr std::uint64_t kDirection = bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k);
  const std::uint64_t letters = (block.present | block.unknown) & kIdleLetters & ~rules.axis_addresses;
  if (letters == 0 || !rules.semantics.arc_radius_is_r) return 0;
  const bool acts_once = effects.one_shot != Function::none && effects.one_shot != Function::dwell;
  if (states_thread_start(block, rules, effects, state)) return kNoteThreadStart;
  if (acts_once || state.drilling.active || state.turning.active) return 0;
  if ((letters & kDirection) != 0 && has_code(block, Function::comp_off)) return kNoteCompDirection;
  const std::uint64_t idle = letters & ~taken_by_motion(block, rules, state.modes.motion) & ~taken_by_codes(block);
  return idle != 0 && std::ranges::all_of(block.codes, takes_none) ? kNoteIdleWord : 0;
}

}  // namespace dripfeed::interpreter
