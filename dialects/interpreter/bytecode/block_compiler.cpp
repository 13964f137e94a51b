// Templates of blocks.
#include "dialects/interpreter/bytecode/block_compiler.h"

#include <algorithm>

#include "dialects/ir/alarm_details.h"
#include "dialects/ir/idle_code.h"
#include "dialects/ir/other_spindle.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;

constexpr std::uint64_t kAxisLetters64 = bit_of(Address::x) | bit_of(Address::y) | bit_of(Address::z) |
                                         bit_of(Address::a) | bit_of(Address::b) | bit_of(Address::c) |
                                         bit_of(Address::u) | bit_of(Address::v) | bit_of(Address::w);
constexpr std::uint64_t kGeometryNotModelled = bit_of(Address::other);

// Codes whose axis words are no positions to move to, and that say themselves when they are not interpreted.
bool takes_axis_words(const ir::Code& code) {
  if (code.function == Function::not_modelled) return true;
  return code.function == Function::dwell || code.function == Function::set_coordinates ||
         code.function == Function::data_input || code.function == Function::repetitive_cycle;
}

std::string_view name_of_code(const ir::Program& program, const ir::Code& code) {
  if (code.name != ir::StringId::none) return program.strings.at(code.name);
  return ir::name_of(code.function);
}

}  // namespace

BlockCompiler::BlockCompiler(CodeBuilder& builder, ExpressionCompiler& expressions)
    : builder_(builder),
      expressions_(expressions),
      names_main_(std::ranges::find(builder.source().codes, Function::main_spindle, &ir::Code::function) !=
                  builder.source().codes.end()) {}

void BlockCompiler::compile(const ir::Block& block, text::Span span) {
  CompiledProgram& out = builder_.out();
  const auto index_in = [](const auto& table) { return static_cast<std::uint32_t>(table.size()); };
  BlockTemplate made{.first_word = index_in(out.words), .first_code = index_in(out.codes)};
  BlockExtra extra{.first_word = index_in(out.computed_words),
                   .first_code = index_in(out.computed_codes),
                   .first_report = index_in(out.block_reports)};
  words_belong_to_code_ = std::ranges::any_of(builder_.source().codes_of(block), takes_axis_words);
  compile_codes(block);
  const bool skips = builder_.context().skips(block.rest_level);
  has_other_speed_ = false;
  drills_ = std::ranges::any_of(builder_.source().codes_of(block),
                                [](const ir::Code& c) { return c.function == Function::drill; });
  const bool idles = std::ranges::any_of(builder_.source().codes_of(block),
                                         [](const ir::Code& c) { return ir::idles(c.function, c.group); });
  for (const ir::Word& word : builder_.source().words_of(block)) {
    if (idles && ir::is_word_of_idle_code(word.address)) continue;
    if (!skips || !in_rest(block, word.span)) compile_word(word);
  }

  made.word_count = static_cast<std::uint16_t>(index_in(out.words) - made.first_word);
  made.code_count = static_cast<std::uint16_t>(index_in(out.codes) - made.first_code);
  extra.word_count = index_in(out.computed_words) - extra.first_word;
  extra.code_count = index_in(out.computed_codes) - extra.first_code;
  extra.report_count = index_in(out.block_reports) - extra.first_report;
  if (extra.word_count + extra.code_count + extra.report_count > 0) {
    made.extra = index_in(out.extras);
    out.extras.push_back(extra);
  }
  out.blocks.push_back(made);
  builder_.emit(Opcode::apply, span, index_in(out.blocks) - 1);
}

void BlockCompiler::compile_codes(const ir::Block& block) {
  CompiledProgram& out = builder_.out();
  const bool skips = builder_.context().skips(block.rest_level);
  for (const ir::Code& code : builder_.source().codes_of(block)) {
    if (skips && in_rest(block, code.span)) continue;
    if (code.number != ir::ExpressionId::none) {
      out.computed_codes.push_back({expressions_.compile_number(code.number).operand, code.letter});
      continue;
    }
    out.codes.push_back(plain(code));
    if (code.function == Function::machine_function && code.name == ir::StringId::none) {
      report(ir::name_of_machine_function(code.argument), code.function,
             ir::is_known_machine_function(builder_.context().control, code.argument));
      continue;
    }
    if (code.function == Function::other_spindle || code.function == Function::main_spindle) {
      report(name_of_code(builder_.source(), code), code.function, true);
      continue;
    }
    const bool idle = code.function == Function::no_effect || code.function == Function::approach ||
                      code.function == Function::stroke_check;
    if (idle || code.function == Function::not_modelled || code.function == Function::machine_function)
      report(name_of_code(builder_.source(), code), code.function, idle);
  }
}

// M1=3 is of the first spindle, where another one may be the main one.
PlainCode BlockCompiler::plain(const ir::Code& code) const {
  const bool is_first = names_main_ && code.group == ir::ModalGroup::spindle && code.letter == 'M' &&
                        code.span.in(builder_.source().source.text()).substr(1).starts_with("1=");
  if (!is_first) return {code.function, code.argument, code.group};
  int order = ir::kStopsSpindle;
  if (code.function == Function::spindle_cw) order = ir::kTurnsClockwise;
  if (code.function == Function::spindle_ccw) order = ir::kTurnsCounterclockwise;
  if (code.function == Function::spindle_orient) order = ir::kOrientsSpindle;
  return {Function::other_spindle, ir::spindle_order(1, order), ir::ModalGroup::non_modal};
}

