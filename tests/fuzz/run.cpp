// Reading any bytes as the dialect that they look like, and running what was read, faults or not, with small limits.
#include <algorithm>
#include <cmath>

#include "dialects/compile/dialect/execute.h"
#include "tests/fuzz/program_checks.h"

using namespace dripfeed;

namespace {

constexpr interpreter::Limits kLimits{
    .blocks = 2000, .loop_passes = 500, .call_depth = 8, .variables = 4096, .strings = 256};

// Counts motions and looks at each.
class Watch final : public ir::MotionSink {
 public:
  explicit Watch(std::uint32_t lines) : lines_(lines) {}

  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      ++count;
      fuzz::require(motion.place.ordinal >= ordinal_, "motions come in the order of execution");
      fuzz::require(motion.place.program != 0 || motion.place.line <= lines_, "a motion's line is there");
      fuzz::require(std::ranges::all_of(motion.end, [](double value) { return std::isfinite(value); }),
                    "a motion ends at a finite place");
      fuzz::require(std::isfinite(motion.feed) && std::isfinite(motion.spindle_rpm), "feed and speed are finite");
      ordinal_ = motion.place.ordinal;
    }
  }
  std::uint64_t count = 0;

 private:
  std::uint32_t lines_;
  std::uint64_t ordinal_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const text::Source source("input", std::string(fuzz::text_of(data, size)));
  const compile::Dialect& dialect = compile::infer_dialect(source);
  const ir::Control control = dialect.infer_control(source);
  const ir::ReadResult read = dialect.read(source, control);

  Watch watch(source.line_count());
  interpreter::RunOptions options;
  options.limits = kLimits;
  options.want_variables = true;
  compile::ProgramLibrary library(control, {});  // of the control's own cycles and second language
  const interpreter::RunResult run = compile::execute(read.program, control, &library, watch, options);
  fuzz::require(run.motions == watch.count, "every motion is counted");
  fuzz::require(run.blocks <= kLimits.blocks + 1, "the limit of blocks holds");
  const bool alarmed = run.ended == interpreter::Ended::alarm || run.ended == interpreter::Ended::limit;
  fuzz::require(!alarmed || !run.diagnostics.empty(), "a run that broke off says why");
  for (const interpreter::RunDiagnostic& at : run.diagnostics) {
    fuzz::require(at.program < run.programs.size(), "a diagnostic's program has a name");
    fuzz::require(at.program != 0 || at.line <= source.line_count(), "a diagnostic's line is there");
    if (at.program == 0) fuzz::require_places({at.diagnostic}, source);
  }
  return 0;
}
