// One function a verb, found by a table.
#include "dialects/family/body_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/naming.h"
#include "dialects/ir/motion.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

struct AxisRow {
  std::string_view name;
  ir::Address address;
  Dimension dimension;
  bool on_lathe;
};
constexpr auto kAxes = std::to_array<AxisRow>({
    {"x", ir::Address::x, kLength, true},
    {"y", ir::Address::y, kLength, false},
    {"z", ir::Address::z, kLength, true},
    {"a", ir::Address::a, kAngle, false},
    {"b", ir::Address::b, kAngle, false},
    {"c", ir::Address::c, kAngle, true},
});
constexpr auto kCenters = std::to_array<AxisRow>({
    {"i", ir::Address::i, kLength, true},
    {"j", ir::Address::j, kLength, false},
    {"k", ir::Address::k, kLength, true},
});

const AxisRow* find_axis(std::span<const AxisRow> rows, std::string_view name) {
  const auto row = std::ranges::find(rows, name, &AxisRow::name);
  return row == rows.end() ? nullptr : &*row;
}

}  // namespace

std::span<const BodyReader::VerbRow> BodyReader::verb_rows() {
  static constexpr auto kVerbs = std::to_array<VerbRow>({
      {"work", &BodyReader::work_offset},
      {"tool", &BodyReader::tool},
      {"spindle", &BodyReader::spindle},
      {"coolant", &BodyReader::coolant},
      {"compensate", &BodyReader::compensate},
      {"feed", &BodyReader::feed},
      {"rapid", &BodyReader::rapid},
      {"cut", &BodyReader::cut},
      {"arc", &BodyReader::arc},
      {"thread", &BodyReader::thread},
      {"groove", &BodyReader::groove},
      {"retract", &BodyReader::retract},
      {"drill", &BodyReader::drill},
      {"ream", &BodyReader::ream},
      {"bore", &BodyReader::bore},
      {"tap", &BodyReader::tap},
      {"at", &BodyReader::hole},
      {"engrave", &BodyReader::engrave},
      {"face", &BodyReader::face},
      {"pocket", &BodyReader::pocket},
      {"rough", &BodyReader::rough},
      {"offset", &BodyReader::offset},
      {"profile", &BodyReader::profile},
      {"for", &BodyReader::for_loop},
      {"while", &BodyReader::while_loop},
      {"if", &BodyReader::if_block},
      {"else", &BodyReader::else_block},
      {"end", &BodyReader::end},
      {"let", &BodyReader::let},
      {"set", &BodyReader::set},
      {"call", &BodyReader::call},
      {"message", &BodyReader::message},
      {"dwell", &BodyReader::dwell},
      {"stop", &BodyReader::stop},
      {"optional", &BodyReader::optional_stop},
      {"skip", &BodyReader::skip},
      {"plane", &BodyReader::plane},
      {"mirror", &BodyReader::mirror},
      {"repeat", &BodyReader::repeat},
      {"native", &BodyReader::native},
      {"polar", &BodyReader::polar},
      {"cylinder", &BodyReader::cylinder},
  });
  return kVerbs;
}

const BodyReader::VerbRow* BodyReader::find_verb(std::string_view word) {
  const std::span<const VerbRow> rows = verb_rows();
  const auto row = std::ranges::find(rows, word, &VerbRow::word);
  return row == rows.end() ? nullptr : &*row;
}

std::vector<std::string_view> BodyReader::verbs() {
  std::vector<std::string_view> out;
  for (const VerbRow& row : verb_rows()) out.push_back(row.word);
  return out;
}

void BodyReader::read_subprogram(text::Span head) {
  is_subprogram_ = true;
  verb_ = head;
  read();
}

void BodyReader::read() {
  const text::Span head = verb_;
  while (!ended_ && !cursor_.at_end()) {
    if (cursor_.at_line_end()) {
      cursor_.advance();
      continue;
    }
    if (is_subprogram_ && (cursor_.at_word("program") || cursor_.at_word("sub") || cursor_.at_word("function")))
      return cursor_.syntax(head, "this subprogram has no 'end'");
    verb_ = cursor_.peek().span;
    line_ = cursor_.peek().line;
    if (const VerbRow* row = find_verb(cursor_.word())) {
      cursor_.advance();
      (this->*row->read)();
    } else {
      cursor_.expected_one_of("a verb such as rapid, cut, feed, for or end", verbs());
    }
    // The line of a subprogram's `end` is its declaration's.
    if (!ended_ || !is_subprogram_) cursor_.finish_line();
  }
  if (ended_ && corner_waits_)
    cursor_.syntax(verb_, "after a chamfer or rounding stands the cut or arc that it leads to");
  if (ended_) {
    if (!is_subprogram_) warn_of_reversed_milling();
    if (!is_subprogram_) check_increments();
    return;
  }
  if (open_.empty()) {
    cursor_.syntax(is_subprogram_ ? head : cursor_.peek().span,
                   is_subprogram_ ? "this subprogram has no 'end'" : "the program has no 'end'");
  } else {
    cursor_.syntax(open_.back().span, "this block has no 'end'");
  }
}

