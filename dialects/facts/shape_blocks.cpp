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

bool stands_right_after(const ir::Program& program, const Shape& shape) {
  if (shape.first <= shape.cycle || program.statements[shape.cycle].skip_level != 0) return false;
  for (std::uint32_t i = shape.cycle + 1; i < shape.first; ++i)
    if (program.statements[i].kind != ir::StatementKind::empty) return false;
  return true;
}

bool is_entered(const Shape& shape, const std::vector<bool>& is_target) {
  for (std::uint32_t i = shape.first; i < shape.end; ++i)
    if (is_target[i]) return true;
  return false;
}

}  // namespace

std::vector<Shape> shapes_of(const ir::Program& program) {
  std::vector<bool> is_target;
  std::vector<Shape> out;
  const auto count = static_cast<std::uint32_t>(program.statements.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (program.statements[i].kind != ir::StatementKind::block) continue;
    const ir::Block& block = program.blocks[program.statements[i].payload];
    const auto codes = program.codes_of(block);
    const auto cycle = std::ranges::find_if(codes, ir::follows_shape);
    if (cycle == codes.end()) continue;
    const auto first = number(program, block, ir::Address::p);
    const auto last = number(program, block, ir::Address::q);
    if (!first || !last) continue;
    const std::uint32_t begin = statement_of(program, *first, i);
    std::uint32_t end = begin == ir::kNoIndex ? begin : statement_of(program, *last, begin);
    if (end == ir::kNoIndex || end < begin) continue;
    const std::uint32_t last_line = program.statements[end].line;
    while (end < count && program.statements[end].line <= last_line) ++end;
    Shape shape{.cycle = i, .first = begin, .end = end};
    if (is_target.empty()) is_target = jump_targets(program);
    shape.is_left_out = cycle->argument != 0 && stands_right_after(program, shape) && !is_entered(shape, is_target);
    out.push_back(shape);
  }
  return out;
}

}  // namespace dripfeed::facts
