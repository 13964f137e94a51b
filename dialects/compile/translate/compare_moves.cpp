// A run becomes a list of steps: a move with all that is in effect, or words that stand for what no run shows. Two
// lists are equal when each step is.
#include "dialects/compile/translate/compare_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "dialects/compile/dialect/describe_move.h"
#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/compile/plain/lost_writes.h"
#include "dialects/compile/translate/inline_moves.h"
#include "dialects/compile/translate/recorded_run.h"
#include "dialects/ir/sections.h"
#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

using ir::Function;
using ir::MotionKind;
using ir::StatementKind;

struct Step {
  std::uint32_t line = 0;
  std::string words{};   // of one that is not a move: "T5", "M 150"
  bool is_known = true;  // false: what it does is not known, only what it says
  ir::Motion motion{};   // of a move or dwell, where `words` is empty
};

// What it does to the axes no run shows; the same words in the same place do the same.
constexpr std::array kOpaque = {Function::machine_function, Function::reference_return, Function::data_input,
                                Function::set_coordinates};
bool is_opaque(Function f) { return std::ranges::find(kOpaque, f) != kOpaque.end(); }

// A variable that any program may read moves nothing; what the control itself reads (offsets, frames) may.
bool states_more(const ir::Program& program, const ir::Statement& s, const ir::Control& control) {
  if (s.kind == StatementKind::assign) {
    const auto write = outside_write(program, program.at(program.assigns[s.payload].target), control);
    return write && !write->is_shared;
  }
  if ((s.kind != StatementKind::block && s.kind != StatementKind::program_end) || s.payload == ir::kNoIndex)
    return false;
  return std::ranges::any_of(program.codes_of(program.blocks[s.payload]),
                             [](const ir::Code& c) { return is_opaque(c.function); });
}

// Lines of the main program whose effect outlives a move or is not known.
class OpaqueLines {
 public:
  explicit OpaqueLines(const ComparedProgram& of) {
    const ir::Section main = ir::section_at(of.program, 0);
    for (std::uint32_t i = 0; i < of.program.statements.size(); ++i) {
      const ir::Statement& s = of.program.statements[i];
      if (!states_more(of.program, s, of.control)) continue;
      if (i < main.first || i >= main.last)
        elsewhere_ = fmt::format("line {} of a called program has effects that a run does not show", s.line);
      lines_.insert(s.line);
      const auto uses = passes::variables_of(of.program, s);
      if (std::ranges::any_of(uses, [](const passes::VariableUseAt& use) { return !use.set; }))
        computed_.insert(s.line);
    }
  }
  [[nodiscard]] bool has(std::uint32_t line) const { return lines_.contains(line); }
  // What it says is decided by values, which its words do not show.
  [[nodiscard]] bool is_computed(std::uint32_t line) const { return computed_.contains(line); }
  [[nodiscard]] const std::string& elsewhere() const { return elsewhere_; }

 private:
  std::set<std::uint32_t> lines_;
  std::set<std::uint32_t> computed_;
  std::string elsewhere_;
};

// One program, run with the switches of block skip as they are given.
class Steps {
 public:
  Steps(const ComparedProgram& of, const OpaqueLines& opaque) : of_(of), opaque_(opaque) {}

  // Why it cannot be compared with another; "" when it can.
  std::string run(std::uint32_t switches, const std::function<std::string()>& used_up) {
    ir::Control control = of_.control;
    control.semantics.unset_is_unknown = true;
    interpreter::RunOptions options;
    options.limits = run_limits(options.limits);
    options.skip_switches = switches;
    options.used_up = used_up;
    const RecordedRun run = record(of_.program, control, of_.library, options, {}, {});
    if (std::string why = gap(run); !why.empty()) return why;
    for (const Visit& visit : run.visits)
      if (std::string why = add(visit, run); !why.empty()) return why;
    return {};
  }

  [[nodiscard]] const std::vector<Step>& all() const { return steps_; }

 private:
  std::string gap(const RecordedRun& run) {
    for (const interpreter::RunDiagnostic& d : run.result.diagnostics)
      if (d.diagnostic.severity == text::Severity::error || d.diagnostic.id == text::DiagnosticId::call_target_missing)
        return fmt::format("its run finds in line {}: {}", d.line, text::message_of(d.diagnostic));
    for (const interpreter::NotInterpreted& lost : run.result.not_interpreted) {
      if (lost.effects_known) continue;
      const std::string place = fmt::format(" in line {}", lost.first_line);
      if (lost.is_input) return lost.name + place + " has a value that is not given";
      if (lost.program != 0) return lost.name + " in a called program is not interpreted";
      if (!is_opaque(lost.function)) return lost.name + place + " is not interpreted";
      if (!opaque_.has(lost.first_line)) return lost.name + place + " is computed";
    }
    for (const interpreter::ComputedCodeUse& one : run.result.computed_codes)
      if (is_opaque(one.function)) return fmt::format("{} in line {} is computed", one.name, one.first_line);
    for (std::size_t i = 1; i < run.result.programs.size(); ++i)
      if (std::string why = gap_of_called(run.result.programs[i]); !why.empty()) return why;
    if (!run.is_whole || run.result.ended == interpreter::Ended::limit) return "it runs too long";
    if (run.result.ended == interpreter::Ended::alarm) return "its run ends by an alarm";
    return {};
  }

