// The same checks as for a verdict, on a coarser grid, with a log of what they take away. Motions go to the path and to
// the check one by one, so that a cut knows its points.
#include "server/app/checks/stock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "checks/gouge/gouge.h"
#include "checks/gouge/milling.h"
#include "dialects/text/number.h"
#include "server/app/checks/machine_facts.h"
#include "server/app/checks/surface_checks.h"
#include "server/app/checks/tool_path.h"

namespace dripfeed::app {

namespace {

constexpr double kMapPlaces = 1 << 16U;
constexpr double kBarPlaces = 1200.0;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

std::vector<float> floats_of(const std::vector<double>& values) {
  std::vector<float> out;
  out.reserve(values.size());
  for (const double one : values) out.push_back(static_cast<float>(one));
  return out;
}

class OneByOne final : public ir::MotionSink {
 public:
  OneByOne(ir::MotionSink& first, ir::MotionSink& second) : first_(first), second_(second) {}
  void consume(std::span<const ir::Motion> motions) override {
    for (std::size_t i = 0; i < motions.size(); ++i) {
      first_.consume(motions.subspan(i, 1));
      second_.consume(motions.subspan(i, 1));
    }
  }

 private:
  ir::MotionSink& first_;
  ir::MotionSink& second_;
};

// The check that cuts, and the stock as it was.
struct Cutting {
  std::unique_ptr<gouge::Milling> milling;
  std::unique_ptr<gouge::Gouge> turning;

