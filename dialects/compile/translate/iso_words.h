// The words of ISO mode as Siemens mode means them, in a program that is to be translated as one of Siemens mode: R of
// an arc is its radius, G4 counts seconds, U is an increment of X. T, D and H stay: they are those of the other
// control.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/passes/refusal.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// The blocks of one program, in the order of its text.
class IsoWords {
 public:
  // `iso` is the control in ISO mode; `to`, which the errors name, the one that it is translated for. `program` gets
  // the numbers. All must outlive it.
  IsoWords(ir::Program& program, const ir::Control& iso, const ir::Control& to)
      : program_(program), iso_(iso), to_(to) {}

  // Another program of the text begins.
  void begin_program();
  // The codes of a block, of either mode.
  void follow(std::span<const ir::Code> codes);
  // The words of a block of ISO mode, with its codes; `skipped`: a switch may leave it out.
  std::vector<ir::Word> translate(std::span<const ir::Code> codes, std::span<const ir::Word> words, bool skipped);
  // An argument of G65 or G66.
  ir::Argument translate(ir::Argument argument);
  // A cycle or positions by radius and angle, which would act on blocks that follow; empty: neither.
  [[nodiscard]] std::string_view in_effect() const;

  std::vector<text::Diagnostic> take_diagnostics() { return std::move(diagnostics_); }

 private:
  struct State {
    bool drills = false;
    bool turns = false;
    bool polar = false;
    bool bends = false;
    bool unsure = false;  // … as a switch decides
  };
  void translate_dwell(std::span<const ir::Word> words, std::vector<ir::Word>& out);
  void translate_increment(ir::Word& word) const;
  [[nodiscard]] ir::ExpressionId with_point(ir::ExpressionId value);
  [[nodiscard]] std::optional<double> number(ir::ExpressionId value) const;
  [[nodiscard]] bool lacks_point(ir::ExpressionId value) const;
  void cannot(passes::Refusal what, text::Span span);

  ir::Program& program_;
  const ir::Control& iso_;
  const ir::Control& to_;
  std::vector<text::Diagnostic> diagnostics_;
  State state_;
};

}  // namespace dripfeed::compile
