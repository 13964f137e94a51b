// The stock of a program as its cuts leave it, from the first to the last: the height map of a mill or the outside of a
// turned bar as the gouge check has them, with the nominal where one is known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/check_budget.h"
#include "server/app/checks/diagnose.h"

namespace dripfeed::app {

struct StockRun {
  bool turns = false;
  // A map's places lie in rows along x, the lowest y first, each in the middle of its cell. A bar's lie along z.
  std::size_t columns = 0;
  std::size_t rows = 1;
  double low_mm = 0.0;       // of the map's x; of the bar the z of the first place
  double y_low_mm = 0.0;     // of the map
  double step_mm = 0.0;      // between places
  double bottom_mm = 0.0;    // of the map's material
  std::vector<float> start;  // height or radius before the first cut; -infinity: no material
  // Of the finished part; NaN: none there; empty: none is known.
  std::vector<float> nominal;
  std::vector<float> tolerances;

  // What the cuts take away, in the order of the points of the program's path, between which a moment may lie.
  std::vector<std::uint32_t> places;
  std::vector<float> heights;
  std::vector<float> moments;
  double span = 0.0;  // so many points count as one moment; 0: each counts

  bool is_cut_off = false;  // the path has more points than are followed
  bool ran = false;
  std::vector<checks::NotChecked> notes;  // what was left out
};

// "box X0 X1 Y0 Y1 Z0 Z1" or "cylinder DIAMETER Z0 Z1", mm in the active work offset; nothing where it is none.
std::optional<family::Stock> read_stock(std::string_view text);

// Errors: as open_text; invalid: no stock is known.
Result<StockRun> follow_stock(const DiagnoseOrder& order, const Documents& documents, const CheckBudget& budget);

}  // namespace dripfeed::app
