// What a program writes and plain blocks do not: outputs, work offsets, tool data, and variables that outlive it. What
// is written for others to read may not vanish; what the program reads again itself it has been computed with.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dialects/compile/plain/by_line.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// A write that outlives the program.
struct OutsideWrite {
  std::string name;        // as written
  std::string variable;    // the same for each form of it; of a variable with a computed number its bank
  bool is_shared = false;  // a variable that any program may read; otherwise what the control or the machine reads
};

// What assigning `v` is; nothing for variables of the program's own, and for the frame that positions are counted in.
std::optional<OutsideWrite> outside_write(const ir::Program& program, const ir::Variable& v,
                                          const ir::Control& control);

// How many such writes each line has, G10 and outputs to devices among them.
std::map<std::uint32_t, std::size_t> writes_by_line(const ir::Program& program, const ir::Control& control);

class LostWrites {
 public:
  // `control` must outlive this.
  explicit LostWrites(const ir::Control& control) : control_(control) {}

  // A block of `program` was executed: number `index` of the run, nullptr for one that cannot be looked at. What it
  // writes is reported at `place`, of the main program.
  void executed(std::uint32_t index, const ir::Program* program, std::uint32_t line, text::Span place);
  // Errors: what is written for others. A warning: what is computed with and not kept at the end.
  [[nodiscard]] std::vector<text::Diagnostic> found() const;

 private:
  using Writes = std::vector<OutsideWrite>;
  struct Found {
    OutsideWrite write;
    text::Span place;
  };

  ByLine<Writes> look_at(const ir::Program& program);

  const ir::Control& control_;
  ByProgram<Writes> programs_;
  std::set<std::string> read_;  // OutsideWrite::variable
  std::set<std::string> reported_;
  std::vector<Found> found_;
};

}  // namespace dripfeed::compile
