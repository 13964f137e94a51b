// dialects/curves: plane geometry as plain numbers: lines, arcs, conics, explicit and parametric curves, profiles made
// of them, the distance of a point from a curve, the surface that a round nose leaves, and bounds of chord errors that
// are proved, not sampled. It names no other folder: what is a tool, a motion or a family is left to those who call.
// Lengths in mm, angles in radians.
#pragma once

#include "dialects/curves/arc.h"
#include "dialects/curves/bezier.h"
#include "dialects/curves/chord_bound.h"
#include "dialects/curves/conic.h"
#include "dialects/curves/deviation.h"
#include "dialects/curves/explicit_curve.h"
#include "dialects/curves/gap.h"
#include "dialects/curves/height_field.h"
#include "dialects/curves/line.h"
#include "dialects/curves/nose.h"
#include "dialects/curves/nurbs.h"
#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/path.h"
#include "dialects/curves/point.h"
#include "dialects/curves/profile.h"
