// The text of a program of which some statements are new: lines whose statements all stayed keep their bytes, the
// others are printed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/optimize/work.h"

namespace dripfeed::compile {

struct KeptText {
  bool comments = true;  // false: but for those before the first block, they are left out
  bool numbers = true;   // false: block numbers that nothing jumps to are left out
};

struct ChangedText {
  std::string text;
  std::vector<std::uint32_t> origin_lines;  // per line of it: the line of the text before; 0: a new one
};

// `before`: the program as it was read; `after`: the same, changed by passes that give new statements new payloads;
// `made`: what the lines of `after` are that lie beyond those of the text.
ChangedText changed_text(const ir::Program& before, const ir::Program& after,
                         const std::vector<optimize::MadeLine>& made, const Dialect& dialect,
                         const ir::Control& control, const KeptText& kept);

}  // namespace dripfeed::compile
