// A node is put in parentheses where the reader would otherwise take it apart: a weaker operator inside a stronger one,
// an equal one on the right side, a sign after an operator.
#include "dialects/sinumerik/writer/print_expression.h"

#include <algorithm>
#include <cmath>

#include "dialects/ir/axis_letters.h"
#include "dialects/sinumerik/tables/keywords.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Operator;

constexpr std::string_view kParts[] = {"TR", "FI", "RT", "SC", "MI"};
constexpr double kLongestWhole = 1e9;
constexpr int kMostDecimals = 9;

bool is_prefix(Operator op) { return op == Operator::negate || op == Operator::logic_not || op == Operator::bit_not; }

// System variables whose first index is an axis.
bool is_axial(std::string_view name) { return name.starts_with("$AA_") || name.starts_with("$P_EP"); }

}  // namespace

void ExpressionPrinter::append_constant(std::string& out, double value) {
  if (value == std::floor(value) && std::abs(value) < kLongestWhole) {
    text::append_fixed(out, value, 0);
    return;
  }
  if (std::abs(value) < kLongestWhole && text::parse_number(text::format_fixed(value, kMostDecimals)) == value) {
    text::append_word_number(out, value, kMostDecimals, true);
    return;
  }
  const std::string shortest = text::format_shortest(value);
  const std::size_t e = shortest.find('e');
  out += shortest.substr(0, e);
  if (e == std::string::npos) return;
  // e-09 is EX-9
  out += shortest[e + 1] == '-' ? "EX-" : "EX";
  out += shortest.substr(std::min(shortest.find_first_not_of("+-0", e + 1), shortest.size() - 1));
}

void ExpressionPrinter::append(std::string& out, ir::ExpressionId id) const { append_ranked(out, id, kWeakestRank); }

void ExpressionPrinter::append_ranked(std::string& out, ir::ExpressionId id, std::uint8_t weakest) const {
  const ir::Expression& e = program_.at(id);
  if (e.op == Operator::constant) {
    const bool sign_alone = e.value < 0.0 && weakest < kWeakestRank;
    if (sign_alone) out += '(';
    append_constant(out, e.value);
    if (sign_alone) out += ')';
  } else if (e.op == Operator::string) {
    // A name that stood without quotes is an axis.
    const std::string_view written =
        e.span.end <= program_.source.text().size() ? e.span.in(program_.source.text()) : std::string_view();
    const bool quoted = written.empty() || written.front() == '"' || written.front() == '(';
    out +=
        quoted ? "\"" + std::string(program_.strings.at(e.string)) + "\"" : std::string(program_.strings.at(e.string));
  } else if (e.op == Operator::variable) {
    append_variable(out, program_.at(e.variable));
  } else if (is_prefix(e.op)) {
    const bool parentheses = e.op == Operator::negate && weakest < kWeakestRank;
    if (parentheses) out += '(';
    out += e.op == Operator::negate ? "-" : std::string(spelling_of(e.op)) + " ";
    append_ranked(out, e.a, kUnaryRank);
    if (parentheses) out += ')';
  } else if (const std::uint8_t rank = rank_of(e.op); rank != 0) {
    const bool parentheses = rank > weakest;
    if (parentheses) out += '(';
    append_ranked(out, e.a, rank);
    const std::string_view sign = spelling_of(e.op);
    const bool word = is_letter(sign.front()) || sign == "<<";
    out += word ? " " + std::string(sign) + " " : std::string(sign);
    append_ranked(out, e.b, static_cast<std::uint8_t>(rank - 1));
    if (parentheses) out += ')';
  } else {
    append_call(out, e);
  }
}

// CTRANS(X,10), and chains of such.
void ExpressionPrinter::append_frame(std::string& out, const ir::Expression& e) const {
  if (e.op == Operator::frame_chain) {
    append(out, e.a);
    out += ':';
    return append(out, e.b);
  }
  out += spelling_of(e.op);
  out += '(';
  append_axis(out, e.a);
  if (e.b != ir::ExpressionId::none) {
    out += ',';
    append(out, e.b);
  }
  out += ')';
}

void ExpressionPrinter::append_axis(std::string& out, ir::ExpressionId axis) const {
  const ir::Expression& e = program_.at(axis);
  if (e.op == Operator::constant && e.value >= 0.0 && e.value < static_cast<double>(ir::kAxisLetters.size()))
    out += ir::kAxisLetters[static_cast<std::size_t>(e.value)];
  else
    append(out, axis);
}

void ExpressionPrinter::append_call(std::string& out, const ir::Expression& e) const {
  if (e.op == Operator::frame_mirror || (e.op >= Operator::frame_shift && e.op <= Operator::frame_chain))
    return append_frame(out, e);
  out += spelling_of(e.op);
  out += '(';
  append(out, e.a);
  for (const ir::ExpressionId operand : {e.b, e.c}) {
    if (operand == ir::ExpressionId::none) continue;
    out += ',';
    append(out, operand);
  }
  out += ')';
}

void ExpressionPrinter::append_variable(std::string& out, const ir::Variable& v) const {
  switch (v.bank) {
    case ir::Bank::hash:  // raise leaves none; a message that quotes one keeps its sign
      out += '#';
      break;
    case ir::Bank::r: out += 'R'; break;
    case ir::Bank::named:
      out += program_.strings.at(program_.at(v.symbol).name);
      append_index(out, v);
      return;
    case ir::Bank::system:
      // Functions that are not read, and variables with three indices, stand as they were written.
      if (!v.span.empty() && v.span.end <= program_.source.text().size()) {
        out += v.span.in(program_.source.text());
        return;
      }
      out += control_.system_variables[v.number].name;
      append_index(out, v);
      return;
  }
  if (v.index == ir::ExpressionId::none) {
    out += std::to_string(v.number);
  } else {
    append_index(out, v);
  }
}

void ExpressionPrinter::append_index(std::string& out, const ir::Variable& v) const {
  if (v.index == ir::ExpressionId::none) return;
  out += '[';
  const bool frame = v.bank == ir::Bank::named && program_.at(v.symbol).type == ir::ValueType::frame &&
                     v.index2 != ir::ExpressionId::none;
  const bool axial = v.bank == ir::Bank::system && is_axial(control_.system_variables[v.number].name);
  if (axial || frame)
    append_axis(out, v.index);
  else
    append(out, v.index);
  const ir::ExpressionId part = v.index2;
  if (frame && program_.at(part).op == Operator::constant && program_.at(part).value < std::size(kParts)) {
    out += ',';
    out += kParts[static_cast<std::size_t>(program_.at(part).value)];
    out += ']';
    return;
  }
  for (const ir::ExpressionId further : {v.index2, v.index3}) {
    if (further == ir::ExpressionId::none) continue;
    out += ',';
    append(out, further);
  }
  out += ']';
}

}  // namespace dripfeed::sinumerik
