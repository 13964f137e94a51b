// The virtual machine: the dispatch loop and what ends a run. Blocks, calls, variables by number and strings are
// carried out by parts of their own.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "dialects/interpreter/cycles/contour_run.h"
#include "dialects/interpreter/cycles/shape_run.h"
#include "dialects/interpreter/machine/block_runner.h"
#include "dialects/interpreter/machine/call_stack.h"
#include "dialects/interpreter/machine/frame_access.h"
#include "dialects/interpreter/machine/shared_access.h"
#include "dialects/interpreter/machine/string_operations.h"
#include "dialects/interpreter/machine/variable_access.h"

namespace dripfeed::interpreter {

class Machine {
 public:
  Machine(const ir::Control& control, ProgramFinder& finder, ir::MotionSink& sink, const RunOptions& options);
  RunResult run(const ir::Program& program);
  // stream.cpp
  RunResult run(PlainStream& stream);

 private:
  // Blocks as they are scanned; false when the run has ended. `here` stands for all of them, and gets their `place`
  // where it has one to be set.
  bool run_plain_blocks(PlainStream& stream, const Instruction& here, text::Span* place);
  bool run_stretch(const Instruction& i);
  RunResult finish(const CompiledProgram& main);
  void set_initial_values(const CompiledProgram& main);
  bool set_touch(const InitialValue& value);
  // Until the run has ended, by the budget or otherwise.
  void run_from(std::uint32_t next);
  void execute(std::uint32_t next);
  void end_by_budget(const BudgetUsedUp& used);
  // Instructions that do not stand in the inner loop; false when the run has ended. `next` may be changed, and after a
  // call or a return it is meant in another program.
  bool execute_rare(const Instruction& i, std::uint32_t& next);

  // Arithmetic on the slow path: vacant operands, faults.
  bool unary(const Instruction& i, ir::Operator op);
  bool binary(const Instruction& i, ir::Operator op);
  bool take_outcome(const Instruction& i, Outcome outcome, std::string_view function, double argument);
  bool convert(const Instruction& i);

  // Field by field into both: a copy of the whole would wait for the fields that were just written.
  void begin_place(std::uint32_t line) {
    out_.place.line = begun_.line = line;
    out_.place.ordinal = begun_.ordinal = executed_++;
    begun_.program = out_.place.program;
  }
  void begin_block(const Instruction& i);
  void show_state(StateObserver& states);
  bool follow(Flow flow, const Instruction& i, std::uint32_t& next);
  bool jump(const Instruction& i, std::uint32_t& next);
  [[nodiscard]] bool enters_loop(std::uint32_t from, std::uint32_t to);
  void look_at_allowance(const Instruction& cycle);
  bool call(const Instruction& i, std::uint32_t& next);
  bool check_passes(const Instruction& i);
  bool count_steps(const Instruction& i, std::uint64_t steps);
  bool begin_shape(const Instruction& i, std::uint32_t& next);
  bool shape_block(const Instruction& i, std::uint32_t& next);
  bool end_shape(std::uint32_t& next);
  // CYCLE95: machine_contour.cpp
  [[nodiscard]] bool is_contour_cycle(const Instruction& i) const;
  bool begin_contour(const Instruction& i, std::uint32_t& next);
  bool run_contour(const Instruction& i, const std::string& name, std::uint32_t& next);
  bool run_contour_program(const Instruction& i, const std::string& written, std::uint32_t& next);
  bool run_contour_labels(const Instruction& i, const std::string& name, std::uint32_t& next);
  bool end_contour();
  bool leave_contour(std::string name);
  // machine_milling.cpp
  [[nodiscard]] bool is_milling_cycle(const Instruction& i);
  bool mill_cycle(const Instruction& i, std::uint32_t& next);
  bool end_path(const Instruction& call);
  bool mill_by(const Instruction& i, const ir::MillCycle& cycle, double radius);
  bool leave_milling(std::string name);
  bool passes_over_missing(const Instruction& i);
  bool begin_modal(const Instruction& i);
  bool call_modal(const Instruction& i, std::uint32_t& next);
  bool go_back(const Instruction& i, std::uint32_t& next);
  bool leave_program(std::uint32_t& next);
  bool go_back_to(const Instruction& i, std::uint32_t& next);
  bool end_program(const Instruction& i, std::uint32_t& next);
  bool end_text(const Instruction& i);

  bool message(const Instruction& i);
  bool output(const Instruction& i);
  bool user_alarm(const Instruction& i);
  bool end_endless(const Instruction& i);
  bool repeat_section(const Instruction& i, std::uint32_t& next);
  void end_section(const Instruction& i, std::uint32_t& next);
  bool execute_text(const Instruction& i, std::uint32_t& next);
  bool enter_foreign_part(const Instruction& i, std::uint32_t& next);
  // A condition on a value that is not known; true when it is taken as fulfilled.
  bool decide_unknown(const Instruction& i);
  void define_shared_data();
  void set_inputs(const CompiledProgram& main);
  [[nodiscard]] bool takes_feed_from_caller(const CompiledProgram& main) const;
  void name_unset_inputs(const CompiledProgram& main);
  [[nodiscard]] bool is_called_by_others(const CompiledProgram& main) const;
  void forget_arguments(const CompiledProgram& main);
  void name_missing_arguments();
  void note_values_at_alarm();
  void name_input(const ir::Program& source, const ir::Variable& variable);
  void report_variable(std::string_view name, double value);
  void report_rare(const Instruction& i);
  void report_block();

  const ir::Control& control_;
  const RunOptions& options_;
  RunNames own_names_;
  RunNames& names_;
  const BlockRules own_rules_;
  BlockRules rules_;  // of the running program: a control may have a second language
  Arithmetic arithmetic_;
  VariableMap variables_;
  SharedData shared_;
  CompileContext context_;
  ProgramTable programs_;
  Storage storage_;
  ModalState state_;
  RunBudget budget_;
  MotionBuffer out_;
  RunReport report_;
  CallStack stack_;
  ShapeRun shape_;
  ContourRun contour_;
  VariableAccess access_;
  FrameAccess frames_;
  BlockRunner blocks_;
  StringOperations strings_;
  SharedAccess shared_access_;
  ProgramFinder& finder_;
  std::uint64_t executed_ = 0;
  ir::Place begun_;  // of the running block; a call and a return change out_.place within it
  std::uint64_t passes_ = 0;
  const Instruction* last_jump_ = nullptr;                           // back, without a condition of its own
  std::uint64_t decisions_ = 0;                                      // since then
  std::vector<VariableChange> changes_;                              // of the running block
  std::unordered_map<const Instruction*, std::uint32_t> undecided_;  // how often a condition was not known
  std::set<std::string> missing_programs_;                           // that were called and reported
  std::uint32_t undecided_count_ = 0;                                // of all conditions
  struct OpenSection {
    std::size_t depth = 0;  // of calls
    std::uint32_t id = 0;
    double left = 0.0;
  };
  std::vector<OpenSection> sections_;  // that are being repeated
  struct Text {
    std::unique_ptr<ir::Program> source;
    std::unique_ptr<CompiledProgram> code;
  };
  std::map<std::pair<const CompiledProgram*, std::string>, Text> texts_;  // that were executed as blocks
};

}  // namespace dripfeed::interpreter
