// What a program writes and plain blocks do not: outputs, work offsets, tool data, and variables that outlive it. What
// is written for others to read may not vanish; what the program reads again itself it has been computed with.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

class LostWrites {
 public:
  // `control` must outlive this.
  explicit LostWrites(const ir::Control& control) : control_(control) {}

  // A block of `program` was executed: number `index` of the run, nullptr for one that nobody can look at. What it
  // writes is told at `place`, of the main program.
  void executed(std::uint32_t index, const ir::Program* program, std::uint32_t line, text::Span place);
  // Errors: what is written for others. A warning: what is computed with and not left behind.
  [[nodiscard]] std::vector<text::Diagnostic> found() const;

 private:
  struct Write {
    std::string name;        // as written
    std::string variable;    // the same for each way to write it; of a variable with a computed number its bank
    bool is_shared = false;  // a variable that any program may read; otherwise what the control or the machine reads
  };
  using ByLine = std::map<std::uint32_t, std::vector<Write>>;
  struct Found {
    Write write;
    text::Span place;
  };

  ByLine look_at(const ir::Program& program);
  [[nodiscard]] std::optional<Write> write_of(const ir::Program& program, const ir::Variable& v) const;

  const ir::Control& control_;
  std::map<std::uint32_t, ByLine> programs_;
  std::set<std::string> read_;  // Write::variable
  std::set<std::string> said_;
  std::vector<Found> found_;
};

}  // namespace dripfeed::compile
