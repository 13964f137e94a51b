// A curve by its points: what is wrong with these values, its knots where the text has none, and how many chords it
// takes to lie within its error of them.
#pragma once

#include <string>
#include <vector>

#include "dialects/family/bind.h"
#include "dialects/family/chord_counts.h"

namespace dripfeed::family {

// The values of all its lists are known.
std::string fault_of(const BoundFamily& bound, const PointCurve& curve);

// How many numbers a list has that is found from the curve, or the numbers themselves.
std::size_t count_of_found(const BoundFamily& bound, const PointCurve& curve, const List& list);
std::vector<double> own_knots(const BoundFamily& bound, const PointCurve& curve);

// A curve without fault, and its error. Lengths in mm; x of a diameter counts as a radius. Each chord is proved: the
// piece of the curve over it is divided into four Bezier pieces, each of which lies inside the convex hull of its
// control points (weights are positive), and the distance from a chord is convex, so no point of the piece is farther
// from the chord than the farthest control point.
ChordCounts point_chord_counts(const BoundFamily& bound, const PointCurve& curve);

// How far a curve without fault may lie from the chords of so many equal steps, proved as above: 0 for less than one.
double equal_steps_height(const BoundFamily& bound, const PointCurve& curve, double count);

}  // namespace dripfeed::family
