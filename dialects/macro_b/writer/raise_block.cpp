// Codes go by what they do: the target's table says how. Words go by their address; axis words get their decimal point,
// their diameter and their letter for increments.
#include "dialects/macro_b/writer/raise_block.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dialects/facts/calls.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/ir/cycle.h"
#include "dialects/ir/frame_use.h"
#include "dialects/ir/hole_pattern.h"
#include "dialects/ir/idle_code.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/macro_b/reader/lower.h"
#include "dialects/macro_b/writer/print.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::DiameterMode;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;

constexpr std::string_view kCenterLetters = "IJK";
constexpr std::string_view kRotaryLetters = "ABC";
constexpr std::int16_t kLastPlainOffset = 6;  // G59
constexpr int kToBaseLetter = 'X' - 'U';      // U V W are increments of X Y Z
constexpr std::int16_t kLengthsOnly = 1;      // argument of unit_inch: feeds stay in mm
constexpr std::int16_t kWholeShift = 1;       // argument of local_shift

bool holds(std::string_view letters, Address address) { return letters.contains(letter_of(address)); }

bool is_center(const ir::Word& word) { return holds(kCenterLetters, word.address); }

bool is_increment_of_c(const ir::Word& word, const ir::Control& control) {
  return word.address == Address::h && ir::incremented_axis(control, 'H').has_value();
}
ir::Word increment_of_c(ir::Word word) {
  word.address = Address::c;
  word.mode = ir::WordMode::incremental;
  return word;
}

// Functions that say nothing on a control that is always so; and how splines end, where they themselves are refused.
bool goes_without_saying(Function function) {
  return function == Function::absolute || function == Function::incremental || function == Function::no_effect ||
         function == Function::return_to_initial || function == Function::return_to_r ||
         function == Function::spline_begin || function == Function::spline_end || function == Function::cycle_off ||
         function == Function::none;
}

// Functions that are more than their name in a table: others stand for several codes. Which offset a measured length
// goes to, and what the words in its block say, each control has its own rules.
bool is_translated_by_table(Function function) {
  return function != Function::no_effect && function != Function::not_modelled && function != Function::approach &&
         function != Function::measure_tool;
}

}  // namespace

BlockRaiser::BlockRaiser(ir::Program& program, const ir::Control& from, const ir::Control& to, passes::Rewrite& out,
                         std::vector<text::Diagnostic>& diagnostics)
    : program_(program),
      from_(from),
      to_(to),
      out_(out),
      diagnostics_(diagnostics),
      same_(from.dialect == to.dialect && from.kind == to.kind && from.g_system == to.g_system),
      edges_(from.semantics.d_selects_edge),
      plane_is_xy_(from.semantics.power_on_plane == Function::plane_xy),
      inch_(from.semantics.power_on_unit == Function::unit_inch),
      diameter_(from.semantics.power_on_diameter) {
  if (!edges_ || same_) return;
  tools_.emplace(program, from, facts::ToolChange::as_the_text);
  calls_others_ = std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    return facts::is_call(s.kind) && !facts::is_standard_cycle(program, s);
  });
}

void BlockRaiser::cannot(const ir::Statement& statement, passes::Refusal what) {
  if (program_.source.text().empty()) what.what += fmt::format(" (line {})", statement.line);
  diagnostics_.push_back(passes::diagnose(std::move(what), statement.span, to_.title));
}

void BlockRaiser::leave_out(const ir::Statement& statement, passes::Refusal what) {
  cannot(statement, std::move(what));
  diagnostics_.back().severity = text::Severity::warning;
}

void BlockRaiser::block(const ir::Statement& statement, std::uint32_t index) {
  statement_ = &statement;
  index_ = index;
  foreign_ = ir::is_foreign(program_, index);
  const ir::Block old = program_.blocks[statement.payload];
  const auto old_codes = program_.codes_of(old);
  const auto old_words = program_.words_of(old);
  const std::vector<ir::Code> codes(old_codes.begin(), old_codes.end());
  const std::vector<ir::Word> words(old_words.begin(), old_words.end());
  draft_ = {};
  shifts_whole_ = false;
  leaves_words_ = false;
  before_.clear();
  after_.clear();
  counts_factors_ = std::ranges::any_of(words, [&](const ir::Word& w) {
    const ir::Expression& e = program_.at(w.value);
    return (is_center(w) || w.address == Address::p) && e.op == Operator::constant && !e.has_point;
  });
  for (const ir::Code& c : codes) code(c);
  const Traits traits = traits_of(codes, words);
  for (const ir::Word& w : words)
    if (!leaves_words_ || !ir::is_word_of_idle_code(w.address)) word(w, traits);
  const bool changes = tools_ && !foreign_ && traits.tool_change;
  if (traits.tool != nullptr || traits.edge != nullptr || changes) tool_words(traits);
  if (traits.comp && tools_ && !foreign_) compensation_number();
  if (shifts_whole_ && !same_) whole_shift();
  distance_frame(traits);
  if (!same_) split_m_codes();
  if (old.rest_level != 0 && !keeps_rest(old)) return cannot(statement, passes::at_switch("block skip inside a block"));
  draft_.rest_level = old.rest_level;
  draft_.rest_begin = old.rest_begin;
  emit_all();
}

