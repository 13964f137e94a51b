// What a machine makes of a path, point by point: when it is there, how fast, what its buffer holds then, and how far
// from the nominal it cuts.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "checks/timing/timing.h"
#include "server/app/checks/surface_checks.h"
#include "server/app/checks/tool_path.h"

namespace dripfeed::app {

// Takes the same motions as a PathRecorder. `e` must outlive it.
class PathTimer {
 public:
  explicit PathTimer(const Examination& e);
  [[nodiscard]] std::vector<ir::MotionSink*> sinks() const;
  // After the recorder has finished; once. Takes path.origins.
  void finish(const Examination& e, ToolPath& path);

 private:
  checks::NotCheckedList skipped_;
  std::unique_ptr<timing::Timing> timing_;
  std::string why_no_times_;
  SurfaceChecks surfaces_;
};

}  // namespace dripfeed::app