void BlockCompiler::compile_word(const ir::Word& word) {
  // A named word with an extension is carried out by a code of its line: it neither moves nor changes anything itself.
  const bool carried_out = word.address == Address::other && word.extension != 0;
  if (carried_out && word.extension == ir::kTurnsSpindle) return report(name_of(word), Function::spindle_orient, true);
  if (carried_out && word.extension == ir::kPacesAxis) return report(name_of(word), Function::feed_per_min, true);
  if (is_other_speed(word)) return put_other_speed(word);
  if (!is_interpreted(word)) return report(name_of(word), Function::not_modelled, carried_out);
  if (word.address == Address::e && drills_)
    return report("E together with a drilling cycle", Function::drill, true);  // Mazak's second feed of G85
  if (word.address == Address::named_axis) return put_named_axis(word);
  // MEAW measures and goes on to its end: only what it measured is not known.
  if (word.address == Address::measuring && word.name != ir::StringId::none)
    return report(builder_.source().strings.at(word.name), Function::not_modelled, true);
  put_value(word);
}

void BlockCompiler::put_value(const ir::Word& word) {
  if (word.value == ir::ExpressionId::none) return;
  // A written number needs no register: programs have millions of them.
  const ir::Expression* number = builder_.find_literal(word.value);
  if (number == nullptr) return put_word(word, expressions_.compile_word(word.value), flags_of(word));
  const bool negative = number != builder_.find(word.value);
  put_word(word, {Operand::none, ir::ValueType::real, negative ? -number->value : number->value}, flags_of(word));
}

void BlockCompiler::put_word(const ir::Word& word, const Value& value, std::uint8_t flags) {
  CompiledProgram& out = builder_.out();
  if (value.constant.has_value()) {
    if (is_unknown(*value.constant, builder_.context().control.semantics)) {
      out.computed_words.push_back({value.operand, Operand::none, word.address, flags, false});
      return;
    }
    if (is_vacant(*value.constant)) return;  // X#0: as if it was not there
    if (counts_increments(word)) flags |= kWordInIncrements;
    out.words.push_back({*value.constant, word.address, flags});
  } else if (value.type == ir::ValueType::frame || value.type == ir::ValueType::axis) {
    const bool frame = value.type == ir::ValueType::frame;
    builder_.emit_failure(word.span, text::DiagnosticId::wrong_type,
                          {"the value of the word", frame ? "FRAME" : "AXIS", "REAL"}, ir::kValueOfWord);
  } else if (value.is_string() && word.address != Address::t) {
    builder_.emit_failure(word.span, text::DiagnosticId::wrong_type, {"the value of the word", "STRING", "REAL"},
                          ir::kValueOfWord);
  } else {
    out.computed_words.push_back({value.operand, Operand::none, word.address, flags, value.is_string()});
  }
}

// A block has one such speed; of a further one the run only knows that it changes.
bool BlockCompiler::is_other_speed(const ir::Word& word) const {
  return word.address == Address::s && (word.extension > 1 || (word.extension == 1 && names_main_));
}

void BlockCompiler::put_other_speed(const ir::Word& word) {
  CompiledProgram& out = builder_.out();
  const std::uint32_t number = word.extension;
  if (number > ir::kMostSpindles) return report(name_of(word), Function::not_modelled, false);
  report(name_of(word), Function::other_spindle, true);
  const bool fits = word.value != ir::ExpressionId::none && !has_other_speed_;
  out.codes.push_back({Function::other_spindle,
                       ir::spindle_order(number, fits ? ir::kSpindleSpeed : ir::kSpindleSpeedUnknown),
                       ir::ModalGroup::non_modal});
  if (!fits) return;
  has_other_speed_ = true;
  ir::Word speed = word;
  speed.address = Address::other_speed;
  speed.extension = 0;
  put_value(speed);
}

void BlockCompiler::put_named_axis(const ir::Word& word) {
  if (word.value == ir::ExpressionId::none || word.axis == ir::ExpressionId::none) return;
  const Operand axis = expressions_.compile_index(word.axis).operand;
  const Value value = expressions_.compile_number(word.value);
  builder_.out().computed_words.push_back({value.operand, axis, word.address, flags_of(word), false});
}

std::uint8_t BlockCompiler::flags_of(const ir::Word& word) const {
  std::uint8_t flags = 0;
  if (word.mode == ir::WordMode::absolute) flags |= kWordAbsolute;
  if (word.mode == ir::WordMode::incremental) flags |= kWordIncremental;
  if (word.extension != 0 && (kAxisLetters64 & bit_of(word.address)) != 0) flags |= kWordNumbered;
  return flags;
}

// A constant as it was written, with its sign; a computed value never counts.
bool BlockCompiler::counts_increments(const ir::Word& word) const {
  if ((builder_.context().rules.counting & bit_of(word.address)) == 0) return false;
  const ir::Expression* number = builder_.find_literal(word.value);
  return number != nullptr && !number->has_point;
}

bool BlockCompiler::is_interpreted(const ir::Word& word) const {
  if ((bit_of(word.address) & kGeometryNotModelled) != 0) return false;
  // A second spindle; the first may be written with its number.
  if (word.extension > 1 && (kAxisLetters64 & bit_of(word.address)) == 0) return false;
  // Y may be a coordinate of a face or cylinder, which only the run knows.
  const bool on_axis =
      (builder_.context().rules.foreign_axes & bit_of(word.address)) == 0 || word.address == Address::y;
  return on_axis || words_belong_to_code_;
}

std::string BlockCompiler::name_of(const ir::Word& word) const {
  if (word.address == Address::other) return std::string(builder_.source().strings.at(word.name));
  std::string name(1, static_cast<char>('A' + static_cast<int>(word.address)));
  if (word.extension != 0) name += std::to_string(word.extension);
  return name;
}

void BlockCompiler::report(std::string_view name, Function function, bool effects_known) {
  builder_.out().block_reports.push_back(builder_.add_report(name, function, effects_known));
}

}  // namespace dripfeed::interpreter
