// PROC, DEF and EXTERN. The symbols of one definition stand together in the program's arena. Lists of values of arrays
// become one assignment an element, because a symbol has one initial value.
#include <algorithm>
#include <optional>

#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using ir::TokenKind;
using text::DiagnosticId;

// REP fills a whole array; beyond this the list is kept as written instead. The second is for all lists of a text: each
// element becomes a statement of its own.
constexpr std::uint32_t kMostElements = 20'000;
constexpr std::uint64_t kMostElementsOfAText = 200'000;

}  // namespace

// DEF REAL L1: by the manual a name begins with two letters, but its own examples and controls in use have others. To
// the lexer L1 is an address with a number; from its definition on it is one name, and its tokens are joined wherever
// it stands.
void Parser::join_short_name() {
  if (cursor_.kind() != TokenKind::address) return;
  const std::string_view text = cursor_.whole();
  const auto run_at = [text](std::uint32_t begin) {
    std::uint32_t end = begin;
    while (end < text.size() && is_name_character(text[end])) ++end;
    return text::Span{begin, end};
  };
  const std::string_view name = run_at(cursor_.span().begin).in(text);
  std::vector<ir::Token>& tokens = program_.tokens;
  std::uint32_t kept = cursor_.index();
  for (std::uint32_t i = kept; i < tokens.size(); ++kept) {
    const text::Span run = tokens[i].kind == TokenKind::address ? run_at(tokens[i].span.begin) : text::Span{};
    std::uint32_t after = i;
    while (after < tokens.size() && tokens[after].span.begin < run.end) ++after;
    if (after > i && tokens[after - 1].span.end == run.end && same_name(run.in(text), name)) {
      tokens[kept] = {TokenKind::name, run};
      i = after;
    } else {
      tokens[kept] = tokens[i++];
    }
  }
  tokens.resize(kept);
  const std::uint32_t here = cursor_.index();
  cursor_ = TokenCursor(text, tokens);
  cursor_.go_to(here);
}

// PROC NAME(REAL A, VAR INT B, REAL C=1.5) SAVE DISPLOF
void Parser::procedure(text::Span head) {
  join_short_name();
  if (cursor_.kind() != TokenKind::name)
    return give_up(DiagnosticId::syntax_error, cursor_.span(), {"PROC has no name"});
  // A further program of the text is named by its head.
  if (program_.sections.empty()) program_.name = UpperName(cursor_.text()).view();
  cursor_.advance();
  ir::Structure structure;
  std::vector<ir::Symbol> parameters;
  if (cursor_.take('(') && !cursor_.take(')')) {
    do {
      ir::Symbol symbol;
      if (!parameter(symbol)) return;
      parameters.push_back(symbol);
    } while (cursor_.take(','));
    expect(')');
  }
  structure.first_symbol = static_cast<std::uint32_t>(program_.symbols.size());
  structure.symbol_count = static_cast<std::uint32_t>(parameters.size());
  for (const ir::Symbol& symbol : parameters) lower_.declare(symbol);
  while (cursor_.kind() == TokenKind::name) {
    structure.saves_modal = structure.saves_modal || cursor_.is_name("SAVE");
    cursor_.advance();
  }
  lower_.add_structure(StatementKind::procedure, structure, to_here(head));
  if (!cursor_.at_block_end()) give_up(DiagnosticId::statement_not_alone, head, {"PROC"});
}

bool Parser::parameter(ir::Symbol& symbol) {
  symbol.is_parameter = true;
  symbol.by_reference = cursor_.take_name("VAR");
  const Keyword* keyword = cursor_.kind() == TokenKind::name ? find_keyword(cursor_.text()) : nullptr;
  if (keyword == nullptr || keyword->role != Role::type) {
    give_up(DiagnosticId::syntax_error, cursor_.span(), {here() + " is not a type of a parameter"});
    return false;
  }
  cursor_.advance();
  std::uint16_t string_length = 0;
  if (keyword->type == ir::ValueType::string && cursor_.is_symbol('[')) {
    ir::Symbol length;
    dimensions(length);
    string_length = length.dimension1;
  }
  return defined_name(keyword->type, string_length, symbol);
}

