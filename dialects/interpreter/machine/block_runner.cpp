// From template to plain block, and its result.
#include "dialects/interpreter/machine/block_runner.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/block/apply.h"
#include "dialects/interpreter/block/data_setting.h"
#include "dialects/interpreter/block/straight_cut.h"
#include "dialects/interpreter/machine/trace.h"
#include "dialects/interpreter/state/axis_names.h"
#include "dialects/ir/alarm_details.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using text::DiagnosticId;

constexpr std::uint32_t kNoExtra = 0xFFFFFFFFU;
constexpr double kHighestMachineFunction = 9999.0;

struct NoteRow {
  std::uint64_t note;
  Report report;
};
// Notes that are counted like a code that is not interpreted.
const std::array<NoteRow, 36>& counted_notes() {
  static const std::array<NoteRow, 36> rows = {{
      {kNoteMoveNotModelled, {"moves under a cycle that is not interpreted"}},
      {kNoteReferenceUnknown, {"the move to the reference point", ir::Function::reference_return}},
      {kNoteArcNotComputed, {"arcs from or to a position that is not known"}},
      {kNoteArcInFrame, {"arcs that a frame stretches"}},
      {kNoteArcUndefined, {"CIP through points that make no circle"}},
      {kNoteCompInFrame, {"compensation of the radius in a plane that a frame tilts"}},
      {kNoteCornerNotComputed, {"a chamfer or rounding that does not fit its corner"}},
      {kNoteLeadChange,
       {"the change of a thread's lead that its block does not state for certain", ir::Function::thread_changing}},
      {kNotePatternWithoutCycle, {"a hole pattern without a drilling cycle", ir::Function::hole_pattern}},
      {kNotePatternWords, {"a word of a hole pattern that may mean something else", ir::Function::hole_pattern}},
      {kNoteFramesOfBoth, {"a frame of one of the control's languages together with one of the other"}},
      {kNoteMeasuring, {"MEAS: where the probe touches"}},
      {kNoteSpline, {"how a spline bends, taken as usual and not looked at", ir::Function::spline}},
      {kNoteContourOffset, {"OFFN: an offset of the contour in addition to the tool's radius"}},
      {kNoteSplineStraight, {"the curve of a spline"}},
      {kNotePolynomialStraight, {"the curve of a polynomial (POLY)"}},
      {kNotePolynomialDiameter, {"POLY: what the coefficients of a diameter count"}},
      {kNotePolynomialAlone, {"PO: coefficients where POLY is not in effect"}},
      {kNoteIncrementalFromUnknown, {"increments from a position that is not known", ir::Function::incremental}},
      {kNoteShiftedIncrement,
       {"an increment along an axis whose frame has changed (SD42440 FRAME_OFFSET_INCR_PROG decides)",
        ir::Function::incremental}},
      {kNoteMachineIncrement,
       {"an increment to a machine position (G53, SUPA together with G91), which does not lead there",
        ir::Function::machine_coordinates}},
      {kNoteLevelUnknown, {"the retract to an initial level that is not known", ir::Function::drill}},
      {kNoteSkip, {"the end of a skip move (G31), which a signal decides", ir::Function::skip_move}},
      {kNoteMeasuringTool,
       {"the end of measuring a tool (G37) and the length that comes of it", ir::Function::measure_tool}},
      {kNoteArcIsLine, {"arcs without centre and radius, taken as straight as by parameter", ir::Function::linear}},
      {kNoteCycleInFrame, {"a drilling cycle along an axis that a frame turns or stretches", ir::Function::drill}},
      {kNoteScaleUnit,
       {"what a scaling factor without a point counts, which a parameter decides", ir::Function::scale}},
      {kNoteFrameValue, {"a scaling factor or angle that is left to a parameter", ir::Function::scale}},
      {kNoteDirectAngle, {"the angle of a line (,A) whose ends do not follow from it", ir::Function::linear}},
      {kNoteHoleWithoutDepth, {"a drilling cycle without a depth", ir::Function::drill}},
      {kNoteIdleWord,
       {"a word that no code of its block takes (P of a spindle, a word of the builder's, an axis next to G04)"}},
      {kNoteThreadStart, {"the angle at which a thread begins (Q), for a second start", ir::Function::thread}},
      {kNoteAxisTwice, {"an axis with two words in its block (X and U), of which one is effective"}},
      {kNoteMoveAtFrameEnd, {"axis letters in the block that ends a rotation or scaling", ir::Function::rotate}},
      {kNoteCompDirection, {"I, J and K of G40, the direction in which the compensation ends"}},
      {kNoteTransformed,
       {"moves on a face or cylinder from a position that is not known", ir::Function::transformation}},
  }};
  return rows;
}

