// Codes first, then tool, speed and feed, then the positions that the block's motion ends at. Whatever is not plainly a
// move to a number makes the position unknown: a fact may say less than a run does, never more.
#include "dialects/facts/effects.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "dialects/facts/axis_words.h"
#include "dialects/facts/block_values.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/shape_blocks.h"
#include "dialects/facts/transformation.h"
#include "dialects/ir/axis_letters.h"
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
      code.function == Function::stroke_check)
    return false;
  return has_own_words(code) || code.group == ModalGroup::work_offset || code.group == ModalGroup::unit ||
         code.group == ModalGroup::diameter || code.group == ModalGroup::length_offset ||
         code.function == Function::tool_change || code.function == Function::data_input ||
         code.function == Function::transformation || code.function == Function::work_offset ||
         code.function == Function::extended_offset;
}

// The block ends where its axis words say.
bool ends_at_its_words(const Setting& motion) {
  switch (motion.function) {
    case Function::rapid:
    case Function::linear:
    case Function::arc_cw:
    case Function::arc_ccw:
    case Function::thread:
    case Function::thread_changing: return true;
    default: return false;
  }
}

// Words that place the end elsewhere than at the axis words.
bool bends_the_end(Address a) {
  return a == Address::polar_angle || a == Address::polar_radius || a == Address::named_axis ||
         a == Address::direct_angle || a == Address::chamfer || a == Address::chamfer_length ||
         a == Address::rounding || a == Address::modal_rounding || a == Address::measuring || a == Address::other ||
         (a >= Address::poly_x2 && a <= Address::poly_z5);
}

// What a caller outside of the text or a called program there left on is not looked for.
bool may_be_on(const Known<Setting>& fact, Function off) {
  return fact.more || (fact.origin != kNobody && fact.value.function != off) ||
         (fact.other_origin != kNobody && fact.other.function != off);
}

}  // namespace

FactSet differing(const Facts& a, const Facts& b) {
  FactSet set;
  for (std::size_t i = 0; i < kModes; ++i) set[i] = !(a.modes[i] == b.modes[i]);
  for (std::size_t i = 0; i < kNumbers; ++i) set[kModes + i] = !(a.numbers[i] == b.numbers[i]);
  return set;
}

Effects::Effects(const ir::Program& program, const ir::Control& control)
    : program_(program),
      control_(control),
      tool_at_once_(control.kind == ir::MachineKind::lathe ||
                    control.semantics.tool_word == ir::ToolWord::number_and_offset),
      shape_(blocks_of_shapes(program)) {}

// --- one block

struct Effects::Walk {
  const Effects& of;
  std::uint32_t statement;
  const ir::Block& block;
  bool with_rest;  // with what stands after "/n" inside the block
  Facts& facts;
  BlockValues values = BlockValues(of.program_, block, with_rest);

  void run() {
    if (values.has_computed_code('G')) return facts.forget_all(statement);
    const Known<Setting> feed_before = facts[Mode::feed];
    const bool names_speed =
        std::ranges::any_of(values.codes, [](const ir::Code& code) { return mode_of(code) == Mode::surface_speed; });
    for (const ir::Code& code : values.codes) take_code(code, names_speed, feed_before);
    if (values.has_computed_code('M'))
      for (const Mode mode : {Mode::spindle, Mode::coolant, Mode::length}) facts[mode].forget(statement);
    take_tool();
    take_length();
    take_feed_and_speed();
    take_positions();
  }

  void set(Mode mode, Function function, std::int32_t argument = 0) {
    facts[mode].set({.function = function, .argument = argument}, statement);
  }
  void set_or_forget(Number number, std::optional<double> value) {
    value ? facts[number].set(*value, statement) : facts[number].forget(statement);
  }