// DEF REAL X, DEF INT G1: an axis, an address or a code is not a name, the control makes no symbol of it (12200). By
// the manual no single letter is one, but programs have such: of the letters that a machine may give to axes or keep as
// addresses (A, I, U ...), those are axes that it is known to have.
bool Parser::is_code_or_address() {
  const text::Span head = cursor_.span();
  const std::string_view text = cursor_.whole();
  if (cursor_.kind() != TokenKind::address && cursor_.kind() != TokenKind::variable) return false;
  std::uint32_t end = head.begin;
  while (end < text.size() && is_name_character(text[end])) ++end;
  const std::string_view name = text.substr(head.begin, end - head.begin);
  if (name.empty()) return false;  // $P_GG
  constexpr std::string_view kCodes = "GMR";
  const bool code = kCodes.contains(to_upper(name.front())) && std::ranges::all_of(name.substr(1), is_digit);
  constexpr std::string_view kFixedAddresses = "DFGHLMNPRST";  // PG, "Fixed addresses"
  constexpr std::string_view kGeometry = "XYZ";
  const char upper = to_upper(name.front());
  const bool letter = name.size() == 1 && (kFixedAddresses.contains(upper) || kGeometry.contains(upper) ||
                                           (control_.from_profile && control_.axes.contains(upper)));
  if (!letter && !code) return false;
  give_up(DiagnosticId::name_defined_twice, {head.begin, end}, {std::string(name)});
  if (!diagnostics_.empty()) {
    diagnostics_.back().alarm = "12200";
    diagnostics_.back().notes.push_back({head, "the control's own language has that name"});
  }
  return true;
}

// NAME, NAME[10,5], NAME=1.5: the part that DEF and PROC share.
bool Parser::defined_name(ir::ValueType type, std::uint16_t string_length, ir::Symbol& symbol) {
  if (is_code_or_address()) return false;
  join_short_name();
  if (cursor_.kind() != TokenKind::name) {
    give_up(DiagnosticId::syntax_error, cursor_.span(), {here() + " is not a name"});
    return false;
  }
  symbol.name = lower_.name(cursor_.text());
  symbol.type = type;
  symbol.string_length = string_length;
  symbol.span = cursor_.span();
  cursor_.advance();
  if (cursor_.is_symbol('[')) dimensions(symbol);
  if (symbol.is_parameter && cursor_.take('=')) {
    operator_ = symbol.span;
    symbol.initial = expression();
  }
  return true;
}

// [10], [10,5], [] of a reference
void Parser::dimensions(ir::Symbol& symbol) {
  expect('[');
  std::uint32_t count = 0;
  do {
    if (cursor_.is_symbol(']') || cursor_.is_symbol(',')) continue;
    ++brackets_;
    const std::uint16_t size = size_of(binary(kWeakestRank));
    --brackets_;
    if (count == 0) symbol.dimension1 = size;
    if (count == 1) symbol.dimension2 = size;
    if (count == 2) symbol.dimension3 = size;
    ++count;
  } while (cursor_.take(','));
  expect(']');
  if (count > kMostDimensions) {
    report(DiagnosticId::too_many_dimensions, symbol.span,
           {std::string(symbol.span.in(cursor_.whole())), std::to_string(count), std::to_string(kMostDimensions)});
    if (!diagnostics_.empty() && !faulty_) diagnostics_.back().alarm = "12190";
  }
}

// A number, or a variable that its definition gives one (DEF INT N=4, then DEF REAL A[N]). What a macro or global data
// decides is not known: large enough that no value and no index of the text is beyond it.
std::uint16_t Parser::size_of(ir::ExpressionId id) const {
  constexpr std::uint16_t kOpenSize = 100;
  constexpr double kLargest = 65535.0;
  const ir::Expression* e = &program_.at(id);
  if (e->op == ir::Operator::variable && program_.at(e->variable).bank == ir::Bank::named) {
    const ir::Symbol& symbol = program_.at(program_.at(e->variable).symbol);
    if (symbol.initial == ir::ExpressionId::none) return kOpenSize;
    e = &program_.at(symbol.initial);
  }
  if (e->op != ir::Operator::constant) return kOpenSize;
  return static_cast<std::uint16_t>(e->value >= 1.0 && e->value <= kLargest ? e->value : 1.0);
}

// SYNR, PHU 5, LLI 0, APR 7: of global data, without meaning for a run; but NCK or CHAN make it global.
bool Parser::skip_value_attributes() {
  bool global = false;
  while (cursor_.kind() == TokenKind::name) {
    const Keyword* keyword = find_keyword(cursor_.text());
    if (keyword == nullptr || keyword->role != Role::attribute) return global;
    global = global || keyword->name == "NCK" || keyword->name == "CHAN";
    cursor_.advance();
    ir::ExpressionId value = ir::ExpressionId::none;
    (void)signed_constant(value);
  }
  return global;
}

