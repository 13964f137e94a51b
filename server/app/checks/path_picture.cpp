// Points are projected, scaled to the extent of the cuts and rounded to the grid. A line that was drawn already, in
// either direction, is not drawn again.
#include "server/app/checks/path_picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <unordered_set>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

constexpr double kMargin = 6.0;
constexpr double kFlat_mm = 1e-4;
constexpr double kCos30 = 0.8660254037844386;
constexpr int kCoarsest = 16;
// A rapid may lead far out of the drawing: as far as a viewer can clip.
constexpr double kFarthest = 16'000.0;

struct Flat {
  double right = 0.0;
  double up = 0.0;
};

struct Dot {
  int x = 0;
  int y = 0;
  friend bool operator==(const Dot&, const Dot&) = default;
};

struct Extent {
  Flat low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Flat high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void take(Flat at) {
    low = {std::min(low.right, at.right), std::min(low.up, at.up)};
    high = {std::max(high.right, at.right), std::max(high.up, at.up)};
  }
  [[nodiscard]] bool is_empty() const { return low.right > high.right; }
};

Flat project(const ToolPath& path, PictureView view, std::size_t point) {
  const double x = path.points_mm[3 * point];
  const double y = path.points_mm[3 * point + 1];
  const double z = path.points_mm[3 * point + 2];
  if (view == PictureView::turning) return {z, x};
  return {(x - y) * kCos30, z + (x + y) / 2};
}

Extent extent_of(const ToolPath& path, PictureView view, bool with_rapids) {
  Extent extent;
  for (std::size_t i = 1; i < path.kinds.size(); ++i) {
    if (path.kinds[i] == PathKind::begin || (path.kinds[i] == PathKind::rapid && !with_rapids)) continue;
    extent.take(project(path, view, i - 1));
    extent.take(project(path, view, i));
  }
  return extent;
}

// From places to dots: one scale for both directions, in the middle of the drawing.
class Frame {
 public:
  Frame(const Extent& extent, int step) : step_(step) {
    const double width = extent.high.right - extent.low.right;
    const double height = extent.high.up - extent.low.up;
    const auto scale = [](double room, double length) {
      return length > 0.0 ? (room - 2 * kMargin) / length : std::numeric_limits<double>::infinity();
    };
    scale_ = std::min(scale(PathPicture::kWidth, width), scale(PathPicture::kHeight, height));
    if (!std::isfinite(scale_)) scale_ = 1.0;
    middle_ = {(extent.low.right + extent.high.right) / 2, (extent.low.up + extent.high.up) / 2};
  }

  [[nodiscard]] Dot dot(Flat at) const {
    return {rounded(PathPicture::kWidth / 2.0 + (at.right - middle_.right) * scale_),
            rounded(PathPicture::kHeight / 2.0 - (at.up - middle_.up) * scale_)};
  }

 private:
  [[nodiscard]] int rounded(double value) const {
    return static_cast<int>(std::lround(std::clamp(value, -kFarthest, kFarthest) / step_)) * step_;
  }

  int step_;
  double scale_ = 1.0;
  Flat middle_;
};

// Path data of lines, each once.
class DrawnLines {
 public:
  void add(Dot from, Dot to) {
    if (from == to || !drawn_.insert(key(from, to)).second) return;
    if (!end_ || *end_ != from) fmt::format_to(std::back_inserter(data_), "M{} {}", from.x, from.y);
    fmt::format_to(std::back_inserter(data_), " {} {}", to.x, to.y);
    end_ = to;
  }
  [[nodiscard]] std::size_t count() const { return drawn_.size(); }
  std::string take() { return std::move(data_); }

 private:
  static std::uint64_t packed(Dot dot) {
    return static_cast<std::uint64_t>(static_cast<std::uint16_t>(dot.x)) << 16U | static_cast<std::uint16_t>(dot.y);
  }
  static std::uint64_t key(Dot from, Dot to) {
    return std::min(packed(from), packed(to)) << 32U | std::max(packed(from), packed(to));
  }

  std::unordered_set<std::uint64_t> drawn_;
  std::optional<Dot> end_;
  std::string data_;
};

bool has_all_cuts(const ToolPath& path) {
  const auto has_cuts = [](const NotDrawnMoves& moves) { return moves.cuts > 0; };
  return path.report.ran && !path.is_cut_off && std::ranges::none_of(path.not_drawn, has_cuts);
}

}  // namespace

PathPicture picture_of(const ToolPath& path) {
  PathPicture picture;
  picture.has_all_cuts = has_all_cuts(path);
  if (path.high_mm[1] - path.low_mm[1] < kFlat_mm) picture.view = PictureView::turning;
  Extent extent = extent_of(path, picture.view, false);
  if (extent.is_empty()) extent = extent_of(path, picture.view, true);
  if (extent.is_empty()) return picture;
  for (int step = 1; step <= kCoarsest; step *= 2) {
    const Frame frame(extent, step);
    DrawnLines cut;
    DrawnLines rapid;
    for (std::size_t i = 1; i < path.kinds.size(); ++i) {
      if (path.kinds[i] == PathKind::begin) continue;
      DrawnLines& lines = path.kinds[i] == PathKind::rapid ? rapid : cut;
      lines.add(frame.dot(project(path, picture.view, i - 1)), frame.dot(project(path, picture.view, i)));
    }
    const std::size_t count = cut.count() + rapid.count();
    picture.cut = cut.take();
    picture.rapid = rapid.take();
    if (count <= PathPicture::kMostLines) break;
  }
  return picture;
}

}  // namespace dripfeed::app
