// Measuring what a family's program or a program's file cuts against a nominal, for the commands accuracy and gouge.
#pragma once

#include <string>

#include "server/app/surface_checks.h"
#include "server/cli/family_options.h"

namespace dripfeed::cli {

struct MeasureOptions {
  FamilyOptions family;
  std::string nominal;  // then FAMILY is a program, and this family has stock and nominal
  std::string plot;     // path of an SVG
};
void add_measure_options(CLI::App& command, MeasureOptions& options);

struct Measured {
  app::CheckReport report;
  family::Geometry geometry;
  ir::MachineKind kind = ir::MachineKind::mill;
  bool x_is_diameter = false;
};
// A family is rendered and examined; a large program's file is run while it is read, and `scope` says for which checks.
// Errors: what cannot be read, rendered or run.
app::Result<Measured> measure(const MeasureOptions& options, app::SurfaceScope scope);

// What kept a check from giving figures.
void print_not_measured(const app::CheckReport& report);

}  // namespace dripfeed::cli
