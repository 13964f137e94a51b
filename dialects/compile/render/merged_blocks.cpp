// Groups are found along the run, so that what a block means is never guessed from its words.
#include "dialects/compile/render/merged_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/translate/inline_moves.h"
#include "dialects/compile/translate/recorded_run.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

using ir::Function;
using ir::Motion;
using ir::MotionKind;
using ir::StatementKind;

constexpr std::size_t kLongestGroup = 200;  // blocks: the time stays linear in the text
constexpr double kMostOfACircle = 0.98 * 2.0 * std::numbers::pi;
constexpr double kSameNumber = 1e-9;
constexpr double kInch_mm = 25.4;
constexpr unsigned kLinearAxes = 7;  // x, y and z

bool is_arc(MotionKind kind) { return kind == MotionKind::arc_cw || kind == MotionKind::arc_ccw; }

// All that both must have alike, but for the places.
bool goes_on(const Motion& a, const Motion& b) {
  return a.kind == b.kind && a.plane == b.plane && a.feed_mode == b.feed_mode && a.length_offset == b.length_offset &&
         a.exact_stop == b.exact_stop && a.feed == b.feed && a.spindle_rpm == b.spindle_rpm &&
         a.surface_speed_m_min == b.surface_speed_m_min && a.spindle == b.spindle && a.coolant == b.coolant &&
         a.gaps == b.gaps && a.tool_offset == b.tool_offset && a.length_offset_number == b.length_offset_number &&
         a.end == b.start;
}

// Known from end to end, in the work offset, without compensation; of axes only x, y and z move.
bool may_merge(const Motion& m) {
  const bool straight = m.kind == MotionKind::linear;
  if (!straight && !is_arc(m.kind)) return false;
  return m.comp == ir::CompSide::off && !m.machine_coordinates && (m.axes_unknown & kLinearAxes) == 0 &&
         std::equal(m.start.begin() + 3, m.start.end(), m.end.begin() + 3);
}

using Place = std::array<double, 3>;
Place place(const std::array<double, ir::kAxisCount>& at) { return {at[0], at[1], at[2]}; }
Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// What is found of a line of the text.
struct Line {
  const ir::Block* block = nullptr;  // axis words, and at most the code of its motion
  bool has_code = false;
  const Motion* motion = nullptr;  // the one that it makes, the only time that it runs
  std::size_t order = 0;           // of its visit
};

class Merging {
 public:
  Merging(const text::Source& source, const ir::Control& control, ProgramLibrary& library, const MergeWishes& wishes)
      : source_(source),
        control_(control),
        library_(library),
        wishes_(wishes),
        dialect_(*find_dialect(control.dialect)) {}

  MergedBlocks run() {
    out_.text = source_.text();
    const ir::ReadResult read = dialect_.read(source_, control_);
    program_ = &read.program;
    if (text::has_error(read.diagnostics)) return refuse("the program has faults");
    if (!is_plain()) return refuse("it has jumps, loops or calls: only plain blocks are merged");
    const RecordedRun before = run_of(read.program);
    if (!before.is_whole || before.result.ended != interpreter::Ended::end)
      return refuse("its run does not reach its end");
    find_lines(before);
    for (std::uint32_t line = 1; line < lines_.size();) line = group_from(line);
    if (out_.groups.empty()) return std::move(out_);
    write();
    if (std::string fault = fault_of(before); !fault.empty()) return refuse(std::move(fault));
    return std::move(out_);
  }

 private:
  MergedBlocks refuse(std::string why) {
    out_ = {};
    out_.text = source_.text();
    out_.obstacle = std::move(why);
    return std::move(out_);
  }

  [[nodiscard]] bool is_plain() const {
    return program_->sections.size() <= 1 && std::ranges::all_of(program_->statements, [](const ir::Statement& s) {
             return s.kind == StatementKind::empty || s.kind == StatementKind::block ||
                    s.kind == StatementKind::message || s.kind == StatementKind::declaration ||
                    s.kind == StatementKind::program_end;
           });
  }

  [[nodiscard]] RecordedRun run_of(const ir::Program& program) {
    interpreter::RunOptions options;
    options.limits = run_limits({});
    return record(program, control_, library_, options, {}, {});
  }

