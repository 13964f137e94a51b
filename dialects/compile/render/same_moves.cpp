// Every field of a motion counts, but for where in the text it is from, what computing it cost, and its text.
#include "dialects/compile/render/same_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace dripfeed::compile {

namespace {

using Point = std::array<double, ir::kAxisCount>;

// What is not known is not a number, and equals itself here.
bool same(double x, double y) { return x == y || (x != x && y != y); }
template <class Numbers>
bool all_same(const Numbers& x, const Numbers& y) {
  return std::ranges::equal(x, y, same);
}

// But for the places.
bool is_alike(const ir::Motion& a, const ir::Motion& b) {
  return a.kind == b.kind && a.plane == b.plane && a.feed_mode == b.feed_mode && a.length_offset == b.length_offset &&
         a.axes_commanded == b.axes_commanded && a.machine_coordinates == b.machine_coordinates &&
         a.exact_stop == b.exact_stop && all_same(a.center, b.center) && same(a.feed, b.feed) &&
         same(a.spindle_rpm, b.spindle_rpm) && same(a.surface_speed_m_min, b.surface_speed_m_min) &&
         a.spindle == b.spindle && a.comp == b.comp && a.coolant == b.coolant && a.gaps == b.gaps &&
         a.number == b.number && a.tool_offset == b.tool_offset && a.axes_unknown == b.axes_unknown &&
         a.length_offset_number == b.length_offset_number;
}

bool is_at_same_places(const ir::Motion& a, const ir::Motion& b) {
  return all_same(a.start, b.start) && all_same(a.end, b.end);
}

std::string_view text_of(const RecordedRun& run, const ir::Motion& m) {
  return m.text < run.result.strings.size() ? std::string_view(run.result.strings[m.text]) : std::string_view();
}

// Between places that may differ along x, y and z alone.
std::optional<double> distance(const Point& a, const Point& b) {
  constexpr std::size_t kLinear = 3;
  if (!std::equal(a.begin() + kLinear, a.end(), b.begin() + kLinear, same)) return {};
  const double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  if (apart == apart) return apart;
  return all_same(a, b) ? std::optional(0.0) : std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> first_difference(const RecordedRun& a, const RecordedRun& b) {
  const std::size_t both = std::min(a.motions.size(), b.motions.size());
  for (std::size_t i = 0; i < both; ++i) {
    const ir::Motion &x = a.motions[i], &y = b.motions[i];
    if (!is_alike(x, y) || !is_at_same_places(x, y) || text_of(a, x) != text_of(b, y)) return x.place.line;
  }
  if (a.motions.size() == b.motions.size()) return {};
  return a.motions.size() > both ? a.motions[both].place.line : a.result.last.line;
}

std::optional<double> distance_apart(const RecordedRun& a, const RecordedRun& b) {
  if (a.motions.size() != b.motions.size()) return {};
  double most = 0.0;
  for (std::size_t i = 0; i < a.motions.size(); ++i) {
    const ir::Motion &x = a.motions[i], &y = b.motions[i];
    if (!is_alike(x, y) || text_of(a, x) != text_of(b, y)) return {};
    if (is_at_same_places(x, y)) continue;
    const bool is_straight =
        x.kind == ir::MotionKind::linear || x.kind == ir::MotionKind::rapid || !ir::is_move(x.kind);
    const std::optional<double> start = distance(x.start, y.start), end = distance(x.end, y.end);
    if (!is_straight || x.comp != ir::CompSide::off || !start || !end) return {};
    most = std::max({most, *start, *end});
  }
  return most;
}

}  // namespace dripfeed::compile