std::string letter_of(ir::Address address) {
  return address <= ir::Address::z ? std::string(1, static_cast<char>('A' + static_cast<int>(address))) : "a word";
}

// Whether a word with a value that is not known leaves no doubt about more than its own axis, feed or speed.
bool stays_local(ir::Address address, bool is_axis) {
  constexpr std::uint64_t kLocal = bit_of(ir::Address::f) | bit_of(ir::Address::s) | bit_of(ir::Address::i) |
                                   bit_of(ir::Address::j) | bit_of(ir::Address::k);
  return is_axis || (kLocal & bit_of(address)) != 0;
}

}  // namespace

std::optional<Flow> BlockRunner::run(const Instruction& i, const CompiledProgram& program) {
  const BlockTemplate& made = program.blocks[i.a];
  fill(made, program);
  if (made.extra != kNoExtra && !fill_computed(i, made, program)) return std::nullopt;
  if ((block_.present & rules_.foreign_axes) != 0) [[unlikely]]
    drop_foreign_axes({});
  return apply_block(i);
}

std::optional<Flow> BlockRunner::run_plain(const Instruction& i, const ir::PlainBatch& batch,
                                           const ir::PlainBlockRow& row) {
  block_.clear();
  block_.codes = {batch.codes.data() + row.first_code, row.code_count};
  const ir::PlainWord* word = batch.words.data() + row.first_word;
  for (std::uint32_t n = 0; n < row.word_count; ++n, ++word) {
    const std::uint64_t bit = bit_of(word->address);
    block_.present |= bit;
    block_.values[index_of(word->address)] = word->value;
    // A later word of the same address counts.
    const bool counts = !word->has_point && (rules_.counting & bit) != 0;
    block_.in_increments = counts ? block_.in_increments | bit : block_.in_increments & ~bit;
  }
  if ((block_.present & rules_.foreign_axes) != 0) [[unlikely]]
    drop_foreign_axes({batch.words.data() + row.first_word, row.word_count});
  return apply_block(i);
}

// Axes that the control does not have are named in the report, unless a code takes the letters for something else. Each
// word of a plain block counts; of other blocks all but Y were reported when they were compiled.
void BlockRunner::drop_foreign_axes(std::span<const ir::PlainWord> words) {
  const auto takes_letters = [](const PlainCode& code) {
    return code.function == ir::Function::dwell || code.function == ir::Function::set_coordinates ||
           code.function == ir::Function::data_input || code.function == ir::Function::repetitive_cycle ||
           code.group == ir::ModalGroup::frame;
  };
  if (std::ranges::any_of(block_.codes, takes_letters)) return;
  // On a face or cylinder Y is not an axis of the machine.
  const bool has_y = state_.transformation.shape != Transformation::Shape::none && !state_.transformation.by_rotary;
  const std::uint64_t foreign = rules_.foreign_axes & ~(has_y ? bit_of(ir::Address::y) : 0);
  for (const ir::PlainWord& word : words) {
    if (word.address != ir::Address::y && (foreign & bit_of(word.address)) != 0)
      report_.count({letter_of(word.address)});
  }
  if ((block_.present & foreign & bit_of(ir::Address::y)) != 0) report_.count({letter_of(ir::Address::y)});
  block_.present &= ~foreign;
}

