// What the called programs read may not be taken for the main program's own, whatever was stated of other programs.
#include "dialects/compile/render/optimize_base.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

// Numbered variables that the statements [first, last) use.
struct UsedNumbers {
  std::set<std::pair<ir::Bank, std::uint32_t>> numbers;
  std::set<ir::Bank> any;  // any number of these may be meant
};

UsedNumbers used_numbers(const ir::Program& program, std::uint32_t first) {
  UsedNumbers out;
  for (std::uint32_t i = first; i < program.statements.size(); ++i)
    for (const passes::VariableUseAt& use : passes::variables_of(program, program.statements[i])) {
      const ir::Variable& v = program.at(use.variable);
      if (v.index != ir::ExpressionId::none)
        out.any.insert(v.bank);
      else
        out.numbers.emplace(v.bank, v.number);
    }
  return out;
}

std::vector<optimize::NumberRange> without(const std::vector<optimize::NumberRange>& ranges, const UsedNumbers& used) {
  std::vector<optimize::NumberRange> out;
  for (optimize::NumberRange range : ranges) {
    if (used.any.contains(range.bank)) continue;
    auto at = used.numbers.lower_bound({range.bank, range.first});
    for (; at != used.numbers.end() && at->first == range.bank && at->second <= range.last; ++at) {
      if (at->second > range.first) out.push_back({range.bank, range.first, at->second - 1});
      range.first = at->second + 1;
    }
    if (range.first <= range.last) out.push_back(range);
  }
  return out;
}

void take_rest(OptimizeBase& base, const ir::Program& given, const MainPart& part, const optimize::Settings& settings) {
  base.settings = settings;
  base.rest = given.source.text().substr(part.bytes);
  if (base.rest.empty()) return;
  base.rest_line = given.source.position(part.bytes).line;
  base.rest_lines = given.source.line_count() + 1 - base.rest_line;
  if (given.source.line(given.source.line_count()).empty()) --base.rest_lines;
  const bool calls = std::ranges::any_of(base.main.statements,
                                         [](const ir::Statement& s) { return s.kind == ir::StatementKind::call; });
  if (!calls) return;
  const UsedNumbers used = used_numbers(given, part.range.last);
  base.settings.own = without(settings.own, used);
  base.settings.free = without(settings.free, used);
}

}  // namespace

std::string obstacle_after_main(const ir::Program& given) {
  for (std::uint32_t i = main_part(given).range.last; i < given.statements.size(); ++i)
    if (given.statements[i].kind == ir::StatementKind::return_to)
      return fmt::format("a return to a block of the caller (line {})", given.statements[i].line);
  return {};
}

OptimizeBase plain_base(const ir::Program& given, const Dialect& dialect, const ir::Control& control,
                        const optimize::Settings& settings) {
  const MainPart part = main_part(given);
  OptimizeBase out;
  if (part.bytes == given.source.text().size()) {
    out.main = given;
  } else {
    std::string text(given.source.text().substr(0, part.bytes));
    out.main = dialect.read(text::Source(given.source.name(), std::move(text)), control).program;
  }
  take_rest(out, given, part, settings);
  return out;
}

OptimizeBase inlined_base(const ir::Program& given, const InlinedText& inlined, const Dialect& dialect,
                          const ir::Control& control, const optimize::Settings& settings) {
  OptimizeBase out;
  out.main = dialect.read(text::Source(given.source.name(), inlined.text), control).program;
  out.origin_lines = inlined.origin_lines;
  for (const InlinedCall& call : inlined.inlined)
    out.changes.push_back({optimize::Rule::inlined, call.line,
                           fmt::format("{} of {} {} the place of the call",
                                       call.blocks == 1 ? "the block" : fmt::format("the {} blocks", call.blocks),
                                       call.program, call.blocks == 1 ? "takes" : "take")});
  take_rest(out, given, main_part(given), settings);
  return out;
}

}  // namespace dripfeed::compile
