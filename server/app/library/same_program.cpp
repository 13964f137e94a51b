// Tokens first, block by block, then what the reader made of them.
#include "server/app/library/same_program.h"

#include <algorithm>
#include <string_view>
#include <tuple>

#include "dialects/text/upper_case.h"

namespace dripfeed::app {

namespace {

using ir::TokenKind;

bool is_same_block(const ir::Program& before, const TokenBlocks& left, const BlockTokens& a, const ir::Program& after,
                   const TokenBlocks& right, const BlockTokens& b) {
  if (a.last - a.first != b.last - b.first) return false;
  for (std::uint32_t i = 0; i < a.last - a.first; ++i) {
    const ir::Token& one = before.tokens[left.indexes[a.first + i]];
    const ir::Token& other = after.tokens[right.indexes[b.first + i]];
    if (one.kind != other.kind) return false;
    if (text::upper_case(one.span.in(before.source.text())) != text::upper_case(other.span.in(after.source.text())))
      return false;
  }
  return true;
}

bool has_same_names(const ir::Program& before, const ir::Program& after) {
  const auto name = [](const ir::Program& of) { return [&of](const auto& one) { return of.strings.at(one.name); }; };
  return before.name == after.name &&
         std::ranges::equal(before.sections, after.sections, {}, name(before), name(after)) &&
         std::ranges::equal(before.calls, after.calls, {}, name(before), name(after)) &&
         std::ranges::equal(before.labels, after.labels, {}, name(before), name(after));
}

bool has_same_statements(const ir::Program& before, const ir::Program& after) {
  const auto statement = [](const ir::Statement& one) {
    return std::tuple(one.kind, one.skip_level, one.is_label, one.payload, one.line);
  };
  const auto code = [](const ir::Code& one) {
    return std::tuple(one.function, one.argument, one.group, one.letter, one.number);
  };
  const auto word = [](const ir::Word& one) {
    return std::tuple(one.address, one.extension, one.mode, one.value, one.axis);
  };
  const auto expression = [](const ir::Expression& one) {
    return std::tuple(one.op, one.has_point, one.a, one.b, one.c, one.value, one.variable);
  };
  const auto label = [](const ir::Label& one) { return std::tuple(one.number, one.statement); };
  const auto jump = [](const ir::Jump& one) {
    return std::tuple(one.condition, one.search, one.tolerant, one.restart, one.number, one.computed);
  };
  return std::ranges::equal(before.statements, after.statements, {}, statement, statement) &&
         std::ranges::equal(before.codes, after.codes, {}, code, code) &&
         std::ranges::equal(before.words, after.words, {}, word, word) &&
         std::ranges::equal(before.expressions, after.expressions, {}, expression, expression) &&
         std::ranges::equal(before.labels, after.labels, {}, label, label) &&
         std::ranges::equal(before.jumps, after.jumps, {}, jump, jump);
}

}  // namespace

TokenBlocks blocks_of(const ir::Program& program) {
  TokenBlocks out;
  const auto count = static_cast<std::uint32_t>(program.tokens.size());
  BlockTokens block;
  for (std::uint32_t i = 0; i < count; ++i) {
    const ir::Token& token = program.tokens[i];
    if (token.kind != TokenKind::white && token.kind != TokenKind::eob) out.indexes.push_back(i);
    block.last = static_cast<std::uint32_t>(out.indexes.size());
    if (token.kind != TokenKind::eob && i + 1 < count) continue;
    out.blocks.push_back(block);
    block = {.first = block.last, .last = block.last, .begin = token.span.end};
  }
  return out;
}

std::optional<std::vector<std::uint32_t>> changed_blocks(const ir::Program& before, const ir::Program& after) {
  const TokenBlocks left = blocks_of(before);
  const TokenBlocks right = blocks_of(after);
  if (left.blocks.size() != right.blocks.size()) return std::nullopt;
  std::vector<std::uint32_t> changed;
  for (std::uint32_t i = 0; i < left.blocks.size(); ++i)
    if (!is_same_block(before, left, left.blocks[i], after, right, right.blocks[i])) changed.push_back(i);
  return changed;
}

bool is_same_program(const ir::Program& before, const ir::Program& after) {
  const auto changed = changed_blocks(before, after);
  return changed && changed->empty() && has_same_statements(before, after) && has_same_names(before, after);
}

}  // namespace dripfeed::app
