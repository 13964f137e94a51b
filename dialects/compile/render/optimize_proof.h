// The runs that show that a program made faster does what the given one does. What a program takes from outside
// (variables that it reads before it sets them) is 0 in the first pair of runs, and arbitrary in two more.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/library.h"
#include "dialects/compile/render/compute_cost.h"
#include "dialects/compile/translate/recorded_run.h"
#include "dialects/ir/control.h"
#include "dialects/ir/cost_model.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

class OptimizeProof {
 public:
  // `given`: the program as it was read. All must outlive it.
  OptimizeProof(const ir::ReadResult& given, const Dialect& dialect, const ir::Control& control,
                const ir::CostModel& cost, ProgramLibrary& library);

  struct Verdict {
    std::string obstacle;      // why the new text must not be used; empty: it may
    std::string not_verified;  // why running does not show that it may; empty: it does
    std::optional<ComputeCost> before;
    std::optional<ComputeCost> after;
  };
  [[nodiscard]] Verdict prove(const text::Source& text);

  // Variables of `program` get values in every run, as those of the given one do.
  void also_give(const ir::Program& program);

  [[nodiscard]] const ir::Program& given() const { return given_.program; }
  [[nodiscard]] RecordedRun run(const ir::Program& program, std::uint64_t seed);
  [[nodiscard]] ComputeCost cost_of(const RecordedRun& run) const { return compute_cost(run, cost_); }
  [[nodiscard]] ComputeCost cost_of_text(const text::Source& text);
  // A finding of the control's own checks that the given program does not have; empty: there is none.
  [[nodiscard]] std::string new_fault(const ir::ReadResult& read) const;
  [[nodiscard]] bool takes_values() const;

  // What decides in the run and is not known; empty where nothing is.
  static std::string input_of(const RecordedRun& run);

 private:
  [[nodiscard]] std::map<text::DiagnosticId, std::string> faults_of(const ir::ReadResult& read) const;
  [[nodiscard]] std::vector<interpreter::InitialValue> values(const ir::Program& program, std::uint64_t seed) const;

  const ir::ReadResult& given_;
  const Dialect& dialect_;
  const ir::Control& control_;
  const ir::CostModel& cost_;
  ProgramLibrary& library_;
  std::map<text::DiagnosticId, std::string> faults_;  // that the given program has
  std::vector<ir::Variable> also_given_;
};

}  // namespace dripfeed::compile
