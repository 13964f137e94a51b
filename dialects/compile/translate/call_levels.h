// Calls between the programs of one text: arguments that no one takes, and how deep they are.
#pragma once

#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// Arguments by letter of programs of the text that read none before they set them: where parameters are declared (PROC)
// the call would end as an alarm.
void drop_unread_arguments(ir::Program& text, const ir::Control& from, const ir::Control& to);

// The calls of a translation, program by program.
class CallLevels {
 public:
  // `name`: as the translation has it.
  void add(const std::string& name, const ir::Program& raised);
  // An error at the call that is deeper than the control goes.
  [[nodiscard]] std::vector<text::Diagnostic> too_deep(const ir::Control& to) const;

 private:
  struct Edge {
    std::string from;
    std::string to;
    bool macro = false;
    text::Span span;
  };
  struct CallPath {
    std::vector<std::string> names;
    std::uint32_t macros = 0;
    std::uint32_t subprograms = 0;
  };
  void follow(const CallPath& path, const ir::Control& to, std::size_t& steps,
              std::vector<text::Diagnostic>& out) const;

  std::vector<std::string> names_;
  std::vector<Edge> edges_;
};

}  // namespace dripfeed::compile
