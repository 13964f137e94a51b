// Times by the cost model, with the model's own doubts next to them.
#include "server/cli/optimize_report.h"

#include <string>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

void print_changes(const compile::OptimizeResult& result, std::string_view name) {
  for (const optimize::Change& change : result.changes)
    fmt::print(stderr, "{}:{}: {}: {}\n", name, change.line, optimize::row_of(change.rule).name, change.what);
  for (const compile::KeptCall& one : result.not_inlined)
    fmt::print(stderr, "{}:{}: {}: {} stays a call: {}\n", name, one.line,
               optimize::row_of(optimize::Rule::inlined).name, one.program.empty() ? "it" : one.program, one.why);
}

namespace {

std::string ms(double value) { return text::format_fixed(value, 2); }

std::string text_of(const compile::Saving& saved) {
  return fmt::format("{} ms ({} to {})", ms(saved.ms), ms(saved.least_ms), ms(saved.most_ms));
}

}  // namespace

void print_saving(const compile::OptimizeResult& result, std::string_view name, const ir::CostModel& cost) {
  if (!result.obstacle.empty()) return print_error(fmt::format("{} is left unchanged: {}", name, result.obstacle));
  if (!result.not_verified.empty()) print_error("not verified by running it: " + result.not_verified);
  if (!result.not_merged.empty()) print_error("no blocks are merged: " + result.not_merged);
  if (!result.not_tabulated.empty()) print_error("no formula is a table: " + result.not_tabulated);
  if (result.off_mm)
    fmt::print(stderr, "the path is {} mm from the program's at most (proved)\n",
               text::format_fixed(*result.off_mm, 6));
  if (!result.before || !result.after) return;
  for (const compile::RuleSaving& one : result.savings)
    fmt::print(stderr, "{} saves {}\n", optimize::row_of(one.rule).name, text_of(one.saved));
  if (result.saved && !result.savings.empty()) fmt::print(stderr, "all rules save {}\n", text_of(*result.saved));
  const compile::ComputeCost &before = *result.before, &after = *result.after;
  fmt::print(stderr,
             "computing {} moves: {} ms in {} blocks before, {} ms in {} blocks after\n"
             "longest before one move: {} ms (line {}) before, {} ms (line {}) after\n"
             "cost model: {} ({}); each time may be off by a factor of {}\n",
             after.moves, ms(before.total_ms), before.blocks, ms(after.total_ms), after.blocks, ms(before.longest_ms),
             before.longest_line, ms(after.longest_ms), after.longest_line, ir::name_of(cost.source), cost.origin,
             text::format_shortest(cost.spread));
}

}  // namespace dripfeed::cli
