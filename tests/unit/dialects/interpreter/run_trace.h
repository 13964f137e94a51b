// Runs a program that was built and gives its trace: what most tests of the interpreter look at.
#pragma once

#include <map>
#include <string>

#include "dialects/interpreter/interpreter.h"
#include "dialects/interpreter/machine/trace.h"
#include "tests/support/program_builder.h"

namespace dripfeed::test {

struct Ran {
  interpreter::RunResult result;
  std::string trace;
  std::vector<ir::Motion> motions;

  [[nodiscard]] const interpreter::RunDiagnostic* last_diagnostic() const {
    return result.diagnostics.empty() ? nullptr : &result.diagnostics.back();
  }
  // Value of a variable after the run; 'vacant' and missing ones give -999.
  [[nodiscard]] double value(std::string_view name) const {
    for (const interpreter::VariableValue& variable : result.variables)
      if (variable.name == name) return variable.value.value_or(-999.0);
    return -999.0;
  }
};

class Programs : public interpreter::ProgramFinder {
 public:
  void add(std::string_view name, const ir::Program& program) { programs_[std::string(name)] = &program; }
  const ir::Program* find(std::string_view name) override {
    const auto found = programs_.find(std::string(name));
    return found == programs_.end() ? nullptr : found->second;
  }

 private:
  std::map<std::string, const ir::Program*> programs_;
};

// Keeps motions and writes the trace.
class Recorder : public ir::MotionSink {
 public:
  Recorder(const ir::Control& control, const interpreter::RunNames& names) : writer_(control, names) {}
  void consume(std::span<const ir::Motion> motions) override {
    motions_.insert(motions_.end(), motions.begin(), motions.end());
    writer_.consume(motions);
  }
  [[nodiscard]] const std::string& trace() const { return writer_.text(); }
  [[nodiscard]] const std::vector<ir::Motion>& motions() const { return motions_; }

 private:
  interpreter::TraceWriter writer_;
  std::vector<ir::Motion> motions_;
};

// Fanuc-like: vacant, exact comparison, motion from power-on known so that nothing is reported about it.
inline ir::Control mill_control() {
  ir::Control control;
  control.dialect = "fanuc";
  control.semantics.power_on_known = true;
  return control;
}
// SINUMERIK-like: no vacant, relative comparison, CR= and AC(), DIV and MOD.
inline ir::Control sinumerik_control() {
  ir::Control control;
  control.dialect = "sinumerik-840d";
  ir::Semantics& s = control.semantics;
  s.has_vacant = false;
  s.comparison = ir::ComparisonMode::relative;
  s.relative_tolerance = 1e-12;
  s.round_half = ir::RoundHalf::up;
  s.round_up = ir::RoundUpMode::next_larger;
  s.atan_full_circle = s.asin_from_90_to_270 = false;
  s.arc_radius_is_r = s.dwell_p_is_ms = false;
  s.d_selects_edge = s.end_in_subprogram_returns = true;
  s.power_on_known = true;
  return control;
}
inline ir::Control lathe_control() {
  ir::Control control = mill_control();
  control.kind = ir::MachineKind::lathe;
  control.axes = "XZ";
  control.semantics.incremental_letters_uvw = true;
  control.semantics.tool_word = ir::ToolWord::number_and_offset;
  control.semantics.power_on_plane = ir::Function::plane_zx;
  control.semantics.power_on_diameter = ir::DiameterMode::diameter;
  return control;
}

inline Ran run_program(const ir::Program& program, const ir::Control& control, interpreter::RunOptions options = {},
                       interpreter::ProgramFinder& finder = interpreter::no_programs()) {
  interpreter::RunNames names;
  if (options.names == nullptr) options.names = &names;
  options.want_variables = true;
  Recorder recorder(control, *options.names);
  Ran ran;
  ran.result = interpreter::run(program, control, finder, recorder, options);
  ran.trace = recorder.trace();
  ran.motions = recorder.motions();
  return ran;
}

}  // namespace dripfeed::test
