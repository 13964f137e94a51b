// The text of each program that was run, by the name that the run has for it (RunResult::programs).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "dialects/compile/dialect/library.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

class RunTexts {
 public:
  RunTexts(const ir::Program& main, const ProgramLibrary& library);

  // nullptr: the main program's.
  [[nodiscard]] std::shared_ptr<const text::Source> find(const std::string& name) const;
  // A fault of the run, with the text that its place is in.
  [[nodiscard]] text::Diagnostic placed(const interpreter::RunDiagnostic& fault,
                                        const interpreter::RunResult& run) const;
  // Puts a fault at a line of a program, by its number in the run.
  void place(text::Diagnostic& fault, const interpreter::RunResult& run, std::uint32_t program,
             std::uint32_t line) const;

 private:
  void add(const ir::Program& program, const std::shared_ptr<const text::Source>& source);

  text::Source main_;
  std::map<std::string, std::shared_ptr<const text::Source>> texts_;
};

}  // namespace dripfeed::compile
