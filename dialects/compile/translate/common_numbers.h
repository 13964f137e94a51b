// Where programs call each other, each has its names in local variables, which every call gets again; there are 33 of
// them. What does not fit there goes to common variables that nothing which may run at the same time has: neither a
// program that calls it, over however many others, nor one that it calls.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "dialects/compile/dialect/library.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

class CommonNumbers {
 public:
  // `text`: one program or several. What the library finds is taken to be translated by itself, one text a program.
  CommonNumbers(const ir::Program& text, const ir::Control& from, const ir::Control& to, ProgramLibrary* library);

  // The target with the numbers that the program may have as its own, as further local ranges. Nothing where that
  // cannot be known: a program that it calls is not found, it may call itself, or it may be called from outside.
  std::optional<ir::Control> control_for(const std::string& program);
  // What it became: the common numbers that it got are no longer free for those that run with it.
  void took(const std::string& program, const ir::Program& raised);

 private:
  struct Facts {
    std::set<std::string> calls;
    std::set<std::uint32_t> numbers;  // of the other control's bank, which mean the same in all programs
    bool calls_unknown = false;       // a name that is computed
    bool is_main = false;             // nothing in it goes back to a caller
    bool in_text = false;
  };
  void note(const std::string& name, const ir::Program& program, std::uint32_t first, std::uint32_t last);
  const Facts* facts_of(const std::string& name);
  std::optional<std::set<std::string>> reached_from(const std::string& name);
  void took_array(std::set<std::uint32_t>& given, const ir::Program& raised, ir::ExpressionId index);

  const ir::Control& to_;
  ProgramLibrary* library_;
  std::map<std::string, Facts> facts_;
  std::map<std::string, std::set<std::uint32_t>> given_;
  std::set<std::uint32_t> reserved_;
};

}  // namespace dripfeed::compile
