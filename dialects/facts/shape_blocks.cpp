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

struct Shape {
  std::uint32_t cycle = 0;
  std::uint32_t first = 0;
  std::uint32_t end = 0;  // behind its last statement
  bool is_roughed = false;
};

std::vector<Shape> shapes(const ir::Program& program) {
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
    out.push_back({.cycle = i, .first = begin, .end = end, .is_roughed = cycle->argument != 0});
  }
  return out;
}

bool stands_right_after(const ir::Program& program, const Shape& shape) {
  if (shape.first <= shape.cycle || program.statements[shape.cycle].skip_level != 0) return false;
  for (std::uint32_t i = shape.cycle + 1; i < shape.first; ++i)
    if (program.statements[i].kind != ir::StatementKind::empty) return false;
  return true;
}

}  // namespace

std::vector<bool> blocks_of_shapes(const ir::Program& program) {
  std::vector<bool> out(program.statements.size());
  for (const Shape& shape : shapes(program))
    for (std::uint32_t i = shape.first; i < shape.end; ++i) out[i] = true;
  return out;
}

std::vector<bool> blocks_left_out(const ir::Program& program) {
  std::vector<bool> out(program.statements.size());
  std::vector<bool> is_target;
  for (const Shape& shape : shapes(program)) {
    if (!shape.is_roughed || !stands_right_after(program, shape)) continue;
    if (is_target.empty()) is_target = jump_targets(program);
    bool is_entered = false;
    for (std::uint32_t i = shape.first; i < shape.end; ++i) is_entered |= is_target[i];
    if (is_entered) continue;
    for (std::uint32_t i = shape.first; i < shape.end; ++i) out[i] = true;
  }
  return out;
}

}  // namespace dripfeed::facts
