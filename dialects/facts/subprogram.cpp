// By the kinds of its statements.
#include "dialects/facts/subprogram.h"

#include <algorithm>
#include <span>

namespace dripfeed::facts {

namespace {

using ir::StatementKind;

std::span<const ir::Statement> statements_of(const ir::Program& program, const StatementRange& range) {
  return std::span(program.statements).subspan(range.first, range.last - range.first);
}

}  // namespace

bool has_end(const ir::Program& program, const StatementRange& range) {
  return std::ranges::find(statements_of(program, range), StatementKind::program_end, &ir::Statement::kind) !=
         statements_of(program, range).end();
}

bool is_subprogram(const ir::Program& program, const StatementRange& range) {
  return std::ranges::any_of(
             statements_of(program, range),
             [](const ir::Statement& s) { return returns(s.kind) || s.kind == StatementKind::procedure; }) &&
         !has_end(program, range);
}

bool is_subprogram(const ir::Program& program) {
  return is_subprogram(program, {.first = 0, .last = static_cast<std::uint32_t>(program.statements.size())});
}

}  // namespace dripfeed::facts