Step BodyReader::step(StepKind kind) const {
  Step out;
  out.kind = kind;
  out.line = line_;
  out.first_word = static_cast<std::uint32_t>(family_.words.size());
  return out;
}

void BodyReader::add(Step step) {
  if (cursor_.line_failed() || !may_stand_here(step.kind)) return;
  if (face_ && !on_face_) enter_face(step);
  if (cursor_.line_failed()) return;
  const bool cuts = step.kind == StepKind::cut || step.kind == StepKind::arc_cw || step.kind == StepKind::arc_ccw;
  if (std::exchange(corner_waits_, false) && (!cuts || skip_level_ != 0))
    return cursor_.syntax(verb_, "after a chamfer or rounding stands the cut or arc that it leads to");
  corner_waits_ = takes_corner(step);
  step.span = {verb_.begin, cursor_.last_span().end};
  step.skip_level = skip_level_;
  steps_.push_back(std::move(step));
}

bool BodyReader::at_axis() const {
  return cursor_.peek().kind == LexemeKind::word && find_axis(kAxes, cursor_.word()) != nullptr;
}

void BodyReader::word(Step& step, ir::Address address, Typed value) {
  if (cursor_.line_failed()) return;
  family_.words.push_back({address, value.id});
  ++step.word_count;
}

// At least one axis, none twice, none that the machine has not.
void BodyReader::axis_words(Step& step) {
  if (!at_axis()) return cursor_.expected("an axis");
  while (!cursor_.line_failed() && at_axis()) {
    const AxisRow& axis = *find_axis(kAxes, cursor_.word());
    const auto begin = family_.words.begin() + step.first_word;
    if (std::ranges::find(begin, family_.words.end(), axis.address, &StepWord::address) != family_.words.end()) {
      return cursor_.syntax(cursor_.peek().span, fmt::format("{} is given twice", axis.name));
    }
    if (face_ && axis.address == ir::Address::c)
      return cursor_.syntax(cursor_.peek().span, "y stands for the turning of c here");
    if (family_.machine == ir::MachineKind::lathe && !axis.on_lathe && !(face_ && axis.address == ir::Address::y)) {
      return cursor_.syntax(cursor_.peek().span, fmt::format("a lathe has no {} axis", axis.name));
    }
    cursor_.advance();
    const bool is_step = cursor_.accept_word("by");
    word(step, axis.address, expressions_.value_of(axis.dimension));
    if (!cursor_.line_failed()) family_.words.back().is_step = is_step;
  }
}

// Whether there is a feed here; a fault otherwise, but in a subprogram, where it is the caller's.
bool BodyReader::may_cut() {
  if (has_feed_) return true;
  if (!is_subprogram_) cursor_.report(text::DiagnosticId::no_feed, verb_, {});
  needs_feed_ = is_subprogram_;
  return is_subprogram_;
}

bool BodyReader::takes_corner(const Step& step) const {
  const auto begin = family_.words.begin() + step.first_word;
  return step.kind == StepKind::cut && std::any_of(begin, begin + step.word_count, [](const StepWord& one) {
           return one.address == ir::Address::chamfer || one.address == ir::Address::rounding;
         });
}

void BodyReader::move(Step out) {
  if (out.kind != StepKind::rapid && !may_cut()) return;
  compensation_waits_ = false;
  axis_words(out);
  if (out.kind == StepKind::cut) corner(out);
  add(std::move(out));
}

// chamfer LENGTH or rounding LENGTH: of the corner between this cut and the next one.
void BodyReader::corner(Step& step) {
  const bool is_round = cursor_.at_word("rounding");
  if (cursor_.line_failed() || (!is_round && !cursor_.at_word("chamfer"))) return;
  if (skip_level_ != 0) return cursor_.syntax(verb_, "a cut that may be skipped has no corner");
  cursor_.advance();
  word(step, is_round ? ir::Address::rounding : ir::Address::chamfer, expressions_.value_of(kLength));
}

