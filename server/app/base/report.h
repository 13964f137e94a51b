// What there is to report of one text for one control: by reading, validating and running it, and by the checks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "checks/plot/plot.h"
#include "checks/verdict.h"
#include "dialects/ir/control.h"
#include "dialects/text/source.h"

namespace dripfeed::app {

// Figures of what was checked; nothing where the check did not run.
struct Pictures {
  std::optional<plot::Plot> gouge;
  std::optional<plot::Plot> accuracy;
};

struct CheckReport {
  text::Source source;  // the diagnostics' spans are in it
  std::string dialect;
  std::string control_title;
  ir::MachineKind kind = ir::MachineKind::mill;
  ir::GSystem g_system = ir::GSystem::a;
  ir::FeedMode feed_mode = ir::FeedMode::per_min;  // at power-on
  std::uint32_t because_line = 0;  // the line by which the control was inferred; 0: named, or the default
  bool inferred = false;
  checks::CheckReport checks;
  std::vector<std::string> programs;  // by ir::Place::program: what a finding's line is of; the main one first
  Pictures pictures;
  checks::Verdict verdict = checks::Verdict::unknown;
  std::uint64_t blocks = 0;  // executed
  bool ran = false;          // to its end
  bool validated = true;     // before it ran; a large program is run while it is read
};

}  // namespace dripfeed::app
