// One run of the whole program, one of what came out, and the same for the lines around where the one that was asked
// for is refused.
#include "dialects/compile/restart/restart.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/source_lines.h"
#include "dialects/compile/restart/restart_approach.h"
#include "dialects/compile/restart/restart_place.h"
#include "dialects/compile/restart/restart_preamble.h"
#include "dialects/compile/restart/restart_proof.h"
#include "dialects/compile/restart/restart_record.h"
#include "dialects/compile/restart/restart_variables.h"
#include "dialects/compile/restart/restart_words.h"

namespace dripfeed::compile {

namespace {

using text::DiagnosticId;

// Lines on either side that are tried at most: each is a run of the program.
constexpr int kTriedAround = 4;

std::string_view end_of_line(const text::Source& source) {
  const std::string_view text = source.text();
  const std::size_t at = text.find_first_of("\r\n");
  return at == std::string_view::npos ? "\n" : text.substr(at, text::eob_length(text, at));
}

class Restarter {
 public:
  explicit Restarter(const RestartRequest& request)
      : request_(request),
        dialect_(*find_dialect(request.control.dialect)),
        own_library_(request.control, [](std::string_view) { return std::nullopt; }),
        library_(request.library != nullptr ? *request.library : own_library_),
        read_(dialect_.read(request.source, request.control)),
        places_(read_.program) {
    options_.limits = request.limits;
    options_.skip_switches = request.skip_switches;
    options_.used_up = request.used_up;
  }

  Restart make() {
    Restart out;
    for (const text::Diagnostic& one : read_.diagnostics)
      if (one.severity == text::Severity::error) out.diagnostics.push_back(one);
    if (!out.diagnostics.empty()) return out;
    const std::uint32_t line = request_.line;
    if (auto refused = attempt(line, out)) {
      out = {};
      out.diagnostics.push_back(
          text::make_diagnostic(refused->id, span_of_line(request_.source, line), {refused->argument}));
      out.safe_before = nearest(line, -1);
      out.safe_after = nearest(line, 1);
    }
    return out;
  }

 private:
  // What the run says of the line before anything is written. `whole`: a run, of whatever line.
  [[nodiscard]] std::optional<RestartRefusal> look_at(std::uint32_t line, const RestartRun& whole) const {
    if (std::string why = places_.why_not(line); !why.empty())
      return RestartRefusal{DiagnosticId::restart_no_block, std::move(why)};
    const LineSeen& seen = whole.seen(line);
    if (seen.visits == 0) return RestartRefusal{DiagnosticId::restart_no_block, "the program never reaches this line"};
    if (seen.obstacle == RestartObstacle::in_shape || seen.visits == 1) {
      if (seen.obstacle != RestartObstacle::none)
        return RestartRefusal{DiagnosticId::restart_inside, std::string(words_of(seen.obstacle))};
    } else {
      return RestartRefusal{DiagnosticId::restart_no_block, fmt::format("the line is executed {} times", seen.visits)};
    }
    if (seen.guessed)
      return RestartRefusal{DiagnosticId::restart_unknown, "the value that decides how the program comes here is"};
    return std::nullopt;
  }

  static std::optional<RestartRefusal> look_at_run(const RestartRun& run) {
    if (!run.is_whole || run.result.ended == interpreter::Ended::limit)
      return RestartRefusal{DiagnosticId::restart_unknown, "the end of so long a run is"};
    for (const interpreter::RunDiagnostic& one : run.result.diagnostics)
      if (one.diagnostic.severity == text::Severity::error)
        return RestartRefusal{DiagnosticId::restart_unknown, fmt::format("what follows the fault in line {} ({}) is",
                                                                         one.line, text::message_of(one.diagnostic))};
    return std::nullopt;
  }

