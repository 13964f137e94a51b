// What stands before the approach: modes, a tool axis that is clear, work offset, tool, spindle, coolant, variables and
// feed, in this order.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dialects/compile/dialect/library.h"
#include "dialects/compile/restart/restart_place.h"
#include "dialects/compile/restart/restart_record.h"
#include "dialects/compile/restart/restart_words.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic_id.h"

namespace dripfeed::compile {

struct RestartRefusal {
  text::DiagnosticId id;
  std::string argument;
};

// What the parts of a restart are made from, and the text that they make.
struct RestartDraft {
  const ir::Program& program;
  const ir::Control& control;
  const ProgramLibrary* library;  // after the run: what it has called is loaded
  const RestartPlaces& places;
  const RestartRun& run;
  const RestartPoint& point;
  const RestartWords& words;
  std::uint32_t line;
  double clearance_mm;
  std::vector<std::string> lines = {};
  std::vector<std::string> assumptions = {};

  void add(const std::vector<std::string>& block) {
    if (std::string text = block_of(block); !text.empty()) lines.push_back(std::move(text));
  }
  [[nodiscard]] bool turns() const { return control.kind != ir::MachineKind::mill; }
};

// Whether the rest changes the tool before it moves an axis; the tool that was in the spindle is not needed then.
bool begins_with_tool_change(const RestartDraft& draft);

std::optional<RestartRefusal> write_preamble(RestartDraft& draft);

}  // namespace dripfeed::compile
