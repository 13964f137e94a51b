// The definitions of all files come in front of the program's first statement.
#include "dialects/compile/dialect/definition_files.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace dripfeed::compile {

namespace {

using ir::ExpressionId;
using ir::StatementKind;

std::optional<double> constant_of(const ir::Program& program, ExpressionId id) {
  if (id == ExpressionId::none) return 0.0;
  const ir::Expression& e = program.at(id);
  if (e.op == ir::Operator::constant) return e.value;
  if (e.op != ir::Operator::negate) return std::nullopt;
  const auto value = constant_of(program, e.a);
  return value ? std::optional(-*value) : std::nullopt;
}

class Definitions {
 public:
  explicit Definitions(ir::Program& program) : program_(program) {}

  void add(const ir::Program& file) {
    for (const ir::Statement& s : file.statements) {
      if (s.kind == StatementKind::define) define(file, file.structures[s.payload]);
      if (s.kind == StatementKind::assign) element(file, file.assigns[s.payload]);
    }
  }

  void finish() {
    if (head_.empty()) return;
    const auto shift = static_cast<std::uint32_t>(head_.size());
    program_.statements.insert(program_.statements.begin(), head_.begin(), head_.end());
    for (ir::Label& label : program_.labels) label.statement += shift;
    for (ir::ForeignPart& part : program_.foreign_parts) {
      part.first += shift;
      part.last += shift;
    }
    for (ir::Structure& structure : program_.structures) structure.partner = ir::kNoIndex;
    (void)ir::match_structures(program_);  // halves have been reported
  }

 private:
  void define(const ir::Program& file, const ir::Structure& list) {
    ir::Structure head;
    head.first_symbol = static_cast<std::uint32_t>(program_.symbols.size());
    for (std::uint32_t i = 0; i < list.symbol_count; ++i) {
      ir::Symbol symbol = file.symbols[list.first_symbol + i];
      const bool is_number = symbol.type == ir::ValueType::real || symbol.type == ir::ValueType::integer ||
                             symbol.type == ir::ValueType::boolean;
      const auto initial = is_number ? constant_of(file, symbol.initial) : std::optional(0.0);
      if (!initial) continue;
      symbol.name = program_.strings.add(file.strings.at(symbol.name));
      symbol.initial = is_number ? program_.add_constant(*initial) : ExpressionId::none;
      symbol.is_global = true;
      symbol.span = {};
      program_.add(symbol);
    }
    head.symbol_count = static_cast<std::uint32_t>(program_.symbols.size()) - head.first_symbol;
    if (head.symbol_count == 0) return;
    push(StatementKind::define, program_.structures, head);
  }

  // DEF NCK REAL A[3]=SET(1,2,3): one assignment an element.
  void element(const ir::Program& file, const ir::Assign& assign) {
    const ir::Variable& written = file.at(assign.target);
    if (written.bank != ir::Bank::named || written.symbol == ir::SymbolId::none) return;
    const auto value = constant_of(file, assign.value);
    const std::optional<ir::SymbolId> symbol = added(file.strings.at(file.at(written.symbol).name));
    if (!value || !symbol) return;
    ir::Variable target;
    target.bank = ir::Bank::named;
    target.symbol = *symbol;
    for (const auto index : {&ir::Variable::index, &ir::Variable::index2, &ir::Variable::index3})
      if (written.*index != ExpressionId::none)
        target.*index = program_.add_constant(constant_of(file, written.*index).value_or(0.0));
    push(StatementKind::assign, program_.assigns, ir::Assign{program_.add(target), program_.add_constant(*value)});
  }

  // The last symbol of the name that was put there.
  [[nodiscard]] std::optional<ir::SymbolId> added(std::string_view name) const {
    for (auto i = static_cast<std::uint32_t>(program_.symbols.size()); i > first_; --i)
      if (program_.strings.at(program_.symbols[i - 1].name) == name) return static_cast<ir::SymbolId>(i - 1);
    return std::nullopt;
  }

  template <class Arena, class Payload>
  void push(StatementKind kind, Arena& arena, const Payload& payload) {
    ir::Statement statement;
    statement.kind = kind;
    statement.payload = static_cast<std::uint32_t>(arena.size());
    arena.push_back(payload);
    head_.push_back(statement);
  }

  ir::Program& program_;
  std::uint32_t first_ = static_cast<std::uint32_t>(program_.symbols.size());
  std::vector<ir::Statement> head_;
};

}  // namespace

void add_definitions(ir::Program& program, const ir::Control& control, ProgramLibrary& library) {
  Definitions definitions(program);
  for (const std::string& name : control.definition_files)
    if (const ir::Program* file = library.find(name)) definitions.add(*file);
  definitions.finish();
}

}  // namespace dripfeed::compile
