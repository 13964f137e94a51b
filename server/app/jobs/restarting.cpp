// The check of the approach sees what the machine has done: the moves of the whole program before the line, then all of
// the restart.
#include "server/app/jobs/restarting.h"

#include <algorithm>
#include <utility>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/shared_definitions.h"
#include "server/app/checks/examine.h"
#include "server/app/checks/surface_checks.h"
#include "store/hash/sha256.h"

namespace dripfeed::app {

namespace {

// Hands on the moves before the restart's line, without their lines: what is found in them is not the restart's.
class MovesBefore final : public ir::MotionSink {
 public:
  MovesBefore(ir::MotionSink& to, std::size_t moves) : to_(to), left_(moves) {}
  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      if (left_ == 0) return;
      if (ir::is_move(motion.kind)) --left_;
      ir::Motion one = motion;
      one.place.line = 0;
      to_.consume(std::span(&one, 1));
    }
  }

 private:
  ir::MotionSink& to_;
  std::size_t left_;
};

void run_into(const Examination& e, const text::Source& source, ir::MotionSink& sink) {
  const ir::Control control = for_check(e.control);
  const ir::ReadResult read = e.dialect->read(source, control);
  compile::ProgramLibrary library(control, e.find_called);
  interpreter::RunOptions options;
  options.used_up = e.used_up;
  static_cast<void>(compile::execute(read.program, control, &library, sink, options));
}

void hold_against_part(const Examination& e, RestartMade& made) {
  if (!e.geometry) {
    made.not_held = "the part is not known";
    return;
  }
  checks::CheckReport report;
  SurfaceChecks surfaces(e, SurfaceScope::all, report.not_checked);
  compile::FanOut sinks(surfaces.sinks());
  MovesBefore before(sinks, made.restart.moves_before);
  run_into(e, e.source, before);
  run_into(e, text::Source(e.source.name(), made.restart.text), sinks);
  Pictures unused;
  surfaces.finish(report, unused);
  if (!report.gouge) {
    made.not_held =
        report.not_checked.empty() ? "it is not known enough of the part" : report.not_checked.list().front().text;
    return;
  }
  if (report.gouge->has_unjudged_cuts) made.not_held = "it has cuts that are not judged";
  for (const checks::Finding& one : report.gouge->findings.kept())
    if (one.place.line != 0) made.findings.push_back({one.severity, one.place.line, one.text});
}

}  // namespace

bool RestartMade::is_possible() const {
  return !restart.text.empty() && std::ranges::none_of(findings, [](const ApproachFinding& one) {
    return one.severity == text::Severity::error;
  });
}

Result<RestartMade> restart_case(RestartOrder order, const Documents& documents, const CheckBudget& budget,
                                 CalledBy& called) {
  const auto one = open_case(std::move(order.of), documents, called);
  if (!one) return std::unexpected(one.error());
  Examination& e = (*one)->examination;
  e.control = compile::with_definitions(std::move(e.control), e.find_called);
  e.used_up = time_budget(budget.seconds);
  compile::ProgramLibrary library(e.control, e.find_called);
  RestartMade made{.restart = compile::restart_at({.source = e.source,
                                                   .control = e.control,
                                                   .line = order.line,
                                                   .library = &library,
                                                   .clearance_mm = order.clearance_mm,
                                                   .used_up = e.used_up}),
                   .source = e.source,
                   .sha256 = {},
                   .findings = {},
                   .not_held = {}};
  if (made.restart.text.empty()) return made;
  made.restart.assumptions.insert(made.restart.assumptions.end(), e.assumed.begin(), e.assumed.end());
  made.sha256 = hash::sha256_hex(made.restart.text);
  hold_against_part(e, made);
  return made;
}

}  // namespace dripfeed::app
