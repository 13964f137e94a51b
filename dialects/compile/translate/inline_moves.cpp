// From statement to moves, and back to the modes that the next block counts on.
#include "dialects/compile/translate/inline_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/compile/plain/lost_writes.h"
#include "dialects/ir/cycle.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

constexpr std::size_t kMostMoves = 20'000;  // of one statement

bool is_own(const ir::Code& c) {
  return c.group == ModalGroup::motion || c.group == ModalGroup::cycle || c.function == Function::repetitive_cycle ||
         c.function == Function::hole_pattern || passes::is_floating_tap(c);
}

// Words that mean the same with any move.
bool stays(Address a) { return a == Address::s || a == Address::t || a == Address::m || a == Address::d; }
// Words of an arc; those of a cycle are all that do not stay.
bool is_of_arc(Address a) {
  return ir::is_axis(a) || (a >= Address::i && a <= Address::k) || a == Address::f ||
         (a >= Address::arc_radius && a <= Address::opening_angle) ||
         (a >= Address::polar_angle && a <= Address::turns) || (a >= Address::via_i && a <= Address::via_k);
}

bool is_of_shape(const ir::Code& c) {
  return c.number == ir::ExpressionId::none && (c.group == ModalGroup::motion || c.group == ModalGroup::comp ||
                                                c.group == ModalGroup::feed || c.group == ModalGroup::distance);
}
bool is_word_of_shape(Address a) {
  return is_of_arc(a) || a == Address::r || (a >= Address::chamfer && a <= Address::rounding) ||
         a == Address::direct_angle;
}

ir::Plane plane_of(Function f) {
  return f == Function::plane_zx ? ir::Plane::zx : f == Function::plane_yz ? ir::Plane::yz : ir::Plane::xy;
}
ir::FeedMode feed_mode_of(Function f) {
  return f == Function::feed_per_rev        ? ir::FeedMode::per_rev
         : f == Function::feed_inverse_time ? ir::FeedMode::inverse_time
                                            : ir::FeedMode::per_min;
}

// Arcs and the finishing cut (G70) go along the contour itself; the other moves of a cycle are its own.
bool compensates(const ir::Program& program, const ir::Statement& s, std::span<const ir::Motion> motions) {
  const bool follows = s.kind == StatementKind::block &&
                       std::ranges::any_of(program.codes_of(program.blocks[s.payload]), [](const ir::Code& c) {
                         return ir::is_cycle(c, ir::RepetitiveCycle::finish);
                       });
  return !follows && std::ranges::any_of(motions, [](const ir::Motion& m) {
    return ir::is_move(m.kind) && m.comp != ir::CompSide::off;
  });
}

bool has_curve(std::span<const ir::Motion> motions) {
  return std::ranges::any_of(motions, [](const ir::Motion& m) { return m.kind == ir::MotionKind::spline; });
}

bool has_word(const ir::Program& program, const ir::Block& block, Address address) {
  return std::ranges::find(program.words_of(block), address, &ir::Word::address) != program.words_of(block).end();
}

}  // namespace

bool same_moves(std::span<const ir::Motion> a, std::span<const ir::Motion> b) {
  constexpr double kSame_mm = 1e-9;
  const auto near = [](double x, double y) { return std::abs(x - y) <= kSame_mm; };
  // Where it leads that is written: the axes that are named, and those of an arc.
  const auto same_end = [&](const ir::Motion& m, const ir::Motion& n) {
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
      const bool written = (m.axes_commanded & (1U << axis)) != 0 || (is_arc(m.kind) && is_in_plane(m.plane, axis));
      if (written && !near(m.end[axis], n.end[axis])) return false;
    }
    return true;
  };
  return std::ranges::equal(a, b, [&](const ir::Motion& m, const ir::Motion& n) {
    return m.kind == n.kind && m.axes_commanded == n.axes_commanded && m.plane == n.plane && same_end(m, n) &&
           std::ranges::equal(m.center, n.center, near) && m.feed == n.feed && m.feed_mode == n.feed_mode &&
           m.spindle == n.spindle && m.gaps == n.gaps;
  });
}

void InlineMoves::cannot(passes::Refusal what, text::Span span) {
  diagnostics_.push_back(passes::diagnose(std::move(what), span, to_.title));
}

// What a cycle's numbers meant can no longer be seen, nor changed at the machine: whoever takes the translation over is
// to know.
void InlineMoves::report_written(const std::string& name, text::Span span) {
  cannot(name, span);
  diagnostics_.back().severity = text::Severity::warning;
  diagnostics_.back().notes = {{.span = span, .text = "it is written as its moves"}};
}

