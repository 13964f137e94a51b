// Measured times of a SINUMERIK 810D: G. Nikiel, "Optimization of execution speed of the CNC parametric part programs",
// tables 1 to 6; ms a single operation (1 to 4), a loop (5) or as printed (6).
#pragma once

#include <array>

#include "checks/timing/cost_fit.h"

namespace dripfeed::paper {

// The paper's programs of tables 1 to 3 and 5, 6 show "...": assumed are ten statements a round, because it defines ten
// variables of each kind for them. Table 4 prints its statements: once a round.
inline constexpr std::uint32_t kStatementsOfARound = 10;

struct PaperRow {
  const char* what;
  timing::CostRow row;  // of one operation
  std::uint32_t a_round = kStatementsOfARound;
};

// The columns of table 4 differ in print (R7/R8 and R7*R8): the count is the same. Its right column: seven blocks,
// R11=R1+R2 R12=R3-R4 R13=R5/R6 R14=R7*R8 R15=R11+R12-R13-R14 R16=R15/R9 R17=R16*R10.
inline constexpr std::array<PaperRow, 8> kTables1To4 = {{
    {"table 1, LUD: VI2=VI1+1", {{.blocks = 1, .named_reads = 1, .named_writes = 1, .operators = 1}, 1.91}},
    {"table 1, R: R2=R1+1", {{.blocks = 1, .number_reads = 1, .number_writes = 1, .operators = 1}, 1.48}},
    {"table 2, LUD: VR2=VR1+1.2", {{.blocks = 1, .named_reads = 1, .named_writes = 1, .operators = 1}, 1.92}},
    {"table 2, R: R2=R1+1.2", {{.blocks = 1, .number_reads = 1, .number_writes = 1, .operators = 1}, 1.52}},
    {"table 3: R2=POT(R1)", {{.blocks = 1, .number_reads = 1, .number_writes = 1, .functions = 1}, 2.07}},
    {"table 3: R2=R1*R1", {{.blocks = 1, .number_reads = 2, .number_writes = 1, .operators = 1}, 1.89}},
    {"table 4: one block", {{.blocks = 1, .number_reads = 10, .number_writes = 1, .operators = 9}, 5.78}, 1},
    {"table 4: seven blocks", {{.blocks = 7, .number_reads = 16, .number_writes = 7, .operators = 9}, 14.54}, 1},
}};

// Table 5, ms a loop. Its body is not printed whole ("..."): only the differences between rows are of use. UNTIL
// R1=1000 is printed for UNTIL R1==1000.
inline constexpr double kIfGoto_ms = 18.16;
inline constexpr double kWhile_ms = 17.80;
inline constexpr double kRepeat_ms = 18.12;
inline constexpr double kFor_ms = 18.04;
// Table 6, ms: with and without a call of the subprogram whose body is the loop's.
inline constexpr double kWithCall_ms = 6.90;
inline constexpr double kWithoutCall_ms = 1.48;

// ms a point of the seal ring's four programs.
inline constexpr std::array<double, 4> kSealRing_ms = {49, 26, 16, 9};

}  // namespace dripfeed::paper
