// Each parameter is moved a little, and the numbers of the text that follow it are its own. A changed number that
// follows one parameter alone gives that parameter's new value; then the family is rendered with all of them and every
// number is compared with what came.
#include "server/app/library/value_changes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/app/library/numbers_of.h"
#include "server/app/shop/catalog.h"

namespace dripfeed::app {

namespace {

using compile::ParameterDescription;

constexpr double kMove = 0.01;  // of the range, or of the value
constexpr int kDecimals = 6;    // as people write values

// A parameter with one number: its value now, and the numbers of the text that follow it.
struct Handle {
  const ParameterDescription* parameter = nullptr;
  double value = 0.0;
  double moved_by = 0.0;
  NumbersOf moved;
  std::set<std::size_t> follows;
};

bool has_one_number(const ParameterDescription& one) {
  return one.most == 0 && one.choices.empty() && one.kind != "text" && one.kind != "points" && one.kind != "tool";
}

// "100 mm" in the parameter's own unit; nothing for another unit.
std::optional<double> number_in(const ParameterDescription& parameter, std::string_view text) {
  const std::size_t blank = text.find(' ');
  const std::string_view unit = blank == std::string_view::npos ? std::string_view() : text.substr(blank + 1);
  if (!unit.empty() && unit != parameter.unit) return std::nullopt;
  return text::parse_number(text.substr(0, blank));
}

std::string text_of(const ParameterDescription& parameter, double value) {
  const std::string number = text::format_shortest(value);
  return parameter.unit.empty() ? number : fmt::format("{} {}", number, parameter.unit);
}

class Explainer {
 public:
  Explainer(const ValueOrder& order, const Documents& documents, const compile::Dialect& dialect, ir::Control control)
      : order_(order),
        documents_(documents),
        dialect_(dialect),
        control_(std::move(control)),
        family_(compile::describe_family(text::Source(order.work.family, order.work.text))),
        work_(order.work) {}

  ValueChanges explain() {
    stored_ = numbers_of(order_.stored, dialect_, control_);
    received_ = numbers_of(order_.received, dialect_, control_);
    if (const auto line = first_other_word(stored_, received_))
      return left(fmt::format("line {} has other words than the stored program, not only other numbers", *line), {});
    const std::vector<std::size_t> changed = other_numbers(stored_, received_);
    if (changed.empty()) return left("no number differs from the stored program", {});
    if (!find_rendering())
      return left("the family gives another text now than the stored one: render the part again", {});
    take_handles(changed);
    for (const std::size_t i : changed) read_value(i);
    if (values_.empty()) return left("no parameter of the family decides the numbers that differ", {});
    return judge();
  }

 private:
  [[nodiscard]] std::optional<NumbersOf> rendered(const Values& values) const {
    RenderWork work = work_;
    work.values = values;
    const auto done = render_family(work, documents_);
    if (!done) return std::nullopt;
    return numbers_of(done->result.text, dialect_, control_);
  }

  // The stored program may have been named by its part, and made faster.
  bool find_rendering() {
    for (const bool optimize : {false, true}) {
      work_.optimize = optimize;
      for (const std::string& name : {order_.work.name, std::string()}) {
        work_.name = name;
        const auto now = rendered(work_.values);
        if (now && !first_other_word(stored_, *now) && other_numbers(stored_, *now).empty()) return true;
      }
    }
    return false;
  }

  [[nodiscard]] std::string before(const ParameterDescription& parameter) const {
    const auto given = work_.values.find(parameter.name);
    return given == work_.values.end() ? parameter.standard : given->second;
  }

  // Moves it to where the text keeps its words; nothing where it cannot be moved so.
  [[nodiscard]] std::optional<Handle> moved(const ParameterDescription& parameter, double value) const {
    const double range = parameter.high > parameter.low ? parameter.high - parameter.low : std::abs(value);
    const double step = parameter.step > 0.0 ? parameter.step : kMove * (range > 0.0 ? range : 1.0);
    for (const double by : {step, -step, 0.01 * step, -0.01 * step}) {
      Values values = work_.values;
      values[parameter.name] = text_of(parameter, value + by);
      auto now = rendered(values);
      if (!now || first_other_word(stored_, *now)) continue;
      Handle handle{.parameter = &parameter, .value = value, .moved_by = by, .moved = std::move(*now), .follows = {}};
      for (const std::size_t i : other_numbers(stored_, handle.moved)) handle.follows.insert(i);
      return handle;
    }
    return std::nullopt;
  }

