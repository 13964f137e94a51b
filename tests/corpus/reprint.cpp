// Both runs are cut at the same number of blocks: what does not end by itself is compared as far as that.
#include "tests/corpus/reprint.h"

#include <fmt/format.h>

#include "dialects/compile/dialect/execute.h"

namespace dripfeed::corpus {

namespace {

constexpr std::uint64_t kMostBlocks = 20'000;

struct Ran {
  std::string trace;
  std::string ended;
};

std::string end_of(const interpreter::RunResult& result) {
  std::string end = fmt::format("ended as {}", static_cast<int>(result.ended));
  if (result.ended == interpreter::Ended::alarm && !result.diagnostics.empty())
    end += fmt::format(" by {}", text::message_of(result.diagnostics.back().diagnostic));
  return end;
}

Ran run(const ir::Program& program, const ir::Control& control) {
  interpreter::RunNames names;
  interpreter::RunOptions options;
  options.names = &names;
  options.limits.blocks = kMostBlocks;
  interpreter::TraceWriter trace(control, names);
  const interpreter::RunResult result = compile::execute(program, control, nullptr, trace, options);
  return {trace.text(), end_of(result)};
}

// The next line of a trace without its number.
std::string_view next_line(std::string_view& trace) {
  const std::size_t end = std::min(trace.find('\n'), trace.size());
  std::string_view line = trace.substr(0, end);
  trace.remove_prefix(std::min(end + 1, trace.size()));
  return line.substr(std::min(line.find(' '), line.size()));
}

}  // namespace

std::optional<std::string> reprint_fault(const text::Source& source, const ir::Program& program,
                                         const compile::Dialect& dialect, const ir::Control& control) {
  const ir::PrintResult printed = dialect.print(program, control);
  const text::Source again(source.name(), printed.text);
  const ir::ReadResult read = dialect.read(again, control);
  for (const text::Diagnostic& one : read.diagnostics) {
    if (one.severity != text::Severity::error) continue;
    return fmt::format("printed anew it cannot be read: {} in \"{}\"", text::message_of(one),
                       again.line(again.position(one.span.begin).line));
  }
  const Ran first = run(program, control);
  const Ran second = run(read.program, control);
  std::string_view left = first.trace;
  std::string_view right = second.trace;
  while (!left.empty() || !right.empty()) {
    const std::string_view before = left;
    const std::string_view was = next_line(left);
    const std::string_view is = next_line(right);
    if (was != is)
      return fmt::format("printed anew it does other things: \"{}\" became \"{}\"", before.substr(0, before.find('\n')),
                         is);
  }
  if (first.ended != second.ended) return fmt::format("printed anew it {} and not {}", second.ended, first.ended);
  return std::nullopt;
}

}  // namespace dripfeed::corpus
