// Threads whose lead changes by the same amount in each turn: after n turns the lead is L + c n and the travel
// L n + c n² / 2, so that its square grows with the travel: lead² = L² + 2 c travel.
#pragma once

#include <cmath>

namespace dripfeed::ir {

// The lead in mm after a travel along the thread's axis, from a lead at its start that is not below 0; 0 where it falls
// to nothing before.
inline double lead_after(double start_lead_mm, double change_mm, double distance_mm) {
  if (change_mm == 0.0) return start_lead_mm;
  const double square = start_lead_mm * start_lead_mm + 2.0 * change_mm * distance_mm;
  return square > 0.0 ? std::sqrt(square) : 0.0;
}

// Travel divided by turns.
inline double mean_lead(double start_lead_mm, double change_mm, double distance_mm) {
  return (start_lead_mm + lead_after(start_lead_mm, change_mm, distance_mm)) / 2.0;
}

}  // namespace dripfeed::ir
