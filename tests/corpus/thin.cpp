// Stretches of four lines are enough here, so that most programs have some.
#include "tests/corpus/thin.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/translate/convert_thin.h"
#include "dialects/compile/translate/thin_program.h"

namespace dripfeed::corpus {

namespace {

constexpr compile::ThinOptions kShort = {.least_bytes = 0, .least_lines = 4};

class Motions final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override { all.insert(all.end(), motions.begin(), motions.end()); }
  std::vector<ir::Motion> all;
};

struct Seen {
  std::vector<std::string> diagnostics;
  std::vector<ir::Motion> motions;
  interpreter::RunResult result;
};

void note(const std::vector<text::Diagnostic>& all, const text::Source& source, std::vector<std::string>& out) {
  for (const text::Diagnostic& one : all) out.push_back(text::format_diagnostic(one, source, ""));
}

Seen see(const text::Source& source, const ir::ReadResult& read, const compile::ThinProgram* thin,
         const compile::Dialect& dialect, const ir::Control& control) {
  Seen seen;
  std::vector<text::Diagnostic> found = read.diagnostics;
  std::ranges::move(dialect.validate(read.program, control, ir::Delivery::memory), std::back_inserter(found));
  if (thin != nullptr) thin->place(found);
  note(found, source, seen.diagnostics);
  Motions motions;
  interpreter::RunOptions options;
  options.limits.blocks = 200'000;
  if (thin != nullptr) options.stretches = &thin->stretches;
  ir::Control unset = control;
  unset.semantics.unset_is_unknown = true;
  seen.result = compile::execute(read.program, unset, nullptr, motions, options);
  if (thin != nullptr) thin->place(seen.result);
  std::vector<text::Diagnostic> run;
  for (const interpreter::RunDiagnostic& one : seen.result.diagnostics) run.push_back(one.diagnostic);
  note(run, source, seen.diagnostics);
  seen.motions = std::move(motions.all);
  return seen;
}

bool same(const ir::Motion& a, const ir::Motion& b) {
  return a.kind == b.kind && a.place.line == b.place.line && a.place.ordinal == b.place.ordinal && a.start == b.start &&
         a.end == b.end && a.feed == b.feed && a.feed_mode == b.feed_mode && a.comp == b.comp &&
         a.spindle_rpm == b.spindle_rpm && a.axes_commanded == b.axes_commanded && a.axes_unknown == b.axes_unknown;
}

std::optional<std::string> translated_otherwise(const text::Source& source, const ir::Control& control) {
  for (const compile::Dialect& to : compile::dialects()) {
    const compile::ConvertRequest request{
        .source = source, .from = control, .to = to.control(control.kind, control.g_system)};
    const auto made = compile::convert_thin(request, kShort);
    if (made && made->text != compile::convert_whole(request).text)
      return fmt::format("thin: translated otherwise to {}", to.name);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> thin_fault(const text::Source& source, const compile::Dialect& dialect,
                                      const ir::Control& control, std::size_t& cut_lines) {
  const auto thin = compile::ThinProgram::read(source, dialect, control, kShort);
  if (thin == nullptr) return std::nullopt;
  for (const ir::PlainStretch& one : thin->stretches.all) cut_lines += one.line_count;
  const Seen whole = see(source, dialect.read(source, control), nullptr, dialect, control);
  const Seen part = see(source, thin->read_result, thin.get(), dialect, control);
  if (whole.diagnostics != part.diagnostics) {
    const auto [a, b] = std::ranges::mismatch(whole.diagnostics, part.diagnostics);
    return fmt::format("thin: another diagnostic: {}, not {}", b == part.diagnostics.end() ? "none" : *b,
                       a == whole.diagnostics.end() ? "none" : *a);
  }
  if (whole.result.ended != part.result.ended || whole.result.blocks != part.result.blocks)
    return fmt::format("thin: {} after {} blocks, not {} after {}", name_of(part.result.ended), part.result.blocks,
                       name_of(whole.result.ended), whole.result.blocks);
  const auto [a, b] = std::ranges::mismatch(whole.motions, part.motions, same);
  if (a == whole.motions.end() && b == part.motions.end()) return translated_otherwise(source, control);
  return fmt::format("thin: another motion in line {}", a == whole.motions.end() ? b->place.line : a->place.line);
}

}  // namespace dripfeed::corpus
