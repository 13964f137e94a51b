// The axes' letters are names in these expressions only. A line with a fault inside a block of points does not end the
// block.
#include "dialects/family/nominal_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "dialects/curves/bezier.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/naming.h"

namespace dripfeed::family {

ir::SymbolId NominalReader::axis(ir::SymbolId& known, std::string_view name) {
  if (known == ir::SymbolId::none) {
    ir::Symbol symbol;
    symbol.name = family_.arena.strings.add(name);
    known = family_.arena.add(symbol);
  }
  return known;
}

ExpressionRange NominalReader::range(Dimension dimension) {
  ExpressionRange out;
  if (cursor_.line_failed() || !cursor_.expect_word("in")) return out;
  out.low = expressions_.value_of(dimension).id;
  cursor_.expect_symbol("..");
  if (!cursor_.line_failed()) out.high = expressions_.value_of(dimension).id;
  return out;
}

void NominalReader::tolerance(ir::ExpressionId& out) {
  if (!cursor_.line_failed() && cursor_.expect_word("tolerance")) out = expressions_.value_of(kLength).id;
}

ir::ExpressionId NominalReader::formula_by(std::initializer_list<ir::SymbolId> names) {
  const Typed value = expressions_.value_of(kLength);
  if (cursor_.line_failed()) return value.id;
  const auto interpolates = [&](ir::SymbolId name) { return interpolates_by(family_.arena, value.id, name); };
  if (std::ranges::any_of(names, interpolates))
    cursor_.syntax(value.span, "a nominal is not an interpolation: its corners would not be measured");
  return value.id;
}

void NominalReader::profile() {
  NominalShape out{.line = cursor_.peek().line};
  cursor_.expect_word("x");
  cursor_.expect_symbol("=");
  expressions_.set_axis_variables({{"z", axis(family_.z_variable, "z")}});
  out.x = formula_by({family_.z_variable});
  expressions_.set_axis_variables({});
  if (!cursor_.line_failed() && cursor_.expect_word("for") && cursor_.expect_word("z")) out.z = range(kLength);
  tolerance(out.tolerance);
  if (!cursor_.line_failed()) family_.nominals.push_back(out);
}

void NominalReader::of_mill() {
  if (cursor_.at_word("z")) return surface();
  if (cursor_.accept_word("surface")) return nurbs_surface();
  CurveShape out;
  out.line = cursor_.peek().line;
  if (cursor_.accept_word("curve")) return formula_curve(std::move(out));
  if (cursor_.accept_word("bezier")) return point_curve(std::move(out));
  if (!cursor_.accept_word("nurbs")) {
    return cursor_.expected("z = ..., surface, curve, bezier or nurbs, the nominals of a mill");
  }
  out.order = order();
  point_curve(std::move(out));
}

// order N
std::int32_t NominalReader::order() {
  cursor_.expect_word("order");
  const text::Span at = cursor_.peek().span;
  const std::int32_t out = cursor_.expect_integer("the order, degree + 1");
  if (!cursor_.line_failed() && (out < 2 || out > static_cast<int>(curves::BezierPiece::kMostPoints)))
    cursor_.syntax(at, "the order must be 2 to 16");
  return out;
}

void NominalReader::nurbs_surface() {
  NurbsSurfaceShape out{.line = cursor_.peek().line, .span = cursor_.last_span()};
  out.order = order();
  tolerance(out.tolerance);
  if (!lines_to_end([&] { surface_line(out); })) return;
  if (out.x_list == ir::SymbolId::none || out.row == ir::ExpressionId::none)
    return cursor_.syntax(out.span, "a surface has a line 'points' and a line 'row'");
  family_.nurbs_surfaces.push_back(out);
}

// points LIST LIST LIST [weights LIST] | row COUNT | knots LIST LIST
void NominalReader::surface_line(NurbsSurfaceShape& out) {
  if (cursor_.accept_word("points")) {
    for (ir::SymbolId* list : {&out.x_list, &out.y_list, &out.z_list}) expect_list(kLength, *list);
    if (!cursor_.line_failed() && cursor_.accept_word("weights")) expect_list(kRatio, out.weight_list);
  } else if (cursor_.accept_word("row")) {
    out.row = expressions_.value_of(kRatio).id;
  } else if (cursor_.accept_word("knots")) {
    for (ir::SymbolId* list : {&out.knot_u_list, &out.knot_v_list}) expect_list(kRatio, *list);
  } else {
    cursor_.expected("points, row, knots or end");
  }
}

void NominalReader::expect_list(Dimension dimension, ir::SymbolId& into) {
  if (!cursor_.line_failed() && !accept_list(dimension, into)) cursor_.expected("the name of a list");
}

void NominalReader::surface() {
  SurfaceShape out{.line = cursor_.peek().line};
  cursor_.advance();
  cursor_.expect_symbol("=");
  const ExpressionReader::AxisVariable x{"x", axis(family_.x_variable, "x")};
  const ExpressionReader::AxisVariable y{"y", axis(family_.y_variable, "y")};
  expressions_.set_axis_variables({x, y});
  out.z = formula_by({x.symbol, y.symbol});
  expressions_.set_axis_variables({});
  if (!cursor_.line_failed() && cursor_.expect_word("for") && cursor_.expect_word("x")) out.x = range(kLength);
  if (!cursor_.line_failed() && cursor_.expect_word("y")) {
    expressions_.set_axis_variables({x});
    out.y = range(kLength);
    expressions_.set_axis_variables({});
  }
  tolerance(out.tolerance);
  if (!cursor_.line_failed()) family_.surfaces.push_back(out);
}

void NominalReader::formula_curve(CurveShape out) {
  const text::Span head = cursor_.last_span();
  if (!cursor_.expect_word("for")) return;
  const std::optional<NewName> name = expect_new_name(cursor_, scope_);
  if (!name || !cursor_.expect_word("in")) return;
  const Typed low = expressions_.value();
  cursor_.expect_symbol("..");
  if (cursor_.line_failed()) return;
  out.t = {low.id, expressions_.value_of(low.dimension).id};
  scope_.open();
  out.parameter = scope_.define(family_.arena, name->name, low.dimension, name->span);
  if (!cursor_.line_failed() && cursor_.expect_word("x")) out.x = formula_by({out.parameter});
  if (!cursor_.line_failed() && cursor_.expect_word("y")) out.y = formula_by({out.parameter});
  scope_.close();
  tolerance(out.tolerance);
  if (!cursor_.line_failed()) out.of_center = cursor_.accept_word("center");
  add(std::move(out), head);
}

void NominalReader::point(CurveShape& out) {
  CurvePoint point;
  cursor_.expect_word("x");
  if (!cursor_.line_failed()) point.x = expressions_.value_of(kLength).id;
  if (!cursor_.line_failed() && cursor_.expect_word("y")) point.y = expressions_.value_of(kLength).id;
  if (!cursor_.line_failed() && cursor_.accept_word("weight")) point.weight = expressions_.value_of(kRatio).id;
  if (!cursor_.line_failed()) out.points.push_back(point);
}

// points LIST LIST [weights LIST]
void NominalReader::points(CurveShape& out) {
  expect_list(kLength, out.x_list);
  expect_list(kLength, out.y_list);
  if (!cursor_.line_failed() && cursor_.accept_word("weights")) expect_list(kRatio, out.weight_list);
}

// A list's name without an index.
bool NominalReader::accept_list(Dimension dimension, ir::SymbolId& into) {
  const Scope::Name* known = cursor_.peek().kind == LexemeKind::word ? scope_.find(cursor_.word()) : nullptr;
  if (known == nullptr || known->kind != NameKind::list || cursor_.at_symbol("[", 1)) return false;
  into = known->symbol;
  const Typed numbers{.dimension = known->dimension, .span = cursor_.peek().span};
  cursor_.advance();
  expressions_.require_dimension(numbers, dimension);
  return true;
}

bool NominalReader::lines_to_end(const std::function<void()>& read_line) {
  bool failed = cursor_.line_failed();
  cursor_.finish_line();
  while (!cursor_.at_end() && !cursor_.at_word("end")) {
    if (cursor_.at_line_end()) {
      cursor_.advance();
      continue;
    }
    read_line();
    failed = failed || cursor_.line_failed();
    cursor_.finish_line();
  }
  cursor_.expect_word("end");
  return !failed && !cursor_.line_failed();
}

// point x VALUE y VALUE [weight VALUE] | points LIST LIST [weights LIST] | knots (LIST | VALUE VALUE ...)
void NominalReader::curve_line(CurveShape& out) {
  if (cursor_.accept_word("point")) return point(out);
  if (cursor_.accept_word("points")) return points(out);
  if (!cursor_.accept_word("knots")) return cursor_.expected("point, points, knots or end");
  if (accept_list(kRatio, out.knot_list)) return;
  while (!cursor_.line_failed() && !cursor_.at_line_end()) out.knots.push_back(expressions_.value_of(kRatio).id);
}

void NominalReader::point_curve(CurveShape out) {
  const text::Span head = cursor_.last_span();
  tolerance(out.tolerance);
  if (!cursor_.line_failed()) out.of_center = cursor_.accept_word("center");
  if (lines_to_end([&] { curve_line(out); })) add(std::move(out), head);
}

void NominalReader::add(CurveShape out, text::Span head) {
  if (cursor_.line_failed()) return;
  out.span = head;
  family_.curves.push_back(std::move(out));
}

}  // namespace dripfeed::family
