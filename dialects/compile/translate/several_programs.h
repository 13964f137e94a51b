// A text may hold several programs: O0001 with its subprograms, or the files of a punched tape. Each is translated as
// a program of its own, and the translations stand in one text again, each under its head.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/passes/refusal.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// The statements of the section as a program; its source and spans are the whole text's.
ir::Program program_of(const ir::Program& text, const ir::Section& section);

class JoinedPrograms {
 public:
  // `control`: that the text is written for. Both must outlive it.
  JoinedPrograms(const ir::Program& text, const ir::Control& control) : text_(text), control_(control) {}

  // Appends a translation: `raised` is what `program`, a program_of(), became. What several programs of one text cannot
  // have in common afterwards is an error.
  void add(const ir::Program& program, const ir::Program& raised, ir::PrintResult printed);
  // The name that `program` has there; empty, with an error, when no call could find it.
  std::string name_there(const ir::Program& program);
  [[nodiscard]] const std::vector<text::Diagnostic>& diagnostics() const { return diagnostics_; }
  ir::PrintResult take();

 private:
  using Place = std::pair<ir::Bank, std::uint32_t>;
  void refuse_sharing(const ir::Program& program, const ir::Program& raised);
  void compare_variables(const ir::Program& program, const ir::Program& raised);
  void cannot(passes::Refusal what, text::Span span);
  [[nodiscard]] text::Span span_of(const ir::Program& program) const;
  [[nodiscard]] bool is_called(const ir::Program& program) const;

  const ir::Program& text_;
  const ir::Control& control_;
  ir::PrintResult joined_;
  std::vector<std::pair<Place, Place>> variables_;  // what a variable became, in all programs so far
  std::vector<std::string> names_;
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace dripfeed::compile
