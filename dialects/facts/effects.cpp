// Codes first, then tool, speed and feed, then the positions that the block's motion ends at. Whatever is not plainly a
// move to a number makes the position unknown: a fact may say less than a run does, never more.
#include "dialects/facts/effects.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "dialects/facts/axis_words.h"
#include "dialects/facts/block_values.h"
#include "dialects/facts/called_cycle_effects.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/drill_effects.h"
#include "dialects/facts/kept_words.h"
#include "dialects/facts/position_effects.h"
#include "dialects/facts/shape_blocks.h"
#include "dialects/facts/tool_effects.h"
#include "dialects/facts/transformation.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/ir/cycle.h"
#include "dialects/ir/frame_use.h"

namespace dripfeed::facts {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

// Writing it may move zeros or lengths.
bool may_be_system_variable(const ir::Variable& v, const ir::Control& control) {
  if (v.bank == ir::Bank::system) return true;
  if (v.bank != ir::Bank::hash) return false;
  const ir::VariableRange* range =
      v.index == ir::ExpressionId::none ? ir::find_variable(control, ir::Bank::hash, v.number) : nullptr;
  return range == nullptr || range->use == ir::VariableUse::system;
}

// Positions have other numbers after these, or only the machine knows them.
bool loses_positions(const ir::Code& code) {
  if (code.function == Function::dwell || code.function == Function::exact_stop_once ||
      code.function == Function::stroke_check || code.function == Function::repetitive_cycle)
    return false;  // the last one ends where it began
  return has_own_words(code) || code.group == ModalGroup::work_offset || code.group == ModalGroup::unit ||
         code.group == ModalGroup::diameter || code.group == ModalGroup::length_offset ||
         code.function == Function::tool_change || code.function == Function::data_input ||
         code.function == Function::transformation || code.function == Function::work_offset ||
         code.function == Function::extended_offset;
}

// In a block that may run; a text that was cut out of another has more codes than that.
bool has_code(const ir::Program& program, Function function) {
  return std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    if (s.kind != StatementKind::block) return false;
    const auto codes = program.codes_of(program.blocks[s.payload]);
    return std::ranges::find(codes, function, &ir::Code::function) != codes.end();
  });
}

bool brings_tool_by_t(const ir::Control& control) {
  return control.kind == ir::MachineKind::lathe || control.semantics.tool_word == ir::ToolWord::number_and_offset;
}

// At power-on nothing does.
bool may_change_lead(Known<Setting> motion) {
  if (motion.changer == kPowerOn && motion.origin == kNoStatement && !motion.inherited) return false;
  if (motion.changer == kPowerOn) motion.changer = kNoStatement;
  return motion.may_be({.function = Function::thread_changing});
}

bool is_finishing(const ir::Code& code) { return ir::is_cycle(code, ir::RepetitiveCycle::finish); }

// What moves may change.
void forget_moves(std::uint32_t statement, Facts& facts) {
  facts.forget_positions(statement);
  facts[Mode::spindle].forget(statement);
  for (const Kept word : {Kept::feed, Kept::speed}) facts[word].forget(statement);
}

// Nothing counts as left to the state of the machine.
void take_as_stated(Facts& facts) {
  for (Known<Setting>& mode : facts.modes) mode.at_power_on = false;
  for (Known<double>& number : facts.numbers) number.at_power_on = false;
  for (Known<Written>& word : facts.kept) word.at_power_on = false;
}

}  // namespace

FactSet differing(const Facts& a, const Facts& b) {
  FactSet set;
  for (std::size_t i = 0; i < kModes; ++i) set[i] = !(a.modes[i] == b.modes[i]);
  for (std::size_t i = 0; i < kNumbers; ++i) set[kModes + i] = !(a.numbers[i] == b.numbers[i]);
  for (std::size_t i = 0; i < kKept; ++i) set[kModes + kNumbers + i] = !(a.kept[i] == b.kept[i]);
  return set;
}