std::optional<Flow> BlockRunner::apply_block(const Instruction& i) {
  if (!forgets_ && is_straight_cut(block_, rules_, state_)) return cut(i);
  const std::uint64_t before = out_.count();
  if (frames_.knows_settable()) [[unlikely]]
    for (const PlainCode& code : block_.codes)
      if (code.function == ir::Function::work_offset) frames_.select(code.argument);
  const BlockResult result = apply(block_, rules_, state_, out_);
  if (forgets_) [[unlikely]] {
    forgets_ = false;
    if (control_.semantics.has_vacant) state_.unknown = kAllAxes;
  }
  const auto waits = [](const PlainCode& code) { return code.function == ir::Function::dwell; };
  if (block_.codes.empty() || !std::ranges::all_of(block_.codes, waits)) ++state_.untimed;
  // A corner may take pieces of the move before it back.
  made_ = out_.count() >= before ? out_.count() - before : 1;
  constexpr std::uint64_t kPolar = bit_of(ir::Address::polar_angle) | bit_of(ir::Address::polar_radius);
  moved_ = (block_.present & (rules_.axis_addresses | kPolar)) != 0 && made_ > 0 && result.moved;
  needs_shape_ = result.needs_shape;
  watch_.look(i, block_, moved_);
  if (result.sets_data) set_data();
  if (result.notes != 0) take_notes(i, result.notes);
  if (result.fault != DiagnosticId::count_) {
    fail(i, result);
    return std::nullopt;
  }
  if (result.second != 0.0) [[unlikely]]
    report_radii(i, result);
  return result.flow;
}

Flow BlockRunner::cut(const Instruction& i) {
  const std::uint64_t before = out_.count();
  const std::uint64_t notes = cut_straight(block_, rules_, state_, out_);
  ++state_.untimed;
  made_ = out_.count() - before;
  moved_ = made_ > 0;
  needs_shape_ = false;
  watch_.look(i, block_, moved_);
  if (notes != 0) [[unlikely]]
    take_notes(i, notes);
  return Flow::next;
}

void BlockRunner::report_radii(const Instruction& i, const BlockResult& result) {
  report_.warn(i, DiagnosticId::arc_radius_mismatch,
               {text::format_fixed(result.first, 4), text::format_fixed(result.second, 4)},
               "a parameter of the machine decides how far they may differ (3410)");
}

// What is set is known from here on; that the machine's memory changes is reported.
void BlockRunner::set_data() {
  const auto set = data_values(block_, rules_, state_, control_.kind != ir::MachineKind::mill);
  for (const DataValue& one : set.values) access_.set_system(one);
  report_.count({.name = set.name, .function = ir::Function::data_input});
}

void BlockRunner::set_word(ir::Address address, double value, std::uint8_t flags) {
  const std::uint64_t bit = bit_of(address);
  // Of an address that is written twice the last word counts, and how that one is written.
  if ((block_.present & bit) != 0) {
    block_.in_increments &= ~bit;
    block_.absolute &= ~bit;
    block_.incremental &= ~bit;
  }
  if (flags == 0) return block_.set(address, value);
  if ((flags & kWordInIncrements) != 0) block_.in_increments |= bit;
  if ((flags & kWordAbsolute) != 0) block_.absolute |= bit;
  if ((flags & kWordIncremental) != 0) block_.incremental |= bit;
  if ((flags & kWordNumbered) != 0)
    block_.numbered |= bit, block_.values[index_of(address)] = value;
  else
    block_.set(address, value);
}

void BlockRunner::fill(const BlockTemplate& made, const CompiledProgram& program) {
  block_.clear();
  block_.codes = {program.codes.data() + made.first_code, made.code_count};
  const TemplateWord* word = program.words.data() + made.first_word;
  for (std::uint32_t n = 0; n < made.word_count; ++n, ++word) set_word(word->address, word->value, word->flags);
}

