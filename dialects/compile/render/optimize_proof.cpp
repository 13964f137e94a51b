// Both runs are kept whole and compared motion by motion.
#include "dialects/compile/render/optimize_proof.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/render/same_moves.h"
#include "dialects/compile/translate/inline_moves.h"

namespace dripfeed::compile {

OptimizeProof::OptimizeProof(const ir::ReadResult& given, const Dialect& dialect, const ir::Control& control,
                             const ir::CostModel& cost, ProgramLibrary& library)
    : given_(given), dialect_(dialect), control_(control), cost_(cost), library_(library), faults_(faults_of(given)) {
  also_give(given.program);
}

void OptimizeProof::also_give(const ir::Program& program) {
  also_given_.insert(also_given_.end(), program.variables.begin(), program.variables.end());
}

OptimizeProof::Verdict OptimizeProof::prove(const text::Source& text) {
  Verdict out;
  const ir::ReadResult read = dialect_.read(text, control_);
  out.obstacle = new_fault(read);
  if (!out.obstacle.empty()) return out;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}}) {
    const RecordedRun old_run = run(given(), seed);
    const RecordedRun new_run = run(read.program, seed);
    if (const std::string input = input_of(old_run); !input.empty()) {
      out.not_verified = "its run depends on " + input;
      return out;
    }
    if (old_run.result.ended != new_run.result.ended) {
      out.obstacle =
          fmt::format("the faster program would end differently ({})", interpreter::name_of(new_run.result.ended));
      return out;
    }
    if (!old_run.is_whole || old_run.result.ended == interpreter::Ended::limit) {
      out.not_verified = "it runs too long to be compared whole";
      return out;
    }
    if (old_run.result.ended == interpreter::Ended::alarm) {
      if (seed == 0) out.not_verified = "its run ends by an alarm";
      continue;
    }
    if (const auto line = first_difference(old_run, new_run)) {
      out.obstacle = fmt::format("the faster program would make other moves (line {})", *line);
      return out;
    }
    if (seed == 0) {
      out.before = cost_of(old_run);
      out.after = cost_of(new_run);
    }
    if (!takes_values()) break;
  }
  return out;
}

std::string OptimizeProof::input_of(const RecordedRun& run) {
  for (const interpreter::NotInterpreted& lost : run.result.not_interpreted)
    if (lost.is_input) return lost.name;
  return {};
}

std::string OptimizeProof::new_fault(const ir::ReadResult& read) const {
  for (const auto& [id, message] : faults_of(read))
    if (!faults_.contains(id)) return "the control would object to the faster program: " + message;
  return {};
}

std::map<text::DiagnosticId, std::string> OptimizeProof::faults_of(const ir::ReadResult& read) const {
  std::map<text::DiagnosticId, std::string> out;
  const auto take = [&](const std::vector<text::Diagnostic>& diagnostics) {
    for (const text::Diagnostic& d : diagnostics)
      if (d.severity == text::Severity::error) out.try_emplace(d.id, text::message_of(d));
  };
  take(read.diagnostics);
  take(dialect_.validate(read.program, control_, ir::Delivery::memory));
  return out;
}

bool OptimizeProof::takes_values() const {
  return std::ranges::any_of(also_given_, [](const ir::Variable& v) { return v.bank != ir::Bank::named; });
}

// For what the program may find in the control's memory: the same for both.
std::vector<interpreter::InitialValue> OptimizeProof::values(const ir::Program& program, std::uint64_t seed) const {
  std::vector<interpreter::InitialValue> out;
  // Where nothing is vacant a variable that was never set is 0; the value is given, so that the run knows it.
  if (seed == 0 && control_.semantics.has_vacant) return out;
  std::set<std::pair<ir::Bank, std::uint32_t>> given;
  for (const std::span<const ir::Variable> variables : {std::span(program.variables), std::span(also_given_)})
    for (const ir::Variable& v : variables) {
      if (v.bank != ir::Bank::hash && v.bank != ir::Bank::r) continue;
      if (v.index != ir::ExpressionId::none || !given.emplace(v.bank, v.number).second) continue;
      const ir::VariableRange* range = ir::find_variable(control_, v.bank, v.number);
      if (range == nullptr || !range->writable || range->use == ir::VariableUse::system) continue;
      const std::uint64_t state = (seed << 32U | v.number) * 0x9E3779B97F4A7C15ULL;
      out.push_back(
          {.bank = v.bank, .number = v.number, .value = seed == 0 ? 0.0 : static_cast<double>(state >> 40U) / 65536.0});
    }
  return out;
}

RecordedRun OptimizeProof::run(const ir::Program& program, std::uint64_t seed) {
  interpreter::RunOptions options;
  options.limits = run_limits({});
  options.initial_values = values(program, seed);
  return record(program, control_, library_, options, {}, {});
}

ComputeCost OptimizeProof::cost_of_text(const text::Source& text) {
  return cost_of(run(dialect_.read(text, control_).program, 0));
}

}  // namespace dripfeed::compile
