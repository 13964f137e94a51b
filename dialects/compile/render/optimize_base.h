// The program of a text that the optimizer's rules work on: the one that a run begins with, as it is given or with the
// lines of what it calls. The programs after it are only read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/translate/inlined_calls.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/optimize/optimize.h"

namespace dripfeed::compile {

struct OptimizeBase {
  ir::Program main;
  std::vector<std::uint32_t> origin_lines;  // by line of its text: the line of the given text; empty: the same
  std::string rest;                         // of the given text
  std::uint32_t rest_line = 0;              // where that begins
  std::uint32_t rest_lines = 0;
  std::vector<optimize::Change> changes;  // that led to it
  // Without the variables that programs after it use, where it still calls any.
  optimize::Settings settings;

  [[nodiscard]] std::uint32_t given_line(std::uint32_t line) const {
    return origin_lines.empty() || line == 0 || line > origin_lines.size() ? line : origin_lines[line - 1];
  }
};

// Why programs after the main one keep it from being changed; empty where they do not.
std::string obstacle_after_main(const ir::Program& given);

OptimizeBase plain_base(const ir::Program& given, const Dialect& dialect, const ir::Control& control,
                        const optimize::Settings& settings);
OptimizeBase inlined_base(const ir::Program& given, const InlinedText& inlined, const Dialect& dialect,
                          const ir::Control& control, const optimize::Settings& settings);

}  // namespace dripfeed::compile