  void take_code(const ir::Code& code, bool names_speed, const Known<Setting>& feed_before) {
    const std::optional<Mode> mode = mode_of(code);
    if (loses_positions(code)) facts.forget_positions(statement);
    if (ir::follows_shape(code)) forget_what_shapes_set();
    if (shifts(code)) take_shift(code);
    if (!mode) return;
    switch (*mode) {
      case Mode::motion: set(Mode::cycle, Function::cycle_off); break;
      case Mode::unit:
        for (const Number length : {Number::feed, Number::shift_x, Number::shift_y, Number::shift_z})
          forget_unless_zero(length);
        break;
      case Mode::frame: return take_frame(code);
      case Mode::transformation:
        return ends_transformation(of.program_, block, code)
                   ? set(Mode::transformation, Function::none)
                   : set(Mode::transformation, code.function, static_cast<std::int32_t>(statement));
      case Mode::pole: return set(Mode::pole, code.function, static_cast<std::int32_t>(statement));
      case Mode::feed:
        if (!feed_before.is({.function = code.function})) forget_unless_zero(Number::feed);
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
        set_or_forget(number, coordinate(*word, *axis_of(axis)));
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

  void forget_unless_zero(Number number) {
    if (!facts[number].is(0.0)) facts[number].forget(statement);
  }

  // G70 to G73 run the blocks of their shape.
  void forget_what_shapes_set() {
    for (const Mode mode : {Mode::motion, Mode::cycle, Mode::compensation, Mode::spindle, Mode::path})
      facts[mode].forget(statement);
    for (const Number number : {Number::feed, Number::speed}) facts[number].forget(statement);
  }

  void take_tool() {
    const bool changes = values.has_code(Function::tool_change);
    const ir::Word* tool = values.word(Address::t);
    if (tool != nullptr) {
      std::optional<double> number = values.is_text(*tool) ? std::optional(kToolByName) : values.constant(*tool);
      if (number && of.control_.semantics.tool_word == ir::ToolWord::number_and_offset)
        number = tool_of_pair(*number).tool;
      set_or_forget(Number::next_tool, number);
    }
    if (!changes && (tool == nullptr || !of.tool_at_once_)) return;
    facts[Number::tool] = facts[Number::next_tool];
    facts.forget_positions(statement);
  }

  // By G43, G44 and G49 with H, by the offset of T0101, or by D where that is a cutting edge of the tool.
  void take_length() {
    for (const ir::Code& code : values.codes)
      if (mode_of(code) == Mode::length) set(Mode::length, code.function);
    const ir::Semantics& semantics = of.control_.semantics;
    if (semantics.d_selects_edge) return take_edge();
    const ir::Word* tool = values.word(Address::t);
    if (semantics.tool_word == ir::ToolWord::number_and_offset && tool != nullptr) {
      const std::optional<double> pair = values.constant(*tool);
      set_length_number(pair ? std::optional(tool_of_pair(*pair).offset) : std::nullopt);
    }
    if (const ir::Word* number = h_is_length() ? values.word(Address::h) : nullptr; number != nullptr)
      set_or_forget(Number::length_number, values.constant(*number));
  }

  // On lathes of G-code system A H is an increment of C.
  [[nodiscard]] bool h_is_length() const { return !ir::incremented_axis(of.control_, 'H').has_value(); }

  // Of a control whose T or D brings the length along.
  void set_length_number(std::optional<double> number) {
    set_or_forget(Number::length_number, number);
    set(Mode::length, Function::length_offset_plus);
  }

  // A tool that comes in brings its first edge along (MD20270).
  void take_edge() {
    const bool comes_in =
        values.has_code(Function::tool_change) || (of.tool_at_once_ && values.word(Address::t) != nullptr);
    if (comes_in) {
      constexpr double kFirstEdge = 1.0;
      const double* tool = facts[Number::tool].certain();
      set_length_number(tool == nullptr ? std::nullopt : std::optional(*tool == 0.0 ? 0.0 : kFirstEdge));
    }
    const ir::Word* edge = values.word(Address::d);
    if (edge == nullptr) return;
    facts.forget_positions(statement);
    set_length_number(values.constant(*edge));
  }

  void take_feed_and_speed() {
    // F and S of a dwell are times.
    if (values.has_code(Function::dwell) && !of.control_.semantics.dwell_p_is_ms) return;
    if (const ir::Word* speed = values.word(Address::s);
        speed != nullptr && !values.has_code(Function::set_coordinates))
      set_or_forget(Number::speed, values.constant(*speed));
    const ir::Word* feed = values.word(Address::f);
    if (feed == nullptr) return;
    // With G34 and G35 of SINUMERIK it is the change of the lead.
    const bool may_be_change =
        !of.control_.semantics.arc_radius_is_r && facts[Mode::motion].may_be({.function = Function::thread_changing});
    set_or_forget(Number::feed, may_be_change ? std::nullopt : values.constant(*feed));
  }

  void take_positions() {
    const bool other_letters = may_be_on(facts[Mode::transformation], Function::none) ||
                               may_be_on(facts[Mode::letters], Function::polar_words_off);
    if (other_letters) return facts.forget_positions(statement);
    if (std::ranges::any_of(values.codes, [](const ir::Code& code) { return has_own_words(code); })) return;
    const auto names_axis = [this](const ir::Word& word) { return target_of(word).has_value(); };
    if (std::ranges::any_of(values.words, [](const ir::Word& word) { return bends_the_end(word.address); }))
      return facts.forget_positions(statement);
    if (std::ranges::none_of(values.words, names_axis)) return;
    const Known<Setting>& motion = facts[Mode::motion];
    const bool plain = facts[Mode::cycle].is({.function = Function::cycle_off}) && !motion.is_open() &&
                       ends_at_its_words(motion.value) &&
                       (motion.other_origin == kNobody || ends_at_its_words(motion.other));
    if (!plain) return facts.forget_positions(statement);
    for (const ir::Word& word : values.words) take_axis(word);
  }

  struct AxisTarget {
    Number axis;
    bool by_letter;  // the letter itself says that it is an increment
  };
  [[nodiscard]] std::optional<AxisTarget> target_of(const ir::Word& word) const {
    const std::optional<char> letter =
        word.address <= Address::z ? ir::incremented_axis(of.control_, ir::letter_of(word.address)) : std::nullopt;
    if (letter) return AxisTarget{*axis_of(static_cast<Address>(*letter - 'A')), true};
    const std::optional<Number> axis = axis_of(word.address);
    return axis ? std::optional(AxisTarget{*axis, false}) : std::nullopt;
  }

  void take_axis(const ir::Word& word) {
    const std::optional<AxisTarget> target = target_of(word);
    if (!target) return;
    Known<double>& position = facts[target->axis];
    const std::optional<double> value = coordinate(word, target->axis);
    const std::optional<bool> increment = is_increment(word, *target);
    if (!value || !increment) return position.forget(statement);
    if (!*increment) return position.set(*value, statement);
    // Under DIAM90 an increment is a radius where X is a diameter.
    const Setting* diameter = facts[Mode::diameter].certain();
    const bool halves =
        target->axis == Number::x && (diameter == nullptr || diameter->function == Function::diameter_absolute_only);
    const double* from = position.certain();
    if (from == nullptr || halves) return position.forget(statement);
    position.set(*from + *value, statement);
  }

  [[nodiscard]] std::optional<bool> is_increment(const ir::Word& word, const AxisTarget& target) const {
    if (target.by_letter) return true;
    if (word.mode != ir::WordMode::as_modal) return word.mode == ir::WordMode::incremental;
    if (of.control_.semantics.incremental_letters_uvw) return false;
    const Setting* distance = facts[Mode::distance].certain();
    return distance == nullptr ? std::nullopt : std::optional(distance->function == Function::incremental);
  }

  // In the program's unit; nothing where it is computed, or counts increments of an unknown unit.
  [[nodiscard]] std::optional<double> coordinate(const ir::Word& word, Number axis) const {
    const std::optional<double> value = values.constant(word);
    const ir::Semantics& semantics = of.control_.semantics;
    if (!value || *value == 0.0 || values.has_point(word) || semantics.decimal_mode == ir::DecimalMode::calculator)
      return value;
    if (axis >= Number::a && axis <= Number::c) return std::nullopt;
    const Setting* unit = facts[Mode::unit].certain();
    return unit == nullptr ? std::nullopt
                           : std::optional(of_increments(*value, semantics, unit->function == Function::unit_inch));
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
  const std::optional<Facts> left_out = s.skip_level != 0 || shape_[statement] ? std::optional(facts) : std::nullopt;
  switch (s.kind) {
    case StatementKind::block: block(statement, facts); break;
    case StatementKind::native:
      if (!program_.natives[s.payload].effects_known)
        facts.forget_all(statement);
      else if (program_.natives[s.payload].moves)
        facts.forget_positions(statement);
      break;
    case StatementKind::repeat_section:
    case StatementKind::execute_text: facts.forget_all(statement); break;
    case StatementKind::call:
      if (!is_standard_cycle(program_, s)) {
        facts.forget_all(statement);
        break;
      }
      facts.forget_positions(statement);
      facts[Mode::spindle].forget(statement);
      break;
    case StatementKind::modal_call:
      facts[Mode::modal_call].set(
          {.function = Function::machine_function, .argument = static_cast<std::int32_t>(statement)}, statement);
      break;
    case StatementKind::modal_call_end: facts[Mode::modal_call].set({}, statement); break;
    case StatementKind::assign:
      if (may_be_system_variable(program_.at(program_.assigns[s.payload].target), control_))
        facts.forget_positions(statement);
      break;
    default: break;
  }
  if (left_out) facts.join(*left_out);
}

FactSet Effects::touched(std::uint32_t statement) const {
  // Each has an origin of its own, so that one that is copied from another shows.
  Facts unknown;
  std::uint32_t origin = 0;
  for (Known<Setting>& mode : unknown.modes) mode = {.origin = origin++, .inherited = true};
  for (Known<double>& number : unknown.numbers) number = {.origin = origin++, .inherited = true};
  Facts after = unknown;
  apply(statement, after);
  return differing(unknown, after);
}

bool Effects::may_move(const ir::Statement& s) const {
  if (s.kind != StatementKind::block) return false;
  const ir::Block& block = program_.blocks[s.payload];
  return block.word_count != 0 || block.code_count != 0;
}

}  // namespace dripfeed::facts
