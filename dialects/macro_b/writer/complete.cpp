// Holes are filled with 0; the diagnostics keep the result from being used.
#include "dialects/macro_b/writer/complete.h"

#include <string>

#include "dialects/passes/refusal.h"
#include "dialects/passes/walk.h"

namespace dripfeed::macro_b {

namespace {

using ir::ExpressionId;
using ir::StatementKind;

class Completer {
 public:
  explicit Completer(ir::Program& program) : program_(program) {}

  // True when the statement had a hole.
  bool fill(const ir::Statement& s) {
    found_ = false;
    fields(s);
    std::vector<ExpressionId> roots;
    passes::for_each_root(program_, s, [&](ExpressionId id) { roots.push_back(id); }, [](ir::VariableId) {});
    for (const ExpressionId root : roots) {
      std::vector<ExpressionId> nodes;
      passes::for_each_node(program_, root, [&](ExpressionId id) { nodes.push_back(id); });
      for (const ExpressionId node : nodes) operands(node);
    }
    return found_;
  }

 private:
  void need(ExpressionId& id) {
    if (id != ExpressionId::none) return;
    id = zero();
    found_ = true;
  }
  ExpressionId zero() { return program_.add_constant(0.0); }

  void operands(ExpressionId id) {
    ir::Expression e = program_.at(id);
    const int count = ir::operand_count(e.op);
    if (count >= 1) need(e.a);
    if (count >= 2) need(e.b);
    if (count >= 3) need(e.c);
    program_.expressions[static_cast<std::uint32_t>(id)] = e;
  }

  void fields(const ir::Statement& s) {
    if (s.kind == StatementKind::block) {
      const ir::Block& b = program_.blocks[s.payload];
      for (std::uint32_t i = 0; i < b.word_count; ++i) need(program_.words[b.first_word + i].value);
    } else if (s.kind == StatementKind::assign) {
      ir::Assign& assign = program_.assigns[s.payload];
      need(assign.value);
      if (assign.target == ir::VariableId::none) assign.target = program_.add(ir::Variable{}), found_ = true;
    } else if (s.kind == StatementKind::if_begin || s.kind == StatementKind::while_begin ||
               s.kind == StatementKind::repeat_end) {
      need(program_.structures[s.payload].condition);
    } else if (s.kind == StatementKind::for_begin) {
      ir::Structure& loop = program_.structures[s.payload];
      need(loop.first);
      need(loop.last);
      if (loop.counter == ir::VariableId::none) loop.counter = program_.add(ir::Variable{}), found_ = true;
    } else if (s.kind == StatementKind::go_to) {
      const ir::Jump& jump = program_.jumps[s.payload];
      found_ |= jump.label == ir::StringId::none && jump.number == ir::kNoIndex && jump.computed == ExpressionId::none;
    }
  }

  ir::Program& program_;
  bool found_ = false;
};

}  // namespace

std::vector<text::Diagnostic> complete_statements(ir::Program& program, const std::string& target) {
  std::vector<text::Diagnostic> diagnostics;
  Completer completer(program);
  for (const ir::Statement& statement : program.statements) {
    if (!completer.fill(statement)) continue;
    diagnostics.push_back(passes::diagnose("a statement that is not whole", statement.span, target));
  }
  return diagnostics;
}

}  // namespace dripfeed::macro_b
