// First all places that set the target, then whether the one that is left is plain and comes first.
#include "dialects/compile/native_targets.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dialects/compile/native_variable.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

NativeTarget refused(std::string why, std::vector<text::DiagnosticNote> notes = {}) {
  return {.constant = std::nullopt, .why = std::move(why), .notes = std::move(notes)};
}

class TargetSearch {
 public:
  TargetSearch(const ir::Program& program, const ir::Control& control, std::string_view target)
      : program_(program), control_(control), target_(target) {}

  NativeTarget run() {
    const std::size_t point = target_.find('.');
    return point == std::string_view::npos ? variable() : argument(target_.substr(0, point), target_.substr(point + 1));
  }

 private:
  // --- #100, R10, DIA

  NativeTarget variable() {
    const auto found = NativeVariable::named(program_, control_, target_);
    if (!found) return refused(fmt::format("{} has no variable of that kind", control_.title));
    const std::vector<NativeVariable::Setting> settings = found->settings(program_);
    if (settings.empty()) return refused(why_never_set());
    if (settings.size() > 1) {
      std::vector<std::uint32_t> places;
      places.reserve(settings.size());
      for (const NativeVariable::Setting& one : settings) places.push_back(one.statement);
      return refused(
          fmt::format("it is set in {}, and which of them counts differs from place to place", lines_of(places)),
          notes_at(places, "it is set here"));
    }
    const NativeVariable::Setting& only = settings.front();
    NativeTarget out = constant_at(only.statement, only.value, only.is_integer);
    if (!out.constant) return out;
    if (program_.statements[only.statement].skip_level != 0)
      return refused(fmt::format("{} may be skipped, and then it has another value", lines_of({only.statement})),
                     notes_at({only.statement}, "behind a block skip"));
    if (const auto early = read_before(*found, only.statement))
      return refused(fmt::format("{} may read it before {} sets it", lines_of({*early}), lines_of({only.statement})),
                     notes_at({*early}, "it is read here"));
    return out;
  }

  [[nodiscard]] std::string why_never_set() const {
    for (std::uint32_t i = 0; i < program_.symbols.size(); ++i) {
      const ir::Symbol& symbol = program_.symbols[i];
      if (symbol.is_parameter && text::upper_case(program_.strings.at(symbol.name)) == target_)
        return fmt::format("it is a parameter of a program: name it with the program, as in PROGRAM.{}", target_);
    }
    return "no line of the native program sets it";
  }

