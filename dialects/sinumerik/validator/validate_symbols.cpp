// Symbols that the control cannot make, indices that are no numbers, axes that are none, and G groups by number.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/called_cycles.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/keywords.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

constexpr double kGroups = 64.0;
constexpr std::uint64_t kMemory_bytes = 16ULL << 20U;  // more than any NC memory of these controls

// How sure it is that the control refuses a name. The words of every version of the language are certain; of others it
// depends on version and options, and words that only some statements know may still be names.
enum class Taken : std::uint8_t { no, perhaps, certainly };

Taken is_taken(std::string_view upper) {
  constexpr Role kCertain[] = {Role::infix,     Role::prefix, Role::function, Role::constant,
                               Role::word_mode, Role::type,   Role::statement};
  const Keyword* keyword = find_keyword(upper);
  if (keyword != nullptr && std::ranges::find(kCertain, keyword->role) != std::end(kCertain)) return Taken::certainly;
  if (keyword != nullptr && keyword->role == Role::address)
    return keyword->address == ir::Address::other ? Taken::perhaps : Taken::certainly;
  if (find_named_code(upper) != nullptr || !standard_cycle(upper).empty()) return Taken::certainly;
  if (find_called_cycle(upper) != nullptr) return Taken::certainly;
  return Taken::no;
}

std::uint64_t bytes_of(const ir::Symbol& symbol) {
  constexpr std::uint64_t kFrame_bytes = 400;
  std::uint64_t one = 8;
  if (symbol.type == ir::ValueType::integer) one = 4;
  if (symbol.type == ir::ValueType::boolean || symbol.type == ir::ValueType::character) one = 1;
  if (symbol.type == ir::ValueType::string) one = symbol.string_length + 1U;
  if (symbol.type == ir::ValueType::frame) one = kFrame_bytes;
  for (const std::uint16_t size : {symbol.dimension1, symbol.dimension2, symbol.dimension3})
    one *= std::max<std::uint64_t>(size, 1);
  return one;
}

// Names of real programs have it (L1, D2), so that it is no fault for certain.
bool begins_as_names_do(std::string_view name) {
  return name.size() > 1 && std::ranges::all_of(name.substr(0, 2), [](char c) { return is_letter(c) || c == '_'; });
}

void check_symbol(const Check& check, const ir::Symbol& symbol) {
  if (symbol.span.empty()) return;
  const std::string name(check.program.strings.at(symbol.name));
  if (!begins_as_names_do(name)) check.report(DiagnosticId::name_beginning, symbol.span, {name});
  if (const Taken taken = is_taken(UpperName(name).view()); taken != Taken::no) {
    text::Diagnostic& d = check.report(DiagnosticId::name_defined_twice, symbol.span, {name});
    if (taken == Taken::perhaps) d.severity = text::Severity::warning;
    d.alarm = "12200";
    d.notes.push_back({symbol.span, "the control's own language has that name"});
  } else if (bytes_of(symbol) > kMemory_bytes) {
    text::Diagnostic& d = check.report(
        DiagnosticId::value_out_of_range, symbol.span,
        {"the size of " + name + " in bytes", std::to_string(bytes_of(symbol)), "1", std::to_string(kMemory_bytes)});
    d.alarm = "12200";
  }
}

// A name that is not defined here may be a macro for a variable of the system: DEFINE POS AS $AA_IW, then POS[X].
void check_index(const Check& check, const ir::Variable& v) {
  const bool is_defined =
      v.bank == ir::Bank::named && v.symbol != ir::SymbolId::none && !check.program.at(v.symbol).span.empty();
  if (!is_defined && v.bank != ir::Bank::r) return;
  for (const ir::ExpressionId id : {v.index, v.index2, v.index3}) {
    if (id == ir::ExpressionId::none || check.program.at(id).op != ir::Operator::string) continue;
    const text::Span span = check.program.at(id).span;
    check.report(DiagnosticId::wrong_type, span, {std::string(check.text_of(span)), "STRING", "a number"}).alarm =
        "12410";
  }
}

// AX[1.5]: only a name or a variable of type AXIS names an axis.
void check_axis(const Check& check, const ir::Word& word) {
  if (word.address != ir::Address::named_axis || word.axis == ir::ExpressionId::none) return;
  const ir::Expression& axis = check.program.at(word.axis);
  if (axis.op != ir::Operator::constant && axis.op != ir::Operator::string) return;
  // The reader gives a name of an axis as the constant of its place; a number begins with a digit.
  const std::string_view written = check.text_of(axis.span);
  if (written.empty() || written.find_first_of("+-.0123456789\"") != 0) return;
  const bool text = axis.op == ir::Operator::string;
  check.report(DiagnosticId::wrong_type, axis.span, {std::string(written), text ? "STRING" : "REAL", "AXIS"}).alarm =
      "12040";
}

// G[group]=number, which is kept as it is written.
class GroupByNumber {
 public:
  GroupByNumber(const Check& check, const ir::Statement& s) : check_(check) {
    const auto& tokens = check.program.tokens;
    at_ = std::ranges::lower_bound(tokens, s.span.begin, {}, [](const ir::Token& t) { return t.span.begin; });
  }

  void run() {
    (void)next();  // G
    if (text_of(next()) != "[") return;
    const auto group = constant();
    if (!group || text_of(next()) != "]" || text_of(next()) != "=") return;
    if (*group < 1.0 || *group > kGroups) return say(DiagnosticId::value_out_of_range, "the G group", *group, "12530");
    const auto number = constant();
    constexpr std::pair<double, double> kSizes[] = {{6.0, 3.0}, {7.0, 3.0}, {14.0, 2.0}};
    const auto* const size = std::ranges::find(kSizes, *group, &std::pair<double, double>::first);
    const double last = size == std::end(kSizes) ? kGroups : size->second;
    if (number && (*number < 1.0 || *number > last))
      say(DiagnosticId::value_out_of_range, "the number in a G group", *number, "12475", last);
  }

 private:
  const ir::Token* next() {
    const auto& tokens = check_.program.tokens;
    while (at_ != tokens.end() && at_->kind == ir::TokenKind::white) ++at_;
    return at_ == tokens.end() ? nullptr : &*at_++;
  }
  std::string_view text_of(const ir::Token* token) const {
    return token == nullptr ? std::string_view() : check_.text_of(token->span);
  }
  std::optional<double> constant() {
    const ir::Token* token = next();
    if (token == nullptr || token->kind != ir::TokenKind::number) return std::nullopt;
    last_ = token->span;
    return text::parse_number(text_of(token));
  }
  void say(DiagnosticId id, std::string_view what, double value, std::string_view alarm, double last = kGroups) {
    check_.report(id, last_, {std::string(what), text::format_shortest(value), "1", text::format_shortest(last)})
        .alarm = alarm;
  }

  const Check& check_;
  std::vector<ir::Token>::const_iterator at_;
  text::Span last_;
};

}  // namespace

void check_symbols(const Check& check) {
  for (const ir::Symbol& symbol : check.program.symbols) check_symbol(check, symbol);
  for (const ir::Variable& v : check.program.variables) check_index(check, v);
  for (const ir::Word& word : check.program.words) check_axis(check, word);
  for (const ir::Statement& s : check.program.statements)
    if (s.kind == StatementKind::native && check.native_name(s) == "G[]") GroupByNumber(check, s).run();
}

}  // namespace dripfeed::sinumerik
