// Expressions and parameters. Priorities, highest first: functions and brackets; **; * / MOD; + -; comparisons; AND OR
// XOR. Equal ones from the left. What the control calculates otherwise than the operators of the IR do is put together
// from these: EQ holds within 0.0001, MOD is never negative, FIX goes down.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "dialects/ir/program.h"
#include "dialects/linuxcnc/line.h"
#include "dialects/macro_b/reader/cursor.h"

namespace dripfeed::linuxcnc {

class ExpressionReader {
 public:
  ExpressionReader(ir::Program& program, macro_b::Faults& faults) : program_(program), faults_(faults) {}

  void begin(const Line& line, std::size_t at) { line_ = &line, at_ = at, depth_ = 0; }
  [[nodiscard]] std::size_t at() const { return at_; }
  void skip(std::size_t count) { at_ += count; }

  // A number, a parameter, a function or a bracket, with signs; none after a fault, as everywhere here.
  ir::ExpressionId value();
  ir::ExpressionId bracketed();
  // From '#' on.
  std::optional<ir::Variable> parameter();
  // A named parameter: of the running program, or of all where the name begins with '_'.
  ir::Variable named(std::string_view name, text::Span span);
  // A name that no program can write, for what the reader itself counts.
  ir::Variable own(std::string_view purpose);
  // next to a named parameter in a text that asks with EXISTS: 1 once it was set.
  ir::Variable existence(std::string_view name) { return own("exists " + std::string(name)); }

  ir::ExpressionId combine(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b = ir::ExpressionId::none);

 private:
  ir::ExpressionId fail(text::DiagnosticId id, std::vector<std::string> arguments);
  ir::ExpressionId operation(int least_rank);
  ir::ExpressionId function();
  ir::ExpressionId exists();
  ir::ExpressionId number();
  ir::ExpressionId join(std::string_view spelling, ir::ExpressionId a, ir::ExpressionId b);
  ir::ExpressionId constant(double value);

  ir::Program& program_;
  macro_b::Faults& faults_;
  const Line* line_ = nullptr;
  std::size_t at_ = 0;
  std::size_t began_ = 0;  // where the node that is being made begins
  std::uint32_t depth_ = 0;
  std::map<std::string, ir::SymbolId, std::less<>> symbols_;
};

}  // namespace dripfeed::linuxcnc
