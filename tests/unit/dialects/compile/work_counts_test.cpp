// The operations counted for a program, against the same text counted by hand.
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

// The counts of all motions of a SINUMERIK program, its end's too.
ir::ComputeCounts counts_of(const std::string& text, const Texts& called = {}) {
  const ir::Control control = find_dialect("sinumerik-840d")->control(ir::MachineKind::mill, ir::GSystem::a);
  ir::ComputeCounts sum;
  for (const ir::Motion& motion : run_on(control, text, called).motions)
    for (const ir::CostTerm& term : ir::kCostTerms) sum.*term.count += motion.compute.*term.count;
  return sum;
}

// Less what the frame alone counts.
ir::ComputeCounts added_by(const std::string& text, const Texts& called = {}) {
  ir::ComputeCounts counts = counts_of(text + "M30\n", called);
  const ir::ComputeCounts frame = counts_of("M30\n");
  for (const ir::CostTerm& term : ir::kCostTerms) counts.*term.count -= frame.*term.count;
  return counts;
}

void expect_counts(const ir::ComputeCounts& counts, const ir::ComputeCounts& expected) {
  for (const ir::CostTerm& term : ir::kCostTerms) EXPECT_EQ(counts.*term.count, expected.*term.count) << term.name;
}

// Each loop makes four rounds of one statement, R2=R1+1 or its like.
TEST(WorkCounts, ARoundOfEachKindOfLoop) {
  // R1=0, then four times: two assignments, a test.
  expect_counts(
      added_by("R1=0\nN10 R1=R1+1\nR2=R1+1\nIF R1<4 GOTOB N10\n"),
      {.blocks = 1 + 4 * 3, .number_reads = 4 * 3, .number_writes = 1 + 4 * 2, .operators = 4 * 3, .jumps = 3});
  expect_counts(
      added_by("R1=0\nREPEAT\nR1=R1+1\nR2=R1+1\nUNTIL R1==4\n"),
      {.blocks = 2 + 4 * 3, .number_reads = 4 * 3, .number_writes = 1 + 4 * 2, .operators = 4 * 3, .jumps = 3});
  // The test is once more at the head; the end is no block.
  expect_counts(added_by("R1=0\nWHILE R1<4\nR1=R1+1\nR2=R1+1\nENDWHILE\n"), {.blocks = 1 + 5 + 4 * 2,
                                                                             .number_reads = 5 + 4 * 2,
                                                                             .number_writes = 1 + 4 * 2,
                                                                             .operators = 5 + 4 * 2,
                                                                             .rounds = 4});
  // The end of FOR steps and tests: reads, writes and compares the counter.
  expect_counts(added_by("DEF INT PP\nFOR PP=1 TO 4\nR2=R1+1\nENDFOR\n"), {.blocks = 2 + 4 * 2,
                                                                           .number_reads = 4,
                                                                           .number_writes = 4,
                                                                           .named_reads = 4,
                                                                           .named_writes = 1 + 4,
                                                                           .operators = 1 + 4 * 2,
                                                                           .rounds = 4});
}

TEST(WorkCounts, CallsAndIndexedAccess) {
  expect_counts(added_by("L10\nL10 P3\n", {{"L10", "R1=1\nM17\n"}}),
                {.blocks = 2 + 4 * 2, .number_writes = 4, .calls = 4});
  expect_counts(added_by("DEF REAL V[5]\nR[R1+1]=R[R2]\nV[1]=2*V[R3]\n"), {.blocks = 3,
                                                                           .number_reads = 4,
                                                                           .number_writes = 1,
                                                                           .named_reads = 1,
                                                                           .named_writes = 1,
                                                                           .operators = 2,
                                                                           .indexed = 4});
}

TEST(WorkCounts, AConditionThatIsNotFulfilledDoesNotJump) {
  expect_counts(added_by("IF R1>4 GOTOF N20\nGOTOF N20\nR1=1\nN20 R1=2\n"),
                {.blocks = 3, .number_reads = 1, .number_writes = 1, .operators = 1, .jumps = 1});
}

}  // namespace
}  // namespace dripfeed::compile::test