Effects::Effects(const ir::Program& program, const ir::Control& control, ToolChange change)
    : program_(program),
      control_(control),
      tool_at_once_(change == ToolChange::as_the_control ? brings_tool_by_t(control)
                                                         : !has_code(program, Function::tool_change)),
      changes_leads_(has_code(program, Function::thread_changing)),
      may_be_left_out_(program.statements.size()) {
  const std::vector<Shape> shapes = shapes_of(program);
  for (const bool left_out : {false, true})
    for (const Shape& shape : shapes)
      for (std::uint32_t i = shape.first; i < shape.end && shape.is_left_out == left_out; ++i)
        may_be_left_out_[i] = !left_out;
}

// --- one block

struct Effects::Walk {
  const Effects& of;
  std::uint32_t statement;
  const ir::Block& block;
  bool with_rest;  // with what stands after "/n" inside the block
  Facts& facts;
  BlockValues values = BlockValues(of.program_, block, with_rest);
  DrillEffects drilling = DrillEffects{of.control_, statement, values, facts};
  PositionEffects positions = PositionEffects{of.control_, statement, values, facts};

  void run() {
    if (values.has_computed_code('G')) return facts.forget_all(statement);
    const Known<Setting> feed_before = facts[Mode::feed];
    const bool names_speed =
        std::ranges::any_of(values.codes, [](const ir::Code& code) { return mode_of(code) == Mode::surface_speed; });
    for (const ir::Code& code : values.codes) take_code(code, names_speed, feed_before);
    if (values.has_computed_code('M'))
      for (const Mode mode : {Mode::spindle, Mode::coolant, Mode::length}) facts[mode].forget(statement);
    ToolEffects{of.control_, statement, of.tool_at_once_, values, facts}.run();
    take_feed_and_speed();
    take_drilling();
    positions.run();
  }

  void set(Mode mode, Function function, std::int32_t argument = 0) {
    facts[mode].set({.function = function, .argument = argument}, statement);
  }
  void set_or_forget(Number number, std::optional<double> value) {
    value ? facts[number].set(*value, statement) : facts[number].forget(statement);
  }

  void take_code(const ir::Code& code, bool names_speed, const Known<Setting>& feed_before) {
    const std::optional<Mode> mode = mode_of(code);
    if (loses_positions(code)) lose_positions();
    if (code.function == Function::turning_cycle) begin_turning_cycle();
    if (code.function == Function::drill) drilling.begin();
    if (is_finishing(code)) forget_what_shapes_set();
    if (code.function == Function::repetitive_cycle && !ir::follows_shape(code)) take_cycle_data(code);
    if (shifts(code)) take_shift(code);
    if (may_turn_spindle(code)) facts[Mode::spindle].forget(statement);
    if (!mode) return;
    switch (*mode) {
      case Mode::motion: set(Mode::cycle, Function::cycle_off); break;
      case Mode::unit:
        for (const Number shift : {Number::shift_x, Number::shift_y, Number::shift_z})
          if (!facts[shift].is(0.0)) facts[shift].forget(statement);
        for (const Kept length : {Kept::feed, Kept::turn_x, Kept::turn_z, Kept::turn_taper, Kept::initial})
          forget_unless_zero(length);
        break;
      case Mode::frame: return take_frame(code);
      case Mode::transformation:
        return ends_transformation(of.program_, block, code)
                   ? set(Mode::transformation, Function::none)
                   : set(Mode::transformation, code.function, static_cast<std::int32_t>(statement));
      case Mode::pole: return set(Mode::pole, code.function, static_cast<std::int32_t>(statement));
      case Mode::feed:
        if (!feed_before.is({.function = code.function})) forget_unless_zero(Kept::feed);
        // One group there: a feed code ends constant surface speed.
        if (!names_speed && of.control_.semantics.feed_code_ends_surface_speed)
          set(Mode::surface_speed, Function::surface_speed_off);
        break;
      case Mode::cycle:
        if (code.function == Function::cycle_off) return end_cycle();
        break;
      case Mode::work_offset: return take_work_offset(code);
      case Mode::spindle:
        return set(Mode::spindle, code.function == Function::spindle_orient ? Function::spindle_stop : code.function);
      case Mode::length: return;  // take_length()
      default: break;
    }
    set(*mode, code.function, code.argument);
  }

