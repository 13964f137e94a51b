// A number is looked for from its cycle on, then from the top of the program.
#include "dialects/facts/shape_blocks.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/cycle.h"

namespace dripfeed::facts {

namespace {

std::optional<double> number(const ir::Program& program, const ir::Block& block, ir::Address address) {
  const auto words = program.words_of(block);
  const auto word = std::ranges::find(words, address, &ir::Word::address);
  if (word == words.end() || word->value == ir::ExpressionId::none) return std::nullopt;
  const ir::Expression& e = program.at(word->value);
  return e.op == ir::Operator::constant ? std::optional(e.value) : std::nullopt;
}

std::uint32_t statement_of(const ir::Program& program, double number, std::uint32_t from) {
  const StatementRange own = section_of(program, from);
  std::uint32_t found = ir::kNoIndex;
  for (const ir::Label& label : program.labels) {
    const bool matches = label.name == ir::StringId::none && label.number == number;
    if (!matches || label.statement < own.first || label.statement >= own.last) continue;
    if (label.statement >= from) return label.statement;
    if (found == ir::kNoIndex) found = label.statement;
  }
  return found;
}

}  // namespace

std::vector<bool> blocks_of_shapes(const ir::Program& program) {
  std::vector<bool> out(program.statements.size());
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    if (program.statements[i].kind != ir::StatementKind::block) continue;
    const ir::Block& block = program.blocks[program.statements[i].payload];
    if (std::ranges::none_of(program.codes_of(block), ir::follows_shape)) continue;
    const auto first = number(program, block, ir::Address::p);
    const auto last = number(program, block, ir::Address::q);
    if (!first || !last) continue;
    const std::uint32_t begin = statement_of(program, *first, i);
    std::uint32_t end = begin == ir::kNoIndex ? begin : statement_of(program, *last, begin);
    if (end == ir::kNoIndex || end < begin) continue;
    const std::uint32_t last_line = program.statements[end].line;
    for (end = begin; end < out.size() && program.statements[end].line <= last_line; ++end) out[end] = true;
  }
  return out;
}

}  // namespace dripfeed::facts
