// Measuring what a family's program or a program's file cuts against a nominal, for the commands accuracy and gouge.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "server/app/checks/measured.h"
#include "server/app/checks/surface_checks.h"
#include "server/cli/family_options.h"

namespace CLI {
class App;  // included only where options are added: it takes seconds to compile
}

namespace dripfeed::cli {

// Of a program that was not rendered: the family that has its stock and nominal, and its lines that make the profile.
struct NominalOptions {
  std::string family;
  std::string profile;  // "12-60,70-71"
};
void add_nominal_options(CLI::App& command, NominalOptions& options, const std::string& help);

struct Nominal {
  family::Geometry geometry;
  std::vector<family::LineRange> profile_lines;
};
// With values as --set gives them. Errors: what cannot be read or bound; faults of the family are printed.
app::Result<Nominal> read_nominal(const NominalOptions& options, const std::vector<std::string>& values);

struct MeasureOptions {
  FamilyOptions family;
  NominalOptions nominal;  // then FAMILY is a program
  std::string plot;        // path of an SVG
};
void add_measure_options(CLI::App& command, MeasureOptions& options);

struct Measured : app::Measured {
  std::optional<RenderedFamily> family;  // with its lines; none: a program was measured
};
// A family is rendered and examined; a large program's file is run while it is read, and `scope` says for which checks.
// Errors: what cannot be read, rendered or run.
app::Result<Measured> measure(const MeasureOptions& options, app::SurfaceScope scope);

// " (roll.family:31)" of a line of the program, "" where it comes from no family.
std::string in_family(const Measured& measured, std::uint32_t line);
// Figures as JSON, with the lines of the family where it is one.
std::string figures_with_lines(const Measured& measured, const std::string& figures);

// Reports what kept a check from giving figures, with --json as a document, too; returns the exit code.
int not_measured(const MeasureOptions& options, const app::CheckReport& report);

}  // namespace dripfeed::cli
