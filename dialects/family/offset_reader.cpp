// offset (left | right) LENGTH, the contour, end: the contour moved aside by a length, to the left or right as it
// leads.
//
//      P2 --------- P3          Each element is moved along its normal. At an outer corner an arc around the corner
//      |   .-------             leads from one to the next, at an inner one they end where they meet. Which corner is
//      |  |                     of which kind depends on values: the steps of all kinds are written under conditions
//      P1 |  offset right       that are decided when the family gets its values, so that one of them is built.
#include <algorithm>
#include <utility>

#include "dialects/family/offset_writer.h"

namespace dripfeed::family {

using ir::Address;
using ir::ExpressionId;

void BodyReader::offset() {
  Offset read{.head = step(StepKind::offset)};
  if (offset_)
    cursor_.syntax(verb_, "an 'offset' in the contour of another one");
  else if (other_plane_)
    cursor_.syntax(verb_, "a contour is moved aside in the plane of x and y: plane xy before it");
  else if (face_ == StepKind::cylinder_begin)
    cursor_.syntax(verb_, "a cylinder has no arcs, and an offset has them at its corners");
  else if (skip_level_ != 0)
    cursor_.syntax(verb_, "an offset is not skipped");
  read.is_left = !cursor_.line_failed() && cursor_.at_word("left");
  if (!cursor_.line_failed() && !cursor_.accept_word("left") && !cursor_.accept_word("right"))
    cursor_.expected("left or right");
  if (!cursor_.line_failed()) read.distance = expressions_.value_of(kLength).id;
  read.head.span = {verb_.begin, cursor_.last_span().end};
  read.first_step = steps_.size();
  const bool may = !cursor_.line_failed() && may_cut();
  open_.push_back({StepKind::offset, verb_, line_});
  scope_.open();
  if (may) offset_ = std::move(read);
}

void BodyReader::end_offset() {
  if (!offset_) return;
  const Offset offset = *std::exchange(offset_, std::nullopt);
  const std::vector<Step> read(steps_.begin() + static_cast<std::ptrdiff_t>(offset.first_step), steps_.end());
  steps_.resize(offset.first_step);
  corner_waits_ = false;
  const text::Span end = std::exchange(verb_, offset.head.span);
  const std::uint32_t line = std::exchange(line_, offset.head.line);
  if (!text::has_error(cursor_.diagnostics)) {
    writes_offset_ = true;
    OffsetWriter(*this, offset).write(read, end);
    writes_offset_ = false;
    for (std::size_t i = offset.first_step; i < steps_.size(); ++i) steps_[i].span = offset.head.span;
  }
  line_ = line;
}

// Its lets stay, its moves become points.
bool BodyReader::OffsetWriter::read(const std::vector<Step>& steps) {
  for (const Step& one : steps) {
    if (one.skip_level != 0)
      return body_.cursor_.syntax(one.span, "the contour of 'offset' is not skipped in parts"), false;
    if (one.kind != StepKind::let) {
      if (!read_point(one)) return false;
      continue;
    }
    contour_.items.push_back({.target = one.target, .value = one.values[0], .span = one.span});
    body_.steps_.push_back(one);
  }
  return true;
}

bool BodyReader::OffsetWriter::read_point(const Step& step) {
  const bool is_start = start_.u == ExpressionId::none;
  OffsetContour::Item item{.span = step.span};
  if (!is_start) {
    const auto last = std::ranges::find_if(contour_.items.rbegin(), contour_.items.rend(),
                                           [](const auto& one) { return one.target == ir::SymbolId::none; });
    item.u = last->u;
    item.v = last->v;
  }
  Element one;
  one.moves_u = one.moves_v = false;
  one.line = step.line;
  one.item = contour_.items.size();
  item.is_arc = one.is_arc = step.kind != StepKind::cut;
  item.clockwise = one.clockwise = step.kind == StepKind::arc_cw;
  const auto first = family_.words.begin() + step.first_word;
  const std::vector<StepWord> words(first, first + step.word_count);
  for (const StepWord& word : words)
    if (!read_word(word, one, item))
      return body_.cursor_.syntax(step.span,
                                  "in the contour of 'offset' a cut or an arc has the two axes of its "
                                  "plane alone: a chamfer or a rounding is a cut or an arc of its own"),
             false;
  if (is_start && (one.is_arc || !one.moves_u || !one.moves_v ||
                   std::ranges::any_of(words, [](const StepWord& word) { return word.is_step; })))
    return body_.cursor_.syntax(step.span,
                                "the contour of 'offset' begins with a cut to its start, which names both "
                                "axes of its plane"),
           false;
  const Pair from = is_start || elements_.empty() ? start_ : elements_.back().to;
  one.to.u = one.moves_u ? stable("contour_u", item.u) : from.u;
  one.to.v = one.moves_v ? stable("contour_v", item.v) : from.v;
  one.center = {stable("contour_i", item.i), stable("contour_j", item.j)};
  one.radius = stable("contour_r", item.radius);
  item.corner = decided("Corner");
  if (!is_start && !one.is_arc && one.moves_u != one.moves_v) item.direction = decided("Direction");
  if (is_start) {
    start_ = one.to;
    start_item_ = one.item;
    start_line_ = step.line;
  } else {
    elements_.push_back(one);
  }
  contour_.items.push_back(item);
  return true;
}

bool BodyReader::OffsetWriter::read_word(const StepWord& word, Element& one, OffsetContour::Item& item) {
  const auto place = [&](ExpressionId& at, bool& moves) {
    at = word.is_step && at != ExpressionId::none ? plus(at, word.value) : word.value;
    moves = true;
  };
  if (word.address == (is_turned_ ? Address::z : Address::x))
    place(item.u, one.moves_u);
  else if (word.address == (is_turned_ ? Address::x : Address::y))
    place(item.v, one.moves_v);
  else if (word.address == (is_turned_ ? Address::k : Address::i))
    item.i = word.value;
  else if (word.address == (is_turned_ ? Address::i : Address::j))
    item.j = word.value;
  else if (word.address == Address::arc_radius)
    item.radius = word.value;
  else
    return false;
  return true;
}

void BodyReader::OffsetWriter::find_geometry(Element& one, Pair from) {
  return one.is_arc ? find_arc(one, from) : find_line(one, from);
}

void BodyReader::OffsetWriter::find_line(Element& one, Pair from) {
  Pair left;
  if (one.moves_u && one.moves_v) {
    const Pair length = across(from, one.to);
    const Pair along = {kept("along_u", length.u), kept("along_v", length.v)};
    const ExpressionId whole = kept("along", root(dot(along, along)));
    left = turned(by(along, whole));
  } else {
    const ExpressionId direction = body_.name_of(contour_.items[one.item].direction);
    left = one.moves_u ? Pair{number(0.0), direction} : Pair{minus(number(0.0), direction), number(0.0)};
  }
  one.normal = contour_.is_left ? left : negated(left);
  if (!one.moves_u || !one.moves_v) return;
  one.normal = {kept("normal_u", one.normal.u, kRatio), kept("normal_v", one.normal.v, kRatio)};
}

void BodyReader::OffsetWriter::find_arc(Element& one, Pair from) {
  Pair length = across(from, one.to);
  if (one.radius != ExpressionId::none) {
    length = {kept("chord_u", length.u), kept("chord_v", length.v)};
    one.center = center_of_radius(one, length);
    one.center = {kept("center_u", one.center.u), kept("center_v", one.center.v)};
  } else {
    for (ExpressionId* part : {&one.center.u, &one.center.v})
      if (*part == ExpressionId::none) *part = number(0.0);
    const bool along_u = is_number(one.center.v, 0.0);
    one.radius = along_u || is_number(one.center.u, 0.0) ? size(along_u ? one.center.u : one.center.v)
                                                         : root(dot(one.center, one.center));
    one.radius = kept("arc_radius", one.radius);
  }
  one.back = minus(one.center, length);
  one.back = {kept("back_u", one.back.u), kept("back_v", one.back.v)};
}

// Of an arc of half a turn at most: i = du/2 +- dv*w, j = dv/2 -+ du*w, w = sqrt(r^2/(du^2 + dv^2) - 1/4), the upper
// sign for clockwise.
BodyReader::OffsetWriter::Pair BodyReader::OffsetWriter::center_of_radius(const Element& one, Pair length) {
  const ExpressionId share = by(times(one.radius, one.radius), dot(length, length));
  const ExpressionId w = kept("arc_w", root(size(minus(share, number(0.25)))), kRatio);
  const Pair half = by(length, number(2.0));
  const Pair aside = times(w, turned(length));
  return one.clockwise ? minus(half, aside) : plus(half, aside);
}

}  // namespace dripfeed::family
