// A micrometre is less than a line of the picture is wide: places are rounded to it, so that the document stays small.
#include "server/json/drawing.h"

#include <cmath>

#include "server/json/json.h"

namespace dripfeed::json {

namespace {

double rounded(double mm) { return std::round(mm * 1000.0) / 1000.0; }

Document point(family::DrawnPoint at) { return Document::array({rounded(at.across_mm), rounded(at.up_mm)}); }

Document line(const family::DrawnLine& one) {
  Document points = Document::array();
  for (const family::DrawnPoint& at : one.points) points.push_back(point(at));
  return {{"of", family::kDrawnOfNames.at(static_cast<std::size_t>(one.of))}, {"points", std::move(points)}};
}

Document circle(const family::DrawnCircle& one) {
  return {{"of", family::kDrawnOfNames.at(static_cast<std::size_t>(one.of))},
          {"center", point(one.center)},
          {"diameter_mm", rounded(one.diameter_mm)}};
}

Document dimension(const family::DrawnDimension& one) {
  const bool is_angle = one.kind == family::DimensionKind::angle;
  return {{"parameter", one.parameter}, {"kind", family::kDimensionKindNames.at(static_cast<std::size_t>(one.kind))},
          {"value", one.value},         {"from", point(one.from)},
          {"to", point(one.to)},        {"at", is_angle ? point(one.at) : Document(nullptr)}};
}

template <class All, class Write>
Document list(const All& all, Write write) {
  Document out = Document::array();
  for (const auto& one : all) out.push_back(write(one));
  return out;
}

}  // namespace

std::string drawing(const std::vector<family::DrawnView>& views) {
  return dump(list(views, [](const family::DrawnView& view) {
    return Document{{"axes", view.axes},
                    {"lines", list(view.lines, line)},
                    {"circles", list(view.circles, circle)},
                    {"dimensions", list(view.dimensions, dimension)}};
  }));
}

}  // namespace dripfeed::json