  void take_handles(const std::vector<std::size_t>& changed) {
    for (const ParameterDescription& one : family_.parameters) {
      const auto value = has_one_number(one) ? number_in(one, before(one)) : std::nullopt;
      auto handle = value ? moved(one, *value) : std::nullopt;
      if (handle && std::ranges::any_of(changed, [&](std::size_t i) { return handle->follows.contains(i); }))
        handles_.push_back(std::move(*handle));
    }
  }

  // The number at `i`, where it follows one parameter alone that has no new value yet.
  void read_value(std::size_t i) {
    const Handle* only = nullptr;
    for (const Handle& one : handles_) {
      if (!one.follows.contains(i)) continue;
      if (only != nullptr) return;
      only = &one;
    }
    if (only == nullptr || values_.contains(only->parameter->name)) return;
    if (const auto value = solve(*only, i)) values_.emplace(only->parameter->name, *value);
  }

  // By the slope, and to as few decimals as give that number in the text.
  [[nodiscard]] std::optional<double> solve(const Handle& handle, std::size_t i) const {
    const double now = stored_.numbers[i].value;
    const double wanted = received_.numbers[i].value;
    const double slope = (handle.moved.numbers[i].value - now) / handle.moved_by;
    const double value = handle.value + (wanted - now) / slope;
    double scale = 1.0;
    for (int decimals = 0; decimals <= kDecimals; ++decimals, scale *= 10.0) {
      const double rounded = std::round(value * scale) / scale;
      if (std::abs(slope * (rounded - value)) > kSameNumber && decimals < kDecimals) continue;
      return rounded;
    }
    return std::nullopt;
  }

  ValueChanges judge() {
    Values values = work_.values;
    for (const Handle& one : handles_)
      if (const auto value = values_.find(one.parameter->name); value != values_.end())
        values[one.parameter->name] = text_of(*one.parameter, value->second);
    const auto now = rendered(values);
    if (!now) return left("the family refuses these values: " + why_refused(values), {});
    if (first_other_word(*now, received_)) return left("with these values the family gives other blocks", {});
    return left(
        other_numbers(*now, received_).empty() ? "" : "some numbers are not what the family gives for these values",
        *now);
  }

  [[nodiscard]] std::string why_refused(const Values& values) const {
    RenderWork work = work_;
    work.values = values;
    const auto done = render_family(work, documents_);
    if (done) return "";
    return done.error().places.empty() ? done.error().text : done.error().places.front().text;
  }

  // `now`: the numbers that the values give; those that differ from what came are left over.
  ValueChanges left(std::string why_not, const NumbersOf& now) const {
    ValueChanges out{.values = {}, .rest = {}, .explains_all = why_not.empty(), .why_not = std::move(why_not)};
    for (const ParameterDescription& one : family_.parameters)
      if (const auto value = values_.find(one.name); value != values_.end())
        out.values.push_back({.name = one.name, .before = before(one), .after = text_of(one, value->second)});
    const NumbersOf& against = now.numbers.empty() ? stored_ : now;
    if (!first_other_word(against, received_)) add_rest(against, out);
    return out;
  }

  void add_rest(const NumbersOf& against, ValueChanges& out) const {
    if (out.explains_all) return;
    for (const std::size_t i : other_numbers(against, received_)) {
      const std::uint32_t line = received_.numbers[i].line;
      if (!out.rest.empty() && out.rest.back().line == line) continue;
      if (out.rest.size() == ValueChanges::kMostLeftOver) return;
      out.rest.push_back({.line = line,
                          .stored = line_of(order_.stored, stored_.numbers[i].line),
                          .received = line_of(order_.received, line)});
    }
  }

  static std::string line_of(std::string_view text, std::uint32_t line) {
    for (; line > 1 && !text.empty(); --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    std::string_view found = text.substr(0, text.find('\n'));
    while (!found.empty() && found.back() == '\r') found.remove_suffix(1);
    return std::string(found);
  }

  const ValueOrder& order_;
  const Documents& documents_;
  const compile::Dialect& dialect_;
  ir::Control control_;
  compile::FamilyDescription family_;
  RenderWork work_;  // that gives the stored text
  NumbersOf stored_;
  NumbersOf received_;
  std::vector<Handle> handles_;
  std::map<std::string, double, std::less<>> values_;
};

}  // namespace

Result<ValueChanges> explain_values(const ValueOrder& order, const Documents& documents) {
  const auto profile = documents.read_profile(order.work.profile);
  if (!profile) return std::unexpected(profile.error());
  const auto control = control_of(*profile);
  if (!control) return std::unexpected(control.error());
  const compile::Dialect* const dialect = compile::find_dialect(control->dialect);
  if (dialect == nullptr) return fail(ErrorCode::invalid, fmt::format("dialect \"{}\" is not known", control->dialect));
  return Explainer(order, documents, *dialect, *control).explain();
}

}  // namespace dripfeed::app