BlockRaiser::Traits BlockRaiser::traits_of(const std::vector<ir::Code>& codes,
                                           const std::vector<ir::Word>& words) const {
  Traits traits;
  for (const ir::Code& c : codes) {
    traits.dwell |= c.function == Function::dwell;
    traits.tool_change |= c.function == Function::tool_change;
    traits.drills |= c.function == Function::drill;
    traits.repeats |= c.function == Function::repetitive_cycle;
    traits.counts_passes |= ir::is_cycle(c, ir::RepetitiveCycle::pattern);
    traits.changes_lead |= c.function == Function::thread_changing;
    traits.threads |= c.function == Function::thread || c.function == Function::thread_changing;
    if (c.function == Function::hole_pattern) traits.pattern = c.argument;
    traits.comp |= c.function == Function::comp_left || c.function == Function::comp_right;
  }
  for (const ir::Word& w : words) {
    if (w.address == Address::t && !foreign_) traits.tool = &w;
    if (w.address == Address::d && edges_ && !foreign_) traits.edge = &w;
    if ((!holds(ir::kAxisLetters, w.address) && !is_increment_of_c(w, from_)) || traits.dwell) continue;
    traits.any_incremental |= is_incremental(w);
    traits.any_absolute |= !is_incremental(w);
  }
  return traits;
}

// By itself or by its letter; the mode is another matter.
bool BlockRaiser::is_incremental(const ir::Word& word) const {
  const bool by_letter =
      (from_.semantics.incremental_letters_uvw && holds("UVW", word.address)) || is_increment_of_c(word, from_);
  const bool by_mode = word.mode == ir::WordMode::as_modal && incremental_;
  return word.mode == ir::WordMode::incremental || by_letter || by_mode;
}

ir::Code BlockRaiser::code_of(Function function, std::int16_t argument) const {
  ir::Code code;
  code.function = function;
  code.argument = argument;
  if (const ir::CodeRow* row = find_function(to_, function, argument); row != nullptr) {
    code.group = row->group;
    code.letter = row->name.front();
  }
  return code;
}

ir::Word BlockRaiser::word_of(Address address, ExpressionId value) const {
  ir::Word word;
  word.address = address;
  word.value = value;
  return word;
}

void BlockRaiser::code(const ir::Code& code) {
  const Function f = code.function;
  follow_direction(code);
  if (f == Function::absolute || f == Function::incremental) incremental_ = f == Function::incremental;
  if (f == Function::unit_inch || f == Function::unit_mm) inch_ = f == Function::unit_inch;
  if (f == Function::unit_inch || f == Function::unit_mm) feed_in_mm_ = inch_ && code.argument == kLengthsOnly;
  shifts_whole_ |= f == Function::local_shift && code.argument == kWholeShift;
  if (f == Function::diameter_on) diameter_ = DiameterMode::diameter;
  if (f == Function::diameter_off) diameter_ = DiameterMode::radius;
  if (f == Function::diameter_absolute_only) diameter_ = DiameterMode::diameter_absolute_only;
  if (f == Function::diameter_on || f == Function::diameter_off || f == Function::diameter_absolute_only) return;
  if (same_) return draft_.codes.push_back(code);
  // T0606 is T6 M6 of the others; where both have T0606, an M6 next to it is an order of its own.
  if (f == Function::tool_change && to_.semantics.tool_word == ir::ToolWord::number_and_offset &&
      from_.semantics.tool_word != to_.semantics.tool_word)
    return;
  if (code.number != ExpressionId::none)
    return cannot(*statement_, passes::computed("a code with a calculated number"));
  if (f == Function::machine_function) return draft_.codes.push_back(code);
  const bool factors = f == Function::scale && code.argument == ir::kFrameAboutPoint;
  if (factors && counts_factors_ && from_.semantics.scale_unit != to_.semantics.scale_unit)
    return cannot(*statement_, passes::by_parameter("scaling, whose factors are counted differently here"));
  if (f == Function::work_offset && code.argument > kLastPlainOffset) {
    ir::Code extended = code_of(Function::work_offset, 1);
    extended.argument = code.argument > kExtendedOffset
                            ? code.argument
                            : static_cast<std::int16_t>(kExtendedOffset + code.argument - kLastPlainOffset);
    return draft_.codes.push_back(extended);
  }
  if (f == Function::transformation && code.argument == ir::kTransformationEnds && !begins_transformation()) return;
  if (f == Function::no_effect || f == Function::continuous_path) return code_by_name(code);
  if (is_translated_by_table(f) && find_function(to_, f, code.argument) != nullptr) {
    ir::Code raised = code_of(f, code.argument);
    raised.span = code.span;
    if (f == Function::drill) raised.name = code.name;
    return draft_.codes.push_back(raised);
  }
  if (goes_without_saying(f) || ir::ends_frame(f, code.argument)) return;
  const std::string_view name = program_.strings.at(code.name);
  cannot(*statement_, name.empty() ? std::string(ir::name_of(f)) : std::string(name));
}

