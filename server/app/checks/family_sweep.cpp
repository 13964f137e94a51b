// Values are written as people write them, in the parameter's own unit, so that a failing example can be tried by hand.
#include "server/app/checks/family_sweep.h"

#include <algorithm>
#include <cmath>

#include "dialects/text/number.h"
#include "server/app/checks/examine.h"
#include "server/app/checks/timed_rendering.h"

namespace dripfeed::app {

namespace {

std::vector<sweep::Parameter> parameters_of(const FamilySweep& order) {
  std::vector<sweep::Parameter> parameters;
  for (const compile::ParameterDescription& one : compile::describe_family(order.family).parameters) {
    // Lists, choices, tools and texts keep their defaults.
    if (one.most > 0 || !one.choices.empty() || one.kind == "tool" || one.kind == "text") continue;
    if (std::ranges::find(order.fixed, one.name, &family::Override::name) != order.fixed.end()) continue;
    const std::string_view number = std::string_view(one.standard).substr(0, one.standard.find(' '));
    const double standard = text::parse_number(number).value_or(one.low);
    const double step = one.kind == "count" ? std::max(one.step, 1.0) : one.step;
    parameters.push_back({one.name, one.unit, one.low, one.high, standard, step});
  }
  return parameters;
}

sweep::Trial failed_by(const text::Diagnostic& diagnostic) {
  return {false, std::string(text::row_of(diagnostic.id).name), text::message_of(diagnostic)};
}

// The first error of a list; passing without one.
sweep::Trial trial_of(const std::vector<text::Diagnostic>& diagnostics) {
  const auto error = std::ranges::find(diagnostics, text::Severity::error, &text::Diagnostic::severity);
  return error == diagnostics.end() ? sweep::Trial{true, {}, {}} : failed_by(*error);
}

sweep::Trial trial_of(const checks::FindingList& findings) {
  for (const checks::Finding& one : findings.kept()) {
    if (one.severity == text::Severity::error) return {false, std::string(text::row_of(one.id).name), one.text};
  }
  return {true, {}, {}};
}

sweep::Trial trial_of(const CheckReport& report) {
  if (report.verdict != checks::Verdict::fail) return {true, {}, {}};
  std::vector<sweep::Trial> trials = {trial_of(report.checks.diagnostics)};
  checks::for_each_check(report.checks, [&](const auto& one) { trials.push_back(trial_of(one.findings)); });
  const auto failed = std::ranges::find(trials, false, &sweep::Trial::passes);
  return failed == trials.end() ? sweep::Trial{false, "verdict", "the verdict is fail"} : *failed;
}

compile::RenderRequest request_of(const FamilySweep& order, std::vector<family::Override> values,
                                  compile::RenderMode mode) {
  return {.family = order.family,
          .values = std::move(values),
          .target = order.control,
          .mode = mode,
          .delivery = order.delivery,
          .program_name = {},
          .heading = {}};
}

// One for all trials: what the machine takes for the values that the fixed ones and the defaults give.
compile::RenderMode mode_of(const FamilySweep& order) {
  if (order.mode != compile::RenderMode::automatic) return order.mode;
  return render_for(request_of(order, order.fixed, order.mode), order.profile).mode;
}

}  // namespace

sweep::Report sweep_family(const FamilySweep& order) {
  const std::vector<sweep::Parameter> parameters = parameters_of(order);
  const compile::RenderMode mode = mode_of(order);
  const auto attempt = [&](std::span<const double> values) {
    std::vector<family::Override> overrides = order.fixed;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      std::string value = text::format_shortest(values[i]);
      if (!parameters[i].unit.empty()) value += " " + parameters[i].unit;
      overrides.push_back({parameters[i].name, std::move(value)});
    }
    compile::RenderResult rendered = compile::render(request_of(order, std::move(overrides), mode));
    if (text::has_error(rendered.diagnostics)) return trial_of(rendered.diagnostics);
    Examination e{.source = text::Source(order.family.name(), std::move(rendered.text)),
                  .dialect = compile::find_dialect(order.control.dialect),
                  .control = order.control,
                  .inferred = false,
                  .profile = order.profile,
                  .delivery = order.delivery,
                  .find_called = {},
                  .geometry = {},
                  .profile_lines = std::move(rendered.profile_lines)};
    // What is found without a map of the part need not be paid for with one.
    if (sweep::Trial failed = trial_of(examine(e)); !failed.passes) return failed;
    e.geometry = std::move(rendered.geometry);
    return trial_of(examine(e));
  };
  return sweep::sweep(parameters, attempt, order.settings);
}

}  // namespace dripfeed::app
