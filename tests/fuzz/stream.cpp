// Any text run while it is read gives what it gives when it is read whole.
#include "tests/fuzz/target.h"
#include "tests/support/stream_runs.h"

using namespace dripfeed;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint64_t kMostBlocks = 500;
  const std::string text(fuzz::text_of(data, size));
  const text::Source source("input", text);
  const compile::Dialect& dialect = compile::infer_dialect(source);
  const ir::Control control = dialect.infer_control(source);
  const std::size_t piece = size % 97 + 1;
  fuzz::require(compile::test::difference_of_stream(text, piece, dialect, control, kMostBlocks).empty(),
                "a stream gives what the whole text gives");
  return 0;
}
