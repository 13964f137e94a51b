// The order of a line's statements. On this control the words of a block are read from left to right; an assignment
// before or after constant words can be moved before them, one between words that use variables cannot, and then the
// line is kept as it is.
#include "dialects/sinumerik/reader/lower.h"

#include <algorithm>

#include "dialects/ir/other_spindle.h"
#include "dialects/sinumerik/tables/called_cycles.h"
#include "dialects/sinumerik/tables/keywords.h"
#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

namespace {

// Statements that write a file or to a device (PGA, "Write file", "Delete file", "Process DataShare").
constexpr std::string_view kFileWriters[] = {"WRITE", "DELETE", "EXTOPEN", "EXTCLOSE"};

using ir::StatementKind;

// What a line does before its words that are kept as written.
bool is_control_flow(StatementKind kind) {
  return (kind >= StatementKind::go_to && kind <= StatementKind::define) || kind == StatementKind::modal_call_end;
}

// Turns it, brings it to a stop or to an angle, or chooses a step of its gear. (PG, "Spindle speed (S), direction of
// spindle rotation (M3, M4, M5)", "Positioning spindles".)
bool orders_spindle(std::uint32_t number) {
  return (number >= 3 && number <= 5) || number == 19 || (number >= 40 && number <= 45);
}

}  // namespace

bool is_aside(const ir::Program& program, const ir::Block& block) {
  constexpr ir::Function kFunctions[] = {ir::Function::rapid, ir::Function::not_modelled, ir::Function::spindle_orient,
                                         ir::Function::other_spindle};
  const auto codes = program.codes_of(block);
  return codes.size() == 1 && codes.front().group == ir::ModalGroup::non_modal &&
         std::ranges::find(kFunctions, codes.front().function) != std::end(kFunctions);
}

Lowering::Lowering(ir::Program& program) : program_(program) {}

void Lowering::begin_line(std::uint32_t line, std::uint32_t first_token) {
  line_ = line;
  first_token_ = first_token;
  first_statement_ = static_cast<std::uint32_t>(program_.statements.size());
  first_label_ = static_cast<std::uint32_t>(program_.labels.size());
  first_code_ = static_cast<std::uint32_t>(program_.codes.size());
  first_word_ = static_cast<std::uint32_t>(program_.words.size());
  skip_level_ = 0;
  block_span_ = {};
  block_flushed_early_ = false;
  native_ = false;
  asides_.clear();
  ending_ = StatementKind::empty;
}

void Lowering::add_label(std::string_view label_name, text::Span span) {
  ir::Label label;
  label.name = name(label_name);
  label.statement = first_statement_;
  label.span = span;
  program_.labels.push_back(label);
}

void Lowering::add_block_number(std::uint32_t number, text::Span span) {
  program_.labels.push_back({ir::StringId::none, number, first_statement_, span});
}

void Lowering::end_line(std::uint32_t token_after, text::Span span) {
  if (!native_) flush_block();
  if (!native_) flush_asides();
  if (ending_ != StatementKind::empty) push(ending_, ir::kNoIndex, ending_span_);
  if (program_.statements.size() == first_statement_) push(StatementKind::empty, ir::kNoIndex, span);
  ir::Statement& first = program_.statements[first_statement_];
  first.is_label = program_.labels.size() > first_label_;
  first.tokens = {first_token_, token_after};
  for (std::size_t i = first_statement_ + std::size_t{1}; i < program_.statements.size(); ++i)
    program_.statements[i].tokens = {token_after, token_after};
}

bool Lowering::has_pending_block() const {
  return program_.codes.size() > first_code_ || program_.words.size() > first_word_;
}

bool Lowering::pending_words_are_constant() const {
  return std::all_of(program_.words.begin() + first_word_, program_.words.end(), [this](const ir::Word& word) {
    const ir::Operator op = program_.at(word.value).op;
    return op == ir::Operator::constant || op == ir::Operator::string;
  });
}

void Lowering::flush_block() {
  if (has_pending_block()) flush_block_of(block_span_);
}

void Lowering::flush_block_of(text::Span span) {
  const auto codes = static_cast<std::uint32_t>(program_.codes.size());
  const auto words = static_cast<std::uint32_t>(program_.words.size());
  push(StatementKind::block, program_.blocks,
       ir::Block{first_code_, codes - first_code_, first_word_, words - first_word_}, span);
  first_code_ = codes;
  first_word_ = words;
}

