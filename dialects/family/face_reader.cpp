// polar ... end: the face of the work, where x is as ever and y a length across it; cylinder diameter LENGTH ... end: a
// cylinder, where y is a length on its circumference. c turns for y. Controls count from where c stands, or on its own
// scale: it is brought to 0 before.
#include <algorithm>
#include <array>
#include <utility>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

namespace {

constexpr auto kOnFace = std::to_array<StepKind>(
    {StepKind::cut,          StepKind::arc_cw,       StepKind::arc_ccw,    StepKind::feed,       StepKind::coolant,
     StepKind::dwell,        StepKind::message,      StepKind::let,        StepKind::set,        StepKind::for_begin,
     StepKind::for_end,      StepKind::while_begin,  StepKind::while_end,  StepKind::if_begin,   StepKind::if_else,
     StepKind::if_end,       StepKind::for_in_begin, StepKind::for_in_end, StepKind::compensate, StepKind::polar_end,
     StepKind::cylinder_end, StepKind::offset});
// Which leave out what they hold, or begin it elsewhere.
constexpr auto kBranching =
    std::to_array<StepKind>({StepKind::for_begin, StepKind::for_in_begin, StepKind::while_begin, StepKind::if_begin,
                             StepKind::arc_cw, StepKind::arc_ccw, StepKind::polar_end, StepKind::cylinder_end});

bool holds(std::span<const StepKind> kinds, StepKind kind) { return std::ranges::find(kinds, kind) != kinds.end(); }

}  // namespace

void BodyReader::polar() { open_face(StepKind::polar_begin, ir::ExpressionId::none); }

void BodyReader::cylinder() {
  ir::ExpressionId diameter = ir::ExpressionId::none;
  if (cursor_.expect_word("diameter")) diameter = expressions_.value_of(kLength).id;
  open_face(StepKind::cylinder_begin, diameter);
}

void BodyReader::open_face(StepKind kind, ir::ExpressionId diameter) {
  if (family_.machine == ir::MachineKind::mill)
    cursor_.syntax(verb_, "only a lathe has a work that turns for y: 'machine lathe'");
  else if (face_)
    cursor_.syntax(verb_, "a face or cylinder inside of another");
  else if (is_subprogram_)
    cursor_.syntax(verb_, "a subprogram holds no face and no cylinder");
  else if (compensation_waits_ || compensated_)
    cursor_.syntax(verb_, "compensation begins and ends inside of a face: compensate off, and a move, before it");
  if (!cursor_.line_failed()) {
    Step turn = step(StepKind::rapid);
    word(turn, ir::Address::c, {.id = number(0.0), .dimension = kAngle});
    add(std::move(turn));
    Step out = step(kind);
    out.values[0] = diameter;
    add(std::move(out));
  }
  open_.push_back({kind, verb_, line_});
  scope_.open();
  face_ = kind;
  on_face_ = false;
}

void BodyReader::close_face() {
  const bool is_polar = face_ == StepKind::polar_begin;
  if (compensation_waits_ || compensated_)
    cursor_.syntax(verb_, "compensation begins and ends inside of a face: compensate off, and a move, before its end");
  add(step(is_polar ? StepKind::polar_end : StepKind::cylinder_end));
  face_.reset();
}

bool BodyReader::may_stand_on_face(StepKind kind) {
  if (kind == StepKind::rapid)
    cursor_.syntax(verb_, "controls make no rapid move on a face or a cylinder: cut, or end it before");
  else if (!holds(kOnFace, kind))
    cursor_.syntax(verb_, "on a face or a cylinder stand cuts, loops, if, let, set, feed, coolant, dwell and message");
  else if (face_ == StepKind::cylinder_begin &&
           (kind == StepKind::arc_cw || kind == StepKind::arc_ccw || kind == StepKind::compensate))
    cursor_.syntax(verb_, "a cylinder has straight cuts and curves: 'cut along' for an arc, and no compensation");
  return !cursor_.line_failed();
}

// From where y is known on every control.
void BodyReader::enter_face(const Step& cut) {
  if (cut.kind != StepKind::cut && !holds(kBranching, cut.kind)) return;
  const auto begin = family_.words.begin() + cut.first_word;
  on_face_ = cut.kind == StepKind::cut && std::any_of(begin, begin + cut.word_count, [](const StepWord& one) {
               return one.address == ir::Address::y && !one.is_step;
             });
  if (!on_face_)
    cursor_.syntax(verb_, "the first cut on a face or a cylinder names y, and stands before loops and arcs");
}

// After a face x and c stand where its last cut left them, which only the control knows.
void BodyReader::check_increments() {
  const auto is_face = [](const Step& one) {
    return one.kind == StepKind::polar_begin || one.kind == StepKind::cylinder_begin;
  };
  if (std::ranges::none_of(steps_, is_face)) return;
  bool inside = false;
  for (const Step& one : steps_) {
    if (is_face(one) || one.kind == StepKind::polar_end || one.kind == StepKind::cylinder_end) inside = is_face(one);
    const auto begin = family_.words.begin() + one.first_word;
    const bool steps = std::any_of(begin, begin + one.word_count, [](const StepWord& word) {
      return word.is_step && (word.address == ir::Address::x || word.address == ir::Address::c);
    });
    if (steps && !inside)
      cursor_.report(text::DiagnosticId::family_syntax, one.span,
                     {"where x and c stand after a face or a cylinder the control alone knows: name their places"});
  }
}

}  // namespace dripfeed::family