// DEF REAL A, B=2, C[3]=SET(1,2,3)
void Parser::definition(text::Span head) {
  const bool global = skip_value_attributes();
  const Keyword* keyword = cursor_.kind() == TokenKind::name ? find_keyword(cursor_.text()) : nullptr;
  if (keyword == nullptr || keyword->role != Role::type)
    return give_up(DiagnosticId::syntax_error, cursor_.span(), {here() + " is not a type of a variable"});
  cursor_.advance();
  std::uint16_t string_length = 0;
  if (keyword->type == ir::ValueType::string && cursor_.is_symbol('[')) {
    ir::Symbol length;
    dimensions(length);
    string_length = length.dimension1;
  }
  (void)skip_value_attributes();
  ir::Structure structure;
  structure.first_symbol = static_cast<std::uint32_t>(program_.symbols.size());
  std::vector<std::pair<ir::Variable, TokenCursor>> lists;  // of arrays, read when all names are there
  do {
    ir::Symbol symbol;
    if (!defined_name(keyword->type, string_length, symbol)) break;
    symbol.is_global = global;
    (void)skip_value_attributes();
    const ir::SymbolId id = lower_.declare(symbol);
    if (!cursor_.take('=')) continue;
    if (cursor_.is_name("SET") || cursor_.is_name("REP") || (cursor_.is_symbol('(') && symbol.dimension1 > 0)) {
      ir::Variable first;
      first.bank = ir::Bank::named;
      first.symbol = id;
      first.span = symbol.span;
      lists.emplace_back(first, cursor_);
      if (cursor_.kind() == TokenKind::name) cursor_.advance();
      std::uint32_t open = 0;
      do {
        open += cursor_.is_symbol('(') ? 1U : 0U;
        open -= cursor_.is_symbol(')') ? 1U : 0U;
        cursor_.advance();
      } while (open > 0 && !cursor_.at_block_end());
    } else {
      operator_ = symbol.span;
      const ir::ExpressionId initial = expression();
      program_.symbols[static_cast<std::uint32_t>(id)].initial = initial;
    }
  } while (cursor_.take(','));
  structure.symbol_count = static_cast<std::uint32_t>(program_.symbols.size()) - structure.first_symbol;
  lower_.add_structure(StatementKind::define, structure, to_here(head));
  const std::uint32_t end = cursor_.index();
  for (const auto& [first, at] : lists) {
    cursor_.go_to(at.index());
    value_list(first, head);
  }
  cursor_.go_to(std::max(end, cursor_.index()));
  if (!cursor_.at_block_end()) give_up(DiagnosticId::statement_not_alone, head, {"DEF"});
}

// SET(a,b,c) or (a,b,c): elements in order from `first` on; REP(v) or REP(v,n). False when it is none of these.
bool Parser::value_list(const ir::Variable& first, text::Span head) {
  if (cursor_.take_name("REP")) {
    repeated_value(first, head);
    return true;
  }
  if (!cursor_.take_name("SET") && !cursor_.is_symbol('(')) return false;
  operator_ = head;
  expect('(');
  ++brackets_;
  std::uint32_t offset = 0;
  bool has_place = true;
  do {
    operator_ = head;
    if (cursor_.is_symbol(',')) {
      ++offset;
      continue;
    }
    const ir::ExpressionId value = binary(kWeakestRank);
    has_place = has_place && element(first, offset++, value, head);
  } while (cursor_.take(','));
  --brackets_;
  expect(')');
  return true;
}

void Parser::repeated_value(const ir::Variable& first, text::Span head) {
  operator_ = head;
  expect('(');
  ++brackets_;
  const ir::ExpressionId value = binary(kWeakestRank);
  std::optional<std::uint32_t> count = elements_of(first);
  if (cursor_.take(',')) count = constant_count(binary(kWeakestRank));
  --brackets_;
  expect(')');
  if (!count || *count > kMostElements) return lower_.keep_as_native("REP", false, head);
  for (std::uint32_t i = 0; i < *count; ++i)
    if (!element(first, i, value, head)) return;
}