  void find_lines(const RecordedRun& run) {
    lines_.assign(source_.line_count() + 2, {});
    std::vector<std::uint32_t> statements(lines_.size(), 0);
    for (const ir::Statement& s : program_->statements) {
      if (s.line >= lines_.size()) continue;
      ++statements[s.line];
      if (s.kind == StatementKind::block && s.skip_level == 0 && !has_comment(s)) take_block(s);
    }
    for (std::size_t i = 0; i < run.visits.size(); ++i) {
      const Visit& visit = run.visits[i];
      if (visit.line >= lines_.size()) continue;
      Line& line = lines_[visit.line];
      const bool is_one = line.motion == nullptr && visit.motion_count == 1 && statements[visit.line] == 1;
      line.motion = is_one ? &run.motions[visit.first_motion] : nullptr;
      if (!is_one || line.motion->place.program != 0 || !may_merge(*line.motion)) line.block = nullptr;
      line.order = i;
    }
  }

  [[nodiscard]] bool has_comment(const ir::Statement& s) const {
    for (std::uint32_t t = s.tokens.first; t < s.tokens.last; ++t)
      if (program_->tokens[t].kind == ir::TokenKind::comment) return true;
    return false;
  }

  void take_block(const ir::Statement& s) {
    const ir::Block& block = program_->blocks[s.payload];
    const auto codes = program_->codes_of(block);
    const bool moves = std::ranges::all_of(codes, [](const ir::Code& c) {
      return c.number == ir::ExpressionId::none &&
             (c.function == Function::linear || c.function == Function::arc_cw || c.function == Function::arc_ccw);
    });
    const bool is_known = std::ranges::all_of(program_->words_of(block), [&](const ir::Word& w) {
      const bool is_place = w.address >= ir::Address::x && w.address <= ir::Address::z;
      const bool is_center = w.address >= ir::Address::i && w.address <= ir::Address::k;
      return (is_place || is_center) && w.mode != ir::WordMode::incremental && number_of(w).has_value();
    });
    if (!moves || !is_known || block.rest_level != 0) return;
    lines_[s.line].block = &block;
    lines_[s.line].has_code = !codes.empty();
  }

  [[nodiscard]] std::optional<double> number_of(const ir::Word& w) const {
    if (w.value == ir::ExpressionId::none) return {};
    const ir::Expression& e = program_->at(w.value);
    if (e.op == ir::Operator::constant) return e.value;
    if (e.op != ir::Operator::negate || program_->at(e.a).op != ir::Operator::constant) return {};
    return -program_->at(e.a).value;
  }

  // Lines that follow each other in the text and in the run, each a move like the one before.
  [[nodiscard]] bool follows(std::uint32_t line) const {
    const Line &a = lines_[line - 1], &b = lines_[line];
    return a.block != nullptr && b.block != nullptr && a.motion != nullptr && b.motion != nullptr &&
           b.order == a.order + 1 && goes_on(*a.motion, *b.motion);
  }

  // The line after the longest group that begins here, or the next one.
  std::uint32_t group_from(std::uint32_t first) {
    const Line& begin = lines_[first];
    const bool wanted = begin.block != nullptr && begin.motion != nullptr &&
                        (is_arc(begin.motion->kind) ? wishes_.arcs : wishes_.lines);
    if (!wanted) return first + 1;
    MergedGroup best;
    for (std::uint32_t last = first + 1; last < lines_.size() && last - first < kLongestGroup && follows(last);
         ++last) {
      const auto off = is_arc(begin.motion->kind) ? arcs_off(first, last) : chain_off(first, last);
      if (!off) break;
      if (says_its_end(first, last))
        best = {.first_line = first, .last_line = last, .is_arc = is_arc(begin.motion->kind), .off_mm = *off};
    }
    if (best.last_line == 0) return first + 1;
    out_.groups.push_back(best);
    return best.last_line + 1;
  }

  // How far the corners lie off the line from the start of the first move to the end of the last; nothing: too far, or
  // the chain turns back.
  [[nodiscard]] std::optional<double> chain_off(std::uint32_t first, std::uint32_t last) const {
    const Place from = place(lines_[first].motion->start);
    const Place along = minus(place(lines_[last].motion->end), from);
    const double length = std::sqrt(dot(along, along));
    if (!(length > 0.0)) return {};
    double off = 0.0;
    for (std::uint32_t n = first; n <= last; ++n) {
      const Motion& m = *lines_[n].motion;
      if (dot(minus(place(m.end), place(m.start)), along) < 0.0) return {};
      const Place away = minus(place(m.end), from);
      const double on = dot(away, along) / length;
      if (n != last) off = std::max(off, std::sqrt(std::max(0.0, dot(away, away) - on * on)));
    }
    return off <= wishes_.tolerance_mm ? std::optional(off) : std::nullopt;
  }

