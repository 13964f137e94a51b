// Reading and validating any bytes as the dialect DRIPFEED_FUZZ_DIALECT, for every kind of control that it has.
#include "tests/fuzz/program_checks.h"

using namespace dripfeed;

namespace {

void read_as(const compile::Dialect& dialect, const text::Source& source, const ir::Control& control) {
  const ir::ReadResult read = dialect.read(source, control);
  fuzz::require_whole(read.program, source);
  fuzz::require_places(read.diagnostics, source);
  for (const ir::Delivery delivery : {ir::Delivery::memory, ir::Delivery::drip}) {
    fuzz::require_places(dialect.validate(read.program, control, delivery), source);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const compile::Dialect* dialect = compile::find_dialect(DRIPFEED_FUZZ_DIALECT);
  fuzz::require(dialect != nullptr, "the dialect is built in");
  const text::Source source("input", std::string(fuzz::text_of(data, size)));
  const ir::Control inferred = dialect->infer_control(source);
  fuzz::require(inferred.because_line <= source.line_count(), "the line that tells the control is there");
  read_as(*dialect, source, inferred);
  read_as(*dialect, source, dialect->control(ir::MachineKind::mill, ir::GSystem::a));
  read_as(*dialect, source, dialect->control(ir::MachineKind::lathe, ir::GSystem::b));
  return 0;
}
