// The verbs of drilling cycles: a line that says the cycle, then its holes, then `end`. Among the holes stands nothing
// that moves or switches, because on the control the cycle is in effect there.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

namespace {

using ir::Address;
using ir::DrillCycle;

constexpr std::array kAmongHoles = {
    StepKind::hole,        StepKind::for_begin, StepKind::for_end,  StepKind::for_in_begin, StepKind::for_in_end,
    StepKind::while_begin, StepKind::while_end, StepKind::if_begin, StepKind::if_else,      StepKind::if_end,
    StepKind::let,         StepKind::set,       StepKind::drill_end};

}  // namespace

void BodyReader::drill() { open_drill(DrillCycle::drill); }
void BodyReader::ream() { open_drill(DrillCycle::feed_out); }
void BodyReader::bore() { open_drill(DrillCycle::stop_out); }
void BodyReader::tap() { open_drill(DrillCycle::tap_right); }

void BodyReader::level(Step& step, std::string_view name, Address address) {
  if (cursor_.line_failed() || !cursor_.expect_word(name)) return;
  word(step, address, expressions_.value_of(kLength));
}

bool BodyReader::accept_clause(Step& step, std::string_view name, Address address, Dimension dimension) {
  if (cursor_.line_failed() || !cursor_.accept_word(name)) return false;
  word(step, address, expressions_.value_of(dimension));
  return true;
}

// drill from LENGTH to LENGTH [peck LENGTH or break LENGTH] [dwell TIME] [return LENGTH]
// ream  from LENGTH to LENGTH [dwell TIME] [return LENGTH]
// bore  from LENGTH to LENGTH [return LENGTH]
// tap   from LENGTH to LENGTH pitch LENGTH [left] [return LENGTH]
void BodyReader::open_drill(DrillCycle cycle) {
  const bool taps = cycle == DrillCycle::tap_right;
  Step out = step(StepKind::drill_begin);
  if (family_.machine != ir::MachineKind::mill)
    cursor_.syntax(verb_, fmt::format("'{}' is a cycle of mills: on a lathe a hole in the middle is made with cut z",
                                      verb_.in(cursor_.text())));
  level(out, "from", Address::r);
  level(out, "to", Address::z);
  if (cycle == DrillCycle::drill) {
    if (accept_clause(out, "peck", Address::q, kLength))
      cycle = DrillCycle::deep_hole;
    else if (accept_clause(out, "break", Address::q, kLength))
      cycle = DrillCycle::chip_break;
  }
  if (taps) {
    level(out, "pitch", Address::f);
    if (!cursor_.line_failed() && cursor_.accept_word("left")) cycle = DrillCycle::tap_left;
  }
  const bool dwells = !taps && cycle != DrillCycle::stop_out && accept_clause(out, "dwell", Address::p, kTime);
  if (dwells && cycle == DrillCycle::drill) cycle = DrillCycle::drill_dwell;
  if (dwells && cycle == DrillCycle::feed_out) cycle = DrillCycle::feed_out_dwell;
  if (!cursor_.line_failed() && cursor_.accept_word("return")) out.values[0] = expressions_.value_of(kLength).id;
  if (!cursor_.line_failed() && compensation_waits_)
    cursor_.syntax(verb_, "compensation begins and ends with a straight move: rapid or cut before the holes");
  out.number = static_cast<std::int32_t>(cycle);
  if (cursor_.line_failed() || taps || may_cut()) add(std::move(out));
  open_.push_back({StepKind::drill_begin, verb_, line_});
  ++open_drills_;
  scope_.open();
}

// at AXIS VALUE ...
void BodyReader::hole() {
  if (open_drills_ == 0)
    return cursor_.syntax(verb_, "'at' names a hole: it stands between drill, ream, bore or tap and its 'end'");
  if (cursor_.at_word("z")) return cursor_.syntax(cursor_.peek().span, "z of a hole is given by from and to");
  Step out = step(StepKind::hole);
  axis_words(out);
  const auto begin = family_.words.begin() + out.first_word;
  if (std::ranges::find(begin, family_.words.end(), Address::z, &StepWord::address) != family_.words.end())
    return cursor_.syntax(verb_, "z of a hole is given by from and to");
  add(std::move(out));
}

bool BodyReader::may_stand_here(StepKind kind) {
  static constexpr std::array kInContour = {StepKind::cut, StepKind::arc_cw, StepKind::arc_ccw, StepKind::let};
  static constexpr std::array kOfOffset = {StepKind::offset, StepKind::if_begin, StepKind::if_end};
  if ((rough_ || offset_) && std::ranges::find(kInContour, kind) == kInContour.end() &&
      (!writes_offset_ || std::ranges::find(kOfOffset, kind) == kOfOffset.end())) {
    cursor_.syntax(verb_, fmt::format("in the contour of '{}' stand only cut, arc, let, and calls of such",
                                      offset_ ? "offset" : "rough"));
    return false;
  }
  if (face_ && !may_stand_on_face(kind)) return false;
  if (open_drills_ == 0 || std::ranges::find(kAmongHoles, kind) != kAmongHoles.end()) return true;
  cursor_.syntax(verb_, "among holes stand only at, loops, if, let and set: end the cycle before");
  return false;
}

}  // namespace dripfeed::family
