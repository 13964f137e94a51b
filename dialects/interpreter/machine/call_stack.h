// Calls and returns: which program runs, with which registers, where its caller goes on, and what it gives back.
#pragma once

#include <bitset>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dialects/interpreter/bytecode/program_table.h"
#include "dialects/interpreter/machine/run_report.h"
#include "dialects/interpreter/machine/storage.h"
#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

class CallStack {
 public:
  // `rules` become those of whatever program is entered.
  CallStack(const CompileContext& context, ProgramTable& programs, Storage& storage, BlockRules& rules,
            ModalState& state, MotionBuffer& out, RunReport& report)
      : context_(context),
        programs_(programs),
        storage_(storage),
        rules_(rules),
        state_(state),
        out_(out),
        report_(report) {}

  void start(CompiledProgram& main);
  // The running program.
  [[nodiscard]] CompiledProgram& program() const { return *program_; }
  [[nodiscard]] bool in_main() const { return frames_.size() == 1; }
  // Enters the program of call site i.a; `next` is where the caller goes on. Gives the instruction to begin at, nothing
  // when the run has ended.
  std::optional<std::uint32_t> call(const Instruction& i, std::uint32_t next);
  // Whether the name of the program that call site i.a calls is not known.
  [[nodiscard]] bool is_unknown_call(const Instruction& i) const;
  // Its name, where the program that the instruction calls cannot be found.
  std::optional<std::string> missing_target(const Instruction& i);
  // Enters a text that is executed as a block, in the frame of the running program.
  bool enter_text(const Instruction& i, CompiledProgram& text, std::uint32_t next);
  // Enters a part of the running program in the control's other language; it is no level of calls. False when the run
  // has ended.
  bool enter_part(const Instruction& i, CompiledProgram& part, std::uint32_t next);
  [[nodiscard]] bool in_foreign_part() const { return frames_.back().is_part; }
  // Enters a program without arguments that no call site names; `next` as for call(). False when the run has ended.
  bool enter_program(const Instruction& i, CompiledProgram& target, std::uint32_t next);
  [[nodiscard]] std::size_t depth() const { return frames_.size(); }
  // G66, MCALL and their end: from now on the site's program is called, `times` at a time, after blocks that move.
  bool begin_modal(const Instruction& i, double times);
  void end_modal() { modal_.reset(); }
  // True where a block that moved is to be followed by the modal call: not in the programs that it has called.
  [[nodiscard]] bool has_modal() const { return modal_.has_value() && modal_frames_ == 0; }
  std::optional<std::uint32_t> call_modal(const Instruction& i, std::uint32_t next);
  // Leaves a called program; gives where the caller goes on. A modal call may be due again: it is then entered again.
  std::uint32_t go_back();
  [[nodiscard]] bool is_main() const { return frames_.size() == 1; }
  [[nodiscard]] bool was_given(std::uint32_t parameter) const {
    return parameter < kParametersAtMost && frames_.back().given[parameter];
  }

 private:
  static constexpr std::uint32_t kParametersAtMost = 128;
  struct Frame {
    CompiledProgram* program = nullptr;
    Bases bases;
    std::uint32_t next = 0;  // where it goes on when the program above has returned
    std::uint32_t line = 0;
    bool is_macro = false;
    bool is_modal = false;
    bool is_external = false;
    bool is_part = false;          // of the program below, in the control's other language
    std::uint32_t times_left = 0;  // of a modal call
    std::bitset<kParametersAtMost> given;
    Modes modes;  // of the caller, when the program gives them back
  };

  // An argument as it is when the call is made, or was when the modal call began.
  struct PassedValue {
    bool given = false;
    bool is_string = false;
    double number = 0.0;
    std::string text;
    std::optional<std::string> shared_text;  // of data of the control, whose type no one knows
    std::optional<double> reference;
  };

  struct ModalCall {
    ir::CallKind kind = ir::CallKind::macro;
    CompiledProgram* target = nullptr;
    std::vector<std::pair<std::uint32_t, double>> locals;  // of a macro: number of the variable, value
    std::vector<PassedValue> arguments;                    // of a subprogram
    std::uint32_t times = 1;
  };

  void enter(Frame& frame);
  void enter_language();
  Frame& push(CompiledProgram& target, std::uint32_t next, bool is_macro);
  void set_locals(const Bases& bases);
  struct Target {
    CompiledProgram* program = nullptr;  // nullptr: there is none
    std::string name = {};
    ir::AlarmDetail detail = ir::AlarmDetail::none;
  };
  Target look_up(CallSite& site);
  CompiledProgram* find_program(const Instruction& i, CallSite& site);
  // CALL … BLOCK … TO …: the part of the program, and where it begins; nullopt: an alarm.
  struct Part {
    CompiledProgram* program = nullptr;
    std::uint32_t begin = 0;
  };
  std::optional<Part> find_part(const Instruction& i, const CallSite& site, const CompiledProgram& whole);
  bool has_room(const Instruction& i, bool macro);
  void pass_locals(const CallSite& site, const Bases& bases);
  void read_values(const CallSite& site, std::vector<PassedValue>& values) const;
  bool has_parameters(const Instruction& i, const CallSite& site, const CompiledProgram& target);
  bool pass_parameters(const Instruction& i, std::span<const PassedValue> values, Frame& frame);
  bool pass_parameter(const Instruction& i, const PassedValue& value, const Parameter& parameter, std::size_t number,
                      const Bases& bases);

  const CompileContext& context_;
  ProgramTable& programs_;
  Storage& storage_;
  BlockRules& rules_;
  ModalState& state_;
  MotionBuffer& out_;
  RunReport& report_;
  std::vector<Frame> frames_;
  CompiledProgram* program_ = nullptr;
  const BlockRules* entered_rules_ = nullptr;  // of program_
  std::uint32_t macros_ = 0;                   // macro calls among the frames
  std::uint32_t parts_ = 0;                    // foreign parts among them
  std::uint32_t modal_frames_ = 0;
  std::optional<ModalCall> modal_;
  std::vector<PassedValue> passing_;  // of the call that is being made
};

}  // namespace dripfeed::interpreter
