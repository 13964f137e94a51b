// What a run has to say: diagnostics with their place, the alarm that ended it, texts and things that were not
// interpreted. Every part of the machine speaks through it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "dialects/interpreter/bytecode/bytecode.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/interpreter/state/motion_buffer.h"

namespace dripfeed::interpreter {

class RunReport {
 public:
  RunReport(const ir::Control& control, const Limits& limits, RunNames& names, const MotionBuffer& out)
      : control_(control), limits_(limits), names_(names), out_(out) {}

  // The program whose instructions are meant from now on.
  void enter(const CompiledProgram& program) { program_ = &program; }

  // Ends the run by an alarm, or by a limit of the run; always false.
  bool fail(const Instruction& at, text::DiagnosticId id, std::vector<std::string> arguments = {},
            ir::AlarmDetail detail = ir::AlarmDetail::none);
  bool fail_limit(const Instruction& at, std::string_view limit);
  // An alarm that the program itself raises; `number` as the control shows it, 0: without.
  bool fail_user(const Instruction& at, std::uint32_t number, std::string_view message);
  bool end(Ended ended);
  // A diagnostic that does not end the run.
  void say(const Instruction& at, text::DiagnosticId id, std::vector<std::string> arguments = {});
  // … and that is a warning here, whatever it is by its row.
  void warn(const Instruction& at, text::DiagnosticId id, std::vector<std::string> arguments, std::string_view note);
  // A cut without a feed: said at the end of the run, unless the program turns out to be a subprogram by then.
  void soften(std::string_view note);
  void keep_no_feed(const Instruction& at, ir::AlarmDetail detail);
  void report_no_feed();
  // From here on the program takes a branch that a value decides which is not known: its alarms are possible, not
  // certain.
  void take_uncertain_path() { uncertain_ = true; }
  [[nodiscard]] bool took_uncertain_path() const { return uncertain_; }
  // The passes that are left are none, because too many branches were guessed: the limit says so.
  void end_guesses() { guesses_end_ = true; }
  void count(const Report& report);
  void note_computed(const std::string& name, ir::Function function);
  // Motion::text of that text; kNoText when there are too many.
  std::uint32_t text_index(const std::string& written);

  [[nodiscard]] RunResult& result() { return result_; }
  [[nodiscard]] const RunResult& result() const { return result_; }

 private:
  void add(const Instruction& at, text::DiagnosticId id, std::vector<std::string> arguments,
           ir::AlarmDetail detail = ir::AlarmDetail::none);

  const ir::Control& control_;
  const Limits& limits_;
  RunNames& names_;
  const MotionBuffer& out_;
  const CompiledProgram* program_ = nullptr;
  RunResult result_;
  std::optional<RunDiagnostic> no_feed_;
  std::size_t no_feed_place_ = 0;  // among the diagnostics
  std::map<std::tuple<std::uint32_t, std::uint32_t, text::DiagnosticId>, std::uint32_t>
      reported_;  // by program and line
  bool uncertain_ = false;
  bool guesses_end_ = false;
  std::unordered_map<std::string, std::size_t> counted_;
  std::unordered_map<std::string, std::uint32_t> texts_;
};

}  // namespace dripfeed::interpreter