  // … and the level where a cycle began has another number, too.
  void lose_positions() {
    facts.forget_positions(statement);
    facts[Kept::initial].forget(statement);
  }

  // The machine builder's functions may, and what is not read.
  [[nodiscard]] bool may_turn_spindle(const ir::Code& code) const {
    return code.function == Function::not_modelled || code.function == Function::other_spindle ||
           code.function == Function::main_spindle ||
           (code.function == Function::machine_function && !ir::is_known_machine_function(of.control_, code.argument));
  }

  static bool shifts(const ir::Code& code) {
    return code.function == Function::local_shift || code.function == Function::local_shift_add ||
           code.function == Function::axial_shift;
  }

  // G52. TRANS, which takes the place of the whole frame, and ATRANS are not followed.
  void take_shift(const ir::Code& code) {
    const bool of_words = code.function == Function::local_shift && code.argument != ir::kFrameReplaces;
    for (const Address axis : {Address::x, Address::y, Address::z}) {
      const auto number = static_cast<Number>(static_cast<int>(Number::shift_x) +
                                              (static_cast<int>(axis) - static_cast<int>(Address::x)));
      if (!of_words) facts[number].forget(statement);
      if (const ir::Word* word = of_words ? values.word(axis) : nullptr; word != nullptr)
        set_or_forget(number, positions.coordinate(*word, *axis_of(axis)));
    }
    if (!of_words) facts[Mode::frame].forget(statement);
  }

  // What joins or replaces the programmable frame of SINUMERIK is not followed.
  void take_frame(const ir::Code& code) {
    if (code.argument == ir::kFrameEnds) return set(Mode::frame, Function::none);
    if (code.argument == ir::kFrameAboutPoint) return set(Mode::frame, code.function);
    facts[Mode::frame].forget(statement);
    for (const Number shift : {Number::shift_x, Number::shift_y, Number::shift_z}) facts[shift].forget(statement);
  }

  void take_work_offset(const ir::Code& code) {
    if (code.function != Function::extended_offset) return set(Mode::work_offset, code.function, code.argument);
    const std::optional<double> number = values.constant_or(Address::p, 1.0);
    if (!number) return facts[Mode::work_offset].forget(statement);
    set(Mode::work_offset, code.function, static_cast<std::int32_t>(*number));
  }

  // G80 ends a drilling cycle. A turning cycle of a lathe is of the motions' group and stays.
  void end_cycle() {
    Known<Setting>& cycle = facts[Mode::cycle];
    if (of.control_.kind == ir::MachineKind::mill) return set(Mode::cycle, Function::cycle_off);
    const Setting* certain = cycle.certain();
    if (certain == nullptr) return cycle.forget(statement);
    if (certain->function != Function::turning_cycle) set(Mode::cycle, Function::cycle_off);
  }

  void forget_unless_zero(Kept word) {
    const Written* written = facts[word].certain();
    const bool stays = written != nullptr && (!written->is_stated || (written->is_number && written->number == 0.0));
    if (!stays) facts[word].forget(statement);
  }

  // G74 to G76 without an end point.
  void take_cycle_data(const ir::Code& code) {
    if (std::ranges::any_of(values.words, [this](const ir::Word& word) { return positions.turns(word); })) return;
    set(ir::is_cycle(code, ir::RepetitiveCycle::thread) ? Mode::thread_data : Mode::peck_data, code.function,
        static_cast<std::int32_t>(statement));
  }
  void begin_turning_cycle() {
    for (const Kept end : {Kept::turn_x, Kept::turn_z}) facts[end].set({}, statement);
    facts[Kept::turn_taper].set({.is_number = true}, statement);
  }

