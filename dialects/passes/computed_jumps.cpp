// GOTO#1, for controls that jump to written targets only: the value is compared with each block number of the program.
//
//     GOTO#1          target = ROUND(#1)
//                     IF target == 10 GOTO N10
//                     IF target == 20 GOTO N20
//                     alarm: the block number is not in the program
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "dialects/facts/flow_graph.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/structures.h"

namespace dripfeed::passes {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

// More comparisons than this are no translation that a person would read.
constexpr std::size_t kMostTargets = 200;
constexpr double kAlarmNumber = 128.0;  // Fanuc's own: PS0128, the sequence number is not found

class ComputedJumps {
 public:
  explicit ComputedJumps(ir::Program& program) : program_(program), out_(program) {}

  StructureReport run() {
    out_.visit_all([this](std::uint32_t i) { statement(i); });
    return std::move(report_);
  }

 private:
  void statement(std::uint32_t i) {
    const ir::Statement& s = program_.statements[i];
    if (s.kind != StatementKind::go_to || program_.jumps[s.payload].computed == ExpressionId::none) return out_.keep();
    const ir::Jump jump = program_.jumps[s.payload];
    const std::vector<std::uint32_t> numbers = targets_of(i);
    if (jump.condition != ExpressionId::none || numbers.empty() || numbers.size() > kMostTargets) return out_.keep();
    ++report_.changed;
    const ir::SymbolId target = new_target();
    const ExpressionId value = program_.add_operator(Operator::round, jump.computed);
    out_.emit_assign(program_.add(variable(target)), value);
    for (const std::uint32_t number : numbers) {
      const ExpressionId same = program_.add_operator(Operator::equal, program_.add_variable(variable(target)),
                                                      program_.add_constant(static_cast<double>(number)));
      out_.emit_jump(jump_to(number, same));
    }
    if (!jump.tolerant) alarm();
  }

  // The block numbers of its own program, each once.
  [[nodiscard]] std::vector<std::uint32_t> targets_of(std::uint32_t i) const {
    const facts::StatementRange own = facts::section_of(program_, i);
    std::vector<std::uint32_t> numbers;
    for (const ir::Label& label : program_.labels)
      if (label.name == ir::StringId::none && own.first <= label.statement && label.statement < own.last)
        numbers.push_back(label.number);
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    return numbers;
  }

  void alarm() {
    ir::Expression text;
    text.op = Operator::string;
    text.string = program_.strings.add("JUMP TARGET MISSING");
    program_.messages.push_back({program_.add(text), program_.add_constant(kAlarmNumber)});
    out_.emit(StatementKind::alarm, static_cast<std::uint32_t>(program_.messages.size() - 1));
  }

  ir::SymbolId new_target() {
    ir::Symbol symbol;
    symbol.name = program_.strings.add("target " + std::to_string(++made_));
    return program_.add(symbol);
  }
  static ir::Variable variable(ir::SymbolId symbol) {
    ir::Variable made;
    made.bank = ir::Bank::named;
    made.symbol = symbol;
    return made;
  }

  ir::Program& program_;
  Rewrite out_;
  StructureReport report_;
  std::uint32_t made_ = 0;
};

}  // namespace

StructureReport lower_computed_jumps(ir::Program& program) {
  const bool any = std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    return s.kind == StatementKind::go_to && program.jumps[s.payload].computed != ExpressionId::none;
  });
  return any ? ComputedJumps(program).run() : StructureReport{};
}

}  // namespace dripfeed::passes
