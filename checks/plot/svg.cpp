// Drawn from back to front: areas, map, grid, series, notes, frame, texts.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "checks/plot/frame.h"
#include "checks/plot/plot.h"
#include "dialects/text/number.h"

namespace dripfeed::plot {

namespace {

constexpr std::array<std::string_view, 6> kColors = {"#1f5fa8", "#c8501e", "#2f8a4c", "#8a4ea8", "#a88a1e", "#4a4a4a"};
constexpr std::array<std::string_view, 4> kAreaColors = {"#e8a08a", "#9fc3e8", "#a8d8b0", "#d8c890"};
constexpr std::string_view kGray = "#d9d9d9";
// From low to high.
constexpr std::array<std::array<double, 3>, 5> kScale = {
    {{38, 32, 84}, {49, 104, 142}, {53, 160, 130}, {150, 208, 70}, {252, 240, 120}}};
constexpr int kShades = 32;
constexpr double kRow_px = 18.0;

std::string px(double value) { return text::format_fixed(std::clamp(value, -1e6, 1e6), 2); }

std::string escaped(std::string_view raw) {
  std::string out;
  for (const char c : raw) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

std::string shade(int level) {
  const double place = static_cast<double>(level) / (kShades - 1) * (kScale.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kScale.size() - 2);
  const double rest = place - static_cast<double>(below);
  std::array<int, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    rgb[i] = static_cast<int>(std::lround(kScale[below][i] + rest * (kScale[below + 1][i] - kScale[below][i])));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

// As many decimals as the distance of the ticks needs.
std::string tick_label(double value, double step) {
  const double size = std::fabs(value);
  if (size >= 1e7 || (step > 0.0 && step < 1e-6)) return text::format_shortest(value);
  const int decimals = step >= 1.0 ? 0 : static_cast<int>(std::clamp(std::ceil(-std::log10(step) - 1e-9), 0.0, 9.0));
  return text::format_fixed(value, decimals);
}

class Drawing {
 public:
  Drawing(const Plot& plot, Size size) : plot_(plot), frame_(plot, size), size_(size) {}

  std::string draw() {
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        px(size_.width_px), px(size_.height_px));
    out_ += fmt::format(
        "<clipPath id=\"frame\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n"
        "<g clip-path=\"url(#frame)\">\n",
        px(frame_.left()), px(frame_.top()), px(frame_.right() - frame_.left()), px(frame_.bottom() - frame_.top()));
    areas();
    if (plot_.map) map(*plot_.map);
    grid();
    for (std::size_t i = 0; i < plot_.series.size(); ++i) series(plot_.series[i], kColors[i % kColors.size()]);
    out_ += "</g>\n";
    notes();
    axes();
    legend();
    return std::move(out_) + "</svg>\n";
  }

 private:
  void text(double x, double y, std::string_view anchor, std::string_view raw, std::string_view more = {}) {
    out_ += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", px(x), px(y), anchor, more,
                        escaped(raw));
  }
  void rectangle(double x, double y, double width, double height, std::string_view fill, std::string_view more = {}) {
    out_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"{}/>\n", px(x), px(y), px(width),
                        px(height), fill, more);
  }
  void line(double x1, double y1, double x2, double y2, std::string_view stroke) {
    out_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\"/>\n", px(x1), px(y1), px(x2),
                        px(y2), stroke);
  }

  // The color of an area's name, in the order of the names.
  std::string_view area_color(const std::string& name) {
    if (name.empty()) return kGray;
    const auto known = std::ranges::find(area_names_, name);
    const auto index = static_cast<std::size_t>(known - area_names_.begin());
    if (known == area_names_.end()) area_names_.push_back(name);
    return kAreaColors[index % kAreaColors.size()];
  }

