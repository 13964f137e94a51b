// A program of a text made faster for its control, and proved by running: the text before and after makes the same
// moves, to the last bit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/compile/dialect/library.h"
#include "dialects/compile/translate/changed_text.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/cost_model.h"
#include "dialects/optimize/optimize.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

struct OptimizeRequest {
  text::Source source;
  ir::Control control;
  ir::CostModel cost;
  optimize::Settings settings = {};
  ProgramLibrary* library = nullptr;  // of called programs; nullptr: none are found
};

// What computing cost a run, by the model: in all, and for the move before which most was computed.
struct ComputeCost {
  double total_ms = 0.0;
  double longest_ms = 0.0;
  std::uint32_t longest_line = 0;
  std::uint64_t moves = 0;
  std::uint64_t blocks = 0;
};

struct OptimizeResult {
  std::string text;                         // the source's own bytes where nothing was changed
  std::vector<std::uint32_t> origin_lines;  // per line of a text that was changed: the source's line; 0: a new one
  std::vector<optimize::Change> changes;    // none with an obstacle
  std::string obstacle;                     // why the program was left as it is; empty where it was not
  std::string not_verified;                 // why running does not show that both are the same; empty where it does
  std::optional<ComputeCost> before;        // of the runs that were compared
  std::optional<ComputeCost> after;
  std::optional<double> off_mm;               // where blocks were merged: how far the paths lie apart at most, proved
  std::string not_merged;                     // why no blocks were; empty where they were, or need not be
  std::vector<text::Diagnostic> diagnostics;  // of reading the source; with an error nothing is done
};

OptimizeResult optimize_text(const OptimizeRequest& request);

}  // namespace dripfeed::compile
