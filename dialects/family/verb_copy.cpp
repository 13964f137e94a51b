// A parameter that takes a number or a name becomes it; others, and what the library computes, get names of their own.
#include "dialects/family/verb_copy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/read.h"
#include "dialects/family/verb_texts.h"

namespace dripfeed::family {

namespace {

using ir::ExpressionId;
using ir::Operator;

Family read_library() {
  ReadFamilyResult read = read_family(text::Source("verbs", std::string(kVerbTexts)));
  return std::move(read.family);
}

// With four decimals at most, as people write it.
bool is_short(double value) {
  constexpr double kRaster = 1e4;
  return std::round(value * kRaster) / kRaster == value;
}

std::optional<double> calculated_number(Operator op, double a, double b) {
  if (op == Operator::minimum) return std::min(a, b);
  if (op == Operator::maximum) return std::max(a, b);
  double value = 0.0;
  if (op == Operator::add)
    value = a + b;
  else if (op == Operator::subtract)
    value = a - b;
  else if (op == Operator::multiply)
    value = a * b;
  else if (op == Operator::divide && b != 0.0)
    value = a / b;
  else
    return std::nullopt;
  return is_short(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

const Family& verb_library() {
  static const Family library = read_library();
  return library;
}

std::optional<double> VerbCopy::number(ExpressionId id) const {
  const ir::Expression& e = to_.arena.at(id);
  if (e.op == Operator::constant) return e.value;
  if (e.op != Operator::negate || to_.arena.at(e.a).op != Operator::constant) return std::nullopt;
  return -to_.arena.at(e.a).value;
}

bool VerbCopy::is_simple(ExpressionId id) const {
  const ir::Expression& e = to_.arena.at(id);
  if (e.op == Operator::variable) return to_.arena.at(e.variable).index == ExpressionId::none;
  return number(id).has_value();
}

bool VerbCopy::is_set(ExpressionId name) const {
  const ir::Expression& e = to_.arena.at(name);
  return e.op == Operator::variable && changing_.contains(to_.arena.at(e.variable).symbol);
}

ExpressionId VerbCopy::calculated(Operator op, ExpressionId a, ExpressionId b) {
  const std::optional<double> left = number(a);
  const std::optional<double> right = number(b);
  if (left && right)
    if (const std::optional<double> known = calculated_number(op, *left, *right)) return constant(*known);
  if (op == Operator::add && left == 0.0) return b;
  if ((op == Operator::add || op == Operator::subtract) && right == 0.0) return a;
  if (op == Operator::subtract && left == 0.0) return to_.arena.add_operator(Operator::negate, b, {}, like_.span);
  if (op == Operator::multiply && left == 1.0) return b;
  if ((op == Operator::multiply || op == Operator::divide) && right == 1.0) return a;
  return to_.arena.add_operator(op, a, b, like_.span);
}

ir::SymbolId VerbCopy::symbol_of(ir::SymbolId own) {
  const auto known = symbols_.find(own);
  if (known != symbols_.end()) return known->second;
  const ir::Program& library = verb_library().arena;
  const std::string stem(library.strings.at(library.at(own).name));
  std::string name = stem;
  for (int i = 2; scope_.find(name) != nullptr; ++i) name = fmt::format("{}{}", stem, i);
  const ir::SymbolId made = scope_.define(to_.arena, name, kRatio, like_.span);
  symbols_.emplace(own, made);
  if (set_.contains(own)) changing_.insert(made);
  return made;
}

ExpressionId VerbCopy::copy(ExpressionId id) {
  const ir::Program& library = verb_library().arena;
  const ir::Expression& e = library.at(id);
  if (e.op == Operator::constant) return constant(e.value);
  if (e.op == Operator::variable) {
    const ir::SymbolId own = library.at(e.variable).symbol;
    if (const auto given = values_.find(own); given != values_.end()) return given->second;
    for (const Definition& one : verb_library().definitions)
      if (one.symbol == own) return copy(one.value);
    ir::Variable variable;
    variable.bank = ir::Bank::named;
    variable.symbol = symbol_of(own);
    variable.span = like_.span;
    return to_.arena.add_variable(variable);
  }
  const ExpressionId a = copy(e.a);
  if (ir::operand_count(e.op) == 1) {
    if (e.op == Operator::negate && number(a)) return constant(-*number(a));
    return to_.arena.add_operator(e.op, a, ExpressionId::none, like_.span);
  }
  return calculated(e.op, a, copy(e.b));
}

ExpressionId VerbCopy::value(std::string_view function, std::span<const ExpressionId> arguments) {
  const UserFunction& found = *verb_library().find_function(function);
  values_.clear();
  for (std::size_t i = 0; i < found.parameters.size(); ++i)
    values_.insert_or_assign(found.parameters[i].symbol, arguments[i]);
  return copy(found.value);
}

std::vector<Step> VerbCopy::steps(std::string_view subprogram, std::span<const ExpressionId> arguments,
                                  const std::optional<VerbFeeds>& feeds) {
  const Subprogram& found = *verb_library().find_subprogram(subprogram);
  values_.clear();
  for (std::size_t i = 0; i < arguments.size(); ++i) values_.insert_or_assign(found.parameters[i].symbol, arguments[i]);
  feeds_ = feeds;
  if (feeds) {
    entry_ = feeds->entry == ExpressionId::none ? constant(0.0) : feeds->entry;
    before_ = constant(0.0);
    values_.insert_or_assign(found.parameters[arguments.size()].symbol, entry_);
    values_.insert_or_assign(found.parameters[arguments.size() + 1].symbol, before_);
  }
  for (const Step& one : found.steps)
    if (one.kind == StepKind::set) set_.insert(one.target);
  std::vector<Step> out;
  for (const Step& one : found.steps)
    if (std::optional<Step> made = copy(one)) out.push_back(std::move(*made));
  return out;
}

// Nothing: it is not needed.
std::optional<Step> VerbCopy::copy(const Step& own) {
  const Family& library = verb_library();
  Step out = own;
  out.line = like_.line;
  out.span = like_.span;
  for (ExpressionId& value : out.values)
    if (value != ExpressionId::none) value = copy(value);
  out.first_word = static_cast<std::uint32_t>(to_.words.size());
  std::vector<StepWord> words;
  for (std::uint32_t i = 0; i < own.word_count; ++i) {
    StepWord word = library.words[own.first_word + i];
    word.value = copy(word.value);
    if (swaps_axes_ && word.address == ir::Address::x)
      word.address = ir::Address::y;
    else if (swaps_axes_ && word.address == ir::Address::y)
      word.address = ir::Address::x;
    words.push_back(word);
  }
  to_.words.insert(to_.words.end(), words.begin(), words.end());
  if (own.kind == StepKind::feed) return copy_feed(std::move(out));
  if (own.kind == StepKind::let && !set_.contains(own.target)) {
    const ExpressionId value = out.values[0];
    if (is_simple(value) && !is_set(value)) {
      values_.insert_or_assign(own.target, value);
      return std::nullopt;
    }
    values_.erase(own.target);
  }
  if (own.target != ir::SymbolId::none) out.target = symbol_of(own.target);
  return out;
}

std::optional<Step> VerbCopy::copy_feed(Step out) {
  if (!feeds_ || feeds_->entry == ExpressionId::none) return std::nullopt;
  out.dimension = feeds_->dimension;
  const bool is_before = out.values[0] == before_;
  out.number = is_before ? kFeedBefore : kPassingFeed;
  if (is_before) out.values[0] = ExpressionId::none;
  return out;
}

}  // namespace dripfeed::family
