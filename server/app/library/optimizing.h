// A text made faster for its control, with the same moves. It is not stored: who wants to keep it adds it as a program.
// The words in which rules and variables are named are read here, for the command and for REST.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dialects/compile/render/optimized.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/checks/workers.h"
#include "server/app/shop/called_programs.h"

namespace dripfeed::app {

// As they are written: rules by name, variables as "R100-R199", "#150-#160" or "R5".
struct OptimizeWords {
  std::vector<std::string> with;     // rules that are off
  std::vector<std::string> without;  // rules that are on
  std::vector<std::string> own;      // variables that no other program reads
  std::vector<std::string> free;     // variables that the program may begin to use
  double tolerance_mm = 0.0;         // how far the path may be changed; 0: not at all
};
// Errors: invalid: a rule that is not known, no range of variables, a rule that changes the path without a tolerance,
// or a tolerance without such a rule.
Result<optimize::Settings> settings_of(const OptimizeWords& words);

struct OptimizeOrder {
  std::string name;  // of the program, for what is found in it
  std::string text;
  std::string dialect;  // empty: the machine's, or the one that the text looks like
  std::string profile;  // the machine's document; empty: the control that the text looks like
  Caller caller;        // whose programs are called
  OptimizeWords words;
};

struct Optimized {
  std::unique_ptr<OpenCase> opened;  // what `cost` refers to
  text::Source source;
  ir::CostModel cost;
  compile::OptimizeResult result;
};

// Errors: as settings_of; invalid: a dialect that is not known, or another one than the machine's.
Result<Optimized> optimize_case(const OptimizeOrder& order, const Documents& documents, CalledBy& called);

}  // namespace dripfeed::app
