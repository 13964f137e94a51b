// What the language server takes from outside: the control that a text is for, the programs that it calls, what is a
// family. The command gives them, so that they are the same as those of `dripfeed check`.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/library.h"
#include "server/app/base/error.h"
#include "server/machine/profile.h"

namespace dripfeed::lsp {

// As the client's initializationOptions or its settings give them; else as the command's options did.
struct Settings {
  std::string machine;             // a profile's file or a preset; "": the dialect decides
  std::string dialect;             // "": the text decides, as for `dripfeed check`
  std::string control;             // kind=lathe,g_system=A
  std::string modes;               // of a subprogram alone: the codes that its caller has in effect
  std::vector<std::string> paths;  // folders with called programs
  std::string docs;                // address of the page of diagnostics; "": messages have no link
  std::string numbering = "numbered";
  std::uint32_t first_number = 10;
  std::uint32_t number_step = 10;
  std::uint32_t seconds = 10;  // that a run of a saved program may take; 0: programs are read, never run
};

struct Language {
  const compile::Dialect* dialect = nullptr;
  ir::Control control;
  std::shared_ptr<const machine::Profile> profile;  // nullptr: no machine was named
  bool inferred = false;
};

struct Surroundings {
  // Errors: a machine, dialect or control that is not known.
  std::function<app::Result<Language>(const Settings&, const text::Source&)> choose_language;
  // For a program in that file; "" for a text without one.
  std::function<compile::FindText(const Settings&, const std::string& file)> find_called;
  std::function<bool(const text::Source&)> is_family;
  std::string version;
};

}  // namespace dripfeed::lsp