// Look-ahead, smoothing, high precision: by the same name, with its words, or not at all, which is reported. G61.1 is
// G64 where it has no name. What only ends something has nothing to end here.
void BlockRaiser::code_by_name(const ir::Code& code) {
  const std::string_view name = program_.strings.at(code.name);
  const auto row = std::ranges::find(to_.g_codes, name, &ir::CodeRow::name);
  if (row != to_.g_codes.end() && row->function == code.function) return draft_.codes.push_back(code);
  const bool goes_on = code.function == Function::continuous_path;
  if (goes_on) draft_.codes.push_back(code_of(code.function, code.argument));
  if (code.group == ir::ModalGroup::frame || name.empty() || name == "G64") return;
  leaves_words_ = true;
  cannot(*statement_, std::string(name) + (goes_on ? ", written as G64," : ""));
  diagnostics_.back().severity = text::Severity::warning;
}

// What moves, as the blocks after it count on it.
void BlockRaiser::follow_direction(const ir::Code& code) {
  const Function f = code.function;
  if (f >= Function::plane_xy && f <= Function::plane_yz) plane_is_xy_ = f == Function::plane_xy;
  if (code.group != ir::ModalGroup::motion && code.group != ir::ModalGroup::cycle) return;
  moves_by_ = f == Function::nurbs ? MovesBy::curve : f == Function::drill ? MovesBy::holes : MovesBy::other;
  const auto cycle = static_cast<ir::DrillCycle>(code.argument);
  shifts_ = moves_by_ == MovesBy::holes && (cycle == ir::DrillCycle::fine_bore || cycle == ir::DrillCycle::back_bore);
}

// Words that count or weigh, with a letter that is a length elsewhere: holes (K), passes (R of G73), knots and weights.
bool BlockRaiser::is_plain_number(const ir::Word& word, const Traits& traits) const {
  if (word.address == Address::r) return traits.counts_passes || moves_by_ == MovesBy::curve;
  if (word.address != Address::k) return false;
  return moves_by_ == MovesBy::curve || (moves_by_ == MovesBy::holes && !(shifts_ && !plane_is_xy_));
}

// Only one that these controls have themselves: others are refused, and their end by itself ends nothing.
bool BlockRaiser::begins_transformation() const {
  return std::ranges::any_of(program_.codes, [](const ir::Code& c) {
    return c.function == Function::transformation &&
           (c.argument == ir::kFaceByRotary || c.argument == ir::kCylinderByRotary);
  });
}

