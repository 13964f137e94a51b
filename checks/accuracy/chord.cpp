// The piece is taken as x = g(z). With the profile x = f(z) the gap h = g - f has h'' = g'' - f'': zero less the
// profile's for a line, the circle's less the profile's for an arc. What both ends' gaps and that range prove is
// curves::gap_bound.
#include "checks/accuracy/chord.h"

#include <algorithm>
#include <cmath>

#include "dialects/curves/chord_bound.h"
#include "dialects/curves/conic.h"

namespace dripfeed::accuracy {

namespace {

constexpr double kUpright_mm = 1e-9;

// The piece as a function of z.
struct Graph {
  curves::Range z;
  const curves::Segment* segment = nullptr;
  curves::Conic circle;  // for an arc: the half above or below its centre

  [[nodiscard]] double x(double at) const {
    if (segment == nullptr) return circle.at(at).x;
    return segment->a.x + (segment->b.x - segment->a.x) * ((at - segment->a.z) / (segment->b.z - segment->a.z));
  }
  [[nodiscard]] curves::Range second(double low, double high) const {
    return segment == nullptr ? circle.second_derivatives(low, high) : curves::Range{};
  }
};

std::optional<Graph> graph_of(const curves::PathPiece& piece) {
  const curves::Box box = curves::box_of(piece);
  Graph graph{box.z, std::get_if<curves::Segment>(&piece), {}};
  if (box.z.width() < kUpright_mm) return std::nullopt;
  if (graph.segment != nullptr) return graph;
  const auto& arc = std::get<curves::Arc>(piece);
  const double start = arc.at(0.0).z;
  const double end = arc.at(1.0).z;
  const bool turns_over =
      box.z.low < std::min(start, end) - kUpright_mm || box.z.high > std::max(start, end) + kUpright_mm;
  if (turns_over || std::fabs(arc.sweep) > 3.2) return std::nullopt;
  const double side = arc.at(0.5).x >= arc.center.x ? 1.0 : -1.0;
  graph.circle = {curves::ConicKind::ellipse, side * arc.radius, arc.radius, arc.center};
  return graph;
}

}  // namespace

std::optional<double> chord_bound(const curves::Profile& profile, const curves::PathPiece& piece) {
  const std::optional<Graph> graph = graph_of(piece);
  if (!graph) return std::nullopt;
  double bound = 0.0;
  for (const curves::ProfilePiece& nominal : profile.pieces) {
    const curves::ExplicitCurve& curve = nominal.curve;
    const double low = std::max(graph->z.low, curve.z.low);
    const double high = std::min(graph->z.high, curve.z.high);
    if (!(low < high)) continue;
    if (!curve.second_derivatives) return std::nullopt;
    const curves::Range f = curve.second_derivatives(low, high);
    const curves::Range g = graph->second(low, high);
    const double gap_low = graph->x(low) - curve.at(low).x;
    const double gap_high = graph->x(high) - curve.at(high).x;
    const double found = curves::gap_bound(gap_low, gap_high, {g.low - f.high, g.high - f.low}, high - low);
    if (!std::isfinite(found)) return std::nullopt;
    bound = std::max(bound, found);
  }
  return bound;
}

}  // namespace dripfeed::accuracy