  // A called program: what no run shows of it is not looked at.
  std::string gap_of_called(const std::string& name) {
    if (ir::section_named(of_.program, name)) return {};  // OpaqueLines has looked at it
    const ir::Program* called = of_.library.find(name);
    if (called == nullptr) return "it calls " + name + ", which is not available";
    if (called->is_standard) return {};
    const bool has_more = std::ranges::any_of(
        called->statements, [&](const ir::Statement& s) { return states_more(*called, s, of_.control); });
    return has_more ? name + ", which it calls, has effects that a run does not show" : std::string();
  }

  std::string add(const Visit& visit, const RecordedRun& run) {
    if (opaque_.has(visit.line)) {
      if (opaque_.is_computed(visit.line))
        return fmt::format("line {} has effects that a run does not show, with values that are computed", visit.line);
      Step step{.line = visit.line, .is_known = false};
      step.words = words_of_line(of_.meaning, visit.line);
      steps_.push_back(std::move(step));
    }
    for (const ir::Motion& m : run.motions_of(visit)) {
      Step step{.line = visit.line};
      if (m.kind == MotionKind::tool) {
        const bool named = m.text < run.result.strings.size();
        step.words = named ? fmt::format("tool {}", run.result.strings[m.text]) : fmt::format("tool {}", m.number);
      } else if (m.kind == MotionKind::stop) {
        step.words = m.number == 0 ? "stop" : "optional stop";
      } else if (m.kind == MotionKind::offset) {
        step.words = fmt::format("work offset {}", m.number);
      } else if (!leads_somewhere(m)) {
        continue;
      }
      step.motion = m;
      steps_.push_back(std::move(step));
    }
    return {};
  }

  const ComparedProgram& of_;
  const OpaqueLines& opaque_;
  std::vector<Step> steps_;
};

bool near(double a, double b) { return std::abs(a - b) <= kSameCoordinate; }
bool alike(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

bool same_state(const ir::Motion& a, const ir::Motion& b) {
  return a.machine_coordinates == b.machine_coordinates && a.comp == b.comp && a.coolant == b.coolant &&
         a.length_offset == b.length_offset && a.length_offset_number == b.length_offset_number &&
         a.tool_offset == b.tool_offset && a.spindle == b.spindle && a.exact_stop == b.exact_stop && a.gaps == b.gaps &&
         a.axes_unknown == b.axes_unknown && alike(a.spindle_rpm, b.spindle_rpm) &&
         alike(a.surface_speed_m_min, b.surface_speed_m_min);
}

bool same_move(const ir::Motion& a, const ir::Motion& b) {
  if (a.kind != b.kind || !same_state(a, b)) return false;
  if (a.kind == MotionKind::dwell) return alike(a.feed, b.feed);
  if (!std::ranges::equal(a.end, b.end, near)) return false;
  const bool has_center = is_arc(a.kind) || a.kind == MotionKind::thread;
  if (has_center && (a.plane != b.plane || !std::ranges::equal(a.center, b.center, near))) return false;
  return a.kind == MotionKind::rapid || (a.feed_mode == b.feed_mode && alike(a.feed, b.feed));
}

bool same_step(const Step& a, const Step& b) {
  if (a.words.empty() && b.words.empty()) return same_move(a.motion, b.motion);
  return a.words == b.words;
}

// How far the two lie apart where both consist of the same moves.
class Deviation {
 public:
  explicit Deviation(bool x_is_diameter) : x_factor_(x_is_diameter ? 0.5 : 1.0) {}

  void add(const Step& a, const Step& b) {
    paired_ = paired_ && a.words == b.words && a.motion.kind == b.motion.kind &&
              a.motion.machine_coordinates == b.motion.machine_coordinates && a.motion.gaps == b.motion.gaps &&
              a.motion.axes_unknown == b.motion.axes_unknown;
    if (!paired_ || !a.words.empty() || a.motion.kind == MotionKind::dwell) return;
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
      const double off = std::abs(a.motion.end[axis] - b.motion.end[axis]) * (axis == 0 ? x_factor_ : 1.0);
      const bool turns = axis >= static_cast<std::size_t>(ir::Axis::a) && axis <= static_cast<std::size_t>(ir::Axis::c);
      (turns ? deg_ : mm_) = std::max(turns ? deg_ : mm_, off);
    }
    if (!is_arc(a.motion.kind)) return;
    for (std::size_t i = 0; i < a.motion.center.size(); ++i)
      mm_ = std::max(mm_, std::abs(a.motion.center[i] - b.motion.center[i]));
  }
  void lost() { paired_ = false; }
  void put(MovesAnswer& into) const {
    if (!paired_) return;
    into.deviation_mm = std::max(into.deviation_mm.value_or(0.0), mm_);
    into.deviation_deg = std::max(into.deviation_deg.value_or(0.0), deg_);
  }
  [[nodiscard]] bool is_paired() const { return paired_; }

 private:
  double x_factor_;
  bool paired_ = true;
  double mm_ = 0.0;
  double deg_ = 0.0;
};

