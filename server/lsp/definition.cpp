// A jump, a contour's blocks and a repetition name blocks of their own program; a call names a program of the same text
// or of a file.
#include <algorithm>
#include <limits>

#include "dialects/compile/dialect/program_digest.h"
#include "dialects/compile/renumber/block_references.h"
#include "dialects/ir/repetition.h"
#include "server/lsp/features.h"
#include "server/lsp/file_uri.h"

namespace dripfeed::lsp {

namespace {

using ir::StatementKind;

class Definition {
 public:
  Definition(const Subject& of, const compile::FindText& find_called)
      : of_(of), program_(of.reading.read.program), find_called_(find_called) {}

  std::vector<Location> at(std::uint32_t offset) {
    for (const compile::BlockReference& one : compile::block_references(program_).known)
      if (offset >= one.span.begin && offset <= one.span.end)
        return block(one.statement, ir::StringId::none, one.number);
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (offset < s.span.begin || offset > s.span.end) continue;
      if (auto found = of_statement(i, s); !found.empty()) return found;
    }
    return {};
  }

 private:
  std::vector<Location> of_statement(std::uint32_t index, const ir::Statement& s) {
    if (s.kind == StatementKind::go_to) {
      const ir::Jump& jump = program_.jumps[s.payload];
      return block(index, jump.label, jump.number, jump.search);
    }
    if (s.kind == StatementKind::repeat_section) {
      const ir::Repeat& repeat = program_.repeats[s.payload];
      return block(index, repeat.first, repeat.first_number, ir::JumpSearch::backward);
    }
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) {
      const ir::StringId name = program_.calls[s.payload].name;
      if (name != ir::StringId::none) return program(program_.strings.at(name));
    }
    return {};
  }

  // The statements of the program of the text that the statement is in.
  [[nodiscard]] ir::Section section_of(std::uint32_t statement) const {
    for (const ir::Section& one : program_.sections)
      if (statement >= one.first && statement < one.last) return one;
    return {.first = 0, .last = static_cast<std::uint32_t>(program_.statements.size())};
  }

  // The label that a search from the statement finds first.
  std::vector<Location> block(std::uint32_t from, ir::StringId name, std::uint32_t number,
                              ir::JumpSearch search = ir::JumpSearch::both) {
    if (name == ir::StringId::none && number == ir::kNoIndex) return {};
    const ir::Section section = section_of(from);
    const ir::Label* best = nullptr;
    std::uint32_t best_steps = std::numeric_limits<std::uint32_t>::max();
    for (const ir::Label& label : program_.labels) {
      const bool is_it = name != ir::StringId::none ? label.name == name : label.number == number;
      if (!is_it || label.statement < section.first || label.statement >= section.last) continue;
      const bool is_after = label.statement > from;
      std::uint32_t steps = is_after ? label.statement - from : section.last + label.statement - from;
      if (search == ir::JumpSearch::backward && !is_after) steps = from - label.statement;
      if (search == ir::JumpSearch::backward && is_after) steps += section.last;
      if (steps >= best_steps) continue;
      best = &label;
      best_steps = steps;
    }
    if (best == nullptr) return {};
    return {{of_.text.uri(), of_.range_of(best->span)}};
  }

  std::vector<Location> program(std::string_view name) {
    const std::string key = compile::call_key(name);
    if (const auto own = head_of(of_.reading.read, key))
      return {{of_.text.uri(), of_.range_of(of_.span_of_line(*own))}};
    if (!find_called_) return {};
    const auto file = find_called_(name);
    if (!file) return {};
    const ir::ReadResult read = of_.reading.language.dialect->read(*file, of_.reading.language.control);
    const std::uint32_t line = head_of(read, key).value_or(1) - 1;
    return {{file_uri(file->name()), {{line, 0}, {line, 0}}}};
  }

  // The line with the name of that program: one of several in a text, or the only one.
  static std::optional<std::uint32_t> head_of(const ir::ReadResult& read, const std::string& key) {
    const ir::Program& program = read.program;
    for (const ir::Section& one : program.sections)
      if (compile::call_key(program.strings.at(one.name)) == key && one.first < program.statements.size())
        return head_after(read, program.statements[one.first].line);
    if (!program.sections.empty() || compile::call_key(program.name) != key) return std::nullopt;
    return head_after(read, 1);
  }

  // A program may begin with lines before its name.
  static std::optional<std::uint32_t> head_after(const ir::ReadResult& read, std::uint32_t line) {
    for (const compile::OutlineRow& row : compile::outline_of(read).rows)
      if (row.sort == compile::OutlineSort::program && row.line >= line) return row.line;
    return std::nullopt;
  }

  const Subject& of_;
  const ir::Program& program_;
  const compile::FindText& find_called_;
};

}  // namespace

std::vector<Location> definition_at(const Subject& of, Position at, const compile::FindText& find_called) {
  if (of.reading.is_family) return {};
  return Definition(of, find_called).at(of.offset_of(at));
}

}  // namespace dripfeed::lsp
