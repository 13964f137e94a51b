// Priorities, by their shape with all parentheses, and printing with the fewest that keep it.
#include <random>
#include <string>

#include "dialects/sinumerik/tables/keywords.h"
#include "dialects/sinumerik/writer/print_expression.h"
#include "tests/unit/dialects/sinumerik/reading.h"

namespace dripfeed::sinumerik {
namespace {

using ir::Operator;

std::string shape(const ir::Program& p, ir::ExpressionId id) {
  const ir::Expression& e = p.at(id);
  if (e.op == Operator::constant) {
    std::string out;
    ExpressionPrinter::append_constant(out, e.value);
    return out;
  }
  if (e.op == Operator::variable) return "R" + std::to_string(p.at(e.variable).number);
  if (e.op == Operator::string) return "\"" + std::string(p.strings.at(e.string)) + "\"";
  std::string out = "(" + (e.op == Operator::negate ? std::string("neg") : std::string(spelling_of(e.op)));
  for (const ir::ExpressionId operand : {e.a, e.b, e.c})
    if (operand != ir::ExpressionId::none) out += " " + shape(p, operand);
  return out + ")";
}

std::string shape_of(std::string_view expression) {
  const ir::Program p = good("R9=" + std::string(expression));
  return shape(p, p.assigns.at(0).value);
}

TEST(Expression, RanksAreThoseOfTheManual) {
  EXPECT_EQ(shape_of("1+2*3"), "(+ 1 (* 2 3))");
  EXPECT_EQ(shape_of("R1-R2-R3"), "(- (- R1 R2) R3)");
  EXPECT_EQ(shape_of("R1 DIV R2*R3 MOD R4"), "(MOD (* (DIV R1 R2) R3) R4)");
  EXPECT_EQ(shape_of("R1 B_OR R2 B_XOR R3 B_AND R4+1"), "(B_OR R1 (B_XOR R2 (B_AND R3 (+ R4 1))))");
  EXPECT_EQ(shape_of("R1 OR R2 XOR R3 AND R4"), "(OR R1 (XOR R2 (AND R3 R4)))");
  EXPECT_EQ(shape_of("NOT R1 AND R2"), "(AND (NOT R1) R2)");
  EXPECT_EQ(shape_of("\"a\" << R1+1 << \"b\""), "(<< (<< \"a\" (+ R1 1)) \"b\")");
}

TEST(Expression, ComparisonsAreTheWeakest) {
  EXPECT_EQ(shape_of("(R1==10) AND (R2==20)"), "(AND (== R1 10) (== R2 20))");
  const ir::ReadResult trap = read_text("R9=R1==10 AND R2==20");
  EXPECT_EQ(shape(trap.program, trap.program.assigns.at(0).value), "(== (== R1 (AND 10 R2)) 20)");
  ASSERT_EQ(trap.diagnostics.size(), 1U);
  EXPECT_EQ(trap.diagnostics[0].id, text::DiagnosticId::comparison_with_logic);
}

TEST(Expression, SignsAndFunctions) {
  EXPECT_EQ(shape_of("-R1*2"), "(* (neg R1) 2)");
  EXPECT_EQ(shape_of("R1*-2"), "(* R1 -2)");
  EXPECT_EQ(shape_of("-(-R1)"), "(neg (neg R1))");
  EXPECT_EQ(shape_of("ATAN2(R1,SQRT(POT(R2)))"), "(ATAN2 R1 (SQRT (POT R2)))");
  EXPECT_EQ(shape_of("BOUND(0,10,R1)"), "(BOUND 0 10 R1)");
  EXPECT_EQ(shape_of("'H0F'+'B11'+1.5EX2+TRUE"), "(+ (+ (+ 15 3) 150) 1)");
}

TEST(Expression, PrintsTheFewestParentheses) {
  EXPECT_EQ(printed(good("R1=((R2+R3))*(R4*R5)")), "R1=(R2+R3)*(R4*R5)\n");
  EXPECT_EQ(printed(good("R1=(R2-R3)-R4")), "R1=R2-R3-R4\n");
  EXPECT_EQ(printed(good("R1=R2-(R3-R4)")), "R1=R2-(R3-R4)\n");
  EXPECT_EQ(printed(good("R1=(R2==1) OR (R3<>2)")), "R1=(R2==1) OR (R3<>2)\n");
  EXPECT_EQ(printed(good("R1=R2*(-1)")), "R1=R2*(-1)\n");
  EXPECT_EQ(printed(good("R1=0.000001+1EX-12+1EX20+R[R2+1]")), "R1=0.000001+1EX-12+1EX20+R[R2+1]\n");
}

// Random trees, printed and read again, must be the same trees.
class RandomTrees {
 public:
  explicit RandomTrees(std::uint32_t seed) : random_(seed) {}