bool BlockRunner::fill_computed(const Instruction& i, const BlockTemplate& made, const CompiledProgram& program) {
  const BlockExtra& extra = program.extras[made.extra];
  for (std::uint32_t n = extra.first_word; n < extra.first_word + extra.word_count; ++n) {
    const ComputedWord& word = program.computed_words[n];
    if (word.is_string) {
      if (!name_tool(i, storage_.text(raw_of(word.operand)))) return false;
      continue;
    }
    const double value = storage_.reg(raw_of(word.operand));
    const ir::Address address = word.axis == Operand::none ? word.address : find_axis(word);
    if (address == ir::Address::other) continue;
    const bool is_axis = (rules_.axis_addresses & bit_of(address)) != 0;
    if (rules_.coordinate_alarm && is_axis && std::abs(value) > kMostCounted)
      return report_.fail(i, DiagnosticId::result_overflow, {}, ir::AlarmDetail::position);
    if (is_unknown(value, control_.semantics)) {
      block_.unknown |= bit_of(address);
      forgets_ = forgets_ || !stays_local(address, is_axis);
      report_.count({.name = letter_of(address) + " from a value that is not known"});
    } else if (is_vacant(value))
      skip_vacant(i, program, n);
    else
      set_word(address, value, word.flags);
  }
  for (std::uint32_t n = extra.first_report; n < extra.first_report + extra.report_count; ++n)
    report_.count(program.reports[program.block_reports[n]]);
  if (extra.code_count == 0) return true;
  codes_.assign(block_.codes.begin(), block_.codes.end());
  for (std::uint32_t n = extra.first_code; n < extra.first_code + extra.code_count; ++n)
    if (!add_computed_code(i, program.computed_codes[n])) return false;
  block_.codes = codes_;
  return true;
}

bool BlockRunner::name_tool(const Instruction& i, const std::string& name) {
  block_.tool_name = report_.text_index(name);
  if (block_.tool_name == kNoText) return report_.fail_limit(i, "strings");
  block_.named_tool = is_unknown(name) ? 0 : ir::tool_of_name(control_, name);
  if (block_.named_tool != 0 || !control_.from_profile) return true;
  constexpr std::string_view kDecides = "\"name\" of the tools in the machine's profile decides this";
  const std::string quoted = '"' + name + '"';
  if (is_unknown(name))
    report_.count({.name = "T by a name that is not known", .effects_known = true});
  else if (control_.tool_names.empty())
    report_.count({.name = "T=" + quoted, .function = ir::Function::tool_change, .effects_known = true});
  else
    report_.warn(i, DiagnosticId::tool_missing, {quoted}, kDecides);
  return true;
}

// AX[…]: the letter of the axis when the control has it; otherwise the report names the axis.
ir::Address BlockRunner::find_axis(const ComputedWord& word) {
  const double axis = storage_.reg(raw_of(word.axis));
  for (std::uint64_t rest = rules_.axis_addresses; rest != 0; rest &= rest - 1) {
    const auto address = static_cast<ir::Address>(std::countr_zero(rest));
    const AxisWord& known = rules_.axis_words[index_of(address)];
    if (!known.incremental && static_cast<double>(known.axis) == axis) return address;
  }
  const std::string name = axis_name(shared_, axis);
  report_.count({.name = is_unknown(name) ? "AX[] of an axis that is not known" : "AX[" + name + "]"});
  if (is_unknown(name)) block_.unknown |= rules_.axis_addresses;
  return ir::Address::other;
}

// A G number is looked up as it comes, G54.1 as 541; an M number is a whole one, M[3.5] is M4.
bool BlockRunner::add_computed_code(const Instruction& i, const ComputedCode& code) {
  const double value = storage_.reg(raw_of(code.operand));
  if (is_unknown(value, control_.semantics)) {
    report_.count({.name = std::string(1, code.letter) + " from a value that is not known"});
    forgets_ = true;
    return true;
  }
  if (is_vacant(value)) return true;  // the word is ignored
  const double tenths = code.letter == 'M' ? arithmetic_.round(value) * 10.0 : arithmetic_.round(value * 10.0);
  const auto table = code.letter == 'M' ? control_.m_codes : control_.g_codes;
  const ir::CodeRow* row =
      std::abs(tenths) < 32767.0 ? ir::find_code(table, static_cast<std::int32_t>(tenths)) : nullptr;
  const std::string name = code.letter + text::format_shortest(tenths / 10.0);
  // An M number that the control has no row for is the machine's own, as when it is written.
  const bool whole = std::fmod(tenths, 10.0) == 0.0 && tenths >= 0.0 && tenths <= kHighestMachineFunction * 10.0;
  if (row == nullptr && !(code.letter == 'M' && whole)) return report_.fail(i, DiagnosticId::unknown_code, {name});
  const PlainCode resolved = row == nullptr ? PlainCode{ir::Function::machine_function,
                                                        static_cast<std::int16_t>(tenths / 10.0), ir::ModalGroup::none}
                                            : PlainCode{row->function, row->argument, row->group};
  if (resolved.function == ir::Function::not_modelled || resolved.function == ir::Function::machine_function)
    report_.count({row == nullptr ? name : std::string(row->name), resolved.function, false});
  report_.note_computed(name, resolved.function);
  codes_.push_back(resolved);
  return true;
}