std::vector<text::Diagnostic> InlineMoves::lower(ir::Program& program) {
  kinds_ = without_counterpart(program, from_, to_);
  find_taps(program);
  const bool replaces =
      std::ranges::any_of(kinds_, [](WithoutCounterpart kind) { return kind != WithoutCounterpart::no; });
  if (!replaces && !as_read_) {
    watch(program, false);
    return std::move(diagnostics_);
  }
  not_compared_ = obstacle(program);
  if (const std::string& what = not_compared_; !what.empty()) {
    runs_.clear();
    for (std::size_t i = 0; i < kinds_.size(); ++i)
      if (const ir::Statement& s = program.statements[i]; kinds_[i] != WithoutCounterpart::no &&
                                                          kinds_[i] != WithoutCounterpart::pecks &&
                                                          kinds_[i] != WithoutCounterpart::tap_part)
        cannot(passes::together(name_of(kinds_[i], program, s) + " together with " + what), s.span);
    return std::move(diagnostics_);
  }
  const facts::Resolved flow(program, from_);
  passes::Rewrite out(program);
  const auto count = static_cast<std::uint32_t>(program.statements.size());
  find_cycles(program);
  std::erase_if(program.labels, [&](const ir::Label& label) {
    return label.name == ir::StringId::none && kinds_[label.statement] == WithoutCounterpart::no &&
           is_dropped(program.statements[label.statement].line);
  });
  for (std::uint32_t i = 0; i < count; ++i) {
    out.at(i);
    if (kinds_[i] == WithoutCounterpart::tap)
      replace_tap(program, i, flow, out);
    else if (kinds_[i] == WithoutCounterpart::tap_part)
      replace_tap_part(program, i, out);
    else if (kinds_[i] != WithoutCounterpart::no)
      replace(program, i, flow, out);
    else if (!is_dropped(program.statements[i].line))
      out.keep();
  }
  out.finish();
  return std::move(diagnostics_);
}

// Why the run says nothing; empty when it does.
std::string InlineMoves::obstacle(const ir::Program& program) {
  if (program.sections.size() > 1) return "another program in the same text";
  if (const std::optional<OutsideInfluence> outside = outside_influence(program)) return outside->what;
  if (std::string levels = set_switches(program); !levels.empty()) return levels;
  shapes_ = shapes_of(program);
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i] == WithoutCounterpart::no || kinds_[i] == WithoutCounterpart::tap_part) continue;
    const std::uint32_t line = program.statements[i].line;
    if (std::ranges::find(owners_, line) != owners_.end()) return "another of its kind in the same line";
    owners_.push_back(line);
  }
  if (library_ != nullptr) return run(program, *library_);
  ProgramLibrary own(from_, [](std::string_view) { return std::nullopt; });
  return run(program, own);
}

// All levels off, and all on.
std::string InlineMoves::set_switches(const ir::Program& program) {
  const std::set<std::uint8_t> levels = skip_levels(program);
  if (levels.size() > 1) return "block skip of several levels";
  settings_ = {0};
  if (!levels.empty()) settings_.push_back(1U << *levels.begin());
  return {};
}

std::string InlineMoves::run(const ir::Program& program, ProgramLibrary& library) {
  for (const std::uint32_t switches : settings_) {
    interpreter::RunOptions options;
    options.limits = limits_;
    options.skip_switches = switches;
    runs_.push_back(record(as_read_ ? *as_read_ : program, from_, library, options, shapes_, owners_));
    const interpreter::RunResult& result = runs_.back().result;
    for (const interpreter::RunDiagnostic& d : result.diagnostics)
      if (d.diagnostic.severity == text::Severity::error)
        return "a run that ends in line " + std::to_string(d.line) + ": " + text::message_of(d.diagnostic) + ",";
    for (const interpreter::NotInterpreted& lost : result.not_interpreted)
      if (!lost.effects_known && lost.function != Function::machine_function &&
          lost.function != Function::reference_return)
        return lost.name + " in line " + std::to_string(lost.first_line) + ", which the run does not know,";
    const bool ends =
        result.ended == interpreter::Ended::end && std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
          return s.line == result.last.line && s.kind == StatementKind::program_end;
        });
    if (!ends) return "a text that is not a main program with its end";
    if (!runs_.back().is_whole) return "a run of that many moves";
  }
  return lost_with_shape(program);
}

bool InlineMoves::is_dropped(std::uint32_t line) const {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const bool plain = std::ranges::any_of(runs_, [&](const RecordedRun& run) { return run.plain_shapes[i]; });
    if (shapes_[i].has(line) && !plain) return true;
  }
  return false;
}

