// Block by block: a block stands in the outline once, by the first of its rows that holds for it.
#include "dialects/compile/dialect/outline.h"

#include <algorithm>
#include <span>
#include <unordered_set>

#include "dialects/compile/dialect/program_digest.h"
#include "dialects/facts/calls.h"
#include "dialects/ir/block_codes.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

// Blocks whose number no one jumps to are nothing that people look for.
std::unordered_set<std::uint32_t> jumped_to(const ir::Program& program) {
  std::unordered_set<std::uint32_t> numbers;
  for (const ir::Jump& jump : program.jumps)
    if (jump.label == ir::StringId::none && jump.number != ir::kNoIndex) numbers.insert(jump.number);
  return numbers;
}

bool names_tool(const ir::Program& program, const ir::Block& block) {
  const auto words = program.words_of(block);
  return std::ranges::any_of(words, [](const ir::Word& w) { return w.address == ir::Address::t; }) ||
         ir::has_code(program, block, ir::Function::tool_change);
}

class Lister {
 public:
  explicit Lister(const ir::Program& program) : program_(program), sorts_(program.statements.size(), kNothing) {}

  Outline run() {
    mark_programs();
    mark_labels();
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) mark_statement(i);
    list();
    return std::move(out_);
  }

 private:
  static constexpr std::uint8_t kNothing = 0xFF;

  void mark(std::uint32_t statement, OutlineSort sort) {
    if (statement < sorts_.size() && sorts_[statement] == kNothing) sorts_[statement] = static_cast<std::uint8_t>(sort);
  }

  void mark_programs() {
    for (const ir::Section& section : program_.sections) mark(first_stating(section.first), OutlineSort::program);
    if (!program_.sections.empty() || program_.name.empty() || program_.statements.empty()) return;
    const std::uint32_t first = first_stating(0);
    const bool is_named_there = program_.source.line(program_.statements[first].line).contains(program_.name);
    if (is_named_there) mark(first, OutlineSort::program);  // otherwise the file gave the name
  }

  // Where a name stands in the text it is on the first line that is not empty and no tape mark.
  [[nodiscard]] std::uint32_t first_stating(std::uint32_t from) const {
    for (std::uint32_t i = from; i < program_.statements.size(); ++i) {
      const std::string_view line = trimmed(program_.source.line(program_.statements[i].line));
      if (!line.empty() && line != "%") return i;
    }
    return from;
  }

  void mark_labels() {
    const std::unordered_set<std::uint32_t> numbers = jumped_to(program_);
    for (const ir::Label& label : program_.labels)
      if (label.name != ir::StringId::none || numbers.contains(label.number)) mark(label.statement, OutlineSort::label);
  }

  void mark_statement(std::uint32_t i) {
    const ir::Statement& s = program_.statements[i];
    const bool is_call = s.kind == StatementKind::call || s.kind == StatementKind::modal_call;
    if (is_call && !facts::is_standard_cycle(program_, s)) return mark(i, OutlineSort::call);
    if (s.kind == StatementKind::program_end) return mark(i, OutlineSort::stop);
    if (s.kind != StatementKind::block) return;
    const ir::Block& block = program_.blocks[s.payload];
    if (names_tool(program_, block)) return mark(i, OutlineSort::tool);
    if (ir::has_code(program_, block, ir::Function::program_stop) ||
        ir::has_code(program_, block, ir::Function::optional_stop))
      mark(i, OutlineSort::stop);
  }

  void list() {
    std::uint32_t before = 0;
    for (std::uint32_t i = 0; i < sorts_.size(); ++i) {
      const std::uint32_t line = program_.statements[i].line;
      if (sorts_[i] == kNothing || line == before) continue;
      before = line;
      if (out_.rows.size() == Outline::kMost) {
        out_.is_cut = true;
        return;
      }
      constexpr std::size_t kWidest_bytes = 120;
      const std::string_view text = trimmed(program_.source.line(line)).substr(0, kWidest_bytes);
      out_.rows.push_back({static_cast<OutlineSort>(sorts_[i]), line, as_utf8(text)});
    }
  }

  static std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(" \t") - first + 1);
  }

  const ir::Program& program_;
  std::vector<std::uint8_t> sorts_;  // of each statement
  Outline out_;
};

}  // namespace

Outline outline_of(const ir::ReadResult& read) { return Lister(read.program).run(); }

}  // namespace dripfeed::compile