  // The two axes of its plane, in the order in which a turn is counter-clockwise.
  static std::array<std::size_t, 2> axes_of(const Motion& m) {
    if (m.plane == ir::Plane::xy) return {0, 1};
    if (m.plane == ir::Plane::zx) return {2, 0};
    return {1, 2};
  }

  struct Turn {
    double angle = 0.0;  // swept
    double radius = 0.0;
    std::array<double, 2> center{};
  };
  static Turn turn_of(const Motion& m) {
    const auto [a, b] = axes_of(m);
    Turn out;
    out.center = {m.start[a] + m.center[a], m.start[b] + m.center[b]};
    out.radius = std::hypot(m.center[a], m.center[b]);
    const double begin = std::atan2(-m.center[b], -m.center[a]);
    const double end = std::atan2(m.end[b] - out.center[1], m.end[a] - out.center[0]);
    out.angle = m.kind == MotionKind::arc_ccw ? end - begin : begin - end;
    if (out.angle <= kSameNumber) out.angle += 2.0 * std::numbers::pi;
    return out;
  }

  // How far the arcs lie off the first one's circle; nothing: too far, a helix, or more than a turn.
  [[nodiscard]] std::optional<double> arcs_off(std::uint32_t first, std::uint32_t last) const {
    if (control_.kind != ir::MachineKind::mill) return {};  // x may be a diameter
    const Turn circle = turn_of(*lines_[first].motion);
    double off = kRounded_mm;
    double angle = 0.0;
    for (std::uint32_t n = first; n <= last; ++n) {
      const Motion& m = *lines_[n].motion;
      const auto [a, b] = axes_of(m);
      const std::size_t third = 3 - a - b;
      if (m.start[third] != m.end[third]) return {};
      const Turn turn = turn_of(m);
      angle += turn.angle;
      off = std::max(off, std::hypot(turn.center[0] - circle.center[0], turn.center[1] - circle.center[1]) +
                              std::fabs(turn.radius - circle.radius));
      off = std::max(off,
                     std::fabs(std::hypot(m.end[a] - circle.center[0], m.end[b] - circle.center[1]) - circle.radius));
    }
    return off <= wishes_.tolerance_mm && angle < kMostOfACircle ? std::optional(off) : std::nullopt;
  }

  // The last block alone must lead to the same end: it names, as they are, all axes that the group moves, and the code
  // of the motion where one of the others has it.
  [[nodiscard]] bool says_its_end(std::uint32_t first, std::uint32_t last) const {
    const Line& end = lines_[last];
    const Motion& m = *end.motion;
    std::uint16_t named = 0;
    bool has_center = false;
    for (const ir::Word& w : program_->words_of(*end.block)) {
      const double number = number_of(w).value_or(0.0);
      const auto is = [number](double wanted) {
        return std::fabs(number - wanted) <= kSameNumber || std::fabs(number * kInch_mm - wanted) <= kSameNumber;
      };
      if (w.address >= ir::Address::x) {
        const auto axis = static_cast<std::size_t>(w.address) - static_cast<std::size_t>(ir::Address::x);
        if (!is(m.end[axis])) return false;
        named |= static_cast<std::uint16_t>(1U << axis);
      } else {
        const auto axis = static_cast<std::size_t>(w.address) - static_cast<std::size_t>(ir::Address::i);
        if (std::fabs(number - m.center[axis]) > kSameNumber) return false;  // in millimeters, from the start
        has_center = true;
      }
    }
    if (is_arc(m.kind) != has_center) return false;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (lines_[first].motion->start[axis] != m.end[axis] && (named >> axis & 1U) == 0) return false;
    for (std::uint32_t n = first; n < last; ++n)
      if (lines_[n].has_code && !end.has_code) return false;
    return true;
  }