void Lowering::flush_asides() {
  for (const Aside& aside : asides_) {
    program_.codes.push_back(aside.code);
    if (aside.word) program_.words.push_back(*aside.word);
    flush_block_of(aside.code.span);
  }
}

void Lowering::push(StatementKind kind, std::uint32_t payload, text::Span span) {
  ir::Statement statement;
  statement.kind = kind;
  statement.skip_level = skip_level_;
  statement.payload = payload;
  statement.line = line_;
  statement.span = span;
  program_.statements.push_back(statement);
}

template <class T>
void Lowering::push(StatementKind kind, std::vector<T>& arena, const T& item, text::Span span) {
  arena.push_back(item);
  push(kind, static_cast<std::uint32_t>(arena.size() - 1), span);
}

void Lowering::add_code(const GCode& code, text::Span span) {
  if (native_) return;
  // Approach, return, fixed points: the codes of their own block that move.
  const bool moves = code.words == WordUse::own && code.row.group == ir::ModalGroup::non_modal;
  if (code.words != WordUse::usual) return keep_as_native(code.row.name, code.words == WordUse::declared, span, moves);
  const bool known = code.row.function != ir::Function::not_modelled && code.row.function != ir::Function::no_effect;
  // G96 and G97 choose the feed as well: per revolution, G961 and G971 per minute.
  if (code.row.group == ir::ModalGroup::surface_speed) {
    const bool per_min = code.row.number10 == 9610 || code.row.number10 == 9710;
    program_.codes.push_back({per_min ? ir::Function::feed_per_min : ir::Function::feed_per_rev, 0,
                              ir::ModalGroup::feed, 'G', ir::ExpressionId::none, ir::StringId::none, span});
  }
  program_.codes.push_back({code.row.function, code.row.argument, code.row.group, 'G', ir::ExpressionId::none,
                            known ? ir::StringId::none : program_.strings.add(code.row.name), span});
  block_span_ = block_span_.empty() ? span : join(block_span_, span);
}

void Lowering::add_code(const ir::Code& code) {
  if (native_) return;
  program_.codes.push_back(code);
  block_span_ = block_span_.empty() ? code.span : join(block_span_, code.span);
}

void Lowering::add_m_code(std::uint32_t number, std::uint32_t extension, text::Span span) {
  if (native_) return;
  const bool main_spindle = extension <= 1;
  const ir::CodeRow* row = find_m_code(number);
  if (row != nullptr && row->group == ir::ModalGroup::flow && number != 0 && number != 1) {
    ending_ = number == 17 ? StatementKind::subprogram_return : StatementKind::program_end;
    ending_span_ = span;
    return;
  }
  ir::Code code;
  code.letter = 'M';
  code.span = span;
  if (row != nullptr && (main_spindle || row->group != ir::ModalGroup::spindle)) {
    code.function = row->function;
    code.argument = row->argument;
    code.group = row->group;
  } else if (main_spindle && number <= 0x7FFF) {
    code.function = ir::Function::machine_function;
    code.argument = static_cast<std::int16_t>(number);
  } else {
    const bool turns = orders_spindle(number) && extension <= ir::kMostSpindles;
    code.function = turns ? ir::Function::other_spindle : ir::Function::not_modelled;
    if (turns) code.argument = ir::spindle_order(extension, static_cast<int>(number));
    if (turns) code.group = ir::ModalGroup::non_modal;
    code.name = name("M" + std::to_string(extension) + "=" + std::to_string(number));
  }
  add_code(code);
}

void Lowering::add_computed_m_code(ir::ExpressionId number, text::Span span) {
  if (native_) return;
  ir::Code code;
  code.letter = 'M';
  code.number = number;
  code.span = span;
  program_.codes.push_back(code);
  block_span_ = block_span_.empty() ? span : join(block_span_, span);
}

void Lowering::add_word(const ir::Word& word) {
  if (native_) return;
  if (block_flushed_early_) return keep_as_native("assignment between words", false, word.span);
  program_.words.push_back(word);
  block_span_ = block_span_.empty() ? word.span : join(block_span_, word.span);
}

void Lowering::add_aside(const ir::Code& code, const std::optional<ir::Word>& word) {
  if (!native_) asides_.push_back({code, word});
}

void Lowering::last_word_is(std::uint8_t extension) {
  if (program_.words.size() > first_word_) program_.words.back().extension = extension;
}