bool has_diameters(const ir::Control& control) {
  return control.semantics.power_on_diameter != ir::DiameterMode::radius;
}

std::string describe(const Step* one, const Step* other) {
  if (one == nullptr) return "nothing more";
  if (!one->words.empty()) return one->words;
  return describe_move(one->motion, other != nullptr && other->words.empty() ? other->motion : one->motion);
}

void describe_first(const Step* a, const Step* b, MovesAnswer& out) {
  out.first_line = a == nullptr ? 0 : a->line;
  out.second_line = b == nullptr ? 0 : b->line;
  out.first = describe(a, b);
  out.second = describe(b, a);
}

// Nothing is known of what a step that only one of them has does to the axes.
std::string unknown_step(const Step* a, const Step* b) {
  for (const Step* one : {a, b})
    if (one != nullptr && !one->is_known)
      return fmt::format("line {} ({}) has no equal in the other: what it does to the axes is not known", one->line,
                         one->words);
  return {};
}

// Adds what one setting of the switches shows. False: nothing more is to be looked at.
bool hold_against(const std::vector<Step>& a, const std::vector<Step>& b, bool x_is_diameter, MovesAnswer& out) {
  Deviation deviation(x_is_diameter);
  const std::size_t most = std::max(a.size(), b.size());
  for (std::size_t i = 0; i < most; ++i) {
    const Step* const one = i < a.size() ? &a[i] : nullptr;
    const Step* const other = i < b.size() ? &b[i] : nullptr;
    const bool same = one != nullptr && other != nullptr && same_step(*one, *other);
    if (!same && out.equal) {
      if (std::string why = unknown_step(one, other); !why.empty()) {
        out = {.why = std::move(why)};
        return false;
      }
      describe_first(one, other, out);
      out.equal = false;
    }
    if (one == nullptr || other == nullptr)
      deviation.lost();
    else
      deviation.add(*one, *other);
    if (out.equal) out.moves += one != nullptr && one->words.empty() ? 1U : 0U;
    if (!out.equal && !deviation.is_paired()) break;
  }
  deviation.put(out);
  if (deviation.is_paired()) return true;
  out.deviation_mm.reset();
  out.deviation_deg.reset();
  return false;
}

std::string reason_of(const ComparedProgram& one, const OpaqueLines& opaque) {
  if (!one.meaning.not_understood.empty()) return one.meaning.not_understood;
  if (ir::is_subprogram(one.program, ir::section_at(one.program, 0)))
    return "it is a subprogram, which only its caller can run";
  const auto is_head = [](const ir::Statement& s) { return s.kind == StatementKind::procedure; };
  if (std::ranges::any_of(one.program.statements, is_head)) return "it has parameters, which only its caller gives";
  return opaque.elsewhere();
}

}  // namespace

MovesAnswer compare_moves(const ComparedProgram& first, const ComparedProgram& second,
                          const std::function<std::string()>& used_up) {
  const auto not_compared = [](std::string_view which, const std::string& why) {
    return MovesAnswer{.why = fmt::format("{}: {}", which, why)};
  };
  const OpaqueLines first_lines(first);
  const OpaqueLines second_lines(second);
  if (const std::string why = reason_of(first, first_lines); !why.empty()) return not_compared("the first", why);
  if (const std::string why = reason_of(second, second_lines); !why.empty()) return not_compared("the second", why);
  if (has_diameters(first.control) != has_diameters(second.control))
    return {.why = "one is written in diameters, the other in radii"};
  std::set<std::uint8_t> levels = skip_levels(first.program);
  levels.merge(skip_levels(second.program));
  if (levels.size() > 1) return {.why = "they have block skip of several levels"};
  std::vector<std::uint32_t> settings = {0};
  if (!levels.empty()) settings.push_back(1U << *levels.begin());
  MovesAnswer out{.why = {}, .equal = true};
  for (const std::uint32_t switches : settings) {
    Steps a(first, first_lines);
    Steps b(second, second_lines);
    if (const std::string why = a.run(switches, used_up); !why.empty()) return not_compared("the first", why);
    if (const std::string why = b.run(switches, used_up); !why.empty()) return not_compared("the second", why);
    if (!hold_against(a.all(), b.all(), has_diameters(first.control), out)) break;
  }
  return out;
}

}  // namespace dripfeed::compile