  ir::ExpressionId tree(ir::Program& p, int depth) {
    static constexpr Operator kBinary[] = {
        Operator::add,     Operator::subtract,  Operator::multiply, Operator::divide,     Operator::integer_divide,
        Operator::modulo,  Operator::bit_and,   Operator::bit_or,   Operator::bit_xor,    Operator::logic_and,
        Operator::equal,   Operator::logic_xor, Operator::logic_or, Operator::not_equal,  Operator::less,
        Operator::greater, Operator::atan2,     Operator::minimum,  Operator::concatenate};
    static constexpr Operator kUnary[] = {Operator::negate, Operator::logic_not, Operator::bit_not, Operator::sin,
                                          Operator::abs};
    if (depth == 0 || pick(5) == 0) return leaf(p);
    if (pick(4) == 0) {
      const Operator op = kUnary[pick(std::size(kUnary))];
      const ir::ExpressionId a = tree(p, depth - 1);
      // The reader takes a sign before a number into the number.
      const bool number = op == Operator::negate && p.at(a).op == Operator::constant;
      return p.add_operator(number ? Operator::abs : op, a);
    }
    const Operator op = kBinary[pick(std::size(kBinary))];
    const ir::ExpressionId a = tree(p, depth - 1);
    return p.add_operator(op, a, tree(p, depth - 1));
  }

 private:
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  ir::ExpressionId leaf(ir::Program& p) {
    if (pick(2) == 0) return p.add_constant(static_cast<double>(pick(200)) / 8.0 - 10.0);
    ir::Variable v;
    v.bank = ir::Bank::r;
    v.number = static_cast<std::uint32_t>(pick(99));
    return p.add_variable(v);
  }
  std::mt19937 random_;
};

TEST(Expression, ChainsAreAsLongAsABlockMayBeAndNoLonger) {
  std::string chain = "1";
  for (int i = 0; i < 1000; ++i) chain += "+1";
  EXPECT_EQ(faults_of("R9=" + chain), "");
  for (int i = 0; i < 200'000; ++i) chain += "*2";
  EXPECT_EQ(faults_of("R9=" + chain), "syntax-error");
}

TEST(Expression, PrintedTreesAreReadAsTheyWere) {
  RandomTrees trees(42);
  const ir::Control c = control(ir::MachineKind::mill);
  for (int round = 0; round < 3000; ++round) {
    ir::Program p;
    const ir::ExpressionId root = trees.tree(p, 5);
    std::string text = "R9=";
    ExpressionPrinter(p, c).append(text, root);
    const ir::ReadResult again = read_text(text);
    for (const text::Diagnostic& d : again.diagnostics)
      ASSERT_EQ(d.severity, text::Severity::warning) << text << ": " << text::message_of(d);
    ASSERT_EQ(shape(again.program, again.program.assigns.at(0).value), shape(p, root)) << text;
  }
}

TEST(Expression, ACharacterOfATextIsAPartOfIt) {
  const ir::Program p = good(
      "DEF STRING[10] TX=\"ABCD\"\nDEF STRING[9] LIST[3]\nDEF CHAR C\nC=TX[2]\nR1=STRLEN(LIST[1])\n"
      "IF C==\"C\" GOTOF DONE\nDONE: M30");
  const ir::Expression& part = p.at(p.assigns[0].value);
  ASSERT_EQ(part.op, ir::Operator::substring);
  EXPECT_EQ(p.at(part.b).value, 2.0);
  EXPECT_EQ(p.at(part.c).value, 1.0);
  EXPECT_EQ(p.at(p.at(p.assigns[1].value).a).op, ir::Operator::variable) << "an element of an array of texts";
  EXPECT_EQ(p.at(p.at(p.jumps[0].condition).b).value, 67.0);
}

}  // namespace
}  // namespace dripfeed::sinumerik
