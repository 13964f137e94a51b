// Letters of single lines, for engraving.
#pragma once

#include <string_view>
#include <vector>

namespace dripfeed::family {

// In units of which a capital is six high and four wide.
struct StrokePoint {
  double x = 0.0;
  double y = 0.0;
};
using Stroke = std::vector<StrokePoint>;
inline constexpr double kCapitalHeight = 6.0;
inline constexpr double kAdvance = 6.0;  // from one letter to the next

// Letters, small ones as capitals, digits, blank and + - . / ,
bool has_glyph(char c);
// In the order in which they are cut; none for a blank and for what has no glyph.
std::vector<Stroke> strokes_of(char c);

}  // namespace dripfeed::family
