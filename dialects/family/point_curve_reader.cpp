// cut along bezier ... and cut along nurbs ...: a curve by its points. It becomes loops of the language itself: a point
// at t is found by de Boor's scheme on those points that count there, times their weights; of a Bezier curve this is de
// Casteljau's.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "dialects/curves/bezier.h"
#include "dialects/family/body_reader.h"

namespace dripfeed::family {

using ir::ExpressionId;
using ir::Operator;

namespace {

struct CurveAxis {
  std::string_view word;
  ir::Address address;
};
constexpr auto kCurveAxes = std::to_array<CurveAxis>({
    {"x", ir::Address::x},
    {"y", ir::Address::y},
    {"z", ir::Address::z},
});

constexpr auto kMostPoints = static_cast<std::int32_t>(curves::BezierPiece::kMostPoints);

}  // namespace

// bezier AXIS LIST AXIS LIST [AXIS LIST] [weights LIST] (steps COUNT [within LENGTH] | within LENGTH)
// nurbs order N AXIS LIST ... [weights LIST] [knots LIST] (steps COUNT [within LENGTH] | within LENGTH)
void BodyReader::cut_along_points(bool is_bezier) {
  compensation_waits_ = false;
  PointCurve curve;
  if (!is_bezier) {
    if (!cursor_.expect_word("order")) return;
    const text::Span at = cursor_.peek().span;
    curve.order = cursor_.expect_integer("the curve's order, degree + 1");
    if (!cursor_.line_failed() && (curve.order < 2 || curve.order > kMostPoints))
      cursor_.syntax(at, "the order must be 2 to 16");
  }
  if (!read_points(curve)) return;
  if (cursor_.accept_word("weights")) curve.weights = expect_list(kRatio);
  if (!is_bezier && !cursor_.line_failed()) {
    curve.has_own_knots = !cursor_.accept_word("knots");
    if (!curve.has_own_knots) curve.knots = expect_list(kRatio);
  }
  if (cursor_.line_failed()) return;
  const bool is_equal = cursor_.accept_word("steps");
  if (!is_equal && !cursor_.accept_word("within")) return cursor_.expected("steps or within");
  const ExpressionId by = expressions_.value_of(is_equal ? kRatio : kLength).id;
  const bool is_limited = is_equal && !cursor_.line_failed() && cursor_.accept_word("within");
  const ExpressionId most = is_limited ? expressions_.value_of(kLength).id : ExpressionId::none;
  if (cursor_.line_failed()) return;
  curve.span = {verb_.begin, cursor_.last_span().end};
  if (!is_equal) curve.error = by;
  scope_.open();
  PointScheme scheme = scheme_of(std::move(curve));
  if (is_limited) {
    Step limited = step(StepKind::require);
    limited.number = static_cast<std::int32_t>(family_.point_curves.size());
    limited.values[0] = by;
    limited.values[1] = most;
    add(std::move(limited));
  }
  if (is_equal)
    equal_point_steps(scheme, by);
  else
    point_chords(scheme);
  scope_.seal();
}

bool BodyReader::read_points(PointCurve& curve) {
  const auto axis_here = [&]() -> const CurveAxis* {
    const auto* row = std::ranges::find(kCurveAxes, cursor_.word(), &CurveAxis::word);
    return row == kCurveAxes.end() ? nullptr : row;
  };
  for (const CurveAxis* axis = axis_here(); axis != nullptr && !cursor_.line_failed(); axis = axis_here()) {
    if (axis->address == ir::Address::y && family_.machine == ir::MachineKind::lathe)
      cursor_.syntax(cursor_.peek().span, "a lathe has no axis y");
    if (std::ranges::find(curve.axes, axis->address, &PointCurve::Axis::address) != curve.axes.end())
      cursor_.syntax(cursor_.peek().span, "this axis stands in the curve already");
    cursor_.advance();
    if (!cursor_.line_failed()) curve.axes.push_back({axis->address, expect_list(kLength)});
  }
  if (!cursor_.line_failed() && curve.axes.size() < 2)
    cursor_.expected("an axis and its list: the points of a curve have two axes or three");
  return !cursor_.line_failed();
}

// A list by its name, without an index.
ir::SymbolId BodyReader::expect_list(Dimension dimension) {
  if (cursor_.line_failed()) return ir::SymbolId::none;
  const Scope::Name* known = cursor_.peek().kind == LexemeKind::word ? scope_.find(cursor_.word()) : nullptr;
  if (known == nullptr || known->kind != NameKind::list || cursor_.at_symbol("[", 1)) {
    cursor_.expected("the name of a list");
    return ir::SymbolId::none;
  }
  const Typed numbers{.dimension = known->dimension, .span = cursor_.peek().span};
  const ir::SymbolId symbol = known->symbol;
  cursor_.advance();
  expressions_.require_dimension(numbers, dimension);
  return symbol;
}

ir::SymbolId BodyReader::hidden_list(std::string_view stem, Dimension dimension, std::int32_t size,
                                     bool counts_chords) {
  List list{.symbol = scope_.define(family_.arena, unused_name(stem), dimension, verb_, NameKind::list),
            .count = ir::SymbolId::none,
            .dimension = dimension,
            .elements = {},
            .size = size,
            .line = line_,
            .counts_chords = counts_chords};
  if (size == 0) list.curve = static_cast<std::int32_t>(family_.point_curves.size());
  list.count = scope_.define(family_.arena, unused_name("list_count"), kRatio, verb_);
  const ir::SymbolId symbol = list.symbol;
  family_.lists.push_back(std::move(list));
  return symbol;
}

// The rows that the scheme works on, and the lists that bind finds.
BodyReader::PointScheme BodyReader::scheme_of(PointCurve curve) {
  PointScheme out;
  const List& points = *family_.find_list(curve.axes.front().list);
  out.count = name_of(points.count);
  out.order = curve.is_bezier() ? out.count : number(curve.order);
  std::int32_t most = curve.order;
  if (curve.is_bezier()) {
    const auto parameter = std::ranges::find(family_.parameters, points.symbol, &Parameter::symbol);
    most = parameter != family_.parameters.end() ? parameter->most
           : points.size > 0                     ? points.size
                                                 : static_cast<std::int32_t>(points.elements.size());
    most = std::min(most, kMostPoints);
  }
  if (curve.has_own_knots) curve.knots = hidden_list("knot", kRatio, 0);
  if (curve.error != ExpressionId::none) curve.counts = hidden_list("chords", kRatio, 0, true);
  for (const PointCurve::Axis& axis : curve.axes) {
    const auto* row = std::ranges::find(kCurveAxes, axis.address, &CurveAxis::address);
    out.rows.push_back(hidden_list(std::string("near_").append(row->word), kLength, most));
  }
  if (curve.weights != ir::SymbolId::none) out.rows.push_back(hidden_list("near_w", kRatio, most));
  family_.point_curves.push_back(curve);
  out.curve = std::move(curve);
  return out;
}

void BodyReader::set_number(ir::SymbolId list, ExpressionId index, ExpressionId value) {
  Step out = step(StepKind::set);
  out.target = list;
  out.values[1] = index;
  out.values[0] = value;
  add(std::move(out));
}

ExpressionId BodyReader::count_hidden_down(std::string_view stem, ExpressionId first, ExpressionId last) {
  Step loop = hidden_loop(stem, kRatio);
  loop.down = true;
  loop.values[0] = first;
  loop.values[1] = last;
  loop.values[2] = number(1.0);
  const ExpressionId counter = name_of(loop);
  add(std::move(loop));
  return counter;
}

void BodyReader::while_hidden(Operator op, ExpressionId a, ExpressionId b) {
  Step out = step(StepKind::while_begin);
  out.values[0] = calculated(op, a, b);
  add(std::move(out));
}

ExpressionId BodyReader::knot(const PointScheme& scheme, ExpressionId at) { return name_of(scheme.curve.knots, at); }

// The knots that a NURBS curve runs between.
ExpressionId BodyReader::knot_ends(const PointScheme& scheme, bool last) {
  return knot(scheme, last ? scheme.count : number(scheme.curve.order - 1));
}

// let first = 0;  for point from 0 to steps step 1:  t = knot[count] - (steps - point)/steps*(…), so that the last one
// is exactly at the last knot
//   while t > knot[first + order];  set first = first + 1;  end;  point at t
void BodyReader::equal_point_steps(PointScheme& scheme, ExpressionId count) {
  const bool seeks = !scheme.curve.is_bezier();
  if (seeks) scheme.first = kept("first", number(0.0), kRatio);
  const ExpressionId point = count_hidden("point", 0.0, count);
  if (!seeks) {
    cut_point(scheme, kept("curve_t", calculated(Operator::divide, point, count), kRatio));
    return end_hidden_loop();
  }
  const ExpressionId last = knot_ends(scheme, true);
  const ExpressionId span = calculated(Operator::subtract, last, knot_ends(scheme, false));
  const ExpressionId left = calculated(Operator::divide, calculated(Operator::subtract, count, point), count);
  const ExpressionId t =
      kept("curve_t", calculated(Operator::subtract, last, calculated(Operator::multiply, left, span)), kRatio);
  while_hidden(Operator::greater, t, knot(scheme, calculated(Operator::add, scheme.first, scheme.order)));
  set_name(family_.arena.at(family_.arena.at(scheme.first).variable).symbol,
           calculated(Operator::add, scheme.first, number(1.0)));
  add(step(StepKind::while_end));
  cut_point(scheme, t);
  end_hidden_loop();
}

// let chord = 0
// for first from 0 to count - order:  if knot[first + order] > knot[first + order - 1]
//   for piece from 0 to 3:  while chord <= chords[4*first + piece]
//     point at knot[first + order - 1] + (piece + chord/chords[…])*(…)/4;  set chord = chord + 1;  end;  set chord = 1
void BodyReader::point_chords(PointScheme& scheme) {
  const bool is_bezier = scheme.curve.is_bezier();
  const auto plus = [&](ExpressionId a, ExpressionId b) { return calculated(Operator::add, a, b); };
  const auto times = [&](ExpressionId a, ExpressionId b) { return calculated(Operator::multiply, a, b); };
  const ExpressionId chord = kept("chord", number(0.0), kRatio);
  const ir::SymbolId chord_symbol = family_.arena.at(family_.arena.at(chord).variable).symbol;
  ExpressionId low = ExpressionId::none;
  ExpressionId high = ExpressionId::none;
  if (!is_bezier) {
    scheme.first = count_hidden("first", 0.0, calculated(Operator::subtract, scheme.count, scheme.order));
    low = knot(scheme, plus(scheme.first, number(scheme.curve.order - 1)));
    high = knot(scheme, plus(scheme.first, scheme.order));
    if (!scheme.curve.has_own_knots) open_if(Operator::greater, high, low);
  }
  const std::int32_t pieces = is_bezier ? kCurvePieces : kSpanPieces;
  const ExpressionId piece = count_hidden("piece", 0.0, number(pieces - 1));
  const ExpressionId row = is_bezier ? piece : plus(times(number(pieces), scheme.first), piece);
  while_hidden(Operator::less_equal, chord, name_of(scheme.curve.counts, row));
  const ExpressionId part =
      calculated(Operator::divide, plus(piece, calculated(Operator::divide, chord, name_of(scheme.curve.counts, row))),
                 number(pieces));
  const ExpressionId t =
      kept("curve_t", is_bezier ? part : plus(low, times(part, calculated(Operator::subtract, high, low))), kRatio);
  cut_point(scheme, t);
  set_name(chord_symbol, plus(chord, number(1.0)));
  add(step(StepKind::while_end));
  set_name(chord_symbol, number(1.0));
  end_hidden_loop();
  if (is_bezier) return;
  if (!scheme.curve.has_own_knots) add(step(StepKind::if_end));
  end_hidden_loop();
}

// Of the points from `first` on each row takes those of its axis, times their weights. The scheme leads them to the
// last one:
//   for level from 1 to order - 1:  for near from order - 1 down to level
//     part = (t - knot[first + near])/(knot[first + near - level + order] - knot[first + near]);  Bezier: t
//     row[near] = row[near - 1] + part*(row[near] - row[near - 1])
void BodyReader::cut_point(const PointScheme& scheme, ExpressionId t) {
  const auto plus = [&](ExpressionId a, ExpressionId b) { return calculated(Operator::add, a, b); };
  const auto minus = [&](ExpressionId a, ExpressionId b) { return calculated(Operator::subtract, a, b); };
  const PointCurve& curve = scheme.curve;
  const bool is_bezier = curve.is_bezier();
  const bool weighs = curve.weights != ir::SymbolId::none;
  const ExpressionId last = is_bezier ? minus(scheme.count, number(1.0)) : number(curve.order - 1);
  const ir::SymbolId weight_row = scheme.rows.back();

  const ExpressionId near = count_hidden("near", 0.0, last);
  const ExpressionId place = is_bezier ? near : plus(scheme.first, near);
  if (weighs) set_number(weight_row, near, name_of(curve.weights, place));
  for (std::size_t i = 0; i < curve.axes.size(); ++i) {
    const ExpressionId at = name_of(curve.axes[i].list, place);
    set_number(scheme.rows[i], near, weighs ? calculated(Operator::multiply, at, name_of(weight_row, near)) : at);
  }
  end_hidden_loop();

  const ExpressionId level = count_hidden("level", 1.0, last);
  const ExpressionId lower = count_hidden_down("near", last, level);
  ExpressionId part = t;
  if (!is_bezier) {
    const ExpressionId from = knot(scheme, plus(scheme.first, lower));
    const ExpressionId to = knot(scheme, plus(minus(plus(scheme.first, lower), level), scheme.order));
    part = kept("part", calculated(Operator::divide, minus(t, from), minus(to, from)), kRatio);
  }
  const ExpressionId before = minus(lower, number(1.0));
  for (const ir::SymbolId row : scheme.rows)
    set_number(row, lower,
               plus(name_of(row, before),
                    calculated(Operator::multiply, part, minus(name_of(row, lower), name_of(row, before)))));
  end_hidden_loop();
  end_hidden_loop();

  Step cut = step(StepKind::cut);
  for (std::size_t i = 0; i < curve.axes.size(); ++i) {
    const ExpressionId at = name_of(scheme.rows[i], last);
    word(cut, curve.axes[i].address, {.id = weighs ? calculated(Operator::divide, at, name_of(weight_row, last)) : at});
  }
  add(std::move(cut));
}

}  // namespace dripfeed::family