  void areas() {
    for (const Area& area : plot_.areas) {
      const double left = frame_.x_px(area.x_low.value_or(frame_.x().low));
      const double right = frame_.x_px(area.x_high.value_or(frame_.x().high));
      const double bottom = frame_.y_px(area.y_low.value_or(frame_.y().low));
      const double top = frame_.y_px(area.y_high.value_or(frame_.y().high));
      if (!std::isfinite(left + right + top + bottom)) continue;
      // What is narrower than a pixel is still seen.
      rectangle(std::min(left, right), std::min(top, bottom), std::max(1.0, std::fabs(right - left)),
                std::max(1.0, std::fabs(bottom - top)), area_color(area.name), " opacity=\"0.6\"");
    }
  }

  // Cells of one shade that lie side by side become one rectangle.
  void map(const Map& map) {
    if (map.columns == 0 || map.rows == 0 || map.values.size() != map.columns * map.rows) return;
    for (const double value : map.values) {
      if (!std::isfinite(value)) continue;
      map_low_ = has_map_ ? std::min(map_low_, value) : value;
      map_high_ = has_map_ ? std::max(map_high_, value) : value;
      has_map_ = true;
    }
    if (!has_map_) return;
    const double scale = map_high_ > map_low_ ? (kShades - 1) / (map_high_ - map_low_) : 0.0;
    const auto level = [&](std::size_t row, std::size_t column) {
      const double value = map.values[row * map.columns + column];
      return std::isfinite(value) ? static_cast<int>(std::lround((value - map_low_) * scale)) : -1;
    };
    const double width = (map.x_high - map.x_low) / static_cast<double>(map.columns);
    const double height = (map.y_high - map.y_low) / static_cast<double>(map.rows);
    for (std::size_t row = 0; row < map.rows; ++row) {
      const double top = frame_.y_px(map.y_low + height * static_cast<double>(row + 1));
      const double bottom = frame_.y_px(map.y_low + height * static_cast<double>(row));
      for (std::size_t first = 0; first < map.columns;) {
        std::size_t end = first + 1;
        while (end < map.columns && level(row, end) == level(row, first)) ++end;
        if (const int here = level(row, first); here >= 0) {
          const double left = frame_.x_px(map.x_low + width * static_cast<double>(first));
          const double right = frame_.x_px(map.x_low + width * static_cast<double>(end));
          // A hair wider, so that no gaps shine through.
          rectangle(left, top, right - left + 0.3, bottom - top + 0.3, shade(here));
        }
        first = end;
      }
    }
  }

  void grid() {
    for (const double x : ticks(frame_.x().low, frame_.x().high, 9))
      line(frame_.x_px(x), frame_.top(), frame_.x_px(x), frame_.bottom(), "#ececec");
    for (const double y : ticks(frame_.y().low, frame_.y().high, 8))
      line(frame_.left(), frame_.y_px(y), frame_.right(), frame_.y_px(y), "#ececec");
  }

