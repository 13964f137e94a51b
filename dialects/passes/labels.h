// Block numbers: finding free ones, and giving numbers to labels with names for controls that jump to numbers only.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// Hands out block numbers that the program does not use, in steps of ten from above its highest (10 for none), never
// above `highest`: then the gaps below.
class FreeNumbers {
 public:
  FreeNumbers(const ir::Program& program, std::uint32_t highest);
  std::uint32_t next();  // 0 when there is none left

 private:
  std::vector<std::uint32_t> used_;  // sorted
  std::uint32_t highest_;
  std::uint32_t last_;
};

// Every label with a name becomes a number and every jump to it a jump to that number. A jump that searches one
// direction (GOTOF, GOTOB) is bound to the label that it would find, so that names given twice stay apart. Jumps
// without a target are left as they are, with jump_target_missing.
std::vector<text::Diagnostic> number_labels(ir::Program& program, FreeNumbers& numbers);

}  // namespace dripfeed::passes
