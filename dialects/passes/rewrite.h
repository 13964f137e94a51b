// A program's statements, written again: each old one is kept, dropped or replaced by several, and labels, partners
// and the places of several programs and of parts in another language are put right at the end. The arenas only grow.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::passes {

class Rewrite {
 public:
  explicit Rewrite(ir::Program& program)
      : program_(program), first_of_(program.statements.size(), ir::kNoIndex), labels_of_(first_of_) {}

  // From here on, what is emitted stands for the old statement `index`: labels at it move to what comes next.
  void at(std::uint32_t index);
  // What was emitted since at() stays in front of the labels there: who jumps to them does not run it again.
  void labels_from_here();
  // The statement of at(), unchanged.
  void keep();
  // A statement of the line and span of at(); its tokens are empty.
  void emit(ir::StatementKind kind, std::uint32_t payload);
  // The statement that was emitted last.
  ir::Statement& last() { return statements_.back(); }
  // A block of its own codes and words.
  void emit_block(const std::vector<ir::Code>& codes, const std::vector<ir::Word>& words);
  void emit_assign(ir::VariableId target, ir::ExpressionId value);
  void emit_jump(const ir::Jump& jump);
  void emit_structure(ir::StatementKind kind, const ir::Structure& structure);
  // The block number `number` at the next statement that is emitted.
  void label_next(std::uint32_t number);
  // Puts the new statements into the program; pending labels at its end get an empty statement. Returns what
  // ir::match_structures does.
  std::vector<std::uint32_t> finish();
  // Calls visit(index) for each old statement, in order, and finishes.
  template <class Visit>
  void visit_all(Visit visit) {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      at(i);
      visit(i);
    }
    finish();
  }

 private:
  [[nodiscard]] std::uint32_t place_of(std::uint32_t index) const;

  ir::Program& program_;
  std::vector<ir::Statement> statements_;
  std::vector<std::uint32_t> first_of_;   // old index -> new index of what stands for it
  std::vector<std::uint32_t> labels_of_;  // old index -> new index of what its labels stand at
  std::vector<ir::Label> new_labels_;
  std::uint32_t current_ = 0;
};

}  // namespace dripfeed::passes
