// What a program leaves in its variables is the same before and after its structures are lowered.
#include "dialects/passes/structures.h"

#include <random>

#include <gtest/gtest.h>

#include "building.h"
#include "dialects/passes/labels.h"

namespace dripfeed::passes {
namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

constexpr std::uint32_t kVariables = 6;

// Programs of nested structures over #100..#105; each loop counts a variable of its own, #106 and up, so that all end.
class RandomProgram {
 public:
  explicit RandomProgram(unsigned seed) : random_(seed) {
    for (std::uint32_t i = 0; i < kVariables; ++i) built_.assign(variable(i), built_.value(pick(9)));
    statements(3, 4);
    built_.end();
  }
  ir::Program program() { return built_.program; }
  [[nodiscard]] std::uint32_t loops() const { return loops_; }

 private:
  ir::Variable variable(std::uint32_t i) { return Building::numbered(ir::Bank::hash, 100 + i); }
  std::uint32_t pick(std::uint32_t below) { return static_cast<std::uint32_t>(random_() % below); }
  ExpressionId read() { return built_.value(variable(pick(kVariables))); }

  ExpressionId condition(int depth) {
    if (depth > 0 && pick(3) == 0) {
      const Operator op = pick(2) == 0 ? Operator::logic_and : Operator::logic_or;
      const ExpressionId a = condition(depth - 1);
      return built_.op(op, a, condition(depth - 1));
    }
    if (depth > 0 && pick(5) == 0) return built_.op(Operator::logic_not, condition(depth - 1));
    if (pick(8) == 0) return read();
    static constexpr Operator kCompare[] = {Operator::less,    Operator::less_equal, Operator::equal,
                                            Operator::greater, Operator::not_equal,  Operator::greater_equal};
    const ExpressionId a = read();
    return built_.op(kCompare[pick(6)], a, built_.value(pick(9)));
  }

  void change() {
    const ExpressionId a = read();
    built_.assign(variable(pick(kVariables)), built_.op(pick(2) == 0 ? Operator::add : Operator::subtract, a, read()));
  }

  void statements(int depth, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t kind = depth == 0 ? 0 : pick(6);
      if (kind == 1 || kind == 2) branch(depth - 1, kind == 2);
      if (kind == 3) counted(depth - 1);
      if (kind == 4) repeat(depth - 1);
      if (kind == 5) loop_while(depth - 1);
      if (kind == 0) change();
    }
  }
  void branch(int depth, bool has_else) {
    built_.condition(StatementKind::if_begin, condition(2));
    statements(depth, 1 + pick(2));
    if (has_else) {
      built_.structure(StatementKind::else_begin);
      statements(depth, 1 + pick(2));
    }
    built_.structure(StatementKind::if_end);
  }
  ir::Variable counter() { return variable(kVariables + loops_++); }
  void counted(int depth) {
    ir::Structure loop;
    loop.counter = built_.program.add(counter());
    loop.first = built_.value(1);
    loop.last = built_.value(1 + pick(3));
    built_.structure(StatementKind::for_begin, loop);
    statements(depth, 1 + pick(2));
    built_.structure(StatementKind::for_end);
  }
  ExpressionId count_up(const ir::Variable& c) { return built_.op(Operator::add, built_.value(c), built_.value(1)); }
  void repeat(int depth) {
    const ir::Variable c = counter();
    built_.assign(c, built_.value(0));
    built_.structure(StatementKind::repeat_begin);
    statements(depth, 1 + pick(2));
    built_.assign(c, count_up(c));
    const ExpressionId done = built_.op(Operator::greater_equal, built_.value(c), built_.value(3));
    built_.condition(StatementKind::repeat_end, built_.op(Operator::logic_or, done, condition(1)));
  }
  void loop_while(int depth) {
    const ir::Variable c = counter();
    built_.assign(c, built_.value(0));
    const ExpressionId more = built_.op(Operator::less, built_.value(c), built_.value(3));
    built_.condition(StatementKind::while_begin,
                     pick(2) == 0 ? more : built_.op(Operator::logic_and, more, condition(1)));
    built_.assign(c, count_up(c));
    statements(depth, 1 + pick(2));
    built_.structure(StatementKind::while_end);
  }

  std::mt19937 random_;
  Building built_;
  std::uint32_t loops_ = 0;
};

bool has_kind(const ir::Program& p, std::initializer_list<StatementKind> kinds) {
  for (const ir::Statement& s : p.statements) {
    for (const StatementKind kind : kinds) {
      if (s.kind == kind) return true;
    }
  }
  return false;
}

