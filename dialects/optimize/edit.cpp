// By kind of statement; kinds that are not listed hold nothing that is changed.
#include "dialects/optimize/edit.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::StatementKind;

bool change_block(ir::Program& program, const ir::Statement& s, passes::Rewrite& out, const ChangeExpression& change) {
  const ir::Block block = program.blocks[s.payload];
  if (block.rest_level != 0) return false;
  std::vector<ir::Word> words(program.words.begin() + block.first_word,
                              program.words.begin() + block.first_word + block.word_count);
  bool changed = false;
  for (ir::Word& word : words) {
    if (word.value == ExpressionId::none || !takes_any_number(word.address)) continue;
    const ExpressionId value = change(word.value);
    changed = changed || value != word.value;
    word.value = value;
  }
  if (!changed) return false;
  const std::vector<ir::Code> codes(program.codes.begin() + block.first_code,
                                    program.codes.begin() + block.first_code + block.code_count);
  out.emit_block(codes, words);
  return true;
}

bool change_structure(ir::Program& program, const ir::Statement& s, passes::Rewrite& out,
                      const ChangeExpression& change) {
  ir::Structure structure = program.structures[s.payload];
  if (structure.condition == ExpressionId::none) return false;
  const ExpressionId condition = change(structure.condition);
  if (condition == structure.condition) return false;
  structure.condition = condition;
  out.emit_structure(s.kind, structure);
  return true;
}

bool change_jump(ir::Program& program, const ir::Statement& s, passes::Rewrite& out, const ChangeExpression& change) {
  ir::Jump jump = program.jumps[s.payload];
  if (jump.condition == ExpressionId::none) return false;
  const ExpressionId condition = change(jump.condition);
  if (condition == jump.condition) return false;
  jump.condition = condition;
  out.emit_jump(jump);
  return true;
}

bool change_assign(ir::Program& program, const ir::Statement& s, passes::Rewrite& out, const ChangeExpression& change) {
  const ir::Assign assign = program.assigns[s.payload];
  const ExpressionId value = change(assign.value);
  if (value == assign.value) return false;
  out.emit_assign(assign.target, value);
  return true;
}

}  // namespace

bool takes_any_number(ir::Address a) {
  return ir::is_axis(a) || (a >= ir::Address::i && a <= ir::Address::k) || a == ir::Address::arc_radius ||
         a == ir::Address::f;
}

void for_each_changeable(const ir::Program& program, const ir::Statement& s,
                         const std::function<void(ExpressionId)>& visit) {
  const auto root = [&](ExpressionId id) {
    if (id != ExpressionId::none) visit(id);
  };
  switch (s.kind) {
    case StatementKind::assign: return root(program.assigns[s.payload].value);
    case StatementKind::go_to: return root(program.jumps[s.payload].condition);
    case StatementKind::if_begin:
    case StatementKind::while_begin:
    case StatementKind::repeat_end: return root(program.structures[s.payload].condition);
    case StatementKind::block:
      if (program.blocks[s.payload].rest_level != 0) return;
      for (const ir::Word& word : program.words_of(program.blocks[s.payload]))
        if (takes_any_number(word.address)) root(word.value);
      return;
    default: return;
  }
}

bool keep_with(ir::Program& program, std::uint32_t index, passes::Rewrite& out, const ChangeExpression& change) {
  const ir::Statement s = program.statements[index];
  bool changed = false;
  switch (s.kind) {
    case StatementKind::assign: changed = change_assign(program, s, out, change); break;
    case StatementKind::block: changed = change_block(program, s, out, change); break;
    case StatementKind::go_to: changed = change_jump(program, s, out, change); break;
    case StatementKind::if_begin:
    case StatementKind::while_begin:
    case StatementKind::repeat_end: changed = change_structure(program, s, out, change); break;
    default: break;
  }
  if (!changed) out.keep();
  return changed;
}

}  // namespace dripfeed::optimize