// Said once a word: a control is silent about it, and the axis does not move.
void BlockRunner::skip_vacant(const Instruction& i, const CompiledProgram& program, std::uint32_t word) {
  constexpr std::size_t kReportedAtMost = 100;
  if (reported_vacant_.size() == kReportedAtMost) return;
  const std::pair key(&program, word);
  if (std::ranges::find(reported_vacant_, key) != reported_vacant_.end()) return;
  reported_vacant_.push_back(key);
  report_.say(i, DiagnosticId::vacant_value, {"of the word " + letter_of(program.computed_words[word].address)});
}

void BlockRunner::take_notes(const Instruction& i, std::uint64_t notes) {
  for (const NoteRow& row : counted_notes())
    if ((notes & row.note) != 0) report_.count(row.report);
  if ((notes & kNoteArcIsLine) != 0 && control_.semantics.unset_is_unknown)
    report_.warn(i, DiagnosticId::arc_without_center, {}, "a parameter decides: a straight line, or this alarm");
  if ((notes & kNoteMeasuringTool) != 0) access_.forget_tool_offsets();
  if ((notes & kNoteMotionWithoutCode) != 0) {
    std::string letters;
    for (std::uint64_t rest = (block_.present | block_.unknown) & rules_.axis_addresses; rest != 0; rest &= rest - 1)
      letters += (letters.empty() ? "" : " ") + letter_of(static_cast<ir::Address>(std::countr_zero(rest)));
    report_.say(i, DiagnosticId::motion_without_code, {letters});
  }
  // A shape is cut with the feed of its cycle. Before a motion code the machine decides whether the block cuts.
  const bool cuts = (notes & kNoteMotionWithoutCode) == 0;
  if ((notes & kNoteNoFeed) != 0 && cuts && !reported_no_feed_ && out_.captured() == nullptr) {
    reported_no_feed_ = true;
    report_.keep_no_feed(i, state_.feed < 0.0 ? ir::kNegative : ir::AlarmDetail::none);
  }
}

bool BlockRunner::fail(const Instruction& i, const BlockResult& result) {
  if (result.fault == DiagnosticId::limit_reached) return report_.fail_limit(i, "steps of one cycle");
  if (result.fault == DiagnosticId::cycle_shape_invalid && result.reason.empty())
    return report_.fail(i, result.fault, {"a thread without a height"}, ir::AlarmDetail::depth_of_pass);
  if (!result.reason.empty()) return report_.fail(i, result.fault, {std::string(result.reason)}, result.detail);
  if (result.fault != DiagnosticId::arc_radius_mismatch) return report_.fail(i, result.fault, {}, result.detail);
  (void)report_.fail(i, result.fault, {text::format_fixed(result.first, 4), text::format_fixed(result.second, 4)},
                     result.detail);
  if (x_may_be_radius())
    report_.soften("DIAMON, DIAM90 or DIAMOF is not stated: the machine decides whether X is a diameter here");
  return false;
}

// On a lathe whose program does not state it, and whose machine is not known.
bool BlockRunner::x_may_be_radius() const {
  return control_.semantics.power_on_diameter != ir::DiameterMode::radius &&
         may_be_older(control_.semantics, state_, ir::ModalGroup::diameter);
}

}  // namespace dripfeed::interpreter