  std::optional<RestartRefusal> attempt(std::uint32_t line, Restart& out) {
    const RestartRun whole = run_for_restart(read_.program, request_.control, library_, options_, line);
    lines_ = whole.lines;
    if (auto refused = look_at(line, whole)) return refused;
    if (auto refused = look_at_run(whole)) return refused;
    const RestartWords words(request_.control, whole.point->state.modes);
    RestartDraft draft{.program = read_.program,
                       .control = request_.control,
                       .library = &library_,
                       .places = places_,
                       .run = whole,
                       .point = *whole.point,
                       .words = words,
                       .line = line,
                       .clearance_mm = request_.clearance_mm};
    draft.assumptions.emplace_back(
        "The control is reset, and the tool stands clear of the work, its fixture and the machine.");
    draft.assumptions.push_back(
        fmt::format("All that stands before line {} is done, and the work has not been moved since; work offsets and "
                    "the lengths and "
                    "radii of tools are those of the first run.",
                    line));
    if (auto refused = look_at_what_is_left_out(draft)) return refused;
    if (auto refused = write_preamble(draft)) return refused;
    if (auto refused = write_approach(draft)) return refused;
    put_together(draft, out);
    return prove(draft, out);
  }

  // Head, preamble and rest, in the line ends of the source.
  void put_together(const RestartDraft& draft, Restart& out) const {
    const text::Source& source = request_.source;
    const std::string_view eob = end_of_line(source);
    std::uint32_t lines = 0;
    const auto add = [&](std::string& to, std::string_view line) {
      to += line;
      to += eob;
    };
    for (const std::uint32_t line : places_.head_lines(draft.line)) {
      add(out.text, source.line(line));
      ++lines;
    }
    out.preamble_line = lines + 1;
    add(out.preamble, draft.words.comment(fmt::format("RESTART AT LINE {}", draft.line)));
    for (const std::string& line : draft.lines) add(out.preamble, line);
    out.text += out.preamble;
    out.rest_line = out.preamble_line + static_cast<std::uint32_t>(draft.lines.size()) + 1;
    const std::string_view rest = source.line(draft.line);
    out.text += source.text().substr(static_cast<std::size_t>(rest.data() - source.text().data()));
    out.assumptions = draft.assumptions;
  }

  std::optional<RestartRefusal> prove(const RestartDraft& draft, Restart& out) {
    const text::Source made("restart", out.text);
    const ir::ReadResult read = dialect_.read(made, request_.control);
    const auto differs = [](std::string why) { return RestartRefusal{DiagnosticId::restart_differs, std::move(why)}; };
    for (const text::Diagnostic& one : read.diagnostics)
      if (one.severity == text::Severity::error)
        return differs(fmt::format("line {} of it: {}", made.position(one.span.begin).line, text::message_of(one)));
    const RestartRun rest = run_for_restart(read.program, request_.control, library_, options_, out.rest_line);
    for (const interpreter::RunDiagnostic& one : rest.result.diagnostics)
      if (one.diagnostic.severity == text::Severity::error)
        return differs(fmt::format("line {} of it: {}", one.line, text::message_of(one.diagnostic)));
    if (!rest.point) return differs("it does not get there");
    out.moves_before = draft.run.moves_before(draft.point.ordinal);
    const RestartProof proof{.whole = draft.run,
                             .rest = rest,
                             .whole_line = draft.line,
                             .rest_line = out.rest_line,
                             .begins_with_tool = begins_with_tool_change(draft),
                             .rounding = draft.words.rounding_mm()};
    if (std::string what = proof.difference(out.compared_moves); !what.empty()) return differs(std::move(what));
    return std::nullopt;
  }

  // By what the run saw first; the few that look good are tried.
  std::uint32_t nearest(std::uint32_t line, int step) {
    int tried = 0;
    const std::vector<LineSeen> lines = lines_;
    for (std::int64_t at = static_cast<std::int64_t>(line) + step;
         at >= 1 && at <= static_cast<std::int64_t>(lines.size()) && tried < kTriedAround; at += step) {
      const auto candidate = static_cast<std::uint32_t>(at);
      const LineSeen& seen = lines[candidate - 1];
      if (seen.visits != 1 || seen.guessed || seen.obstacle != RestartObstacle::none) continue;
      if (!places_.why_not(candidate).empty()) continue;
      ++tried;
      Restart unused;
      if (!attempt(candidate, unused)) return candidate;
    }
    return 0;
  }

  const RestartRequest& request_;
  const Dialect& dialect_;
  ProgramLibrary own_library_;
  ProgramLibrary& library_;
  ir::ReadResult read_;
  RestartPlaces places_;
  interpreter::RunOptions options_;
  std::vector<LineSeen> lines_;  // of the last run
};

}  // namespace

Restart restart_at(const RestartRequest& request) { return Restarter(request).make(); }

}  // namespace dripfeed::compile
