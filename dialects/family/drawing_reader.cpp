// A place names two axes in either order: `x 0 mm y 10 mm`. All places of a declaration lie in one view.
#include "dialects/family/drawing_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/naming.h"

namespace dripfeed::family {

namespace {

struct ViewRow {
  std::string_view axes;  // the first one across
  bool turns;             // of lathes, or of mills
};
constexpr std::array kViews = {ViewRow{"zx", true}, ViewRow{"xy", false}, ViewRow{"xz", false}, ViewRow{"yz", false}};

constexpr bool fits(const ViewRow& view, ir::MachineKind machine) {
  return machine == ir::MachineKind::mill_turn || view.turns == (machine == ir::MachineKind::lathe);
}

}  // namespace

// A mill-turn's x and z are seen as a lathe's, which come first.
std::string_view DrawingReader::axes_of(std::string_view one, std::string_view other) const {
  const auto is_view = [&](const ViewRow& view) {
    return one != other && view.axes.contains(one) && view.axes.contains(other) && fits(view, family_.machine);
  };
  const auto* view = std::ranges::find_if(kViews, is_view);
  return view == kViews.end() ? std::string_view() : view->axes;
}

DrawnPlace DrawingReader::place(std::string_view word, std::string_view& axes) {
  if (cursor_.line_failed() || !cursor_.expect_word(word)) return {};
  const text::Span begin = cursor_.peek().span;
  std::array<std::string_view, 2> names;
  std::array<ir::ExpressionId, 2> values = {ir::ExpressionId::none, ir::ExpressionId::none};
  for (std::size_t i = 0; i < 2; ++i) {
    names.at(i) = cursor_.word();
    if (names.at(i) != "x" && names.at(i) != "y" && names.at(i) != "z") {
      cursor_.expected("x, y or z and a length");
      return {};
    }
    cursor_.advance();
    values.at(i) = expressions_.value_of(kLength).id;
    if (cursor_.line_failed()) return {};
  }
  const std::string_view here = axes_of(names[0], names[1]);
  if (here.empty()) {
    cursor_.syntax(begin, family_.machine == ir::MachineKind::lathe ? "a point of a lathe's drawing has z and x"
                                                                    : "a point of the drawing has two different axes");
  } else if (!axes.empty() && axes != here) {
    cursor_.syntax(begin, fmt::format("the points before have {} and {}", axes[0], axes[1]));
  }
  axes = here;
  const bool in_order = here.starts_with(names[0]);
  return {values.at(in_order ? 0 : 1), values.at(in_order ? 1 : 0)};
}

void DrawingReader::figure(OutlineShape& out) {
  if (cursor_.accept_word("circle")) {
    out.places.push_back(place("at", out.axes));
    if (!cursor_.line_failed() && cursor_.expect_word("diameter")) out.diameter = expressions_.value_of(kLength).id;
    return;
  }
  out.places.push_back(place("from", out.axes));
  do {
    out.places.push_back(place("to", out.axes));
  } while (!cursor_.line_failed() && cursor_.at_word("to"));
  out.is_closed = !cursor_.line_failed() && cursor_.accept_word("closed");
}

void DrawingReader::outline() {
  OutlineShape out;
  if (!cursor_.accept_word("for")) {
    figure(out);
  } else {
    const std::optional<NewName> name = expect_new_name(cursor_, scope_);
    if (!name || !cursor_.expect_word("in")) return;
    out.counts.low = expressions_.value_of(kRatio).id;
    cursor_.expect_symbol("..");
    if (cursor_.line_failed()) return;
    out.counts.high = expressions_.value_of(kRatio).id;
    scope_.open();
    out.counter = scope_.define(family_.arena, name->name, kRatio, name->span);
    if (!cursor_.line_failed()) figure(out);
    scope_.close();
  }
  if (!cursor_.line_failed()) family_.outlines.push_back(std::move(out));
}

void DrawingReader::dimension() {
  DimensionShape out;
  const auto row = std::ranges::find(family_.parameters, cursor_.word(), &Parameter::name);
  if (row == family_.parameters.end() || row->kind != ParameterKind::number)
    return cursor_.expected("the name of a parameter that is a number");
  out.parameter = static_cast<std::size_t>(row - family_.parameters.begin());
  cursor_.advance();
  const auto* kind = std::ranges::find(kDimensionKindNames, cursor_.word());
  if (kind == kDimensionKindNames.end()) return cursor_.expected("length, diameter, radius or angle");
  out.kind = static_cast<DimensionKind>(kind - kDimensionKindNames.begin());
  const bool is_angle = out.kind == DimensionKind::angle;
  if (row->dimension != (is_angle ? kAngle : kLength))
    return cursor_.syntax(cursor_.peek().span, fmt::format("'{}' is a {}, and this is the dimension of {}", row->name,
                                                           row->quantity, is_angle ? "an angle" : "a length"));
  cursor_.advance();
  if (is_angle) out.at = place("at", out.axes);
  out.from = place("from", out.axes);
  out.to = place("to", out.axes);
  if (!cursor_.line_failed()) family_.dimensions.push_back(out);
}

}  // namespace dripfeed::family