void BlockRaiser::word(const ir::Word& word, const Traits& traits) {
  if (traits.tool == &word || traits.edge == &word) return;
  if (same_ && !holds(ir::kAxisLetters, word.address) && !is_center(word) && word.address != Address::r) {
    return draft_.words.push_back(word);
  }
  if (program_.at(word.value).op == Operator::string)
    return cannot(*statement_, passes::of_value("a word with a name as its value"));
  if (traits.dwell && !from_.semantics.dwell_p_is_ms) return dwell_word(word);
  if (traits.repeats && word.address == Address::a) return draft_.words.push_back(word);  // the angle of a thread
  if (holds(ir::kAxisLetters, word.address) && !traits.dwell) return axis_word(word);
  if (is_increment_of_c(word, from_)) return axis_word(increment_of_c(word));
  if (is_increment_of_c(word, to_))
    return cannot(*statement_, passes::of_tool("H of a tool length, which is an increment of C there,"));
  if (traits.pattern >= 0 && (is_center(word) || word.address == Address::p)) return pattern_word(word, traits.pattern);
  // What it counts without a point, a parameter decides.
  const bool in_increments = from_.semantics.decimal_mode == ir::DecimalMode::least_increment &&
                             program_.at(word.value).op == Operator::constant && !program_.at(word.value).has_point;
  if (traits.changes_lead && !same_ && word.address == Address::k && in_increments)
    return cannot(*statement_, passes::by_parameter("the change of a lead without a point"));
  // Mazak's second feed of G85, which others do not have.
  if (!same_ && word.address == Address::e && moves_by_ == MovesBy::holes)
    return cannot(*statement_, passes::together("the word E together with a drilling cycle"));
  if (word.extension > 1 && word.address != Address::other)
    return cannot(*statement_, "a word with the number of a spindle or axis");
  ir::Word raised = word;
  raised.extension = 0;
  if (word.address == Address::spindle_limit) return speed_limit(word);
  if (word.address == Address::arc_radius) raised.address = Address::r;
  // A lead by the letter of its axis: here it is F along either.
  if (traits.threads && word.address == Address::i && !from_.semantics.arc_radius_is_r) raised.address = Address::f;
  if (is_center(word) && word.mode == ir::WordMode::absolute) return cannot(*statement_, "an absolute arc centre");
  if (word.address == Address::direct_angle) {
    // Not every mill has it.
    if (!from_.semantics.arc_radius_is_r && to_.kind == ir::MachineKind::mill)
      return cannot(*statement_, "a line by its angle");
    raised.value = with_point(raised.value, true);
    return draft_.words.push_back(raised);
  }
  if (word.address == Address::rounding || word.address == Address::chamfer) {
    // ,R1 of a tap is a choice, no length.
    if (!traits.drills) raised.value = with_point(raised.value, false);
    return draft_.words.push_back(raised);
  }
  const bool length = (is_center(word) || holds(ir::kAxisLetters, word.address) || raised.address == Address::r) &&
                      !is_plain_number(word, traits);
  if (length || raised.address == Address::f) {
    const bool counts = length || from_.semantics.decimal_mode == ir::DecimalMode::calculator;
    if (counts) raised.value = with_point(raised.value, false);
    if (raised.address == Address::f && feed_in_mm_ && !same_ && !traits.threads)
      raised.value = scaled(raised.value, 1.0 / 25.4);
  }
  if (raised.address > Address::z && !(from_.dialect == to_.dialect)) {
    const std::string_view written = word.span.in(program_.source.text());
    return cannot(*statement_, written.empty() ? "a word that this control has no address for"
                                               : fmt::format("the word {}", written));
  }
  draft_.words.push_back(raised);
}

// Increments become letters where the control has letters for them; diameters are what lathes take.
void BlockRaiser::axis_word(ir::Word word) {
  const bool rotary = holds(kRotaryLetters, word.address);
  const bool by_letter = from_.semantics.incremental_letters_uvw && holds("UVW", word.address);
  const bool incremental = is_incremental(word);
  if (by_letter) word.address = static_cast<Address>(static_cast<int>(word.address) + kToBaseLetter);
  word.value = with_point(word.value, rotary);
  const bool turning = from_.kind != ir::MachineKind::mill && to_.kind != ir::MachineKind::mill;
  const bool as_radius =
      diameter_ == DiameterMode::radius || (diameter_ == DiameterMode::diameter_absolute_only && incremental);
  if (turning && word.address == Address::x && as_radius && to_.semantics.power_on_diameter == DiameterMode::diameter) {
    word.value = scaled(word.value, 2.0);
  }
  if (incremental && to_.semantics.incremental_letters_uvw) {
    if (word.address == Address::c && ir::incremented_axis(to_, 'H'))
      word.address = Address::h;
    else if (!holds("XYZ", word.address))
      return cannot(*statement_, "an increment of a rotary axis");
    else
      word.address = static_cast<Address>(static_cast<int>(word.address) - kToBaseLetter);
  }
  word.mode = ir::WordMode::as_modal;
  draft_.words.push_back(word);
}

// Where increments have no letters, a block of them is put between G91 and G90.
void BlockRaiser::distance_frame(const Traits& traits) {
  if (to_.semantics.incremental_letters_uvw || draft_.words.empty()) return;
  if (traits.any_incremental && traits.any_absolute)
    return cannot(*statement_, passes::together("absolute and incremental words in one block"));
  const bool incremental = traits.any_incremental;
  if ((!traits.any_incremental && !traits.any_absolute) || incremental == incremental_) return;
  // G90 X=IC(5): the block's own code is the one after it.
  std::erase_if(draft_.codes, [](const ir::Code& c) {
    return c.function == Function::absolute || c.function == Function::incremental;
  });
  before_.push_back({{code_of(incremental ? Function::incremental : Function::absolute)}, {}});
  after_.push_back({{code_of(incremental ? Function::absolute : Function::incremental)}, {}});
}

