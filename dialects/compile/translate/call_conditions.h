// Which calls the lines of a subprogram may stand in place of, so that the program does the same.
#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/library.h"
#include "dialects/compile/translate/called_body.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/sections.h"

namespace dripfeed::compile {

// A program of some text.
struct Callee {
  const ir::Program* text = nullptr;  // nullptr: none
  std::uint32_t section = 0;
  [[nodiscard]] ir::Section range() const { return ir::section_at(*text, section); }
  friend bool operator==(const Callee&, const Callee&) = default;
};

// Where a call stands.
struct Around {
  std::vector<Callee> callers = {};      // the main program first
  std::vector<std::uint8_t> loops = {};  // numbers of those around it, the bodies around it included
  bool repeats = false;                  // it runs more than once
  std::uint32_t site = 0, line = 0;      // of the call in the main program
};

// The loops around a statement of a program, and whether it may run again.
struct LoopsAround {
  std::vector<std::uint8_t> numbers;
  bool repeats = false;
};
LoopsAround loops_around(const ir::Program& text, const ir::Section& range, std::uint32_t statement);

// Numbers that the body's loops get where they stand, by statement.
using LoopNumbers = std::map<std::uint32_t, std::uint8_t>;

// What takes the place of a call.
struct TakenBody {
  CalledBody body;
  LoopNumbers numbers;
};

class CallConditions {
 public:
  // `main`: the program of `text` that a run begins with. All must outlive it.
  CallConditions(const ir::Program& text, const Callee& main, const Dialect& dialect, const ir::Control& control,
                 ProgramLibrary& library);

  // As a run looks for it: in the text of the caller, in the main program's, and in the library.
  [[nodiscard]] Callee find(const std::string& name, const ir::Program& from) const;
  // Why the call stays, for how it is made; empty: it need not.
  [[nodiscard]] std::string refusal(const Callee& caller, std::uint32_t call, const Callee& target,
                                    const Around& around) const;
  // … for what the program does.
  [[nodiscard]] std::expected<TakenBody, std::string> body_of(const Callee& target, const Around& around);

 private:
  void look_at(std::uint32_t statement);
  [[nodiscard]] std::string refusal_in_body(const Callee& target, std::uint32_t statement) const;
  [[nodiscard]] bool reads_own_place(const ir::Program& text, const ir::Statement& s) const;
  [[nodiscard]] bool rests_at_calls();
  [[nodiscard]] bool states_exact_stop_first() const;
  [[nodiscard]] bool keeps_exact_stop(const Callee& program, std::vector<Callee>& seen) const;
  [[nodiscard]] bool has_errors(const ir::Program& text) const;

  const ir::Program& text_;
  Callee main_;
  const Dialect& dialect_;
  const ir::Control& control_;
  ProgramLibrary& library_;
  std::string main_why_;         // of every call
  std::set<std::string> names_;  // that the main program defines
  std::optional<bool> rests_;    // rests_at_calls()
};

}  // namespace dripfeed::compile
