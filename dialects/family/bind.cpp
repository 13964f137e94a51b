// Overrides are read and checked one by one, then lets are computed in order, then conditions and loops are tried.
#include "dialects/family/bind.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/binder.h"
#include "dialects/family/chord_counts.h"
#include "dialects/family/geometry.h"
#include "dialects/family/point_chords.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

using text::DiagnosticId;

BindResult Binder::bind() {
  parameters();
  if (text::has_error(result_.diagnostics)) return std::move(result_);
  // In the order of the text: each may use what stands above it.
  auto list = family_.lists.begin();
  for (const Definition& definition : family_.definitions) {
    for (; list != family_.lists.end() && list->line < definition.line; ++list) define(*list);
    define(definition);
  }
  for (; list != family_.lists.end(); ++list) define(*list);
  if (text::has_error(result_.diagnostics)) return std::move(result_);
  for (const Requirement& requirement : family_.requirements) check(requirement);
  for (const CurveShape& curve : family_.curves) check_curve(curve);
  for (const NurbsSurfaceShape& surface : family_.nurbs_surfaces) check_surface(surface);
  for (const Step& step : family_.steps)
    if (step.kind == StepKind::set) {
      known_[static_cast<std::size_t>(step.target)] = 0;
      sets_.insert(step.target);
    }
  if (!text::has_error(result_.diagnostics))
    for (const ChordedCurve& curve : family_.chorded) count_chords(curve);
  if (!text::has_error(result_.diagnostics))
    for (const PointCurve& curve : family_.point_curves) find_points(curve);
  const std::size_t found = result_.diagnostics.size();
  if (!text::has_error(result_.diagnostics)) check_verbs();
  if (result_.diagnostics.size() > found) return std::move(result_);  // their loops would be reported again
  for (const Step& step : family_.steps) {
    if (step.kind == StepKind::for_begin) check_loop(step);
    if (step.kind == StepKind::tool) check_tool(step);
    if (step.kind == StepKind::drill_begin) check_holes(step);
    if (step.kind == StepKind::thread) check_thread(step);
    if (step.kind == StepKind::cylinder_begin) check_cylinder(step);
    if (step.kind == StepKind::message) check_message(step);
    if (step.kind == StepKind::engrave) check_engraving(step);
    check_indices(step);
  }
  return std::move(result_);
}

std::optional<double> Binder::compute(ir::ExpressionId expression) {
  const std::vector<double>& values = result_.bound.values;
  const double value = evaluate(family_.arena, expression, values).value;
  if (std::isfinite(value)) return value;
  const text::Span at = family_.arena.at(first_undefined(family_.arena, expression, values)).span;
  report(DiagnosticId::argument_out_of_domain, at, {std::string(at.in(family_.source.text())), "these values"});
  return std::nullopt;
}

bool Binder::check_points(ir::ExpressionId id) {
  if (id == ir::ExpressionId::none) return true;
  const ir::Expression& e = family_.arena.at(id);
  const int operands = ir::operand_count(e.op);
  if (e.op != kAlong) return operands == 0 || (check_points(e.a) && (operands == 1 || check_points(e.b)));
  if (!check_points(e.a)) return false;
  const std::string fault = fault_of_points(points_of(family_.arena, e));
  if (!fault.empty()) report(DiagnosticId::family_syntax, e.span, {fault});
  return fault.empty();
}

std::string Binder::fault_of_points(const PointLists& lists) const {
  const auto name_of = [this](ir::SymbolId list) { return family_.arena.strings.at(family_.arena.at(list).name); };
  for (const ir::SymbolId list : {lists.x, lists.y})
    if (!known_[static_cast<std::size_t>(list)])
      return fmt::format("the program changes {}: an interpolation takes lists that stay", name_of(list));
  const auto xs = list_in(result_.bound.values, lists.x);
  const auto ys = list_in(result_.bound.values, lists.y);
  if (xs.size() != ys.size())
    return fmt::format("{} has {} numbers and {} has {}", name_of(lists.x), xs.size(), name_of(lists.y), ys.size());
  if (xs.size() < 2) return fmt::format("{} has one number: an interpolation takes two or more", name_of(lists.x));
  const auto back = std::ranges::adjacent_find(xs, std::greater_equal<>());
  if (back == xs.end()) return {};
  return fmt::format("{} must increase: {} follows {}", name_of(lists.x), text::format_shortest(*(back + 1)),
                     text::format_shortest(*back));
}

void Binder::define(const Definition& definition) {
  if (!check_points(definition.value)) return;
  if (const std::optional<double> value = compute(definition.value)) know(definition.symbol, *value);
}