void BlockRaiser::whole_shift() {
  for (const char letter : to_.axes) {
    const auto address = static_cast<Address>(letter - 'A');
    if (std::ranges::find(draft_.words, address, &ir::Word::address) == draft_.words.end()) {
      draft_.words.push_back(word_of(address, program_.add_constant(0.0)));
    }
  }
}

// Seconds to milliseconds.
void BlockRaiser::dwell_word(const ir::Word& word) {
  if (word.address != Address::f) return cannot(*statement_, "a dwell in turns of the spindle");
  draft_.words.push_back(word_of(Address::p, scaled(word.value, 1000.0)));
}

// G50 S or G92 S in a block before.
void BlockRaiser::speed_limit(const ir::Word& word) {
  if (find_function(to_, Function::set_coordinates, 0) == nullptr)
    return cannot(*statement_, "a limit of the spindle speed");
  before_.push_back({{code_of(Function::set_coordinates)}, {word_of(Address::s, word.value)}});
}

// Numbers of holes stay whole, angles are degrees, the rest are lengths.
void BlockRaiser::pattern_word(ir::Word word, std::int16_t pattern) {
  const bool grid = pattern == ir::kHolesOnGrid;
  const bool count = word.address == Address::k || (grid && word.address == Address::p);
  const bool angle = !grid && (word.address == Address::j || word.address == Address::p);
  if (!count) word.value = with_point(word.value, angle);
  draft_.words.push_back(word);
}

bool BlockRaiser::is_constant(ExpressionId id, double value) const {
  if (id == ExpressionId::none) return false;
  const ir::Expression& e = program_.at(id);
  return e.op == Operator::constant && e.value == value;
}

ExpressionId BlockRaiser::scaled(ExpressionId value, double factor) {
  const ir::Expression e = program_.at(value);
  if (e.op == Operator::constant) return program_.add_constant(e.value * factor, e.span, e.has_point);
  return program_.add_operator(Operator::multiply, value, program_.add_constant(factor, e.span), e.span);
}

// A constant as the source control took it, with the point written.
ExpressionId BlockRaiser::with_point(ExpressionId value, bool rotary) {
  const ir::Expression e = program_.at(value);
  if (e.op != Operator::constant || e.has_point) return value;
  double number = e.value;
  if (from_.semantics.decimal_mode == ir::DecimalMode::least_increment) {
    const double per_unit =
        std::nearbyint(1.0 / (rotary ? from_.semantics.least_increment_deg : from_.semantics.least_increment_mm));
    number /= inch_ && !rotary ? per_unit * 10.0 : per_unit;
  }
  return program_.add_constant(number, e.span, true);
}

// What the switch leaves out is still the same words of the same block.
bool BlockRaiser::keeps_rest(const ir::Block& old) const {
  const auto count = [&](const auto& list) {
    return std::ranges::count_if(list, [&](const auto& one) { return in_rest(old, one.span); });
  };
  const auto before = count(program_.codes_of(old)) + count(program_.words_of(old));
  return before_.empty() && after_.empty() && count(draft_.codes) + count(draft_.words) == before;
}

void BlockRaiser::emit_all() {
  for (const Draft& draft : before_) emit(draft);
  if (!draft_.empty()) emit(draft_);
  for (const Draft& draft : after_) emit(draft);
}

void BlockRaiser::emit(const Draft& draft) {
  ir::Block block;
  block.first_code = static_cast<std::uint32_t>(program_.codes.size());
  block.code_count = static_cast<std::uint32_t>(draft.codes.size());
  block.first_word = static_cast<std::uint32_t>(program_.words.size());
  block.word_count = static_cast<std::uint32_t>(draft.words.size());
  program_.codes.insert(program_.codes.end(), draft.codes.begin(), draft.codes.end());
  program_.words.insert(program_.words.end(), draft.words.begin(), draft.words.end());
  block.rest_level = draft.rest_level;
  block.rest_begin = draft.rest_begin;
  program_.blocks.push_back(block);
  out_.emit(ir::StatementKind::block, static_cast<std::uint32_t>(program_.blocks.size() - 1));
}

}  // namespace dripfeed::macro_b
