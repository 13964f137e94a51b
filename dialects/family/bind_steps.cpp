// Steps whose values are known before the program runs.
#include <algorithm>

#include <fmt/format.h>

#include "dialects/family/binder.h"
#include "dialects/family/contour_check.h"
#include "dialects/family/engraving.h"
#include "dialects/family/offset_check.h"
#include "dialects/family/point_chords.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

using text::DiagnosticId;

namespace {

// A loop bound that lies this part of a step on the wrong side is rounding, not a mistake.
constexpr double kStepTolerance = 1e-6;

// More trips than this are a mistyped step.
constexpr double kLargestTrips = 10'000'000.0;

}  // namespace

void Binder::check_verbs() {
  struct Branch {
    bool is_reached;  // the `if`
    bool takes_first, takes_other;
  };
  std::vector<Branch> open;
  bool is_reached = true;
  const std::vector<std::uint8_t> known_before = known_;
  for (const Step& step : family_.steps) {
    follow(step);
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
    } else if (step.kind == StepKind::offset && is_reached) {
      check_offset(family_.offsets[static_cast<std::size_t>(step.number)]);
    }
  }
  known_ = known_before;
  for (const OffsetContour& one : family_.offsets)
    for (const OffsetContour::Item& item : one.items)
      for (const ir::SymbolId symbol : {item.corner, item.direction})
        if (symbol != ir::SymbolId::none) known_[static_cast<std::size_t>(symbol)] = 1;
}

// What a let of the body is where the next steps stand: what follows from parameters alone.
void Binder::follow(const Step& step) {
  if (step.kind == StepKind::for_begin || step.kind == StepKind::for_in_begin)
    known_[static_cast<std::size_t>(step.target)] = 0;  // a closed block may have had the name for a let
  if (step.kind != StepKind::let || sets_.contains(step.target)) return;
  if (!names_unknown(family_.arena, step.values[0], known_))
    know(step.target, evaluate(family_.arena, step.values[0], result_.bound.values).value);
  else
    known_[static_cast<std::size_t>(step.target)] = 0;
}

void Binder::check_offset(const OffsetContour& contour) {
  const OffsetCorners corners = corners_of(result_.bound, known_, contour);
  if (corners.fault) return report(DiagnosticId::family_syntax, corners.fault->span, {corners.fault->text});
  for (const auto& [symbol, value] : corners.values) {
    if (known_[static_cast<std::size_t>(symbol)] != 0 && value_of(symbol) != value)
      return report(DiagnosticId::family_syntax, contour.span,
                    {"the calls of this contour differ in a corner that is an outer one in one of them and not in "
                     "another: write it as two contours"});
    know(symbol, value);
  }
}

void Binder::check_equal_steps(const Step& step) {
  for (const ir::ExpressionId value : {step.values[0], step.values[1]})
    if (names_unknown(family_.arena, value, known_))
      return report(DiagnosticId::family_syntax, step.span,
                    {"the steps of a curve and how far it may lie from them depend on parameters only, and on what "
                     "follows from them"});
  const std::optional<double> count = compute(step.values[0]);
  const std::optional<double> most_mm = compute(step.values[1]);
  if (!count || !most_mm) return;
  const PointCurve& curve = family_.point_curves[static_cast<std::size_t>(step.number) - 1];
  const double height_mm = equal_steps_height(result_.bound, curve, *count);
  if (height_mm <= *most_mm) return;
  report(
      DiagnosticId::family_constraint_failed, step.span,
      {fmt::format("{} equal steps within {} mm (the curve lies up to {} mm from a chord)",
                   text::format_shortest(*count), text::format_shortest(*most_mm), text::format_fixed(height_mm, 4))});
}

void Binder::check_verb(const Step& step) {
  if (step.number > 0) return check_equal_steps(step);
  if (names_unknown(family_.arena, step.values[0], known_))
    return report(
        DiagnosticId::family_syntax, step.span,
        {"the sizes of a face or a pocket are checked before the program runs: they depend on parameters only, "
         "and on what follows from them"});
  const std::optional<double> holds = compute(step.values[0]);
  if (holds && *holds == 0.0) report(DiagnosticId::family_syntax, step.span, {step.text});
}