  [[nodiscard]] ir::MotionSink& sink() const {
    return milling ? static_cast<ir::MotionSink&>(*milling) : static_cast<ir::MotionSink&>(*turning);
  }
  [[nodiscard]] gouge::Report finish() const { return milling ? milling->finish() : turning->finish(); }
};

void take_map(const gouge::HeightMap& map, StockRun& out) {
  const gouge::HeightMap::Grid grid = map.grid();
  out.columns = grid.columns;
  out.rows = grid.rows;
  out.low_mm = grid.x_low;
  out.y_low_mm = grid.y_low;
  out.step_mm = map.step_mm();
  out.bottom_mm = grid.bottom;
  out.start = floats_of(grid.heights);
  out.nominal = floats_of(grid.nominal);
  for (float& one : out.nominal) one = std::isfinite(one) ? one : kNone;
  out.tolerances = grid.tolerances;
}

void take_bar(const gouge::RemainingStock& bar, const curves::Profile& nominal, StockRun& out) {
  out.columns = bar.radii().size();
  out.low_mm = bar.z_low();
  out.step_mm = bar.step_mm();
  out.start = floats_of(bar.radii());
  if (nominal.empty()) return;
  for (std::size_t i = 0; i < out.columns; ++i) {
    const double z = out.low_mm + static_cast<double>(i) * out.step_mm;
    const curves::ProfilePiece* const piece = curves::piece_at(nominal, z);
    out.nominal.push_back(piece == nullptr ? kNone : static_cast<float>(piece->curve.at(z).x));
    out.tolerances.push_back(piece == nullptr ? 0.0F : static_cast<float>(piece->tolerance));
  }
}

// Nothing: this stock is of no such machine.
Cutting begin_cutting(const Examination& e, gouge::RemovalLog& log, StockRun& out) {
  Cutting cutting;
  if (out.turns) {
    gouge::Settings settings = turning_gouge(e);
    settings.log = &log;
    if (settings.stock)
      settings.step_mm = std::max(1e-3, (settings.stock->z_high_mm - settings.stock->z_low_mm) / kBarPlaces);
    cutting.turning = std::make_unique<gouge::Gouge>(std::move(settings));
    if (cutting.turning->stock() != nullptr) take_bar(*cutting.turning->stock(), e.geometry->nominal, out);
    return cutting;
  }
  gouge::MillingSettings settings = milling_gouge(e);
  settings.log = &log;
  if (settings.stock) settings.step_mm = std::sqrt(settings.stock->x.width() * settings.stock->y.width() / kMapPlaces);
  cutting.milling = std::make_unique<gouge::Milling>(std::move(settings));
  if (cutting.milling->map() != nullptr) take_map(*cutting.milling->map(), out);
  return cutting;
}

void take_removals(gouge::RemovalLog& log, const PathRecorder& recorder, StockRun& out) {
  out.span = log.span();
  const std::vector<gouge::Removal> removals = log.finish();
  out.places.reserve(removals.size());
  out.heights.reserve(removals.size());
  out.moments.reserve(removals.size());
  for (const gouge::Removal& one : removals) {
    out.places.push_back(one.place);
    out.heights.push_back(one.height_mm);
    out.moments.push_back(static_cast<float>(recorder.point_of(one.moment)));
  }
}

Result<void> need_stock(const DiagnoseOrder& order, Examination& e) {
  if (!order.stock.empty()) {
    auto stock = read_stock(order.stock);
    if (!stock)
      return fail(ErrorCode::invalid, "stock must be \"box X0 X1 Y0 Y1 Z0 Z1\" or \"cylinder DIAMETER Z0 Z1\", in mm");
    if (!e.geometry) e.geometry.emplace().machine = e.control.kind;
    e.geometry->stock = *stock;
  }
  if (!e.geometry || !e.geometry->stock) return fail(ErrorCode::invalid, "no stock is known of this program");
  if (!ir::serves(e.control.kind, e.geometry->machine))
    return fail(ErrorCode::invalid, "the stock is of a family for another kind of machine");
  const bool is_box = std::holds_alternative<family::BoxStock>(*e.geometry->stock);
  if (is_box && e.control.kind != ir::MachineKind::mill) return fail(ErrorCode::invalid, "a lathe has a cylinder");
  return {};
}

}  // namespace

std::optional<family::Stock> read_stock(std::string_view text) {
  constexpr std::size_t kMostNumbers = 6;
  const std::size_t blank = std::min(text.find(' '), text.size());
  const std::string_view kind = text.substr(0, blank);
  std::vector<double> numbers;
  for (std::size_t at = blank; at < text.size() && numbers.size() <= kMostNumbers;) {
    const std::size_t end = std::min(text.find(' ', at + 1), text.size());
    const auto number = text::parse_number(text.substr(at + 1, end - at - 1));
    if (!number || !(std::fabs(*number) <= checks::kFarthest)) return std::nullopt;
    numbers.push_back(*number);
    at = end;
  }
  const auto range = [&](std::size_t i) { return curves::Range{numbers[i], numbers[i + 1]}; };
  if (kind == "box" && numbers.size() == kMostNumbers) {
    const family::BoxStock box{.x_mm = range(0), .y_mm = range(2), .z_mm = range(4)};
    const bool is_one = box.x_mm.width() > 0.0 && box.y_mm.width() > 0.0 && box.z_mm.width() > 0.0;
    return is_one ? std::optional<family::Stock>(box) : std::nullopt;
  }
  if (kind == "cylinder" && numbers.size() == 3) {
    const family::CylinderStock bar{.diameter_mm = numbers[0], .bore_mm = 0.0, .z_mm = range(1)};
    const bool is_one = bar.diameter_mm > 0.0 && bar.z_mm.width() > 0.0;
    return is_one ? std::optional<family::Stock>(bar) : std::nullopt;
  }
  return std::nullopt;
}

Result<StockRun> follow_stock(const DiagnoseOrder& order, const Documents& documents, const CheckBudget& budget) {
  const auto opened = open_text(order, documents);
  if (!opened) return std::unexpected(opened.error());
  Examination& e = (*opened)->examination;
  if (auto known = need_stock(order, e); !known) return std::unexpected(known.error());
  StockRun out;
  out.turns = e.control.kind != ir::MachineKind::mill;
  PathRecorder recorder(x_is_diameter(e.control, e.profile));
  gouge::RemovalLog log([&recorder](const ir::Motion& motion) {
    const PathRecorder::RowRange rows = recorder.rows_of(motion.place.ordinal);
    return gouge::RemovalLog::Moments{rows.first, rows.last};
  });
  const Cutting cutting = begin_cutting(e, log, out);
  if (out.start.empty()) return fail(ErrorCode::invalid, "no stock is known of this program");
  OneByOne sinks(recorder, cutting.sink());
  const Followed followed = follow_within(e, budget, recorder, sinks);
  out.is_cut_off = recorder.finish(followed.run).is_cut_off;
  out.ran = followed.report.ran;
  take_removals(log, recorder, out);
  out.notes = followed.report.checks.not_checked.list();
  const gouge::Report report = cutting.finish();
  for (const checks::NotChecked& one : report.not_checked.list()) out.notes.push_back(one);
  return out;
}

}  // namespace dripfeed::app
