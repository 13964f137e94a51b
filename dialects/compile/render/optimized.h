// A program of a text made faster for its control, and proved by running: the text before and after makes the same
// moves, to the last bit, or within the tolerance where a rule that changes the path is asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/compile/dialect/library.h"
#include "dialects/compile/render/compute_cost.h"
#include "dialects/compile/translate/changed_text.h"
#include "dialects/compile/translate/inlined_calls.h"
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

// What a rule saves: the run with it and with the rules before it in the table, next to the run with those alone. So
// the savings of all rules add up to the whole difference.
struct RuleSaving {
  optimize::Rule rule = optimize::Rule::values;
  std::size_t edits = 0;  // changes that are listed
  Saving saved;
};

struct OptimizeResult {
  std::string text;                         // the source's own bytes where nothing was changed
  std::vector<std::uint32_t> origin_lines;  // per line of a text that was changed: the source's line; 0: a new one
  std::vector<optimize::Change> changes;    // none with an obstacle
  std::string obstacle;                     // why the program was left as it is; empty where it was not
  std::string not_verified;                 // why running does not show that both are the same; empty where it does
  std::optional<ComputeCost> before;        // of the runs that were compared
  std::optional<ComputeCost> after;
  std::optional<Saving> saved;        // from `before` to `after`
  std::vector<RuleSaving> savings;    // of rules that changed the text, in their order; none where it is not run
  std::optional<double> off_mm;       // with rules that change the path: how far both lie apart at most, proved
  std::string not_merged;             // why no blocks were; empty where they were, or need not be
  std::string not_tabulated;          // why no formula is a table; empty where one is, or need not be
  std::vector<KeptCall> not_inlined;  // calls that stay, in the order of the text
  std::vector<text::Diagnostic> diagnostics;  // of reading the source; with an error nothing is done
};

OptimizeResult optimize_text(const OptimizeRequest& request);

}  // namespace dripfeed::compile
