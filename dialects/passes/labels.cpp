// A jump is bound to the label that it would find when it runs; which number a label gets is of no meaning.
#include "dialects/passes/labels.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::passes {

namespace {

constexpr std::uint32_t kStep = 10;

bool same_label(const ir::Label& label, const ir::Jump& jump) {
  return jump.label != ir::StringId::none ? label.name == jump.label
                                          : label.name == ir::StringId::none && label.number == jump.number;
}

// Index of the label that the jump at `statement` finds, kNoIndex for none. Labels are in the order of their
// statements.
std::uint32_t find_label(const std::vector<ir::Label>& labels, const ir::Jump& jump, std::uint32_t statement) {
  std::uint32_t before = ir::kNoIndex;  // the last one up to the jump
  std::uint32_t first = ir::kNoIndex;
  std::uint32_t after = ir::kNoIndex;
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    if (!same_label(labels[i], jump)) continue;
    if (first == ir::kNoIndex) first = i;
    if (labels[i].statement <= statement) {
      before = i;
    } else if (after == ir::kNoIndex) {
      after = i;
    }
  }
  switch (jump.search) {
    case ir::JumpSearch::forward: return after;
    case ir::JumpSearch::backward: return before;
    case ir::JumpSearch::both: return after != ir::kNoIndex ? after : first;
  }
  return ir::kNoIndex;
}

}  // namespace

FreeNumbers::FreeNumbers(const ir::Program& program, std::uint32_t highest) : highest_(highest), last_(0) {
  for (const ir::Label& label : program.labels) {
    if (label.name == ir::StringId::none && label.number != ir::kNoIndex) used_.push_back(label.number);
  }
  std::ranges::sort(used_);
  if (!used_.empty()) last_ = used_.back() / kStep * kStep;
}

std::uint32_t FreeNumbers::next() {
  if (last_ <= highest_ && highest_ - last_ >= kStep) {
    last_ += kStep;
    used_.push_back(last_);  // above all others: stays sorted
    return last_;
  }
  std::uint32_t candidate = 1;
  for (const std::uint32_t number : used_) {
    if (number > candidate) break;
    if (number == candidate) ++candidate;
  }
  if (candidate > highest_) return 0;
  used_.insert(std::ranges::lower_bound(used_, candidate), candidate);
  return candidate;
}

std::vector<text::Diagnostic> number_labels(ir::Program& program, FreeNumbers& numbers) {
  std::vector<text::Diagnostic> diagnostics;
  std::ranges::stable_sort(program.labels, {}, &ir::Label::statement);
  const std::vector<ir::Label> old = program.labels;
  std::vector<std::uint32_t> new_number(old.size(), 0);
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::Statement& statement = program.statements[i];
    if (statement.kind != ir::StatementKind::go_to) continue;
    ir::Jump& jump = program.jumps[statement.payload];
    if (jump.computed != ir::ExpressionId::none) continue;
    const std::uint32_t found = find_label(old, jump, i);
    if (found == ir::kNoIndex) {
      if (jump.tolerant) continue;  // goes on with the next block
      const std::string name = jump.label != ir::StringId::none ? std::string(program.strings.at(jump.label))
                                                                : fmt::format("N{}", jump.number);
      diagnostics.push_back(text::make_diagnostic(text::DiagnosticId::jump_target_missing, statement.span, {name}));
      continue;
    }
    if (new_number[found] == 0) {
      const auto duplicates = std::ranges::count_if(old, [&](const ir::Label& l) { return same_label(l, jump); });
      const bool keeps = old[found].name == ir::StringId::none && duplicates == 1;
      new_number[found] = keeps ? old[found].number : numbers.next();
    }
    jump.label = ir::StringId::none;
    jump.number = new_number[found];
    jump.search = ir::JumpSearch::both;
  }
  // Names that nothing jumps to go; numbers stay, they may be meant for people.
  program.labels.clear();
  for (std::size_t i = 0; i < old.size(); ++i) {
    ir::Label label = old[i];
    if (new_number[i] == 0 && label.name != ir::StringId::none) continue;
    if (new_number[i] != 0) label.number = new_number[i];
    label.name = ir::StringId::none;
    program.labels.push_back(label);
  }
  for (ir::Statement& statement : program.statements) statement.is_label = false;
  for (const ir::Label& label : program.labels) program.statements[label.statement].is_label = true;
  return diagnostics;
}

}  // namespace dripfeed::passes
