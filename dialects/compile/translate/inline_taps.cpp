// Taps of lathes: their moves are known from the run, and are written as a tap of the other control, not as plain
// moves, on which feed override and feed hold act.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/compile/translate/inline_moves.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

bool is_thread(const ir::Motion& m) { return m.kind == ir::MotionKind::thread; }

bool states_speed(const ir::Program& program, const ir::Statement& s) {
  return s.kind == StatementKind::block &&
         std::ranges::any_of(program.words_of(program.blocks[s.payload]),
                             [](const ir::Word& w) { return w.address == Address::s && w.extension <= 1; });
}

}  // namespace

void InlineMoves::find_taps(const ir::Program& program) {
  taps_ = tap_statements(program, from_, to_);
  for (std::uint32_t i = 0; i < taps_.size(); ++i) {
    const TapStatement& tap = taps_[i];
    const bool speed = (tap.role == TapRole::tap && tap.own_speed) || states_speed(program, program.statements[i]);
    if (speed) speed_lines_.insert(program.statements[i].line);
    if (tap.role == TapRole::none) continue;
    kinds_[i] = tap.role == TapRole::tap ? WithoutCounterpart::tap : WithoutCounterpart::tap_part;
    const std::uint32_t line = program.statements[i].line;
    if (tap.role == TapRole::tap) tap_lines_[line] = line;
    if (tap.owner != ir::kNoIndex) tap_lines_[line] = program.statements[tap.owner].line;
  }
}

void InlineMoves::replace_tap(ir::Program& program, std::uint32_t index, const facts::Resolved& flow,
                              passes::Rewrite& out) {
  const ir::Statement s = program.statements[index];
  const TapStatement& tap = taps_[index];
  const std::string name = name_of(kinds_[index], program, s);
  BlockTerms terms;
  BlockRest rest;
  std::span<const ir::Motion> motions;
  for (const std::string& what : {tap.fault, same_tap_each_time(s.line, tap, motions),
                                  terms_at(program, index, flow, terms), rest_of(program, index, rest)})
    if (!what.empty()) return cannot(fmt::format("{} {}", name, what), s.span);
  const bool compensates = std::ranges::any_of(
      motions, [](const ir::Motion& m) { return ir::is_move(m.kind) && m.comp != ir::CompSide::off; });
  if (compensates) return cannot(passes::together(name + " where the radius is compensated"), s.span);
  if (tap.own_speed) {
    const RecordedRun& run = runs_.front();
    for (std::size_t v = 0; v < run.visits.size(); ++v)
      if (run.visits[v].line == s.line && !states_speed_after(run, v))
        return cannot(name + " at another speed than before it, after which no speed is stated,", s.span);
  }
  // What ,R1 says, the run shows.
  const bool rigid = tap.rigid || (ir::has_numbered_variables(from_) && std::ranges::any_of(motions, is_thread));
  TapMoves moves(program, out, terms, to_, rigid);
  if (const auto done = moves.write(motions, std::move(rest)); !done)
    return cannot(name + " with " + done.error(), s.span);
  if (!ir::has_numbered_variables(to_) && !motions.empty()) {
    report_written(name, s.span);
    diagnostics_.back().notes.front().text =
        rigid ? "it is written as G331 and G332" : "it is written as G63, which needs a compensating chuck";
  }
  if (const Restored again = restored(program, index, moves.plain()); !again.codes.empty() || !again.words.empty())
    out.emit_block(again.codes, again.words);
}

// Codes that only announce the tap go with it.
void InlineMoves::replace_tap_part(const ir::Program& program, std::uint32_t index, passes::Rewrite& out) const {
  const ir::Statement& s = program.statements[index];
  if (s.kind != StatementKind::block || taps_[index].owner != ir::kNoIndex) return;
  if (taps_[index].role == TapRole::orients) {
    const bool has_no_codes = program.codes_of(program.blocks[s.payload]).empty();  // by the code that stands for SPOS
    if (!has_no_codes) out.emit_block({code_of(Function::spindle_stop, ir::ModalGroup::spindle)}, {});
    return;
  }
  const ir::Block& block = program.blocks[s.payload];
  std::vector<ir::Code> codes(program.codes_of(block).begin(), program.codes_of(block).end());
  std::erase_if(codes, [&](const ir::Code& c) { return passes::announces_rigid_tap(c, from_); });
  const std::vector<ir::Word> words(program.words_of(block).begin(), program.words_of(block).end());
  if (!codes.empty() || !words.empty()) out.emit_block(codes, words);
}

// With the retract, where that has a line of its own.
std::string InlineMoves::same_tap_each_time(std::uint32_t line, const TapStatement& tap,
                                            std::span<const ir::Motion>& motions) const {
  bool found = false;
  const auto is_part = [&](const Visit& v) {
    const auto at = tap_lines_.find(v.line);
    return v.line != line && at != tap_lines_.end() && at->second == line;
  };
  for (const RecordedRun& run : runs_) {
    for (std::size_t v = 0; v < run.visits.size(); ++v) {
      if (run.visits[v].line != line) continue;
      std::size_t count = run.visits[v].motion_count;
      for (std::size_t next = v + 1; next < run.visits.size(); ++next) {
        if (!is_part(run.visits[next]) && run.visits[next].motion_count != 0) break;
        count += run.visits[next].motion_count;
      }
      const auto here = std::span(run.motions).subspan(run.visits[v].first_motion, count);
      const auto turns_alike = [](const ir::Motion& a, const ir::Motion& b) {
        return a.spindle_rpm == b.spindle_rpm && a.surface_speed_m_min == b.surface_speed_m_min;
      };
      if (found && (!same_moves(here, motions) || !std::ranges::equal(here, motions, turns_alike)))
        return "that makes other moves each time";
      motions = here;
      found = true;
      if (ir::has_numbered_variables(from_) && !here.empty()) {
        const std::size_t first = run.visits[v].first_motion;
        const ir::SpindleState before = first == 0 ? ir::SpindleState::stopped : run.motions[first - 1].spindle;
        const bool rigid = tap.rigid || std::ranges::any_of(here, is_thread);
        // G84 counts on M3 where the spindle only turns back, and what it makes of M4 is the machine's.
        if (before == ir::SpindleState::counterclockwise || (!rigid && before == ir::SpindleState::stopped))
          return "where the spindle does not turn by M3";
      }
      const bool turns = !here.empty() && here.front().spindle != ir::SpindleState::stopped;
      if (tap.needs_stop && turns) return "where the spindle was not brought to a stop (SPOS)";
    }
  }
  return found ? "" : "that is never run";
}

// Whether what follows a tap at a speed of its own says a speed before it cuts.
bool InlineMoves::states_speed_after(const RecordedRun& run, std::size_t visit) const {
  const Visit& tap = run.visits[visit];
  if (tap.motion_count == 0) return true;
  const double own = run.motions[tap.first_motion + tap.motion_count - 1].spindle_rpm;
  const double before = tap.first_motion == 0 ? own : run.motions[tap.first_motion - 1].spindle_rpm;
  if (before == own) return true;
  for (std::size_t v = visit + 1; v < run.visits.size(); ++v) {
    if (speed_lines_.contains(run.visits[v].line)) return true;
    const auto cuts = [](const ir::Motion& m) { return ir::is_move(m.kind) && m.kind != ir::MotionKind::rapid; };
    if (std::ranges::any_of(run.motions_of(run.visits[v]), cuts)) return false;
  }
  return true;
}

}  // namespace dripfeed::compile