void Binder::define(const List& list) {
  std::vector<double> numbers;
  for (const ir::ExpressionId element : list.elements) {
    const std::optional<double> value = compute(element);
    if (!value) return;
    numbers.push_back(*value);
  }
  if (list.curve >= 0) {
    const PointCurve& curve = family_.point_curves[static_cast<std::size_t>(list.curve)];
    numbers.assign(count_of_found(result_.bound, curve, list), 1.0);  // until find_points
  } else if (list.counts_chords) {
    numbers.assign(kCurvePieces, 1.0);  // until count_chords
  } else if (list.size > 0) {
    numbers.assign(static_cast<std::size_t>(list.size), 0.0);
  } else if (list.elements.empty()) {
    numbers = given_lists_.at(list.symbol);
  }
  std::vector<double>& values = result_.bound.values;
  values.push_back(static_cast<double>(numbers.size()));
  know(list.symbol, static_cast<double>(values.size()));
  know(list.count, static_cast<double>(numbers.size()));
  values.insert(values.end(), numbers.begin(), numbers.end());
}

void Binder::check(const Requirement& requirement) {
  if (!check_points(requirement.condition)) return;
  const std::optional<double> holds = compute(requirement.condition);
  if (!holds || *holds != 0.0) return;
  std::string condition(requirement.span.in(family_.source.text()));
  if (!requirement.text.empty()) condition += fmt::format(" ({})", requirement.text);
  report(DiagnosticId::family_constraint_failed, requirement.span, {std::move(condition)});
}

void Binder::check_curve(const CurveShape& curve) {
  std::vector<ir::ExpressionId> all = curve.knots;
  all.insert(all.end(), {curve.t.low, curve.t.high, curve.tolerance});
  for (const CurvePoint& point : curve.points) all.insert(all.end(), {point.x, point.y, point.weight});
  for (const ir::ExpressionId one : all) {
    if (one != ir::ExpressionId::none && !compute(one)) return;
  }
  const std::string fault = fault_of(result_.bound, curve);
  if (!fault.empty()) report(DiagnosticId::family_syntax, curve.span, {fault});
}

void Binder::check_surface(const NurbsSurfaceShape& surface) {
  if (!compute(surface.row) || !compute(surface.tolerance)) return;
  const std::string fault = fault_of(result_.bound, surface);
  if (!fault.empty()) report(DiagnosticId::family_syntax, surface.span, {fault});
}

void Binder::count_chords(const ChordedCurve& curve) {
  std::uint8_t& knows_parameter = known_[static_cast<std::size_t>(curve.parameter)];
  const std::uint8_t before = std::exchange(knows_parameter, 1);
  const auto unknown = [this](ir::ExpressionId e) { return names_unknown(family_.arena, e, known_); };
  bool open = unknown(curve.t.low) || unknown(curve.t.high) || unknown(curve.error);
  for (const StepWord& word : words_of(family_, curve))
    open = open || (names(family_.arena, word.value, curve.parameter) && unknown(word.value));
  knows_parameter = before;
  if (open)
    return report(DiagnosticId::family_syntax, curve.span,
                  {"the chords of a curve are counted before the program runs, and what the program computes changes "
                   "this one: use 'steps' in place of 'within'"});
  if (!compute(curve.t.low) || !compute(curve.t.high) || !compute(curve.error)) return;
  const ChordCounts counts = chord_counts(result_.bound, curve);
  if (!counts.fault.empty()) return report(DiagnosticId::family_syntax, curve.span, {counts.fault});
  put(curve.counts, counts.by_piece);
}

void Binder::find_points(const PointCurve& curve) {
  std::vector<ir::SymbolId> lists = {curve.weights};
  if (!curve.has_own_knots) lists.push_back(curve.knots);
  for (const PointCurve::Axis& axis : curve.axes) lists.push_back(axis.list);
  const auto changes = [this](ir::SymbolId one) {
    return one != ir::SymbolId::none && known_[static_cast<std::size_t>(one)] == 0;
  };
  if (std::ranges::any_of(lists, changes))
    return report(DiagnosticId::family_syntax, curve.span,
                  {"the program changes a list of this curve: its points, weights and knots are those of parameters "
                   "and of what follows from them"});
  if (const std::string fault = fault_of(result_.bound, curve); !fault.empty())
    return report(DiagnosticId::family_syntax, curve.span, {fault});
  if (curve.has_own_knots) put(curve.knots, own_knots(result_.bound, curve));
  if (curve.error == ir::ExpressionId::none) return;
  if (names_unknown(family_.arena, curve.error, known_))
    return report(DiagnosticId::family_syntax, curve.span,
                  {"the chords of a curve are counted before the program runs, and what the program computes changes "
                   "the error of this one: use 'steps' in place of 'within'"});
  if (!compute(curve.error)) return;
  const ChordCounts counts = point_chord_counts(result_.bound, curve);
  if (!counts.fault.empty()) return report(DiagnosticId::family_syntax, curve.span, {counts.fault});
  put(curve.counts, counts.by_piece);
}

void Binder::put(ir::SymbolId list, const std::vector<double>& numbers) {
  std::ranges::copy(numbers, result_.bound.values.begin() + static_cast<std::ptrdiff_t>(value_of(list)));
}

BindResult bind_family(std::shared_ptr<const Family> family, std::span<const Override> overrides) {
  return Binder(std::move(family), overrides).bind();
}

}  // namespace dripfeed::family