void Binder::check_indices(const Step& step) {
  if (step.kind == StepKind::set && step.values[1] != ir::ExpressionId::none) check_index(step.target, step.values[1]);
  for (const ir::ExpressionId value : step.values) check_indices(value);
  for (std::uint32_t i = 0; i < step.word_count; ++i) check_indices(family_.words[step.first_word + i].value);
}

void Binder::check_indices(ir::ExpressionId id) {
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

void Binder::check_index(ir::SymbolId list, ir::ExpressionId index) {
  if (names_unknown(family_.arena, index, known_)) return;
  const std::optional<double> at = compute(index);
  const std::size_t count = list_in(result_.bound.values, list).size();
  if (!at || (*at >= 0.0 && *at < static_cast<double>(count) && is_whole(*at))) return;
  report(DiagnosticId::family_syntax, family_.arena.at(index).span,
         {fmt::format("{} has the numbers [0] to [{}], and none [{}]",
                      family_.arena.strings.at(family_.arena.at(list).name), count - 1, text::format_shortest(*at))});
}

void Binder::check_tool(const Step& step) {
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

void Binder::check_loop(const Step& step) {
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

void Binder::check_thread(const Step& step) {
  const ir::ExpressionId pitch = family_.words[step.first_word + step.word_count - 1].value;
  if (names_unknown(family_.arena, pitch, known_)) return;
  const std::optional<double> value = compute(pitch);
  if (value && *value <= 0.0)
    report(DiagnosticId::thread_invalid, step.span, {fmt::format("its pitch is {}", text::format_shortest(*value))});
}

void Binder::check_cylinder(const Step& step) {
  if (names_unknown(family_.arena, step.values[0], known_))
    return report(DiagnosticId::family_syntax, step.span, {"the diameter of a cylinder may depend on parameters only"});
  const std::optional<double> diameter = compute(step.values[0]);
  if (diameter && *diameter <= 0.0)
    report(DiagnosticId::family_syntax, step.span,
           {fmt::format("the diameter of a cylinder is {}", text::format_shortest(*diameter))});
}

void Binder::check_engraving(const Step& step) {
  const std::string fault = fault_of_engraving(result_.bound.texts.at(step.target));
  if (fault.empty()) return;
  const auto parameter = std::ranges::find(family_.parameters, step.target, &Parameter::symbol);
  report(DiagnosticId::family_syntax, parameter->span,
         {fmt::format("{}: {} cannot be engraved: there are letters, digits, blanks and + - . / ,", parameter->name,
                      fault)});
}

void Binder::check_message(const Step& step) {
  for (std::uint32_t i = 0; i < step.word_count; ++i) {
    const ir::ExpressionId value = family_.words[step.first_word + i].value;
    if (names_unknown(family_.arena, value, known_))
      report(DiagnosticId::family_syntax, family_.arena.at(value).span,
             {"a message takes values of parameters, which stand in its text, and none that the program computes"});
    else
      (void)compute(value);
  }
}

void Binder::check_holes(const Step& step) {
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

std::string Binder::fault_of_hole(ir::Address address, double value, const std::optional<double>& top) {
  const std::string written = text::format_shortest(value);
  if (address == ir::Address::z && top && value >= *top)
    return fmt::format("leads from {} to {}, which is not down", text::format_shortest(*top), written);
  if (address == ir::Address::q && value <= 0.0) return fmt::format("has pecks of {}", written);
  if (address == ir::Address::f && value <= 0.0) return fmt::format("has the pitch {}", written);
  if (address == ir::Address::p && value < 0.0) return fmt::format("has a dwell of {} s", written);
  return {};
}

std::int32_t tool_number(const BoundFamily& bound, const Step& step) {
  if (step.target == ir::SymbolId::none) return step.number;
  return static_cast<std::int32_t>(bound.values[static_cast<std::size_t>(step.target)]);
}

}  // namespace dripfeed::family
