// Calls and returns: which program runs, with which registers, where its caller goes on, and what it gives back.
#pragma once

#include <bitset>
#include <vector>

#include "dialects/interpreter/apply.h"
#include "dialects/interpreter/program_table.h"
#include "dialects/interpreter/run_report.h"
#include "dialects/interpreter/storage.h"

namespace dripfeed::interpreter {

class CallStack {
 public:
  CallStack(const CompileContext& context, ProgramTable& programs, Storage& storage, ModalState& state,
            MotionBuffer& out, RunReport& report)
      : context_(context), programs_(programs), storage_(storage), state_(state), out_(out), report_(report) {}

  void start(CompiledProgram& main);
  // The running program.
  [[nodiscard]] CompiledProgram& program() const { return *program_; }
  [[nodiscard]] bool in_main() const { return frames_.size() == 1; }
  // Enters the program of call site i.a; `next` is where the caller goes on. False when the run has ended.
  bool call(const Instruction& i, std::uint32_t next);
  // Whether the name of the program that call site i.a calls is not known.
  [[nodiscard]] bool is_unknown_call(const Instruction& i) const;
  // Enters a text that is executed as a block, in the frame of the running program.
  bool enter_text(const Instruction& i, CompiledProgram& text, std::uint32_t next);
  [[nodiscard]] std::size_t depth() const { return frames_.size(); }
  // Leaves a called program; gives where the caller goes on.
  std::uint32_t go_back();
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
    std::bitset<kParametersAtMost> given;
    Modes modes;  // of the caller, when the program gives them back
  };

  void enter(Frame& frame);
  CompiledProgram* find_program(const Instruction& i, CallSite& site);
  bool has_room(const Instruction& i, const CallSite& site);
  void pass_locals(const CallSite& site, const Bases& bases);
  bool pass_parameters(const Instruction& i, const CallSite& site, Frame& frame);
  bool pass_parameter(const Instruction& i, const CallArgument& argument, const Parameter& parameter,
                      const Bases& bases);

  const CompileContext& context_;
  ProgramTable& programs_;
  Storage& storage_;
  ModalState& state_;
  MotionBuffer& out_;
  RunReport& report_;
  std::vector<Frame> frames_;
  CompiledProgram* program_ = nullptr;
  std::uint32_t macros_ = 0;  // macro calls among the frames
};

}  // namespace dripfeed::interpreter
