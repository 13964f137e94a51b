// Timing a program's file: small ones are read whole and validated as check does, large ones are run while they are
// read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checks/timing/machine_fit.h"
#include "checks/timing/timing.h"
#include "dialects/text/source.h"
#include "server/cli/family_options.h"

namespace dripfeed::cli {

struct TimeOptions {
  TextOptions text;
  std::string file;
  bool drip = false;
  int baud = 0;  // 0: the machine's
  unsigned threads = 1;
  std::uint32_t seconds = kCheckSeconds;
  std::vector<std::string> values;  // --set, of a family
  std::string mode = "auto";
  std::string plot_feed;
  std::string plot_buffer;
};

struct TimedProgram {
  std::optional<timing::Report> report;  // nothing: it did not run to its end, and the diagnostics say why
  std::vector<text::Diagnostic> diagnostics;
  text::Source source;
  std::string control_title;
  bool validated = true;  // before it ran; a large program is run while it is read
  std::vector<checks::NotChecked> not_checked = {};
  std::optional<RenderedFamily> family = {};  // that `source` was rendered from
};
// With the machine's accelerations and computing times by those factors, and another cost model than its own. Errors:
// what cannot be read, no machine named.
app::Result<TimedProgram> run_timing(const TimeOptions& options, const timing::MachineFactors& factors = {},
                                     const std::optional<ir::CostModel>& cost = {});

}  // namespace dripfeed::cli