std::uint32_t deepest_loop(const ir::Program& p) {
  std::uint32_t depth = 0;
  std::uint32_t deepest = 0;
  for (const ir::Statement& s : p.statements) {
    if (s.kind == StatementKind::while_begin || s.kind == StatementKind::loop_begin)
      deepest = std::max(deepest, ++depth);
    if (s.kind == StatementKind::while_end || s.kind == StatementKind::loop_end) --depth;
  }
  return deepest;
}

TEST(StructuresProperty, LoweringKeepsWhatTheProgramComputes) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    RandomProgram random(seed);
    ir::Program p = random.program();
    const ir::Control control = control_with(kVariables + random.loops() + 1);
    const auto before = run(p, control);
    ASSERT_EQ(before.at("ended"), static_cast<double>(interpreter::Ended::end)) << seed;
    FreeNumbers numbers(p, 99'999);
    lower_counted_loops(p, numbers);
    ASSERT_FALSE(has_kind(p, {StatementKind::for_begin, StatementKind::repeat_begin}));
    ASSERT_EQ(run(p, control), before) << "counted loops, seed " << seed;
    lower_conditions(p, numbers);
    ASSERT_FALSE(has_kind(p, {StatementKind::else_begin}));
    ASSERT_EQ(run(p, control), before) << "conditions, seed " << seed;
    EXPECT_TRUE(lower_logic(p, numbers).diagnostics.empty());
    ASSERT_EQ(run(p, control), before) << "logic, seed " << seed;
    limit_loop_nesting(p, numbers, 1);
    ASSERT_LE(deepest_loop(p), 1U);
    ASSERT_EQ(run(p, control), before) << "nesting, seed " << seed;
  }
}

TEST(Structures, KeepsIfAroundOneAssignment) {
  Building b;
  const ir::Variable v = Building::numbered(ir::Bank::hash, 100);
  b.condition(StatementKind::if_begin, b.op(Operator::less, b.value(v), b.value(1)));
  b.assign(v, b.value(5));
  b.structure(StatementKind::if_end);
  b.end();
  FreeNumbers numbers(b.program, 9999);
  EXPECT_EQ(lower_conditions(b.program, numbers).changed, 0U);
  EXPECT_EQ(b.program.statements[0].kind, StatementKind::if_begin);
}

TEST(Structures, RefusesExclusiveOrOfConditions) {
  Building b;
  const ir::Variable v = Building::numbered(ir::Bank::hash, 100);
  ir::Jump jump;
  jump.number = 10;
  const ExpressionId a = b.op(Operator::less, b.value(v), b.value(1));
  jump.condition = b.op(Operator::logic_xor, a, b.op(Operator::less, b.value(v), b.value(2)));
  b.jump(jump);
  b.label(10);
  b.end();
  FreeNumbers numbers(b.program, 9999);
  EXPECT_EQ(lower_logic(b.program, numbers).diagnostics.size(), 1U);
}

TEST(Labels, FreeNumbersGoUpAndThenIntoGaps) {
  Building b;
  b.label(1);
  b.label(25);
  b.end();
  FreeNumbers numbers(b.program, 45);
  EXPECT_EQ(numbers.next(), 30U);
  EXPECT_EQ(numbers.next(), 40U);
  EXPECT_EQ(numbers.next(), 2U);
  EXPECT_EQ(numbers.next(), 3U);
  FreeNumbers none(b.program, 0);
  EXPECT_EQ(none.next(), 0U);
}

TEST(Labels, BindsJumpsToTheLabelInTheirDirection) {
  Building b;
  const ir::Variable v = Building::numbered(ir::Bank::hash, 100);
  b.label("A");
  b.assign(v, b.value(1));
  b.jump(b.to_name("A", ir::JumpSearch::forward));
  b.assign(v, b.value(2));
  b.label("A");
  b.end();
  FreeNumbers numbers(b.program, 9999);
  EXPECT_TRUE(number_labels(b.program, numbers).empty());
  ASSERT_EQ(b.program.labels.size(), 1U);  // the first A is no one's target
  EXPECT_EQ(b.program.labels[0].statement, 3U);
  EXPECT_EQ(b.program.jumps[0].number, b.program.labels[0].number);
  EXPECT_EQ(run(b.program, control_with(3)).at("#100"), 1.0);
}

TEST(Labels, ReportsMissingTargets) {
  Building b;
  b.jump(b.to_name("NOWHERE"));
  ir::Jump tolerant = b.to_name("NOWHERE");
  tolerant.tolerant = true;
  b.jump(tolerant);
  b.end();
  FreeNumbers numbers(b.program, 9999);
  const auto diagnostics = number_labels(b.program, numbers);
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].id, text::DiagnosticId::jump_target_missing);
}

}  // namespace
}  // namespace dripfeed::passes