void InlineMoves::replace(ir::Program& program, std::uint32_t index, const facts::Resolved& flow,
                          passes::Rewrite& out) {
  const ir::Statement s = program.statements[index];
  const std::string name = name_of(kinds_[index], program, s);
  BlockTerms terms;
  BlockRest rest;
  std::span<const ir::Motion> motions;
  for (const std::string& what :
       {same_each_time(s.line, motions), terms_at(program, index, flow, terms), rest_of(program, index, rest)})
    if (!what.empty()) return cannot(fmt::format("{} {}", name, what), s.span);
  const bool plain_arc = kinds_[index] == WithoutCounterpart::arc && !has_curve(motions);
  if (!plain_arc && compensates(program, s, motions))
    return cannot(
        passes::together(name + " where the radius is compensated, which the control may do by a method of its own,"),
        s.span);
  PlainMoves moves(program, out, terms);
  if (const auto done = moves.write(motions, std::move(rest)); !done)
    return cannot(name + " with " + done.error(), s.span);
  if (!plain_arc && !motions.empty()) report_written(name, s.span);
  if (const Restored again = restored(program, index, moves); !again.codes.empty() || !again.words.empty())
    out.emit_block(again.codes, again.words);
}

std::string InlineMoves::same_each_time(std::uint32_t line, std::span<const ir::Motion>& motions) const {
  bool found = false;
  for (const RecordedRun& run : runs_) {
    for (const Visit& visit : run.visits) {
      if (visit.line != line) continue;
      if (found && !same_moves(run.motions_of(visit), motions)) return "that makes other moves each time";
      motions = run.motions_of(visit);
      found = true;
    }
  }
  if (!found) return "that is never run";
  return motions.size() > kMostMoves ? "of that many moves" : "";
}

std::string InlineMoves::terms_at(const ir::Program& program, std::uint32_t index, const facts::Resolved& flow,
                                  BlockTerms& terms) const {
  const facts::Facts* facts = flow.before(index);
  if (facts == nullptr) return "that no control-flow path leads to";
  std::array<Function, facts::kModes> modes{};
  for (std::size_t mode = 0; mode < facts::kModes; ++mode)
    if (facts->modes[mode].agrees()) modes[mode] = facts->modes[mode].value.function;
  const ir::Statement& s = program.statements[index];
  if (s.kind == StatementKind::block)
    for (const ir::Code& c : program.codes_of(program.blocks[s.payload]))
      if (const auto mode = facts::mode_of(c)) modes[facts::index_of(*mode)] = c.function;
  const auto at = [&](facts::Mode mode) { return modes[facts::index_of(mode)]; };
  const auto is_lengths_only = [](const ir::Code& c) { return c.function == Function::unit_inch && c.argument == 1; };
  if (std::ranges::any_of(program.codes, is_lengths_only)) return "together with G70, which leaves the feeds metric,";
  if (at(facts::Mode::unit) == Function::none) return "where the unit of lengths is not known";
  if (at(facts::Mode::distance) == Function::none) return "where absolute or incremental is not known";
  if (at(facts::Mode::feed) == Function::none) return "where the kind of feed is not known";
  if (at(facts::Mode::plane) == Function::none) return "where the plane is not known";
  terms.unit_mm = at(facts::Mode::unit) == Function::unit_inch ? 25.4 : 1.0;
  terms.plane = plane_of(at(facts::Mode::plane));
  terms.feed_mode = feed_mode_of(at(facts::Mode::feed));
  terms.dwell_p_is_ms = from_.semantics.dwell_p_is_ms;
  terms.decimals = to_.limits.linear_decimals;
  const bool diameter_axis = from_.semantics.power_on_diameter != ir::DiameterMode::radius;
  const Function diameter = at(facts::Mode::diameter);
  if (diameter == Function::none && from_.kind != ir::MachineKind::mill) return "where diameter or radius is not known";
  terms.x_scale = diameter_axis && diameter == Function::diameter_off ? 0.5 : 1.0;
  if (at(facts::Mode::distance) != Function::incremental) return {};
  if (ir::has_numbered_variables(from_)) return "where increments are in effect";
  terms.mode = ir::WordMode::absolute;
  return {};
}

std::string InlineMoves::rest_of(const ir::Program& program, std::uint32_t index, BlockRest& rest) const {
  const ir::Statement& s = program.statements[index];
  if (s.skip_level != 0) return "that a switch may skip";
  if (s.kind != StatementKind::block) return {};
  const ir::Block& block = program.blocks[s.payload];
  if (block.rest_level != 0) return "with block skip inside it";
  for (const ir::Code& c : program.codes_of(block)) {
    if (c.number != ir::ExpressionId::none) return "together with a code with a calculated number";
    if (is_own(c)) continue;
    const bool drills = kinds_[index] == WithoutCounterpart::drilling || kinds_[index] == WithoutCounterpart::tap;
    if (drills && c.function == Function::machine_function)
      return "with an M function, which the cycle gives its own time,";
    const bool ends = c.function == Function::coolant_off || c.function == Function::spindle_stop ||
                      c.function == Function::program_stop || c.function == Function::optional_stop;
    const bool sets = c.group == ModalGroup::plane || c.group == ModalGroup::distance || c.group == ModalGroup::unit ||
                      c.group == ModalGroup::work_offset || c.group == ModalGroup::diameter ||
                      c.group == ModalGroup::return_level;
    (ends ? rest.after : sets ? rest.before : rest.codes).push_back(c);
  }
  const bool arc = kinds_[index] == WithoutCounterpart::arc;
  // D of G71 and G76 in one block is a depth.
  const bool has_depth = std::ranges::any_of(
      program.codes_of(block), [](const ir::Code& c) { return c.function == Function::repetitive_cycle; });
  for (const ir::Word& w : program.words_of(block)) {
    const bool own = arc ? is_of_arc(w.address) : !stays(w.address) || (has_depth && w.address == Address::d);
    if (!own && !stays(w.address)) return "with the word " + std::string(w.span.in(program.source.text()));
    if (!own) rest.words.push_back(w);
  }
  return {};
}

