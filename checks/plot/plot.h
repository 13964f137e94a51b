// checks/plot: figures of the checks as SVG: axes with ticks, series as lines, steps or dots, shaded areas, a map of
// heights, notes. What is drawn is the caller's; where it is written to, too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dripfeed::plot {

// In the units of the axes.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

enum class Mark : std::uint8_t {
  line,
  steps,  // each value holds until the next point's x
  dots,
};

// A point that is not finite interrupts a line and is no dot.
struct Series {
  std::string name;  // in the legend; empty: not there
  std::vector<Point> points;
  Mark mark = Mark::line;
};

// Without bounds an axis takes those of what is drawn; one that has no width gets some.
struct Axis {
  std::string title;
  std::optional<double> low = {};
  std::optional<double> high = {};
};

// A rectangle under the series: a stall, a tolerance. A bound that is not given is the axis's end.
struct Area {
  std::string name;  // areas of one name share a color and a row of the legend; empty: gray, not there
  std::optional<double> x_low = {};
  std::optional<double> x_high = {};
  std::optional<double> y_low = {};
  std::optional<double> y_high = {};
};

// Values at the cells of a grid, drawn as colors with a scale next to it; row 0 lies at y_low. A cell that is not
// finite stays empty. Nothing is drawn when `values` has not columns·rows entries.
struct Map {
  std::string title;  // of the scale
  double x_low = 0.0;
  double x_high = 0.0;
  double y_low = 0.0;
  double y_high = 0.0;
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> values;  // row after row
};

struct Note {
  Point at;  // a small cross, with the text next to it
  std::string text;
};

struct Plot {
  std::string title;
  Axis x;
  Axis y;
  bool equal_scale = false;  // one unit is as long on both axes
  std::vector<Area> areas = {};
  std::optional<Map> map = {};
  std::vector<Series> series = {};
  std::vector<Note> notes = {};
};

struct Size {
  double width_px = 960.0;
  double height_px = 480.0;
};

// A whole SVG document. Texts are escaped. Long series are thinned to what the pixels can show: of a run of points in
// one pixel column the first, the last, the highest and the lowest stay.
std::string svg(const Plot& plot, Size size = {});

// Round values (1, 2 or 5 times a power of ten apart) within a range, at most `most` (>= 2); empty when the range has
// no width or is not finite.
std::vector<double> ticks(double low, double high, int most);

}  // namespace dripfeed::plot