  // A statement that reads the variable before it is set; where no statement reads it, an end that is reached without.
  [[nodiscard]] std::optional<std::uint32_t> read_before(const NativeVariable& variable, std::uint32_t setting) const {
    const std::vector<bool> reached = reached_without(program_, setting);
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    const facts::StatementRange own = facts::section_of(program_, setting);
    // Local variables of another program of the text are others.
    const facts::StatementRange readers = is_local() ? own : facts::StatementRange{.first = 0, .last = count};
    bool is_read = false;
    for (std::uint32_t i = readers.first; i < readers.last; ++i) {
      if (!variable.is_read_by(program_, i)) continue;
      is_read = true;
      if (reached[i]) return i;
    }
    if (is_read) return std::nullopt;
    for (std::uint32_t i = own.first; i < own.last; ++i) {
      const StatementKind kind = program_.statements[i].kind;
      if (reached[i] && (kind == StatementKind::program_end || facts::returns(kind))) return i;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_local() const {
    const auto number = target_.starts_with('#') ? text::parse_integer(target_.substr(1)) : std::nullopt;
    if (!number) return false;
    const ir::VariableRange* range = ir::find_variable(control_, ir::Bank::hash, static_cast<std::uint32_t>(*number));
    return range != nullptr && range->use == ir::VariableUse::local;
  }

  // --- TURNING_CYCLE.EXTD

  NativeTarget argument(std::string_view name, std::string_view parameter) {
    const ir::StringId id = program_.strings.find(name);
    const ir::Structure* head = id == ir::StringId::none ? nullptr : procedure_named(program_, id);
    if (head == nullptr)
      return refused(
          fmt::format("the native text holds no program {} with a PROC line, which names its parameters", name));
    std::uint32_t position = 0;
    std::string known;
    for (; position < head->symbol_count; ++position) {
      const std::string_view here = program_.strings.at(program_.symbols[head->first_symbol + position].name);
      if (text::upper_case(here) == parameter) break;
      known += fmt::format("{}{}", known.empty() ? "" : ", ", here);
    }
    if (position == head->symbol_count)
      return refused(known.empty() ? fmt::format("{} has no parameters", name)
                                   : fmt::format("{} has no parameter {}; it has {}", name, parameter, known));
    const std::vector<std::uint32_t> calls = calls_of(id);
    if (calls.empty()) return refused(fmt::format("no line of the native program calls {}", name));
    if (calls.size() > 1)
      return refused(fmt::format("{} is called in {}, and the value belongs to one call", name, lines_of(calls)),
                     notes_at(calls, "it is called here"));
    const ir::Call& call = program_.calls[program_.statements[calls.front()].payload];
    const ir::ExpressionId value = position < call.argument_count
                                       ? program_.arguments[call.first_argument + position].value
                                       : ir::ExpressionId::none;
    if (value == ir::ExpressionId::none)
      return refused(fmt::format("the call in {} leaves it out", lines_of(calls)), notes_at(calls, "here"));
    const ir::Symbol& symbol = program_.symbols[head->first_symbol + position];
    return constant_at(calls.front(), value, symbol.type == ir::ValueType::integer);
  }

  [[nodiscard]] std::vector<std::uint32_t> calls_of(ir::StringId name) const {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (facts::is_call(s.kind) && program_.calls[s.payload].name == name) out.push_back(i);
    }
    return out;
  }

  // --- both

  NativeTarget constant_at(std::uint32_t statement, ir::ExpressionId value, bool takes_integer) {
    if (value == ir::ExpressionId::none)
      return refused(fmt::format("{} counts it or gets it back from a call", lines_of({statement})),
                     notes_at({statement}, "here"));
    NativeTarget out{.constant = plain_constant(program_, value), .why = {}, .notes = {}};
    if (!out.constant)
      return refused(fmt::format("{} does not set it to a plain decimal number", lines_of({statement})),
                     notes_at({statement}, "here"));
    out.constant->statement = statement;
    out.constant->takes_integer = takes_integer;
    return out;
  }

  [[nodiscard]] std::string lines_of(const std::vector<std::uint32_t>& statements) const {
    std::vector<std::uint32_t> lines;
    lines.reserve(statements.size());
    for (const std::uint32_t one : statements) lines.push_back(program_.statements[one].line);
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return fmt::format("line{} {} of the native program", lines.size() == 1 ? "" : "s", in_words(lines));
  }

  [[nodiscard]] std::vector<text::DiagnosticNote> notes_at(const std::vector<std::uint32_t>& statements,
                                                           std::string_view text) const {
    constexpr std::size_t kMost = 5;
    std::vector<text::DiagnosticNote> out;
    for (std::size_t i = 0; i < statements.size() && i < kMost; ++i)
      out.push_back({.span = program_.statements[statements[i]].span, .text = std::string(text)});
    return out;
  }

  const ir::Program& program_;
  const ir::Control& control_;
  std::string_view target_;
};

bool is_sign(char c) { return c == '+' || c == '-'; }

// A '+' that the reader took for no part of the number.
text::Span with_sign(std::string_view text, text::Span span) {
  std::uint32_t before = span.begin;
  while (before > 0 && (text[before - 1] == ' ' || text[before - 1] == '\t')) --before;
  if (before > 0 && text[before - 1] == '+') span.begin = before - 1;
  return span;
}

}  // namespace

NativeTarget find_target(const ir::Program& program, const ir::Control& control, std::string_view target) {
  return TargetSearch(program, control, target).run();
}

std::optional<NativeConstant> plain_constant(const ir::Program& program, ir::ExpressionId value) {
  const ir::Expression& e = program.at(value);
  const bool negated = e.op == ir::Operator::negate && program.at(e.a).op == ir::Operator::constant;
  if (e.op != ir::Operator::constant && !negated) return std::nullopt;
  const std::string_view whole = program.source.text();
  const text::Span span = with_sign(whole, e.span);
  std::string_view written = span.in(whole);
  const bool negative = written.starts_with('-');
  if (!written.empty() && is_sign(written.front())) written.remove_prefix(1);
  written.remove_prefix(std::min(written.find_first_not_of(" \t"), written.size()));
  const auto decimal = text::read_decimal(written);
  if (!decimal || decimal->length != written.size() || !std::isfinite(decimal->value)) return std::nullopt;
  NativeConstant out;
  out.span = span;
  out.value = negative ? -decimal->value : decimal->value;
  out.has_point = decimal->has_point;
  out.digits = decimal->digits;
  return out;
}

std::string in_words(const std::vector<std::uint32_t>& lines) {
  constexpr std::size_t kMost = 8;
  const std::size_t shown = std::min(lines.size(), kMost);
  std::string out;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == lines.size();
    out += fmt::format("{}{}", i == 0 ? "" : last ? " and " : ", ", lines[i]);
  }
  if (shown < lines.size()) out += fmt::format(" and {} more", lines.size() - shown);
  return out;
}

}  // namespace dripfeed::compile