  // G70 runs the blocks of its shape; after roughing what held before its cycle does.
  void forget_what_shapes_set() {
    for (const Mode mode : {Mode::motion, Mode::cycle, Mode::compensation, Mode::spindle, Mode::path})
      facts[mode].forget(statement);
    for (const Kept word : {Kept::feed, Kept::speed}) facts[word].forget(statement);
  }

  void take_drilling() {
    if (std::ranges::any_of(values.codes, [](const ir::Code& code) { return has_own_words(code); })) return;
    const Setting* cycle = facts[Mode::cycle].certain();
    if (cycle == nullptr) return forget_drilling();
    if (cycle->function == Function::drill) drilling.take_words();
  }
  // Where it is not known whether a cycle is in effect, a word may be the cycle's or not.
  void forget_drilling() {
    constexpr Kept kWords[] = {Kept::drill_depth, Kept::drill_level, Kept::drill_peck, Kept::drill_dwell,
                               Kept::drill_i,     Kept::drill_j,     Kept::initial};
    if (std::ranges::none_of(values.words, [](const ir::Word& word) {
          return ir::is_axis(word.address) || word.address == Address::r || word.address == Address::q ||
                 word.address == Address::p || word.address == Address::i || word.address == Address::j;
        }))
      return;
    for (const Kept word : kWords) facts[word].forget(statement);
    facts[Mode::hole_end].forget(statement);
  }

  // With G50 and G92 S is the limit of the spindle.
  void take_speed() {
    if (const ir::Word* limit = values.word(Address::spindle_limit); limit != nullptr)
      facts[Kept::spindle_limit].set(written(*limit, values), statement);
    const ir::Word* speed = values.word(Address::s);
    if (speed == nullptr) return;
    if (values.has_code(Function::set_coordinates))
      return facts[Kept::spindle_limit].set(written(*speed, values), statement);
    if (speed->extension > 1) return facts[Kept::speed].forget(statement);  // of another spindle
    facts[Kept::speed].set(written(*speed, values), statement);
    if (facts[Mode::surface_speed].may_be({.function = Function::surface_speed_on}))
      facts[Kept::surface_speed].set(written(*speed, values), statement);
  }

  void take_feed_and_speed() {
    // F and S of a dwell are times.
    if (values.has_code(Function::dwell) && !of.control_.semantics.dwell_p_is_ms) return;
    take_speed();
    const ir::Word* feed = values.word(Address::f);
    if (feed == nullptr) return;
    // With G34 and G35 of SINUMERIK it is the change of the lead.
    const bool may_be_change =
        !of.control_.semantics.arc_radius_is_r && of.changes_leads_ && may_change_lead(facts[Mode::motion]);
    if (may_be_change) return facts[Kept::feed].forget(statement);
    facts[Kept::feed].set(written(*feed, values), statement);
  }
};

void Effects::block(std::uint32_t statement, Facts& facts) const {
  const ir::Block& block = program_.blocks[program_.statements[statement].payload];
  if (block.rest_level == 0) return Walk{*this, statement, block, true, facts}.run();
  Facts without_rest = facts;
  Walk{*this, statement, block, false, without_rest}.run();
  Walk{*this, statement, block, true, facts}.run();
  facts.join(without_rest);
}

// --- one statement

void Effects::apply(std::uint32_t statement, Facts& facts) const {
  const ir::Statement& s = program_.statements[statement];
  std::optional<Facts> left_out =
      s.skip_level != 0 || may_be_left_out_[statement] ? std::optional(facts) : std::nullopt;
  carry_out(statement, facts);
  // What a block states counts as stated for the blocks of the same switch: an operator who skips it skips them.
  if (left_out && s.skip_level != 0) take_as_stated(*left_out);
  if (left_out) facts.join(*left_out);
  if (s.moves_follow) facts.forget_positions(statement);
}

