// Overrides are read and checked one by one, then lets are computed in order, then conditions and loops are tried.
#include "dialects/family/bind.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/family/chord_counts.h"
#include "dialects/family/contour_check.h"
#include "dialects/family/engraving.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/geometry.h"
#include "dialects/family/point_chords.h"
#include "dialects/family/text_value.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

using text::DiagnosticId;

// A loop bound that lies this part of a step on the wrong side is rounding, not a mistake.
constexpr double kStepTolerance = 1e-6;

// More trips than this are a mistyped step.
constexpr double kLargestTrips = 10'000'000.0;

class Binder {
 public:
  Binder(std::shared_ptr<const Family> family, std::span<const Override> overrides)
      : family_(*family), overrides_(overrides) {
    const std::size_t symbols = family_.arena.symbols.size();
    result_.bound = {std::move(family), std::vector<double>(symbols, 0.0), {}};
    known_.assign(symbols, 0);
  }

  BindResult bind() {
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
    for (const Step& step : family_.steps)
      if (step.kind == StepKind::set) known_[static_cast<std::size_t>(step.target)] = 0;
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
      if (step.kind == StepKind::message) check_message(step);
      if (step.kind == StepKind::engrave) check_engraving(step);
      check_indices(step);
    }
    return std::move(result_);
  }

 private:
  double& value_of(ir::SymbolId symbol) { return result_.bound.values[static_cast<std::size_t>(symbol)]; }
  void know(ir::SymbolId symbol, double value) {
    value_of(symbol) = value;
    known_[static_cast<std::size_t>(symbol)] = 1;
  }

  void report(DiagnosticId id, text::Span span, std::vector<std::string> arguments) {
    result_.diagnostics.push_back(text::make_diagnostic(id, span, std::move(arguments)));
  }

  void parameters() {
    std::unordered_map<std::string_view, const Parameter*> by_name;
    for (const Parameter& parameter : family_.parameters) {
      if (parameter.kind == ParameterKind::list) {
        given_lists_.emplace(parameter.symbol, parameter.standards);
      } else {
        know(parameter.symbol, parameter.standard);
      }
      if (parameter.kind == ParameterKind::text) result_.bound.texts.emplace(parameter.symbol, parameter.standard_text);
      by_name.try_emplace(parameter.name, &parameter);
    }
    std::unordered_map<std::string_view, const Override*> given_names;
    const std::vector<Override> overrides = with_axes();
    for (const Override& given : overrides) {
      if (const auto [earlier, is_first] = given_names.try_emplace(given.name, &given); !is_first) {
        const auto of = by_name.find(given.name);
        report(DiagnosticId::family_given_twice, of == by_name.end() ? text::Span{} : of->second->span,
               {given.name, earlier->second->value, given.value});
        continue;
      }
      if (const auto found = by_name.find(given.name); found != by_name.end()) {
        set(*found->second, given.value);
      } else {
        report(DiagnosticId::family_unknown_parameter, {}, {given.name});
      }
    }
    for (const PointParameter& points : family_.points) check_axes(points);
  }

  // The overrides, with a list of points as one list an axis.
  std::vector<Override> with_axes() {
    std::vector<Override> out;
    for (const Override& given : overrides_) {
      const PointParameter* points = family_.find_points(given.name);
      if (points == nullptr) {
        out.push_back(given);
        continue;
      }
      const std::optional<std::vector<std::string>> axes = axes_of_points(given.value, points->axes.size());
      if (!axes)
        report(DiagnosticId::family_syntax, points->span,
               {fmt::format("{}: '{}' are not points of {} numbers, such as ({})", points->name, given.value,
                            points->axes.size(), standard_point(*points))});
      for (std::size_t i = 0; axes && i < axes->size(); ++i)
        out.push_back({family_.parameters[points->first + i].name, (*axes)[i]});
    }
    return out;
  }

  [[nodiscard]] std::string standard_point(const PointParameter& points) const {
    std::string out;
    for (std::size_t i = 0; i < points.axes.size(); ++i) {
      const Parameter& axis = family_.parameters[points.first + i];
      out += fmt::format("{}{}", i == 0 ? "" : ", ", format_value(axis, axis.standards.front()));
    }
    return out;
  }

  void check_axes(const PointParameter& points) {
    const auto count = [&](std::size_t row) { return given_lists_.at(family_.parameters[row].symbol).size(); };
    for (std::size_t row = points.first + 1; row < points.first + points.axes.size(); ++row)
      if (count(row) != count(points.first))
        report(DiagnosticId::family_syntax, points.span,
               {fmt::format("{} has {} numbers and {} has {}: a point has one of each",
                            family_.parameters[points.first].name, count(points.first), family_.parameters[row].name,
                            count(row))});
  }

  void set(const Parameter& parameter, const std::string& written) {
    switch (parameter.kind) {
      case ParameterKind::number:
      case ParameterKind::tool:
        if (const std::optional<double> value = number_of(parameter, written)) know(parameter.symbol, *value);
        return;
      case ParameterKind::choice:
      case ParameterKind::yes_no: return set_choice(parameter, written);
      case ParameterKind::list: return set_list(parameter, written);
      case ParameterKind::text: return set_text(parameter, written);
    }
  }

  void set_text(const Parameter& parameter, const std::string& written) {
    std::string fault = fault_of_text(written);
    if (fault.empty() &&
        (std::cmp_less(written.size(), parameter.fewest) || std::cmp_greater(written.size(), parameter.most)))
      fault = fmt::format("the text has {} characters, {} to {} are allowed", written.size(), parameter.fewest,
                          parameter.most);
    if (!fault.empty())
      return report(DiagnosticId::family_syntax, parameter.span, {fmt::format("{}: {}", parameter.name, fault)});
    result_.bound.texts.insert_or_assign(parameter.symbol, written);
  }

  void set_choice(const Parameter& parameter, const std::string& written) {
    const auto place = std::ranges::find(parameter.choices, written);
    if (place != parameter.choices.end())
      return know(parameter.symbol, static_cast<double>(place - parameter.choices.begin()));
    report(DiagnosticId::family_syntax, parameter.span,
           {fmt::format("{}: '{}' is none of {}", parameter.name, written, fmt::join(parameter.choices, ", "))});
  }

  // "10 mm, 12 mm"
  void set_list(const Parameter& parameter, const std::string& written) {
    std::vector<double> numbers;
    for (std::string_view rest = written; !rest.empty();) {
      const std::string_view one = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(rest.size(), one.size() + 1));
      const std::optional<double> number = number_of(parameter, std::string(one));
      if (!number) return;
      numbers.push_back(*number);
    }
    const auto given = static_cast<std::int32_t>(numbers.size());
    if (given >= parameter.fewest && given <= parameter.most) {
      given_lists_.insert_or_assign(parameter.symbol, std::move(numbers));
      return;
    }
    report(DiagnosticId::family_syntax, parameter.span,
           {fmt::format("{} has {} numbers, {} to {} are allowed", parameter.name, given, parameter.fewest,
                        parameter.most)});
  }

  // The stored value of a quantity that the parameter may have; nothing after a fault.
  std::optional<double> number_of(const Parameter& parameter, const std::string& written) {
    WrittenValue read = read_value(parameter, written);
    if (read.fault) report(read.fault->id, parameter.span, std::move(read.fault->arguments));
    return read.fault ? std::nullopt : std::optional(read.stored);
  }

  // The value, or nothing and a diagnostic at the operation that has none.
  std::optional<double> compute(ir::ExpressionId expression) {
    const std::vector<double>& values = result_.bound.values;
    const double value = evaluate(family_.arena, expression, values).value;
    if (std::isfinite(value)) return value;
    const text::Span at = family_.arena.at(first_undefined(family_.arena, expression, values)).span;
    report(DiagnosticId::argument_out_of_domain, at, {std::string(at.in(family_.source.text())), "these values"});
    return std::nullopt;
  }

  // The points of every interpolation in it: two or more, from left to right, which no step changes.
  bool check_points(ir::ExpressionId id) {
    if (id == ir::ExpressionId::none) return true;
    const ir::Expression& e = family_.arena.at(id);
    const int operands = ir::operand_count(e.op);
    if (e.op != kAlong) return operands == 0 || (check_points(e.a) && (operands == 1 || check_points(e.b)));
    if (!check_points(e.a)) return false;
    const std::string fault = fault_of_points(points_of(family_.arena, e));
    if (!fault.empty()) report(DiagnosticId::family_syntax, e.span, {fault});
    return fault.empty();
  }

  [[nodiscard]] std::string fault_of_points(const PointLists& lists) const {
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

  void define(const Definition& definition) {
    if (!check_points(definition.value)) return;
    if (const std::optional<double> value = compute(definition.value)) know(definition.symbol, *value);
  }

  // Its numbers follow all others; see list_in.
  void define(const List& list) {
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

  void check(const Requirement& requirement) {
    if (!check_points(requirement.condition)) return;
    const std::optional<double> holds = compute(requirement.condition);
    if (!holds || *holds != 0.0) return;
    std::string condition(requirement.span.in(family_.source.text()));
    if (!requirement.text.empty()) condition += fmt::format(" ({})", requirement.text);
    report(DiagnosticId::family_constraint_failed, requirement.span, {std::move(condition)});
  }

  void check_curve(const CurveShape& curve) {
    std::vector<ir::ExpressionId> all = curve.knots;
    all.insert(all.end(), {curve.t.low, curve.t.high, curve.tolerance});
    for (const CurvePoint& point : curve.points) all.insert(all.end(), {point.x, point.y, point.weight});
    for (const ir::ExpressionId one : all) {
      if (one != ir::ExpressionId::none && !compute(one)) return;
    }
    const std::string fault = fault_of(result_.bound, curve);
    if (!fault.empty()) report(DiagnosticId::family_syntax, curve.span, {fault});
  }

  // Only where the curve depends on nothing of the body its chords are counted before the program runs.
  void count_chords(const ChordedCurve& curve) {
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

  // Checks a curve by its points, and finds the lists that follow from them.
  void find_points(const PointCurve& curve) {
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

  // Numbers of a list, for which there is room.
  void put(ir::SymbolId list, const std::vector<double>& numbers) {
    std::ranges::copy(numbers, result_.bound.values.begin() + static_cast<std::ptrdiff_t>(value_of(list)));
  }

  // Of verbs that stand for many moves, but not in a branch that these values do not take.
  void check_verbs() {
    struct Branch {
      bool is_reached;  // the `if`
      bool takes_first, takes_other;
    };
    std::vector<Branch> open;
    bool is_reached = true;
    for (const Step& step : family_.steps) {
      if (step.kind == StepKind::if_begin) {
        const bool known = is_reached && !names_unknown(family_.arena, step.values[0], known_);
        const bool holds = known && compute(step.values[0]).value_or(1.0) != 0.0;
        open.push_back({is_reached, !known || holds, !known || !holds});
        is_reached = is_reached && open.back().takes_first;
      } else if (step.kind == StepKind::if_else && !open.empty()) {
        is_reached = open.back().is_reached && open.back().takes_other;
      } else if (step.kind == StepKind::if_end && !open.empty()) {
        is_reached = open.back().is_reached;
        open.pop_back();
      } else if (step.kind == StepKind::require && is_reached) {
        check_verb(step);
      } else if (step.kind == StepKind::contour && is_reached) {
        const RoughContour& contour = family_.contours[static_cast<std::size_t>(step.number)];
        if (const auto fault = fault_of_contour(result_.bound, known_, contour))
          report(DiagnosticId::family_syntax, fault->span, {fault->text});
      }
    }
  }

  void check_verb(const Step& step) {
    if (names_unknown(family_.arena, step.values[0], known_))
      return report(
          DiagnosticId::family_syntax, step.span,
          {"the sizes of a face or a pocket are checked before the program runs: they depend on parameters only, "
           "and on what follows from them"});
    const std::optional<double> holds = compute(step.values[0]);
    if (holds && *holds == 0.0) report(DiagnosticId::family_syntax, step.span, {step.text});
  }

  // Those that are known before the program runs.
  void check_indices(const Step& step) {
    if (step.kind == StepKind::set && step.values[1] != ir::ExpressionId::none)
      check_index(step.target, step.values[1]);
    for (const ir::ExpressionId value : step.values) check_indices(value);
    for (std::uint32_t i = 0; i < step.word_count; ++i) check_indices(family_.words[step.first_word + i].value);
  }

  void check_indices(ir::ExpressionId id) {
    if (id == ir::ExpressionId::none) return;
    const ir::Expression& e = family_.arena.at(id);
    const int operands = ir::operand_count(e.op);
    if (operands > 0) check_indices(e.a);
    if (operands > 1) check_indices(e.b);
    if (e.op == kAlong) (void)check_points(id);
    if (e.op != ir::Operator::variable) return;
    const ir::Variable& v = family_.arena.at(e.variable);
    if (v.index == ir::ExpressionId::none) return;
    check_indices(v.index);
    check_index(v.symbol, v.index);
  }

  void check_index(ir::SymbolId list, ir::ExpressionId index) {
    if (names_unknown(family_.arena, index, known_)) return;
    const std::optional<double> at = compute(index);
    const std::size_t count = list_in(result_.bound.values, list).size();
    if (!at || (*at >= 0.0 && *at < static_cast<double>(count) && is_whole(*at))) return;
    report(DiagnosticId::family_syntax, family_.arena.at(index).span,
           {fmt::format("{} has the numbers [0] to [{}], and none [{}]",
                        family_.arena.strings.at(family_.arena.at(list).name), count - 1, text::format_shortest(*at))});
  }

  // The shape of a tool is known before the program runs.
  void check_tool(const Step& step) {
    for (const ir::ExpressionId one : step.values) {
      if (one == ir::ExpressionId::none) continue;
      if (names_unknown(family_.arena, one, known_)) {
        report(DiagnosticId::family_syntax, step.span, {"a tool's shape may depend on parameters only"});
        return;
      }
      const std::optional<double> value = compute(one);
      if (value && *value < 0.0) report(DiagnosticId::family_syntax, step.span, {"a tool's shape is negative"});
    }
  }

  // Only loops that depend on nothing of the body are known before the program runs.
  void check_loop(const Step& step) {
    const auto unknown = [this](ir::ExpressionId e) { return names_unknown(family_.arena, e, known_); };
    if (std::ranges::any_of(step.values, unknown)) return;
    const std::optional<double> from = compute(step.values[0]);
    const std::optional<double> to = compute(step.values[1]);
    const std::optional<double> by = compute(step.values[2]);
    if (!from || !to || !by) return;
    const double span = step.down ? *from - *to : *to - *from;
    const auto written = [](double value) { return text::format_shortest(value); };
    if (*by <= 0.0) {
      report(DiagnosticId::family_bad_loop, step.span,
             {fmt::format("has the step {}; steps are positive", written(*by))});
    } else if (span < -kStepTolerance * *by) {
      report(DiagnosticId::family_bad_loop, step.span,
             {fmt::format("counts {} from {} to {}", step.down ? "down" : "up", written(*from), written(*to))});
    } else if (span / *by > kLargestTrips) {
      report(DiagnosticId::family_bad_loop, step.span, {"runs more than ten million times"});
    }
  }

  // Its pitch is its last word.
  void check_thread(const Step& step) {
    const ir::ExpressionId pitch = family_.words[step.first_word + step.word_count - 1].value;
    if (names_unknown(family_.arena, pitch, known_)) return;
    const std::optional<double> value = compute(pitch);
    if (value && *value <= 0.0)
      report(DiagnosticId::thread_invalid, step.span, {fmt::format("its pitch is {}", text::format_shortest(*value))});
  }

  void check_engraving(const Step& step) {
    const std::string fault = fault_of_engraving(result_.bound.texts.at(step.target));
    if (fault.empty()) return;
    const auto parameter = std::ranges::find(family_.parameters, step.target, &Parameter::symbol);
    report(DiagnosticId::family_syntax, parameter->span,
           {fmt::format("{}: {} cannot be engraved: there are letters, digits, blanks and + - . / ,", parameter->name,
                        fault)});
  }

  // No control can write what it computes into a message.
  void check_message(const Step& step) {
    for (std::uint32_t i = 0; i < step.word_count; ++i) {
      const ir::ExpressionId value = family_.words[step.first_word + i].value;
      if (names_unknown(family_.arena, value, known_))
        report(DiagnosticId::family_syntax, family_.arena.at(value).span,
               {"a message takes values of parameters, which stand in its text, and none that the program computes"});
      else
        (void)compute(value);
    }
  }

  // Levels that depend on the body are the control's to find; a dwell and a pitch are numbers in the text.
  void check_holes(const Step& step) {
    std::optional<double> top;
    for (std::uint32_t i = 0; i < step.word_count; ++i) {
      const StepWord& word = family_.words[step.first_word + i];
      if (names_unknown(family_.arena, word.value, known_)) {
        if (!is_number_of_cycle(word.address)) continue;
        report(DiagnosticId::family_syntax, step.span,
               {"the dwell and the pitch of holes may depend on parameters only"});
        return;
      }
      const std::optional<double> value = compute(word.value);
      if (!value) return;
      if (word.address == ir::Address::r) top = value;
      if (const std::string fault = fault_of_hole(word.address, *value, top); !fault.empty())
        return report(DiagnosticId::family_bad_hole, step.span, {fault});
    }
    if (step.values[0] == ir::ExpressionId::none || names_unknown(family_.arena, step.values[0], known_)) return;
    const std::optional<double> back = compute(step.values[0]);
    if (back && top && *back < *top)
      report(DiagnosticId::family_bad_hole, step.span,
             {fmt::format("returns to {}, below {} where its feed begins", text::format_shortest(*back),
                          text::format_shortest(*top))});
  }

  static std::string fault_of_hole(ir::Address address, double value, const std::optional<double>& top) {
    const std::string written = text::format_shortest(value);
    if (address == ir::Address::z && top && value >= *top)
      return fmt::format("leads from {} to {}, which is not down", text::format_shortest(*top), written);
    if (address == ir::Address::q && value <= 0.0) return fmt::format("has pecks of {}", written);
    if (address == ir::Address::f && value <= 0.0) return fmt::format("has the pitch {}", written);
    if (address == ir::Address::p && value < 0.0) return fmt::format("has a dwell of {} s", written);
    return {};
  }

  const Family& family_;
  std::span<const Override> overrides_;
  BindResult result_;
  std::vector<std::uint8_t> known_;                          // by symbol
  std::map<ir::SymbolId, std::vector<double>> given_lists_;  // of parameters
};

}  // namespace

std::optional<std::vector<std::string>> axes_of_points(std::string_view written, std::size_t axes) {
  const auto trim = [&] { written.remove_prefix(std::min(written.find_first_not_of(" \t"), written.size())); };
  std::vector<std::string> out(axes);
  for (trim(); !written.empty(); trim()) {
    const std::size_t close = written.find(')');
    if (written.front() != '(' || close == std::string_view::npos) return std::nullopt;
    std::string_view point = written.substr(1, close - 1);
    if (static_cast<std::size_t>(std::ranges::count(point, ',')) + 1 != axes) return std::nullopt;
    for (std::string& axis : out) {
      const std::string_view number = point.substr(0, point.find(','));
      point.remove_prefix(std::min(point.size(), number.size() + 1));
      axis += fmt::format("{}{}", axis.empty() ? "" : ", ", number);
    }
    written.remove_prefix(close + 1);
    trim();
    if (written.empty()) return out;
    if (written.front() != ',') return std::nullopt;
    written.remove_prefix(1);
  }
  return std::nullopt;  // nothing, or nothing after a comma
}

std::int32_t tool_number(const BoundFamily& bound, const Step& step) {
  if (step.target == ir::SymbolId::none) return step.number;
  return static_cast<std::int32_t>(bound.values[static_cast<std::size_t>(step.target)]);
}

WrittenValue read_value(const Parameter& parameter, const std::string& written) {
  const auto fault = [](DiagnosticId id, std::vector<std::string> arguments) {
    return WrittenValue{.stored = 0.0, .fault = ValueFault{id, std::move(arguments)}};
  };
  const std::optional<Quantity> quantity = parse_quantity(written);
  if (!quantity)
    return fault(DiagnosticId::family_syntax,
                 {fmt::format("{}: '{}' is not a number with a unit", parameter.name, written)});
  const std::string named = fmt::format("{} = {}", parameter.name, written);
  const Dimension dimension = quantity->unit == nullptr ? kRatio : quantity->unit->dimension;
  if (quantity->unit == nullptr && parameter.dimension != kRatio)
    return fault(
        DiagnosticId::family_missing_unit,
        {named, fmt::format("{}, such as {} {}", describe(parameter.dimension), written, parameter.unit->name)});
  if (dimension != parameter.dimension)
    return fault(DiagnosticId::family_wrong_unit, {named, describe(dimension), describe(parameter.dimension)});
  return {.stored = quantity->stored(), .fault = fault_of_value(parameter, quantity->stored(), written)};
}

BindResult bind_family(std::shared_ptr<const Family> family, std::span<const Override> overrides) {
  return Binder(std::move(family), overrides).bind();
}

}  // namespace dripfeed::family
