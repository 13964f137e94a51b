// Statements that the other control has no word for, written as the moves that they make: CIP and CT, the drilling
// cycles of lathes, hole patterns, G70 to G73 and CYCLE95; and the taps of lathes, each as a tap of its own. The
// program is run; where nothing from outside decides what it does, a statement that makes the same moves each time is
// replaced by them, and the translation is run and compared.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "dialects/compile/dialect/library.h"
#include "dialects/compile/translate/outside_influence.h"
#include "dialects/compile/translate/plain_moves.h"
#include "dialects/compile/translate/recorded_run.h"
#include "dialects/compile/translate/tap_moves.h"
#include "dialects/compile/translate/tap_statements.h"
#include "dialects/compile/translate/without_counterpart.h"
#include "dialects/facts/resolved.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/passes/refusal.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// To the last digit; neither their lines nor the speed of the spindle.
bool same_moves(std::span<const ir::Motion> a, std::span<const ir::Motion> b);

// Both runs are kept whole, 256 bytes a motion: a block may hold a million pecks, so blocks alone bound nothing.
constexpr interpreter::Limits run_limits(interpreter::Limits asked) {
  asked.blocks = std::min<std::uint64_t>(asked.blocks, 1'000'000);
  asked.loop_passes = std::min<std::uint64_t>(asked.loop_passes, 1'000'000);
  asked.motions = std::min<std::uint64_t>(asked.motions, 2'000'000);
  return asked;
}

class InlineMoves {
 public:
  // `library`: of contours; nullptr: there are none. `limits`: of each run, as far as they are below run_limits' own.
  // The controls must outlive it.
  InlineMoves(const ir::Control& from, const ir::Control& to, ProgramLibrary* library,
              const interpreter::Limits& limits)
      : from_(from), to_(to), library_(library), limits_(run_limits(limits)) {}

  // The program as it was read, whose ISO parts are spliced where lower() gets it: this is what is run, and compared
  // wherever nothing from outside decides what it does.
  void run_as(const ir::Program& program) { as_read_ = program; }
  // Replaces what it can; what cannot be written so is an error at its block.
  std::vector<text::Diagnostic> lower(ir::Program& program);
  // Runs a program of which nothing is replaced, for compare(). `called`: whether the programs that it calls are part
  // of the translation.
  void watch(const ir::Program& program, bool called);
  // Whether the translation, with the source's line for each of its lines, moves as the source did; an error at the
  // first line that does not.
  [[nodiscard]] std::vector<text::Diagnostic> compare(const ir::Program& translation,
                                                      const std::vector<std::uint32_t>& origin_lines) const;
  // Why compare() cannot say anything; empty when it can.
  [[nodiscard]] const std::string& not_compared() const { return not_compared_; }

 private:
  struct Restored {
    std::vector<ir::Code> codes;
    std::vector<ir::Word> words;
  };
  [[nodiscard]] std::string obstacle(const ir::Program& program);
  [[nodiscard]] std::string run(const ir::Program& program, ProgramLibrary& library);
  void find_taps(const ir::Program& program);
  void replace(ir::Program& program, std::uint32_t index, const facts::Resolved& flow, passes::Rewrite& out);
  void replace_tap(ir::Program& program, std::uint32_t index, const facts::Resolved& flow, passes::Rewrite& out);
  void replace_tap_part(const ir::Program& program, std::uint32_t index, passes::Rewrite& out) const;
  [[nodiscard]] std::string same_tap_each_time(std::uint32_t line, const TapStatement& tap,
                                               std::span<const ir::Motion>& motions) const;
  [[nodiscard]] bool states_speed_after(const RecordedRun& run, std::size_t visit) const;
  [[nodiscard]] std::string same_each_time(std::uint32_t line, std::span<const ir::Motion>& motions) const;
  [[nodiscard]] std::string terms_at(const ir::Program& program, std::uint32_t index, const facts::Resolved& flow,
                                     BlockTerms& terms) const;
  [[nodiscard]] std::string rest_of(const ir::Program& program, std::uint32_t index, BlockRest& rest) const;
  [[nodiscard]] Restored restored(const ir::Program& program, std::uint32_t index, PlainMoves& moves) const;
  [[nodiscard]] bool is_dropped(std::uint32_t line) const;
  [[nodiscard]] std::vector<text::Diagnostic> alarm_of(const ir::Program& translation,
                                                       const std::vector<std::uint32_t>& origin_lines) const;
  // Of the source, of a write that the translation does not make.
  [[nodiscard]] std::optional<std::uint32_t> first_lost_write(const ir::Program& translation, const RecordedRun& run,
                                                              const std::vector<std::uint32_t>& origin_lines,
                                                              std::size_t setting) const;
  [[nodiscard]] std::string watched(const ir::Program& program, bool called);
  [[nodiscard]] std::string set_switches(const ir::Program& program);
  // Of the source.
  struct Difference {
    std::uint32_t line = 0;
    std::string what;
  };
  // The first move that is another one in the translation; nothing where there is none.
  [[nodiscard]] std::optional<Difference> first_difference(const ir::Program& translation,
                                                           const std::vector<std::uint32_t>& origin_lines,
                                                           std::size_t setting) const;
  void find_cycles(const ir::Program& program);
  [[nodiscard]] std::string lost_with_shape(const ir::Program& program) const;
  void cannot(passes::Refusal what, text::Span span);
  void report_written(const std::string& name, text::Span span);

  const ir::Control& from_;
  const ir::Control& to_;
  ProgramLibrary* library_;
  interpreter::Limits limits_;                        // of each run
  std::optional<ir::Program> as_read_;                // of run_as()
  std::vector<WithoutCounterpart> kinds_;             // by statement
  std::vector<LineRange> shapes_;                     // of the text
  std::vector<TapStatement> taps_;                    // by statement
  std::map<std::uint32_t, std::uint32_t> tap_lines_;  // of a tap and its parts: the line of the tap
  std::set<std::uint32_t> speed_lines_;               // that say a speed
  std::vector<std::uint32_t> owners_;                 // lines of what is replaced
  std::vector<std::uint32_t> settings_;               // of the switches of block skip
  std::vector<RecordedRun> runs_;                     // one a setting
  std::map<std::uint32_t, text::Span> spans_;         // by line
  std::set<std::uint32_t> cycles_;                    // lines that make several moves and are kept
  std::map<std::uint32_t, std::size_t> writes_;       // for others, by line
  text::Source source_;                               // of the program that was run
  std::string not_compared_ = "it was not run";
  bool returns_ = false;  // runs_ are of a text without a program end
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace dripfeed::compile
