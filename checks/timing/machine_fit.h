// Which factors on a machine's accelerations and on what computing costs it explain measured cycle times.
#pragma once

#include <expected>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace dripfeed::timing {

struct MachineFactors {
  double acceleration = 1.0;
  double compute = 1.0;
};

struct MeasuredRun {
  double measured_s = 0.0;
  // The predicted cycle time with these factors, s.
  std::function<double(const MachineFactors&)> predict;
};

struct MachineFit {
  MachineFactors factors;
  std::vector<double> before_share;  // (predicted - measured) / measured with factors of one, by run
  std::vector<double> after_share;
};

// Least squares of the relative errors over the logarithms of both factors, each within 0.2 to 5. Errors: no run, a
// time that is not above zero, runs that do not depend on a factor.
std::expected<MachineFit, std::string> fit_machine(std::span<const MeasuredRun> runs);

}  // namespace dripfeed::timing
