// A parameter that is a list of points: (x, y) by (x, y). Each axis is a list of its own, NAME.x, so that everything
// that takes lists takes them.
#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/parameter_reader.h"

namespace dripfeed::family {

namespace {

constexpr auto kPointAxes = std::to_array<std::string_view>({"xy", "xz", "yz", "xyz"});

}  // namespace

// list of points AXIS AXIS [AXIS] (VALUE, VALUE), ... range count FEWEST .. MOST
void ParameterReader::points(const NewName& name, std::uint32_t line) {
  std::vector<Parameter> axes = axes_of(name);
  std::size_t count = 0;
  while (!cursor_.line_failed() && point(axes)) {
    ++count;
    if (!cursor_.accept_symbol(",")) break;
  }
  if (!cursor_.line_failed()) ranges(axes);
  if (!cursor_.line_failed() && !axes.empty()) count_range(axes.front(), count, "points", kMostNumbers);
  if (!cursor_.line_failed() && !axes.empty()) trailer(axes.front());
  if (axes.empty()) return;
  (void)scope_.define(family_.arena, name.name, kLength, name.span, NameKind::points);
  const auto row = std::ranges::find_if(kPointAxes, [&](std::string_view one) {
    return one.size() == axes.size() && one.front() == axes.front().name.back() &&
           one.back() == axes.back().name.back();
  });
  family_.points.push_back({.name = name.name,
                            .first = static_cast<std::uint32_t>(family_.parameters.size()),
                            .axes = row == kPointAxes.end() ? std::string_view() : *row,
                            .span = name.span});
  const Parameter first = axes.front();
  for (Parameter& axis : axes) {
    axis.fewest = first.fewest;
    axis.most = first.most;
    axis.step = first.step;
    axis.text = first.text;
    axis.group = first.group;
    for (const double one : axis.standards)
      if (!cursor_.line_failed()) check(axis, one, axis.span);
    define_list(axis, {axis.name, axis.span}, line);
    family_.parameters.push_back(std::move(axis));
  }
}

// "x y": one list each, without numbers.
std::vector<Parameter> ParameterReader::axes_of(const NewName& name) {
  std::string letters;
  const text::Span at = cursor_.peek().span;
  while (cursor_.at_word("x") || cursor_.at_word("y") || cursor_.at_word("z")) {
    letters += cursor_.word();
    cursor_.advance();
  }
  if (std::ranges::find(kPointAxes, letters) == kPointAxes.end()) {
    cursor_.syntax(at, "points have the axes x y, x z, y z or x y z");
    return {};
  }
  std::vector<Parameter> out;
  for (const char letter : letters) {
    Parameter axis;
    axis.name = fmt::format("{}.{}", name.name, letter);
    axis.kind = ParameterKind::list;
    axis.quantity = find_quantity("length")->name;
    axis.dimension = kLength;
    axis.span = name.span;
    out.push_back(std::move(axis));
  }
  return out;
}

// "(" VALUE { "," VALUE } ")"
bool ParameterReader::point(std::vector<Parameter>& axes) {
  cursor_.expect_symbol("(");
  for (std::size_t i = 0; i < axes.size() && !cursor_.line_failed(); ++i) {
    if (i > 0) cursor_.expect_symbol(",");
    if (cursor_.line_failed()) break;
    if (const auto value = standard(axes[i], *find_quantity("length"))) axes[i].standards.push_back(*value);
  }
  if (!cursor_.line_failed()) cursor_.expect_symbol(")");
  return !cursor_.line_failed();
}

// "in" LOW ".." HIGH of all, or one an axis: AXIS "in" LOW ".." HIGH.
void ParameterReader::ranges(std::vector<Parameter>& axes) {
  if (!cursor_.at_word("in")) {
    for (Parameter& axis : axes) {
      cursor_.expect_word(std::string_view(axis.name).substr(axis.name.size() - 1));
      if (cursor_.line_failed()) return;
      range(axis);
    }
    return;
  }
  range(axes.front());
  for (Parameter& axis : axes) {
    axis.low = axes.front().low;
    axis.high = axes.front().high;
  }
}

}  // namespace dripfeed::family
