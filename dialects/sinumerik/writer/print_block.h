// One block of codes and words as text.
#pragma once

#include <span>
#include <string>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/sinumerik/writer/print_expression.h"

namespace dripfeed::sinumerik {

class BlockPrinter {
 public:
  BlockPrinter(const ir::Program& program, const ir::Control& control)
      : program_(program), control_(control), expressions_(program, control) {}

  void append(std::string& out, const ir::Block& block) const;

 private:
  [[nodiscard]] bool is_m(const ir::Code& code) const;
  [[nodiscard]] std::string code(const ir::Code& code) const;
  // With the words of its block: the coefficients of a polynomial stand after its end.
  [[nodiscard]] std::string word(const ir::Word& word, std::span<const ir::Word> words) const;
  [[nodiscard]] std::string coefficients(ir::Address axis, std::span<const ir::Word> words) const;
  // Only a machine that states its increment rounds; otherwise a position keeps what a trace would show and more.
  [[nodiscard]] int position_decimals(const ir::Expression& e) const;

  const ir::Program& program_;
  const ir::Control& control_;
  ExpressionPrinter expressions_;
};

}  // namespace dripfeed::sinumerik
