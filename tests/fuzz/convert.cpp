// Converting any bytes from the dialect that they look like to every dialect, in both modes.
#include "dialects/compile/translate/convert.h"

#include "tests/fuzz/program_checks.h"

using namespace dripfeed;

namespace {

void convert(const text::Source& source, const ir::Control& from, const compile::Dialect& to,
             compile::ConvertMode mode) {
  const ir::Control target = to.control(from.kind, from.g_system);
  compile::ConvertRequest request{.source = source, .from = from, .to = target, .mode = mode};
  request.limits.blocks = 1000;
  request.limits.motions = 100'000;
  request.limits.loop_passes = 300;
  request.limits.call_depth = 8;
  request.limits.variables = 4096;
  request.limits.strings = 256;
  const compile::ConvertResult result = compile::convert(request);
  fuzz::require_places(result.diagnostics, source);
  const bool same = from.dialect == target.dialect && mode == compile::ConvertMode::macro;
  if (same) return fuzz::require(result.text == source.text(), "the same dialect gives the same bytes");
  if (text::has_error(result.diagnostics)) return fuzz::require(result.text.empty(), "an error gives no text");

  const text::Source printed("printed", result.text);
  fuzz::require(result.origin_lines.size() <= printed.line_count(), "origins are of printed lines");
  for (const std::uint32_t line : result.origin_lines) {
    fuzz::require(line <= source.line_count(), "a printed line's origin is there");
  }
  const ir::ReadResult read = to.read(printed, target);
  fuzz::require_whole(read.program, printed);
  fuzz::require(!text::has_error(read.diagnostics), "a converted text has no fault of syntax");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const text::Source source("input", std::string(fuzz::text_of(data, size)));
  const ir::Control from = compile::infer_dialect(source).infer_control(source);
  for (const compile::Dialect& to : compile::dialects()) {
    convert(source, from, to, compile::ConvertMode::macro);
    convert(source, from, to, compile::ConvertMode::explicit_blocks);
  }
  return 0;
}