// From `first` to the end of the array. Nothing where the text does not say it: R parameters are as many as the machine
// has, and an array of a parameter has as many elements as its caller's.
std::optional<std::uint32_t> Parser::elements_of(const ir::Variable& first) const {
  if (first.bank != ir::Bank::named || first.symbol == ir::SymbolId::none) return std::nullopt;
  const ir::Symbol& symbol = program_.at(first.symbol);
  if (symbol.dimension1 == 0 && (symbol.is_parameter || symbol.span.empty())) return std::nullopt;
  const auto at_least_one = [](std::uint16_t size) { return std::max<std::uint64_t>(size, 1); };
  const std::uint64_t layers = at_least_one(symbol.dimension3);
  const std::uint64_t columns = at_least_one(symbol.dimension2);
  const std::uint64_t count = at_least_one(symbol.dimension1) * columns * layers;
  std::uint64_t before = 0;
  const std::pair<ir::ExpressionId, std::uint64_t> indices[] = {
      {first.index, columns * layers}, {first.index2, layers}, {first.index3, 1}};
  for (const auto& [index, step] : indices) {
    if (index == ir::ExpressionId::none) continue;
    const auto place = constant_count(index);
    if (!place) return std::nullopt;
    before += *place * step;
  }
  if (before >= count) return 1U;  // beyond the array: element() says so
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(count - before, kMostElements + 1U));
}

// Nothing where it is computed, missing, or no count.
std::optional<std::uint32_t> Parser::constant_count(ir::ExpressionId id) const {
  if (id == ir::ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program_.at(id);
  if (e.op != ir::Operator::constant || !(e.value >= 0.0 && e.value <= kMostElements)) return std::nullopt;
  return static_cast<std::uint32_t>(e.value);
}

// More values than the array has elements: 12260. An array of a parameter has as many as its caller's.
bool Parser::is_beyond(const ir::Symbol& symbol, std::uint64_t flat, text::Span head) {
  const auto at_least_one = [](std::uint16_t size) { return std::max<std::uint64_t>(size, 1); };
  const std::uint64_t elements = symbol.dimension1 * at_least_one(symbol.dimension2) * at_least_one(symbol.dimension3);
  if (elements == 0 || symbol.is_parameter || flat < elements) return false;
  report(DiagnosticId::too_many_initial_values, head,
         {std::to_string(flat + 1), std::to_string(elements), std::string(program_.strings.at(symbol.name))});
  if (!diagnostics_.empty() && !faulty_) diagnostics_.back().alarm = "12260";
  return true;
}

// One assignment to the element `offset` places after `first`, row by row. False when the place is not known.
bool Parser::element(const ir::Variable& first, std::uint32_t offset, ir::ExpressionId value, text::Span head) {
  const auto constant_index = [this](ir::ExpressionId id, std::uint32_t& index) {
    if (id == ir::ExpressionId::none) return true;
    const ir::Expression& e = program_.at(id);
    if (e.op != ir::Operator::constant || e.value < 0.0 || e.value > 1e6) return false;
    index = static_cast<std::uint32_t>(e.value);
    return true;
  };
  std::uint32_t row = 0;
  std::uint32_t column = 0;
  std::uint32_t layer = 0;
  const bool fits = ++elements_ <= kMostElementsOfAText;
  if (!fits || first.bank == ir::Bank::system || !constant_index(first.index, row) ||
      !constant_index(first.index2, column) || !constant_index(first.index3, layer)) {
    lower_.keep_as_native("SET", false, head);
    return false;
  }
  const bool named = first.bank == ir::Bank::named;
  const std::uint64_t columns = named ? program_.at(first.symbol).dimension2 : 0U;
  const std::uint64_t layers = named ? program_.at(first.symbol).dimension3 : 0U;
  ir::Variable target = first;
  std::uint64_t flat = row;
  if (columns > 0) flat = flat * columns + column;
  if (layers > 0) flat = flat * layers + layer;
  flat += offset;
  if (first.bank == ir::Bank::r) {
    target.number = static_cast<std::uint32_t>(flat);
    target.index = ir::ExpressionId::none;
  } else {
    if (named && is_beyond(program_.at(first.symbol), flat, head)) return false;
    if (layers > 0) target.index3 = constant(static_cast<double>(flat % layers), first.span);
    if (layers > 0) flat /= layers;
    if (columns > 0) target.index2 = constant(static_cast<double>(flat % columns), first.span);
    target.index = constant(static_cast<double>(columns > 0 ? flat / columns : flat), first.span);
  }
  lower_.add_assign(program_.add(target), value, head);
  return true;
}

}  // namespace dripfeed::sinumerik
