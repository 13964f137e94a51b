// The arenas' adders, and the matching of structures, which every dialect needs alike.
#include "dialects/ir/program.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace dripfeed::ir {

namespace {

template <class Id, class T>
Id append(std::vector<T>& arena, const T& item) {
  arena.push_back(item);
  return static_cast<Id>(arena.size() - 1);
}

// Which kind closes which: an opener's row names the middle and the end that it takes.
struct StructureRow {
  StatementKind begin;
  StatementKind end;
};
constexpr StructureRow kStructures[] = {
    {StatementKind::if_begin, StatementKind::if_end},         {StatementKind::while_begin, StatementKind::while_end},
    {StatementKind::repeat_begin, StatementKind::repeat_end}, {StatementKind::for_begin, StatementKind::for_end},
    {StatementKind::loop_begin, StatementKind::loop_end},
};

const StructureRow* opener_row(StatementKind kind) {
  for (const StructureRow& row : kStructures)
    if (row.begin == kind) return &row;
  return nullptr;
}
const StructureRow* closer_row(StatementKind kind) {
  for (const StructureRow& row : kStructures)
    if (row.end == kind) return &row;
  return nullptr;
}

class StructureMatcher {
 public:
  explicit StructureMatcher(Program& program) : program_(program) {}

  std::vector<std::uint32_t> match() {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) visit(i);
    for (const Open& open : stack_) unmatched_.push_back(open.begin);
    return std::move(unmatched_);
  }

 private:
  struct Open {
    std::uint32_t begin;  // the opener, for the end's partner
    std::uint32_t last;   // opener or its else: whose partner the next part becomes
  };

  Structure& structure(std::uint32_t statement) { return program_.structures[program_.statements[statement].payload]; }

  void visit(std::uint32_t i) {
    const StatementKind kind = program_.statements[i].kind;
    if (opener_row(kind) != nullptr) {
      stack_.push_back({i, i});
    } else if (kind == StatementKind::else_begin) {
      middle(i);
    } else if (const StructureRow* row = closer_row(kind)) {
      close(i, *row);
    }
  }

  void middle(std::uint32_t i) {
    if (stack_.empty() || program_.statements[stack_.back().begin].kind != StatementKind::if_begin ||
        stack_.back().last != stack_.back().begin) {
      unmatched_.push_back(i);
      return;
    }
    structure(stack_.back().last).partner = i;
    stack_.back().last = i;
  }

  void close(std::uint32_t i, const StructureRow& row) {
    if (stack_.empty() || program_.statements[stack_.back().begin].kind != row.begin ||
        structure(stack_.back().begin).loop_number != structure(i).loop_number) {
      unmatched_.push_back(i);
      return;
    }
    structure(stack_.back().last).partner = i;
    structure(i).partner = stack_.back().begin;
    stack_.pop_back();
  }

  Program& program_;
  std::vector<Open> stack_;
  std::vector<std::uint32_t> unmatched_;
};

}  // namespace

StringId StringTable::add(std::string_view text) {
  if (const auto found = ids_.find(text); found != ids_.end()) return found->second;
  const auto id = static_cast<StringId>(texts_.size());
  texts_.emplace_back(text);
  ids_.emplace(std::string(text), id);
  return id;
}

StringId StringTable::find(std::string_view text) const {
  const auto found = ids_.find(text);
  return found == ids_.end() ? StringId::none : found->second;
}

std::string_view StringTable::at(StringId id) const {
  return id == StringId::none ? std::string_view() : std::string_view(texts_[static_cast<std::uint32_t>(id)]);
}

ExpressionId Program::add(const Expression& expression) { return append<ExpressionId>(expressions, expression); }
VariableId Program::add(const Variable& variable) { return append<VariableId>(variables, variable); }
SymbolId Program::add(const Symbol& symbol) { return append<SymbolId>(symbols, symbol); }

ExpressionId Program::add_constant(double value, text::Span span, bool has_point) {
  Expression e;
  e.value = value;
  e.has_point = has_point;
  e.span = span;
  return add(e);
}

ExpressionId Program::add_operator(Operator op, ExpressionId a, ExpressionId b, text::Span span) {
  Expression e;
  e.op = op;
  e.a = a;
  e.b = b;
  e.span = span;
  return add(e);
}

ExpressionId Program::add_variable(const Variable& variable) {
  Expression e;
  e.op = Operator::variable;
  e.variable = add(variable);
  e.span = variable.span;
  return add(e);
}

std::string_view program_name_of_path(std::string_view path) {
  if (const std::size_t slash = path.find_last_of("/\\:"); slash != std::string_view::npos)
    path.remove_prefix(slash + 1);
  const auto starts = [](std::string_view text, std::string_view head) {
    if (text.size() < head.size()) return false;
    for (std::size_t i = 0; i < head.size(); ++i) {
      const char c = text[i] >= 'a' && text[i] <= 'z' ? static_cast<char>(text[i] - 'a' + 'A') : text[i];
      if (c != head[i]) return false;
    }
    return true;
  };
  const auto drop_one_of = [&](std::initializer_list<std::string_view> endings) {
    constexpr std::size_t kEnding = 4;
    for (const std::string_view ending : endings)
      if (path.size() > kEnding && starts(path.substr(path.size() - kEnding), ending))
        return path.remove_suffix(kEnding);
  };
  const bool of_control = starts(path, "_N_");
  if (of_control) path.remove_prefix(3);
  drop_one_of({"_SPF", "_MPF", ".SPF", ".MPF", ".CYC", ".DEF"});
  if (of_control) drop_one_of({"_CYC", "_DEF"});  // elsewhere a name may end so
  return path;
}

int operand_count(Operator op) {
  if (op <= Operator::string) return 0;
  if (op <= Operator::to_lower) return 1;
  return op < Operator::bound ? 2 : 3;
}

bool is_foreign(const Program& program, std::uint32_t statement) {
  const auto next = std::ranges::upper_bound(program.foreign_parts, statement, {}, &ForeignPart::first);
  return next != program.foreign_parts.begin() && statement < std::prev(next)->last;
}

std::string print_same(const Program& program) {
  std::string out;
  out.reserve(program.source.text().size());
  for (const Token& token : program.tokens) out += token.span.in(program.source.text());
  return out;
}

std::vector<std::uint32_t> match_structures(Program& program) { return StructureMatcher(program).match(); }

text::Span span_of_last(const Program& program, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t i = last; i > first; --i)
    if (program.statements[i - 1].kind != StatementKind::empty) return program.statements[i - 1].span;
  return {};
}

}  // namespace dripfeed::ir
