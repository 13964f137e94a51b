// The steps of a moved contour. Those of all kinds of corner are written, each under its condition.
#include "dialects/family/offset_writer.h"

namespace dripfeed::family {

using ir::Address;
using ir::ExpressionId;
using ir::Operator;

bool BodyReader::OffsetWriter::is_same(ExpressionId a, ExpressionId b) const {
  if (a == b) return true;
  const ir::Expression& left = family_.arena.at(a);
  const ir::Expression& right = family_.arena.at(b);
  if (left.op != Operator::variable || right.op != Operator::variable) return false;
  const ir::Variable& one = family_.arena.at(left.variable);
  const ir::Variable& other = family_.arena.at(right.variable);
  return one.symbol == other.symbol && one.index == ExpressionId::none && other.index == ExpressionId::none;
}

void BodyReader::OffsetWriter::assign(Pair names, Pair values) {
  for (const auto& [name, value] : {std::pair(names.u, values.u), std::pair(names.v, values.v)}) {
    Step out = body_.step(StepKind::let);
    out.target = family_.arena.at(family_.arena.at(name).variable).symbol;
    out.values[0] = value;
    body_.add(std::move(out));
  }
}

void BodyReader::OffsetWriter::write(const std::vector<Step>& steps, text::Span end) {
  Step check = offset_.head;
  check.number = static_cast<std::int32_t>(family_.offsets.size());
  body_.add(std::move(check));
  changing_ = assigned_twice(steps);
  offset_.distance = kept("offset_by", offset_.distance);
  if (!read(steps)) return;
  if (elements_.empty())
    return body_.cursor_.syntax(end, "the contour of 'offset' has a cut to its start and one further");
  const std::size_t last = elements_.size() - 1;
  find_geometry(elements_[last], last == 0 ? start_ : elements_[last - 1].to);
  if (last > 0) find_geometry(elements_[0], start_);
  const ir::SymbolId closing = contour_.items[start_item_].corner;
  Meeting from{.at = start_, .corner = closing, .before = last, .after = 0, .is_start = true};
  Pair at = meet(from, [&](Pair to) { move(StepKind::cut, {.line = start_line_}, to, Pair()); });
  for (std::size_t n = 0; n <= last; ++n) {
    if (n + 1 < last) find_geometry(elements_[n + 1], elements_[n].to);
    const Element& one = elements_[n];
    const Meeting to{.at = one.to,
                     .corner = n == last ? closing : contour_.items[one.item].corner,
                     .before = n,
                     .after = n == last ? 0 : n + 1};
    at = meet(to, [&](Pair reached) { lead(one, from, at, reached); });
    from = to;
  }
  family_.offsets.push_back(std::move(contour_));
}

// From the corner to where the offsets of both tangents meet.
BodyReader::OffsetWriter::Pair BodyReader::OffsetWriter::straight_meeting(const Element& before, const Element& after) {
  const Pair first = last_normal(before);
  const Pair second = first_normal(after);
  const ExpressionId share = plus(number(1.0), dot(first, second));
  return times(offset_.distance, by(plus(first, second), share));
}

// From the corner to where the two offsets meet, of which one is an arc at least.
BodyReader::OffsetWriter::Pair BodyReader::OffsetWriter::crossing(const Meeting& meeting, Operator op) {
  const Element& before = elements_[meeting.before];
  const Element& after = elements_[meeting.after];
  if (before.is_arc && after.is_arc) return circle_crossing(op, before, after);
  return before.is_arc ? line_crossing(op, after.normal, before.back, moved_radius(before))
                       : line_crossing(op, before.normal, after.center, moved_radius(after));
}

// Along the moved line from where the corner's normal meets it.
BodyReader::OffsetWriter::Pair BodyReader::OffsetWriter::line_crossing(Operator op, Pair normal, Pair to_center,
                                                                       ExpressionId radius) {
  const Pair along = turned(normal);
  const ExpressionId off = kept("cross_off", minus(dot(to_center, normal), offset_.distance));
  const ExpressionId reach = root(size(minus(times(radius, radius), times(off, off))));
  const ExpressionId by_length = kept("cross_at", body_.sum(op, dot(to_center, along), reach));
  return plus(times(offset_.distance, normal), times(by_length, along));
}

// On the line through both circles' intersections.
BodyReader::OffsetWriter::Pair BodyReader::OffsetWriter::circle_crossing(Operator op, const Element& before,
                                                                         const Element& after) {
  Pair between = minus(after.center, before.back);
  between = {kept("between_u", between.u), kept("between_v", between.v)};
  const ExpressionId square = kept("between_2", dot(between, between));
  const ExpressionId first = moved_radius(before);
  const ExpressionId second = moved_radius(after);
  const ExpressionId rest = minus(times(first, first), times(second, second));
  const ExpressionId along = kept("cross_at", by(plus(square, rest), times(number(2.0), square)), kRatio);
  const ExpressionId aside =
      kept("cross_off", root(size(minus(by(times(first, first), square), times(along, along)))), kRatio);
  const Pair middle = plus(before.back, times(along, between));
  const Pair out = times(aside, turned(between));
  return op == Operator::add ? plus(middle, out) : minus(middle, out);
}

// Calls `use` with where the element before the meeting ends (at the start of the contour: where the first one begins),
// for each kind of corner that is possible, in a branch of its own.
template <class Use>
void BodyReader::OffsetWriter::each_kind(const Meeting& meeting, const Use& use) {
  const Element& before = elements_[meeting.before];
  const Element& after = elements_[meeting.after];
  open(meeting.corner, Operator::greater_equal, Corner::outer);
  const Pair normal = meeting.is_start ? first_normal(after) : last_normal(before);
  use(place(meeting.at, times(offset_.distance, normal)));
  close();
  open(meeting.corner, Operator::equal, Corner::straight);
  use(place(meeting.at, straight_meeting(before, after)));
  close();
  if (!before.is_arc && !after.is_arc) return;
  for (const auto& [kind, op] :
       {std::pair(Corner::minus_root, Operator::subtract), std::pair(Corner::plus_root, Operator::add)}) {
    open(meeting.corner, Operator::equal, kind);
    use(place(meeting.at, crossing(meeting, op)));
    close();
  }
}

// `lead` writes the move to the meeting. Returns the names of its place, or of where the next element begins.
template <class Lead>
BodyReader::OffsetWriter::Pair BodyReader::OffsetWriter::meet(const Meeting& meeting, const Lead& lead) {
  const bool has_names = is_named(meeting);
  const Pair reached = has_names ? new_names() : Pair{};
  each_kind(meeting, [&](Pair to) { has_names ? assign(reached, to) : lead(to); });
  if (has_names) lead(reached);
  if (meeting.is_start) return reached;
  const Pair begin = place(meeting.at, times(offset_.distance, first_normal(elements_[meeting.after])));
  if (!names_starts_) {
    open(meeting.corner, Operator::equal, Corner::outer);
    outer_arc(meeting, begin);
    close();
    return reached;
  }
  const Pair next = new_names();
  open(meeting.corner, Operator::equal, Corner::outer);
  assign(next, begin);
  close();
  open(meeting.corner, Operator::not_equal, Corner::outer);
  assign(next, reached);
  close();
  open(meeting.corner, Operator::equal, Corner::outer);
  outer_arc(meeting, next);
  close();
  return next;
}

void BodyReader::OffsetWriter::outer_arc(const Meeting& meeting, Pair to) {
  const Pair normal = last_normal(elements_[meeting.before]);
  move(contour_.is_left ? StepKind::arc_cw : StepKind::arc_ccw, {.line = elements_[meeting.before].line}, to,
       times(offset_.distance, negated(normal)));
}

// From the meeting `from` on, where `start` has the names of where the element before ended.
void BodyReader::OffsetWriter::lead(const Element& one, const Meeting& from, Pair start, Pair to) {
  if (!one.is_arc) return move(StepKind::cut, one, to, Pair());
  const StepKind kind = one.clockwise ? StepKind::arc_cw : StepKind::arc_ccw;
  const Pair from_start = minus(one.center, across(from.at, start));
  if (names_starts_) return move(kind, one, to, from_start);
  open(from.corner, Operator::greater_equal, Corner::outer);
  move(kind, one, to, minus(one.center, times(offset_.distance, first_normal(one))));
  close();
  open(from.corner, Operator::less, Corner::outer);
  move(kind, one, to, from_start);
  close();
}

void BodyReader::OffsetWriter::move(StepKind kind, const Element& one, Pair to, Pair center) {
  if (names_places_ && kind != StepKind::cut) center = {kept("offset_i", center.u), kept("offset_j", center.v)};
  if (names_places_) to = {kept("to_u", to.u), kept("to_v", to.v)};
  Step out = body_.step(kind);
  out.line = one.line;
  const auto word = [&](bool is_wanted, Address address, ExpressionId value) {
    if (is_wanted) body_.word(out, address, {.id = value});
  };
  word(one.moves_u || one.is_arc, is_turned_ ? Address::z : Address::x, to.u);
  word(one.moves_v || one.is_arc, is_turned_ ? Address::x : Address::y, to.v);
  if (kind != StepKind::cut) {
    word(!is_number(center.u, 0.0), is_turned_ ? Address::k : Address::i, center.u);
    word(!is_number(center.v, 0.0), is_turned_ ? Address::i : Address::j, center.v);
  }
  body_.add(std::move(out));
}

}  // namespace dripfeed::family
