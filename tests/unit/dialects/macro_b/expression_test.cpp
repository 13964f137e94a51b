// Priorities of expressions, and printing with as few brackets as read back to the same tree.
#include <array>
#include <cmath>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/macro_b/writer/print_expression.h"
#include "reading.h"

namespace dripfeed::macro_b {
namespace {

using ir::ExpressionId;
using ir::Operator;

// The tree as text: (op a b).
std::string tree(const ir::Program& program, ExpressionId id) {
  const ir::Expression& e = program.at(id);
  if (e.op == Operator::constant) return fmt::format("{}", e.value);
  if (e.op == Operator::vacant) return "#0";
  if (e.op == Operator::variable) {
    const ir::Variable& v = program.at(e.variable);
    return v.index == ExpressionId::none ? fmt::format("#{}", v.number) : "#[" + tree(program, v.index) + "]";
  }
  std::string out = fmt::format("({}", static_cast<int>(e.op));
  for (const ExpressionId operand : {e.a, e.b, e.c}) {
    if (operand != ExpressionId::none) out += " " + tree(program, operand);
  }
  return out + ")";
}

struct Parsed {
  ir::ReadResult read;
  ExpressionId value = ExpressionId::none;
};
Parsed parse(const std::string& expression) {
  Parsed parsed{read_text("#9=" + expression + "\n")};
  if (!parsed.read.program.assigns.empty()) parsed.value = parsed.read.program.assigns.front().value;
  return parsed;
}
std::string tree_of(const std::string& expression) {
  const Parsed parsed = parse(expression);
  if (!parsed.read.diagnostics.empty()) return "fault: " + text::message_of(parsed.read.diagnostics.front());
  return tree(parsed.read.program, parsed.value);
}
std::string printed(const std::string& expression) {
  const Parsed parsed = parse(expression);
  return ExpressionPrinter(parsed.read.program, test_grammar()).expression(parsed.value);
}

TEST(Expression, RanksFunctionsProductsSumsComparisons) {
  EXPECT_EQ(tree_of("#1+#2*#3"), tree_of("#1+[#2*#3]"));
  EXPECT_EQ(tree_of("#1-#2-#3"), tree_of("[#1-#2]-#3"));
  EXPECT_EQ(tree_of("#1/#2*#3"), tree_of("[#1/#2]*#3"));
  EXPECT_EQ(tree_of("#1 AND #2 OR #3"), tree_of("[#1 AND #2] OR #3"));
  EXPECT_EQ(tree_of("#1 OR #2 AND #3"), tree_of("#1 OR [#2 AND #3]"));
  EXPECT_EQ(tree_of("#1+#2 MOD #3"), tree_of("#1+[#2 MOD #3]"));
  EXPECT_EQ(tree_of("#1 XOR #2+#3"), tree_of("[#1 XOR #2]+#3"));
  EXPECT_EQ(tree_of("#1+1 EQ #2*2"), tree_of("[#1+1] EQ [#2*2]"));
  EXPECT_EQ(tree_of("-#1*#2"), tree_of("[-#1]*#2"));
  EXPECT_EQ(tree_of("SIN[#1]*2"), tree_of("[SIN[#1]]*2"));
  EXPECT_NE(tree_of("#1-#2-#3"), tree_of("#1-[#2-#3]"));
}

TEST(Expression, ReadsBothFormsOfAtan) {
  EXPECT_EQ(tree_of("ATAN[#1]/[#2]"), tree_of("ATAN[#1,#2]"));
  EXPECT_NE(tree_of("ATAN[#1]/#2"), tree_of("ATAN[#1]/[#2]"));
  EXPECT_EQ(printed("ATAN[#1,#2]"), "ATAN[#1]/[#2]");
  EXPECT_EQ(printed("[ATAN[#1]]/[#2+1]"), "[ATAN[#1]]/[#2+1]");
}

TEST(Expression, DistinguishesTruthsFromBits) {
  const Parsed bits = parse("#1 AND #2");
  EXPECT_EQ(bits.read.program.at(bits.value).op, Operator::bit_and);
  const Parsed truths = parse("[#1 EQ 1]AND[#2 EQ 2]");
  EXPECT_EQ(truths.read.program.at(truths.value).op, Operator::logic_and);
}

TEST(Expression, PrintsWithFewBrackets) {
  EXPECT_EQ(printed("[[#1*#2]+[#3/#4]]"), "#1*#2+#3/#4");
  EXPECT_EQ(printed("#1-[#2-#3]"), "#1-[#2-#3]");
  EXPECT_EQ(printed("#1*[-2.]"), "#1*[-2.]");
  EXPECT_EQ(printed("-2.*#1"), "-2.*#1");
  EXPECT_EQ(printed("#[#1+1]"), "#[#1+1]");
  EXPECT_EQ(printed("#0"), "#0");
  EXPECT_EQ(printed("[#1 EQ #0]AND[#2 LT 3]"), "[#1 EQ #0] AND [#2 LT 3]");
  EXPECT_EQ(printed("0.000001"), "0.000001");
  EXPECT_EQ(printed("1"), "1");
  EXPECT_EQ(printed("1."), "1.");
}

TEST(Expression, CountsBracketsWithThoseOfFunctions) {
  EXPECT_EQ(tree_of("[[[[[#1]]]]]"), "#1");
  EXPECT_EQ(parse("[[[[[[#1]]]]]]").read.diagnostics.size(), 1U);
  EXPECT_EQ(parse("SIN[SIN[SIN[SIN[SIN[SIN[#1]]]]]]").read.diagnostics.front().id,
            text::DiagnosticId::bracket_nesting_too_deep);
  EXPECT_EQ(parse(std::string(100'000, '[')).read.diagnostics.size(), 2U);  // named once, then given up
}

// A random tree of n operators, printed, read and compared.
class RandomTree {
 public:
  RandomTree(ir::Program& program, unsigned seed) : program_(program), random_(seed) {}
  ExpressionId make(int depth) {
    static constexpr std::array kOperators = {
        Operator::add,     Operator::subtract, Operator::multiply, Operator::divide, Operator::modulo,
        Operator::bit_and, Operator::bit_or,   Operator::bit_xor,  Operator::sin,    Operator::round_up,
        Operator::atan,    Operator::atan2,    Operator::negate,   Operator::power};
    if (depth == 0 || random_() % 5 == 0) return leaf();
    const Operator op = kOperators[random_() % kOperators.size()];
    if (op == Operator::negate) return program_.add_operator(op, variable());
    const ExpressionId a = make(depth - 1);
    return program_.add_operator(op, a, ir::operand_count(op) == 2 ? make(depth - 1) : ExpressionId::none);
  }

 private:
  ExpressionId variable() {
    ir::Variable v;
    v.number = 1 + static_cast<std::uint32_t>(random_() % 33);
    return program_.add_variable(v);
  }
  ExpressionId leaf() {
    if (random_() % 2 == 0) return variable();
    return program_.add_constant((static_cast<double>(random_() % 2001) - 1000.0) / 8.0);
  }
  ir::Program& program_;
  std::mt19937 random_;
};

TEST(Expression, ChainsAreAsLongAsABlockMayBeAndNoLonger) {
  std::string chain = "1";
  for (int i = 0; i < 1000; ++i) chain += "+1";
  EXPECT_TRUE(read_text("#9=" + chain + "\n").diagnostics.empty());
  for (int i = 0; i < 200'000; ++i) chain += "*2";
  const ir::ReadResult read = read_text("#9=" + chain + "\n");
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.diagnostics.front().id, text::DiagnosticId::syntax_error);
}

TEST(ExpressionProperty, PrintedReadsBackToTheSameTree) {
  ir::Control control = test_control();
  control.limits.expression_nesting = 60;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    ir::Program program;
    const ExpressionId made = RandomTree(program, seed).make(5);
    const std::string text = ExpressionPrinter(program, test_grammar()).expression(made);
    const ir::ReadResult read = read_text("#9=" + text + "\n", control);
    ASSERT_TRUE(read.diagnostics.empty()) << text << ": " << text::message_of(read.diagnostics.front());
    ASSERT_EQ(tree(read.program, read.program.assigns.front().value), tree(program, made)) << text;
  }
}

}  // namespace
}  // namespace dripfeed::macro_b