void BodyReader::rapid() { move(step(StepKind::rapid)); }
void BodyReader::cut() { cursor_.accept_word("along") ? cut_along() : move(step(StepKind::cut)); }

void BodyReader::arc() {
  const bool clockwise = cursor_.at_word("cw");
  if (!cursor_.accept_word("cw") && !cursor_.accept_word("ccw")) return cursor_.expected("cw or ccw");
  if (!may_cut()) return;
  if (std::exchange(compensation_waits_, false))
    return cursor_.syntax(verb_, "compensation begins and ends with a straight move: rapid or cut before this arc");
  Step out = step(clockwise ? StepKind::arc_cw : StepKind::arc_ccw);
  axis_words(out);
  if (cursor_.line_failed()) return;
  if (cursor_.accept_word("radius")) {
    word(out, ir::Address::arc_radius, expressions_.value_of(kLength));
    return add(std::move(out));
  }
  if (!cursor_.accept_word("center")) return cursor_.expected("radius or center");
  const std::uint32_t axes = out.word_count;
  while (!cursor_.line_failed() && cursor_.peek().kind == LexemeKind::word) {
    const AxisRow* center = find_axis(kCenters, cursor_.word());
    if (center == nullptr) break;
    cursor_.advance();
    word(out, center->address, expressions_.value_of(kLength));
  }
  if (out.word_count == axes) cursor_.expected("i, j or k");
  add(std::move(out));
}

// thread AXIS VALUE ... pitch LENGTH [depth ...]
void BodyReader::thread() {
  if (family_.machine == ir::MachineKind::mill)
    return cursor_.syntax(
        verb_, "'thread' follows the turning spindle of a lathe: on a mill a thread is tapped, or milled by arcs");
  if (std::exchange(compensation_waits_, false))
    return cursor_.syntax(verb_, "compensation begins and ends with a straight move: rapid or cut before this thread");
  if (surface_speed_)
    return cursor_.syntax(verb_, "a thread needs a spindle that keeps its speed: spindle in rpm before it");
  Step out = step(StepKind::thread);
  axis_words(out);
  const auto begin = family_.words.begin() + out.first_word;
  const bool turns =
      std::any_of(begin, family_.words.end(), [](const StepWord& one) { return ir::is_rotary_axis(one.address); });
  if (turns) return cursor_.syntax(verb_, "a thread is cut along x and z");
  if (cursor_.line_failed() || !cursor_.expect_word("pitch")) return;
  const Typed pitch = expressions_.value_of(kLength);
  if (!cursor_.line_failed() && cursor_.at_word("depth")) return thread_passes(out, pitch.id);
  word(out, ir::Address::f, pitch);
  add(std::move(out));
}

// One rapid a part, in order: out of the work first, away from it then.
void BodyReader::retract() {
  do {
    move(step(StepKind::rapid));
  } while (!cursor_.line_failed() && cursor_.accept_word("then"));
}

// skip [LEVEL] verb ...: the operator decides whether the control executes it.
void BodyReader::skip() {
  static constexpr std::array kVerbs = {
      std::string_view("rapid"),   std::string_view("cut"),     std::string_view("arc"),
      std::string_view("retract"), std::string_view("coolant"), std::string_view("message"),
      std::string_view("dwell"),   std::string_view("stop"),    std::string_view("optional")};
  constexpr std::int32_t kLevels = 8;  // as many as every control has
  skip_level_ = 1;
  if (cursor_.peek().kind == LexemeKind::number) {
    const text::Span at = cursor_.peek().span;
    const std::int32_t level = cursor_.expect_integer("the level of block skip");
    if (level < 1 || level > kLevels) cursor_.syntax(at, fmt::format("block skip has the levels 1 to {}", kLevels));
    skip_level_ = static_cast<std::uint8_t>(level);
  }
  const VerbRow* row = cursor_.line_failed() ? nullptr : find_verb(cursor_.word());
  if (!cursor_.line_failed() && open_drills_ > 0)
    cursor_.syntax(verb_, "block skip does not stand among holes: the first hole states the cycle");
  else if (row == nullptr || std::ranges::find(kVerbs, row->word) == kVerbs.end())
    cursor_.expected_one_of("what may be skipped: a move, coolant, message, dwell or stop", kVerbs);
  else if (compensation_waits_)
    cursor_.syntax(verb_, "compensation begins and ends with a move that is not skipped");
  if (!cursor_.line_failed() && row != nullptr) {
    cursor_.advance();
    (this->*row->read)();
  }
  skip_level_ = 0;
}

}  // namespace dripfeed::family
