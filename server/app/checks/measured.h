// Measuring what a program cuts and how long it takes, without keeping a verdict; and what a measuring machine found,
// compared with the same nominal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "checks/accuracy/cmm.h"
#include "checks/sweep/sweep.h"
#include "server/app/base/report.h"
#include "server/app/checks/checking.h"

namespace dripfeed::app {

struct Measured {
  CheckReport report;
  family::Geometry geometry;  // what it was compared with
  ir::MachineKind kind = ir::MachineKind::mill;
  bool x_is_diameter = false;
};
Measured measured_of(CheckReport report, const Examination& examination);

struct MeasureWishes {
  std::uint32_t baud = 0;  // another speed of the machine's line; 0: its own
  TimingWishes timing = {};
};
// What a request asks for.
struct MeasureOrder {
  CheckOrder of;
  MeasureWishes wishes;
};
// Errors: as open_case; refused: it has faults or does not run to its end.
Result<Measured> measure_case(CaseOrder of, const MeasureWishes& wishes, const Documents& documents,
                              const CheckBudget& budget, CalledBy& called);

// As SVG; nothing where the check did not run. Feed and buffer need the timing's curve (see TimingWishes).
enum class PictureKind : std::uint8_t { deviation, stock, feed, buffer };
std::optional<std::string> picture_of(const Measured& measured, PictureKind kind);
std::string picture_of(const sweep::Report& report);

// Why a check did not run, in sentences.
std::string why_not_measured(const Measured& measured);

// Points as CSV (see read_cmm) against the nominal. Errors: invalid: no table of points, or points without a nominal.
Result<accuracy::CmmReport> measure_points(std::string_view csv, bool best_fit, const Measured& measured);

// The parameter space of a family on a machine; `values` are not swept. Errors: invalid: values that do not bind.
struct SweepOrder {
  std::string family;
  Values values;
  std::string machine;
  compile::RenderMode mode = compile::RenderMode::automatic;
  store::Delivery delivery = store::Delivery::drip;
  sweep::Settings settings;
};
Result<sweep::Report> sweep_values(const SweepOrder& order, std::string_view family_text, std::string_view profile_text,
                                   const Documents& documents);

}  // namespace dripfeed::app
