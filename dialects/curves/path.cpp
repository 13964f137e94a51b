// What segments and arcs answer alike.
#include "dialects/curves/path.h"

#include <algorithm>

namespace dripfeed::curves {

namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

}  // namespace

Point direction_at(const PathPiece& piece, double t) {
  return std::visit(Overloaded{[](const Segment& segment) { return segment.direction(); },
                               [t](const Arc& arc) { return arc.direction(t); }},
                    piece);
}

PathPiece part_of(const PathPiece& piece, double from, double to) {
  return std::visit(
      Overloaded{[=](const Segment& segment) -> PathPiece { return Segment{segment.at(from), segment.at(to)}; },
                 [=](const Arc& arc) -> PathPiece {
                   return Arc{arc.center, arc.radius, arc.start_angle + from * arc.sweep, (to - from) * arc.sweep};
                 }},
      piece);
}

PathPiece moved(const PathPiece& piece, Point by) {
  return std::visit(
      Overloaded{
          [=](const Segment& segment) -> PathPiece { return Segment{segment.a + by, segment.b + by}; },
          [=](const Arc& arc) -> PathPiece { return Arc{arc.center + by, arc.radius, arc.start_angle, arc.sweep}; }},
      piece);
}

Box box_of(const PathPiece& piece) {
  return std::visit(Overloaded{[](const Segment& s) {
                                 return Box{{std::min(s.a.z, s.b.z), std::max(s.a.z, s.b.z)},
                                            {std::min(s.a.x, s.b.x), std::max(s.a.x, s.b.x)}};
                               },
                               [](const Arc& arc) { return box_of(arc); }},
                    piece);
}

}  // namespace dripfeed::curves