// What the next block counts on and the moves have changed: its motion code and its feed, where it says none itself.
InlineMoves::Restored InlineMoves::restored(const ir::Program& program, std::uint32_t index, PlainMoves& moves) const {
  Restored out;
  const std::uint32_t line = program.statements[index].line;
  const RecordedRun& run = runs_.front();
  const auto is_here = [&](const Visit& v) { return v.line == line; };
  auto visit = std::ranges::find_if(run.visits, is_here);
  if (visit == run.visits.end()) return out;
  const auto block_at = [&](std::uint32_t at) -> const ir::Block* {
    const auto s = std::ranges::find_if(program.statements, [&](const ir::Statement& one) {
      return one.line == at && one.kind == StatementKind::block;
    });
    return s == program.statements.end() ? nullptr : &program.blocks[s->payload];
  };
  bool moved = false;
  bool feeds = false;
  for (++visit; visit != run.visits.end() && !(moved && feeds); ++visit) {
    const auto tap = tap_lines_.find(visit->line);
    if (tap != tap_lines_.end() && tap->second == line && visit->line != line) continue;  // the retract
    const ir::Block* block = block_at(visit->line);
    const bool replaced = std::ranges::find(owners_, visit->line) != owners_.end();
    if (block != nullptr && !replaced) {
      moved |= std::ranges::any_of(program.codes_of(*block), [](const ir::Code& c) {
        return c.group == ModalGroup::motion || c.group == ModalGroup::cycle;
      });
      feeds |= has_word(program, *block, Address::f);
    }
    for (const ir::Motion& m : run.motions_of(*visit)) {
      const std::optional<Function> function = plain_function_of(m.kind);
      if (!function || replaced) {
        moved |= replaced && ir::is_move(m.kind);
        feeds |= replaced && ir::is_move(m.kind) && m.kind != ir::MotionKind::rapid;
        continue;
      }
      if (!std::exchange(moved, true) && block != nullptr) out.codes.push_back(motion_code(*function));
      const bool cuts = m.kind != ir::MotionKind::rapid;
      if (cuts && !std::exchange(feeds, true) && moves.last_feed() != m.feed)
        out.words.push_back(moves.feed_word(m.feed));
    }
  }
  return out;
}

// Kept lines of several moves, and where each line stands. The blocks of a cycle that the control brings along have the
// line of its call.
void InlineMoves::find_cycles(const ir::Program& program) {
  writes_ = writes_by_line(program, from_);
  for (const RecordedRun& run : runs_) {
    std::uint32_t line = 0;
    std::ptrdiff_t moves = 0;
    for (const Visit& visit : run.visits) {
      if (std::exchange(line, visit.line) != visit.line) moves = 0;
      moves += std::ranges::count_if(run.motions_of(visit), [](const ir::Motion& m) { return ir::is_move(m.kind); });
      if (moves > 1) cycles_.insert(line);
    }
  }
  for (const std::uint32_t line : owners_) cycles_.erase(line);
  for (const ir::Statement& s : program.statements) spans_.try_emplace(s.line, s.span);
}

// The blocks of a shape go with it. They may hold nothing but moves: an M function, a limit of the speed or an
// assignment would be lost.
std::string InlineMoves::lost_with_shape(const ir::Program& program) const {
  for (const ir::Statement& s : program.statements) {
    if (!is_dropped(s.line) || s.kind == StatementKind::empty) continue;
    bool moves = s.kind == StatementKind::block && s.skip_level == 0;
    if (moves) {
      const ir::Block& block = program.blocks[s.payload];
      moves =
          block.rest_level == 0 && std::ranges::all_of(program.codes_of(block), is_of_shape) &&
          std::ranges::all_of(program.words_of(block), [](const ir::Word& w) { return is_word_of_shape(w.address); });
    }
    if (!moves) return "a shape that holds more than moves, in line " + std::to_string(s.line) + ",";
  }
  return {};
}

}  // namespace dripfeed::compile
