// The new statement list grows next to the old one; indices are put right once, at the end.
#include "dialects/passes/rewrite.h"

#include <algorithm>
#include <utility>

namespace dripfeed::passes {

void Rewrite::at(std::uint32_t index) {
  current_ = index;
  first_of_[index] = static_cast<std::uint32_t>(statements_.size());
  labels_of_[index] = first_of_[index];
}

void Rewrite::labels_from_here() { labels_of_[current_] = static_cast<std::uint32_t>(statements_.size()); }

void Rewrite::keep() { statements_.push_back(program_.statements[current_]); }

void Rewrite::emit(ir::StatementKind kind, std::uint32_t payload) {
  const ir::Statement& old = program_.statements[current_];
  ir::Statement statement;
  statement.kind = kind;
  statement.skip_level = old.skip_level;
  statement.payload = payload;
  statement.line = old.line;
  statement.span = old.span;
  statements_.push_back(statement);
}

void Rewrite::emit_block(const std::vector<ir::Code>& codes, const std::vector<ir::Word>& words) {
  ir::Block made;
  made.first_code = static_cast<std::uint32_t>(program_.codes.size());
  made.code_count = static_cast<std::uint32_t>(codes.size());
  made.first_word = static_cast<std::uint32_t>(program_.words.size());
  made.word_count = static_cast<std::uint32_t>(words.size());
  program_.codes.insert(program_.codes.end(), codes.begin(), codes.end());
  program_.words.insert(program_.words.end(), words.begin(), words.end());
  program_.blocks.push_back(made);
  emit(ir::StatementKind::block, static_cast<std::uint32_t>(program_.blocks.size() - 1));
}

void Rewrite::emit_assign(ir::VariableId target, ir::ExpressionId value) {
  program_.assigns.push_back({target, value});
  emit(ir::StatementKind::assign, static_cast<std::uint32_t>(program_.assigns.size() - 1));
}

void Rewrite::emit_jump(const ir::Jump& jump) {
  program_.jumps.push_back(jump);
  emit(ir::StatementKind::go_to, static_cast<std::uint32_t>(program_.jumps.size() - 1));
}

void Rewrite::emit_structure(ir::StatementKind kind, const ir::Structure& structure) {
  program_.structures.push_back(structure);
  program_.structures.back().partner = ir::kNoIndex;
  emit(kind, static_cast<std::uint32_t>(program_.structures.size() - 1));
}

void Rewrite::label_next(std::uint32_t number) {
  const text::Span span = program_.statements[current_].span;
  new_labels_.push_back({ir::StringId::none, number, static_cast<std::uint32_t>(statements_.size()), span});
}

// Of an old statement, or of the end of the list.
std::uint32_t Rewrite::place_of(std::uint32_t index) const {
  return index < first_of_.size() ? first_of_[index] : static_cast<std::uint32_t>(statements_.size());
}

std::vector<std::uint32_t> Rewrite::finish() {
  for (ir::Label& label : program_.labels) label.statement = labels_of_[label.statement];
  program_.labels.insert(program_.labels.end(), new_labels_.begin(), new_labels_.end());
  std::ranges::stable_sort(program_.labels, {}, &ir::Label::statement);
  if (!program_.labels.empty() && program_.labels.back().statement >= statements_.size()) {
    emit(ir::StatementKind::empty, ir::kNoIndex);
  }
  for (ir::Statement& statement : statements_) statement.is_label = false;
  for (const ir::Label& label : program_.labels) statements_[label.statement].is_label = true;
  for (ir::Section& section : program_.sections) {
    section.first = place_of(section.first);
    section.last = place_of(section.last);
  }
  for (ir::ForeignPart& part : program_.foreign_parts) {
    part.first = place_of(part.first);
    part.last = place_of(part.last);
  }
  program_.statements = std::exchange(statements_, {});
  new_labels_.clear();
  for (ir::Structure& structure : program_.structures) structure.partner = ir::kNoIndex;
  return ir::match_structures(program_);
}

}  // namespace dripfeed::passes
