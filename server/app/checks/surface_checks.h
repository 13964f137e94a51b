// The checks that need stock, nominal and tools: gouge and accuracy, of turning or of milling. Made from what is known;
// what is missing for one is reported.
#pragma once

#include <memory>
#include <vector>

#include "checks/gouge/milling.h"
#include "checks/verdict.h"
#include "server/app/base/report.h"
#include "server/app/checks/examine.h"

namespace dripfeed::app {

// of_each_block: accuracy alone, and the report has the deviation of each block.
enum class SurfaceScope : std::uint8_t { all, accuracy_alone, of_each_block };

// The machine's tools, completed and overruled by what the family states of their shapes.
std::vector<checks::Tool> tools_of(const Examination& e);

// How gouges are looked for. Precondition: e.geometry is known.
gouge::Settings turning_gouge(const Examination& e);
gouge::MillingSettings milling_gouge(const Examination& e);

class SurfaceChecks {
 public:
  // `skipped` gets why a check is not made. `e` is read here only, but for its control, which must outlive this.
  SurfaceChecks(const Examination& e, SurfaceScope scope, checks::NotCheckedList& skipped);
  ~SurfaceChecks();
  SurfaceChecks(const SurfaceChecks&) = delete;
  SurfaceChecks& operator=(const SurfaceChecks&) = delete;

  [[nodiscard]] std::vector<ir::MotionSink*> sinks() const;
  // After the last motion; once.
  void finish(checks::CheckReport& report, Pictures& pictures);

 private:
  struct Made;
  std::unique_ptr<Made> made_;
};

}  // namespace dripfeed::app
