// One text run whole and run while it is read, and how the two differ. The oracle of streaming is reading whole.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/stream.h"

namespace dripfeed::compile::test {

// Bytes in pieces of at most `piece`.
class Pieces final : public ProgramText {
 public:
  Pieces(std::string text, std::size_t piece) : text_(std::move(text)), piece_(piece) {}
  std::expected<std::size_t, std::string> read(std::span<char> into) override {
    const std::size_t count = std::min({into.size(), piece_, text_.size() - at_});
    std::copy_n(text_.data() + at_, count, into.data());
    at_ += count;
    return count;
  }
  std::expected<std::string, std::string> whole() override {
    was_whole = true;
    return text_;
  }
  bool was_whole = false;

 private:
  std::string text_;
  std::size_t piece_;
  std::size_t at_ = 0;
};

// Inputs that are named after the end of the program were never met: `read_whole` leaves them in.
inline std::string describe(const interpreter::RunResult& r, std::string_view trace, bool read_whole) {
  std::string out = fmt::format("{} blocks, {} motions, {}, last {}:{}\n", r.blocks, r.motions, name_of(r.ended),
                                r.last.line, r.last.ordinal);
  for (const interpreter::RunDiagnostic& d : r.diagnostics)
    out += fmt::format("{}:{} [{},{}) {}\n", d.program, d.line, d.diagnostic.span.begin, d.diagnostic.span.end,
                       text::message_of(d.diagnostic));
  for (const interpreter::NotInterpreted& n : r.not_interpreted)
    if (read_whole || n.first_line <= r.last.line)
      out += fmt::format("{} x{} at {} {}\n", n.name, n.count, n.first_line, n.effects_known);
  return out.append(trace);
}

// Nothing is read after the end of a stream, so what is named there only is not listed.
inline std::string describe_variables(const interpreter::RunResult& r) {
  std::string out;
  for (const interpreter::VariableValue& v : r.variables) out += fmt::format("{}={}\n", v.name, v.value.value_or(-0.5));
  return out;
}

inline interpreter::RunOptions options_with(interpreter::RunNames& names, std::uint64_t most_blocks) {
  interpreter::RunOptions options;
  options.want_variables = true;
  options.names = &names;
  options.limits.blocks = most_blocks;
  options.limits.loop_passes = most_blocks;
  return options;
}

struct Whole {
  std::string reported;
  std::string reported_as_read;  // as if nothing after the end had been read
  std::string variables;
  std::uint32_t faulty_line = 0;  // the first that the reader has an error for; it is then not run
};
inline Whole run_whole(const std::string& text, const Dialect& dialect, const ir::Control& control,
                       std::uint64_t most_blocks) {
  const text::Source source("t", text);
  const ir::ReadResult read = dialect.read(source, control);
  for (const text::Diagnostic& d : read.diagnostics)
    if (d.severity == text::Severity::error) return {"", "", "", source.position(d.span.begin).line};
  interpreter::RunNames names;
  interpreter::TraceWriter trace(control, names);
  const interpreter::RunResult result =
      execute(read.program, control, nullptr, trace, options_with(names, most_blocks));
  return {describe(result, trace.text(), true), describe(result, trace.text(), false), describe_variables(result), 0};
}

struct Streamed {
  std::string reported;
  bool was_whole = false;
  bool faulty = false;
  interpreter::RunResult result;
};
inline Streamed run_stream(const std::string& text, std::size_t piece, const Dialect& dialect,
                           const ir::Control& control, std::uint64_t most_blocks) {
  Pieces bytes(text, piece);
  interpreter::RunNames names;
  interpreter::TraceWriter trace(control, names);
  StreamRun run = execute_stream(bytes, "t", dialect, control, nullptr, trace, options_with(names, most_blocks));
  return {describe(run.result, trace.text(), true), bytes.was_whole, text::has_error(run.diagnostics),
          std::move(run.result)};
}

// "" when the stream gives what the whole text gives. A text that the reader has errors for is not run whole; then the
// stream must have met the errors, or ended before them.
inline std::string difference_of_stream(const std::string& text, std::size_t piece, const Dialect& dialect,
                                        const ir::Control& control, std::uint64_t most_blocks) {
  const Whole whole = run_whole(text, dialect, control, most_blocks);
  const Streamed streamed = run_stream(text, piece, dialect, control, most_blocks);
  if (whole.faulty_line != 0) {
    if (streamed.faulty) return "";
    const bool before =
        streamed.result.ended != interpreter::Ended::text_end && streamed.result.last.line < whole.faulty_line;
    return before ? "" : fmt::format("ran past the fault of line {}:\n{}", whole.faulty_line, streamed.reported);
  }
  const std::string& reported = streamed.was_whole ? whole.reported : whole.reported_as_read;
  if (streamed.reported != reported) return fmt::format("whole:\n{}stream:\n{}", reported, streamed.reported);
  const std::string variables = describe_variables(streamed.result);
  const std::string& expected = streamed.was_whole ? whole.variables : "";
  return variables == expected ? "" : fmt::format("variables of whole:\n{}of stream:\n{}", expected, variables);
}

}  // namespace dripfeed::compile::test
