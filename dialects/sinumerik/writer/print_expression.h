// Expressions as text, with the fewest parentheses that keep their meaning by the control's own ranks.
#pragma once

#include <string>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::sinumerik {

class ExpressionPrinter {
 public:
  ExpressionPrinter(const ir::Program& program, const ir::Control& control) : program_(program), control_(control) {}

  void append(std::string& out, ir::ExpressionId id) const;
  void append_variable(std::string& out, const ir::Variable& variable) const;
  // A number inside an expression: 2, 0.25, 1.5EX-10.
  static void append_constant(std::string& out, double value);

 private:
  void append_ranked(std::string& out, ir::ExpressionId id, std::uint8_t weakest) const;
  void append_frame(std::string& out, const ir::Expression& e) const;
  void append_axis(std::string& out, ir::ExpressionId axis) const;
  void append_call(std::string& out, const ir::Expression& e) const;
  void append_index(std::string& out, const ir::Variable& variable) const;

  const ir::Program& program_;
  const ir::Control& control_;
};

}  // namespace dripfeed::sinumerik