void Lowering::add_assign(ir::VariableId target, ir::ExpressionId value, text::Span span) {
  if (native_) return;
  if (has_pending_block() && !pending_words_are_constant()) {
    flush_block();
    block_flushed_early_ = true;
  }
  push(StatementKind::assign, program_.assigns, ir::Assign{target, value}, span);
}

void Lowering::add_jump(const ir::Jump& jump, text::Span span) {
  if (!native_) flush_block();
  push(StatementKind::go_to, program_.jumps, jump, span);
}

void Lowering::add_return(const ir::Jump& jump, text::Span span) {
  if (native_) return;
  flush_block();
  push(StatementKind::return_to, program_.jumps, jump, span);
}

void Lowering::add_structure(StatementKind kind, const ir::Structure& structure, text::Span span) {
  if (!native_) flush_block();
  push(kind, program_.structures, structure, span);
}

void Lowering::add_call(StatementKind kind, ir::Call call, text::Span span) {
  if (native_) return;
  flush_block();
  call.cycle = find_called_cycle(program_.strings.at(call.name));
  push(kind, program_.calls, call, span);
}

void Lowering::add_message(StatementKind kind, const ir::Message& message, text::Span span) {
  if (native_) return;
  flush_block();
  push(kind, program_.messages, message, span);
}

void Lowering::add_repeat(const ir::Repeat& repeat, text::Span span) {
  if (native_) return;
  flush_block();
  push(StatementKind::repeat_section, program_.repeats, repeat, span);
}

void Lowering::add_plain(StatementKind kind, text::Span span) {
  if (native_) return;
  flush_block();
  push(kind, ir::kNoIndex, span);
}

void Lowering::keep_as_native(std::string_view native_name, bool effects_known, text::Span span, bool moves) {
  if (native_) return;
  // What was read of the line moves no axis any more, and the line may.
  moves = moves || std::any_of(program_.words.begin() + first_word_, program_.words.end(), [](const ir::Word& word) {
            return ir::is_axis(word.address) || word.address == ir::Address::named_axis;
          });
  program_.codes.resize(first_code_);
  program_.words.resize(first_word_);
  auto& statements = program_.statements;
  const auto dropped = std::remove_if(statements.begin() + first_statement_, statements.end(),
                                      [](const ir::Statement& s) { return !is_control_flow(s.kind); });
  statements.erase(dropped, statements.end());
  const bool writes = std::ranges::find(kFileWriters, native_name) != std::end(kFileWriters);
  const Keyword* const keyword = find_keyword(native_name);
  const bool smooths = keyword != nullptr && keyword->effect == Effect::smooths;
  const bool paces = keyword != nullptr && keyword->effect == Effect::paces;
  const bool shifts = keyword != nullptr && keyword->effect == Effect::shifts;
  push(StatementKind::native, program_.natives,
       ir::Native{.name = name(native_name),
                  .effects_known = effects_known,
                  .moves = moves,
                  .shifts = shifts,
                  .writes = writes,
                  .smooths = smooths,
                  .paces = paces},
       span);
  native_ = true;
}

ir::StringId Lowering::name(std::string_view text) { return program_.strings.add(UpperName(text).view()); }

ir::SymbolId Lowering::find_symbol(std::string_view symbol_name) const {
  const ir::StringId id = program_.strings.find(UpperName(symbol_name).view());
  if (id == ir::StringId::none) return ir::SymbolId::none;
  const auto found = symbols_.find(id);
  return found == symbols_.end() ? ir::SymbolId::none : found->second;
}

ir::SymbolId Lowering::symbol_used(std::string_view symbol_name) {
  const ir::StringId id = name(symbol_name);
  const auto found = symbols_.find(id);
  if (found != symbols_.end()) return found->second;
  ir::Symbol symbol;
  symbol.name = id;
  symbol.is_global = true;
  const ir::SymbolId added = program_.add(symbol);
  symbols_.emplace(id, added);
  return added;
}

ir::SymbolId Lowering::declare(const ir::Symbol& symbol) {
  const ir::SymbolId added = program_.add(symbol);
  // The first of two definitions counts; a use before the definition stays undefined.
  const auto [entry, is_new] = symbols_.emplace(symbol.name, added);
  if (!is_new && !is_declared(entry->second)) entry->second = added;
  return added;
}

bool Lowering::is_declared(ir::SymbolId id) const { return id != ir::SymbolId::none && !program_.at(id).span.empty(); }

}  // namespace dripfeed::sinumerik
