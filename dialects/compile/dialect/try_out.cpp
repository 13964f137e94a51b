// A number that is not set is one that is not known: what a block takes of it the interpreter reports.
#include "dialects/compile/dialect/try_out.h"

#include <algorithm>

#include "dialects/compile/dialect/execute.h"
#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::compile {

namespace {

constexpr std::uint64_t kMostTried = 2'000'000;  // blocks and passes

bool is_set_by_steps(const family::List& list) { return list.size > 0; }

ir::VariableId number_of(ir::Program& program, const family::List& list, std::int32_t n) {
  ir::Variable variable;
  variable.bank = ir::Bank::named;
  variable.symbol = list.symbol;
  variable.index = program.add_constant(n, {}, false);
  return program.add(variable);
}

}  // namespace

bool are_set_by_steps(std::span<const family::List> lists) { return std::ranges::any_of(lists, is_set_by_steps); }

ir::Program with_unknown_lists(std::span<const family::List> lists, const ir::Program& built) {
  ir::Program out = built;
  passes::Rewrite rewrite(out);
  for (std::uint32_t i = 0; i < built.statements.size(); ++i) {
    rewrite.at(i);
    for (const family::List& list : lists)
      for (std::int32_t n = 0; i == 0 && n < list.size; ++n)
        rewrite.emit_assign(number_of(out, list, n), out.add_constant(interpreter::kUnknown));
    rewrite.keep();
  }
  rewrite.finish();
  return out;
}

std::set<std::uint32_t> lines_with_unset(const interpreter::RunResult& run) {
  std::set<std::uint32_t> out;
  for (const interpreter::NotInterpreted& one : run.not_interpreted)
    if (one.name.ends_with("not known")) out.insert(one.first_line);
  return out;
}

interpreter::RunResult try_out(const ir::Program& program, const ir::Control& control) {
  NoMotions none;
  return try_out(program, control, none);
}

interpreter::RunResult try_out(const ir::Program& program, const ir::Control& control, ir::MotionSink& motions) {
  interpreter::RunOptions options;
  options.limits.blocks = options.limits.loop_passes = kMostTried;
  return execute(program, control, nullptr, motions, options);
}

std::optional<TriedLists> try_set_lists(std::span<const family::List> lists, const ir::Program& built,
                                        const ir::Control& control) {
  if (!are_set_by_steps(lists)) return std::nullopt;
  ir::Control watching = control;
  watching.semantics.unset_is_unknown = true;
  TriedLists out{.lines = {}, .run = try_out(with_unknown_lists(lists, built), watching)};
  out.lines = lines_with_unset(out.run);
  return out;
}

}  // namespace dripfeed::compile