  void series(const Series& series, std::string_view color) {
    if (series.mark == Mark::dots) {
      out_ += fmt::format("<g fill=\"{}\">\n", color);
      for (const Point& point : series.points) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
        out_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"2.5\"/>\n", px(frame_.x_px(point.x)),
                            px(frame_.y_px(point.y)));
      }
      out_ += "</g>\n";
      return;
    }
    std::vector<Point> run;
    const auto flush = [&] {
      if (run.size() > 1) polyline(run, series.mark, color);
      run.clear();
    };
    for (const Point& point : series.points) {
      if (std::isfinite(point.x) && std::isfinite(point.y)) {
        run.push_back({frame_.x_px(point.x), frame_.y_px(point.y)});
      } else {
        flush();
      }
    }
    flush();
  }

  // `run` in pixels.
  void polyline(const std::vector<Point>& run, Mark mark, std::string_view color) {
    out_ += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\" points=\"", color);
    const auto put = [&](double x, double y) { out_ += fmt::format("{},{} ", px(x), px(y)); };
    double y_before = run.front().y;
    for (std::size_t first = 0; first < run.size();) {
      std::size_t end = first + 1;
      std::size_t low = first;
      std::size_t high = first;
      while (end < run.size() && std::floor(run[end].x) == std::floor(run[first].x)) {
        if (run[end].y < run[low].y) low = end;
        if (run[end].y > run[high].y) high = end;
        ++end;
      }
      std::array<std::size_t, 4> kept = {first, std::min(low, high), std::max(low, high), end - 1};
      for (std::size_t i = 0; i < kept.size(); ++i) {
        if (i > 0 && kept[i] == kept[i - 1]) continue;
        const Point& point = run[kept[i]];
        if (mark == Mark::steps) put(point.x, y_before);
        put(point.x, point.y);
        y_before = point.y;
      }
      first = end;
    }
    out_ += "\"/>\n";
  }

  void notes() {
    for (const Note& note : plot_.notes) {
      const double x = frame_.x_px(note.at.x);
      const double y = frame_.y_px(note.at.y);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      line(x - 4, y, x + 4, y, "black");
      line(x, y - 4, x, y + 4, "black");
      const bool right_half = x > 0.6 * frame_.left() + 0.4 * frame_.right();
      text(right_half ? x - 6 : x + 6, std::max(y - 6, frame_.top() + 12), right_half ? "end" : "start", note.text);
    }
  }

  void axes() {
    rectangle(frame_.left(), frame_.top(), frame_.right() - frame_.left(), frame_.bottom() - frame_.top(), "none",
              " stroke=\"#404040\"");
    const auto step_of = [](const std::vector<double>& all) { return all.size() > 1 ? all[1] - all[0] : 1.0; };
    const std::vector<double> x_ticks = ticks(frame_.x().low, frame_.x().high, 9);
    for (const double x : x_ticks)
      text(frame_.x_px(x), frame_.bottom() + 16, "middle", tick_label(x, step_of(x_ticks)));
    const std::vector<double> y_ticks = ticks(frame_.y().low, frame_.y().high, 8);
    for (const double y : y_ticks) text(frame_.left() - 6, frame_.y_px(y) + 4, "end", tick_label(y, step_of(y_ticks)));
    text(0.5 * (frame_.left() + frame_.right()), frame_.bottom() + 38, "middle", plot_.x.title);
    const double middle = 0.5 * (frame_.top() + frame_.bottom());
    text(16, middle, "middle", plot_.y.title, fmt::format(" transform=\"rotate(-90 16 {})\"", px(middle)));
    text(frame_.left(), frame_.top() - 14, "start", plot_.title, " font-size=\"15\"");
  }

  void legend() {
    const double x = frame_.right() + 14;
    double y = frame_.top() + 10;
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      if (plot_.series[i].name.empty()) continue;
      rectangle(x, y - 6, 14, 4, kColors[i % kColors.size()]);
      text(x + 20, y, "start", plot_.series[i].name);
      y += kRow_px;
    }
    for (const std::string& name : area_names_) {
      rectangle(x, y - 9, 14, 10, area_color(name), " opacity=\"0.6\"");
      text(x + 20, y, "start", name);
      y += kRow_px;
    }
    if (has_map_) scale(x, y + kRow_px);
  }

  // The map's colors from high to low.
  void scale(double x, double y) {
    constexpr double kStep_px = 5.0;
    text(x, y - 6, "start", plot_.map->title);
    for (int i = 0; i < kShades; ++i) rectangle(x, y + kStep_px * i, 14, kStep_px + 0.3, shade(kShades - 1 - i));
    text(x + 20, y + 9, "start", text::format_fixed(map_high_, 3));
    text(x + 20, y + kStep_px * kShades, "start", text::format_fixed(map_low_, 3));
  }

  const Plot& plot_;
  Frame frame_;
  Size size_;
  std::string out_;
  std::vector<std::string> area_names_;
  bool has_map_ = false;
  double map_low_ = 0.0;
  double map_high_ = 0.0;
};

}  // namespace

std::string svg(const Plot& plot, Size size) { return Drawing(plot, size).draw(); }

}  // namespace dripfeed::plot