void Effects::carry_out(std::uint32_t statement, Facts& facts) const {
  const ir::Statement& s = program_.statements[statement];
  switch (s.kind) {
    case StatementKind::block: block(statement, facts); break;
    case StatementKind::native: native(statement, facts); break;
    case StatementKind::repeat_section:
    case StatementKind::execute_text: facts.forget_all(statement); break;
    case StatementKind::call:
      if (!is_standard_cycle(program_, s)) {
        facts.forget_all(statement);
        break;
      }
      CalledCycleEffects{program_, control_, statement, facts}.run();
      // Its own moves are followed by what is called modally, too.
      if (!facts[Mode::modal_call].is({}) && moving(s) == Moving::no) forget_moves(statement, facts);
      break;
    case StatementKind::modal_call: set_modal_call(statement, facts); break;
    case StatementKind::modal_call_end: facts[Mode::modal_call].set({}, statement); break;
    case StatementKind::assign:
      if (may_be_system_variable(program_.at(program_.assigns[s.payload].target), control_))
        facts.forget_positions(statement);
      forget_computed(program_, program_.assigns[s.payload].target, facts);
      break;
    case StatementKind::for_begin:
      if (program_.structures[s.payload].counter != ir::VariableId::none)
        forget_computed(program_, program_.structures[s.payload].counter, facts);
      break;
    default: break;
  }
}

void Effects::native(std::uint32_t statement, Facts& facts) const {
  const ir::Statement& s = program_.statements[statement];
  const ir::Native& native = program_.natives[s.payload];
  if (!native.effects_known)
    facts.forget_all(statement);
  else if (native.moves)
    facts.forget_positions(statement);
  // A cycle that is not read stands after its modal call in the same line.
  const bool is_modal = statement > 0 && program_.statements[statement - 1].kind == StatementKind::modal_call_end &&
                        program_.statements[statement - 1].line == s.line;
  if (is_modal && !native.effects_known) set_modal_call(statement, facts);
}

void Effects::set_modal_call(std::uint32_t statement, Facts& facts) {
  facts[Mode::modal_call].set(
      {.function = Function::machine_function, .argument = static_cast<std::int32_t>(statement)}, statement);
}

FactSet Effects::touched(std::uint32_t statement) const {
  // Each has an origin of its own, so that one that is copied from another shows.
  Facts unknown;
  std::uint32_t origin = 0;
  for (Known<Setting>& mode : unknown.modes) mode = {.origin = origin++, .inherited = true};
  for (Known<double>& number : unknown.numbers) number = {.origin = origin++, .inherited = true};
  for (Known<Written>& word : unknown.kept) word = {.origin = origin++, .inherited = true};
  Facts after = unknown;
  apply(statement, after);
  return differing(unknown, after);
}

// A row or a circle of holes moves to each of them.
Moving Effects::moving(const ir::Statement& s) const {
  if (s.kind == StatementKind::call) {
    const ir::Call& call = program_.calls[s.payload];
    const bool is_pattern =
        ir::is_called(call, ir::CalledSort::holes_in_row) || ir::is_called(call, ir::CalledSort::holes_on_circle);
    if (!is_pattern && !ir::is_called(call, ir::CalledSort::holes_anywhere)) return Moving::no;
    const bool has_holes = is_pattern && s.skip_level == 0 &&
                           ir::number_of(program_, call, ir::CycleValue::pattern_count).value_or(0.0) >= 1.0;
    return has_holes ? Moving::yes : Moving::perhaps;
  }
  if (s.kind != StatementKind::block) return Moving::no;
  const ir::Block& block = program_.blocks[s.payload];
  if (block.word_count == 0 && block.code_count == 0) return Moving::no;
  const bool moves = s.skip_level == 0 && block.rest_level == 0 && !has_own_words(program_, block) &&
                     std::ranges::any_of(program_.words_of(block), ir::is_axis, &ir::Word::address);
  return moves ? Moving::yes : Moving::perhaps;
}

}  // namespace dripfeed::facts