  void write() {
    auto group = out_.groups.begin();
    out_.text.clear();
    for (std::uint32_t n = 1; n <= source_.line_count(); ++n) {
      while (group != out_.groups.end() && group->last_line < n) ++group;
      const bool inside = group != out_.groups.end() && group->first_line <= n;
      if (inside && n < group->last_line) continue;
      const std::string_view bytes = whole_line(n);
      if (bytes.empty()) continue;
      out_.text += inside && group->is_arc ? arc_of(*group, bytes) : std::string(bytes);
      out_.origin_lines.push_back(n);
      if (inside) out_.most_mm = std::max(out_.most_mm, group->off_mm);
    }
  }

  // With its end.
  [[nodiscard]] std::string_view whole_line(std::uint32_t number) const {
    const std::string_view text = source_.text();
    const auto begin = [&](std::uint32_t n) {
      return n > source_.line_count() ? text.size() : static_cast<std::size_t>(source_.line(n).data() - text.data());
    };
    return text.substr(begin(number), begin(number + 1) - begin(number));
  }

  // The group's last block with the center as it lies from the start of the first arc.
  [[nodiscard]] std::string arc_of(const MergedGroup& group, std::string_view bytes) const {
    const auto offset = static_cast<std::uint32_t>(bytes.data() - source_.text().data());
    const Motion& first = *lines_[group.first_line].motion;
    std::string out(bytes);
    const auto words = program_->words_of(*lines_[group.last_line].block);
    for (std::size_t i = words.size(); i-- > 0;) {
      const ir::Word& w = words[i];
      if (w.address < ir::Address::i || w.address > ir::Address::k) continue;
      const auto axis = static_cast<std::size_t>(w.address) - static_cast<std::size_t>(ir::Address::i);
      const std::string_view written = w.span.in(source_.text());
      const std::size_t number = written.find_first_of("+-.0123456789");
      std::string fresh = text::format_fixed(first.center[axis], kDecimals);
      out.replace(w.span.begin - offset + number, written.size() - number, fresh);
    }
    return out;
  }

  // Empty, or why the new text must not be used: it is run, and compared with the old run.
  std::string fault_of(const RecordedRun& before) {
    const text::Source made(source_.name(), out_.text);
    const ir::ReadResult read = dialect_.read(made, control_);
    if (text::has_error(read.diagnostics)) return "the control would object to the shorter program";
    const RecordedRun after = run_of(read.program);
    if (after.result.ended != interpreter::Ended::end) return "the shorter program would end differently";
    std::size_t n = 0;
    auto group = out_.groups.begin();
    for (const Motion& m : before.motions) {
      const bool inside = group != out_.groups.end() && m.place.program == 0 && group->first_line <= m.place.line;
      if (inside && m.place.line < group->last_line) continue;
      if (n == after.motions.size()) return "the shorter program would make fewer moves";
      const Motion& made_move = after.motions[n++];
      if (!is_like(m, made_move, inside ? wishes_.tolerance_mm + 2.0 * kRounded_mm : 0.0))
        return fmt::format("the shorter program would make other moves (line {})", m.place.line);
      if (inside) ++group;
    }
    return n == after.motions.size() ? std::string() : "the shorter program would make more moves";
  }

  // `inside`: the end of a group, which begins and turns elsewhere.
  static bool is_like(const Motion& a, const Motion& b, double turned) {
    if (a.kind != b.kind || a.plane != b.plane || a.feed != b.feed || a.feed_mode != b.feed_mode || a.end != b.end ||
        a.spindle != b.spindle || a.spindle_rpm != b.spindle_rpm || a.coolant != b.coolant || a.comp != b.comp ||
        a.number != b.number || a.tool_offset != b.tool_offset || a.exact_stop != b.exact_stop)
      return false;
    if (turned == 0.0) return a.start == b.start && a.center == b.center;
    if (!is_arc(a.kind)) return true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (std::fabs(a.start[axis] + a.center[axis] - b.start[axis] - b.center[axis]) > turned) return false;
    return true;
  }

  static constexpr int kDecimals = 4;
  static constexpr double kRounded_mm = 1e-4;  // of a center, in its plane

  const text::Source& source_;
  const ir::Control& control_;
  ProgramLibrary& library_;
  const MergeWishes& wishes_;
  const Dialect& dialect_;
  const ir::Program* program_ = nullptr;
  std::vector<Line> lines_;  // by number
  MergedBlocks out_;
};

}  // namespace

MergedBlocks merge_blocks(const text::Source& source, const ir::Control& control, ProgramLibrary& library,
                          const MergeWishes& wishes) {
  return Merging(source, control, library, wishes).run();
}

}  // namespace dripfeed::compile
