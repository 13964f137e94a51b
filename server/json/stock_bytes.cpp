// Numbers are copied as they lie in memory.
#include "server/json/stock_bytes.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "server/json/parse.h"
#include "server/json/reports.h"

namespace dripfeed::json {

namespace {

static_assert(std::endian::native == std::endian::little);
constexpr std::size_t kAligned = 4;

template <class Number>
void append(std::string& out, const std::vector<Number>& column) {
  const std::size_t at = out.size();
  out.resize(at + column.size() * sizeof(Number));
  if (!column.empty()) std::memcpy(out.data() + at, column.data(), column.size() * sizeof(Number));
}

template <class Number>
Document array_row(std::string_view name, const std::vector<Number>& column) {
  return {name, std::is_same_v<Number, float> ? "f32" : "u32", column.size()};
}

Document head_of(const app::StockRun& stock) {
  return {
      {"kind", stock.turns ? "bar" : "map"},
      {"columns", stock.columns},
      {"rows", stock.rows},
      {"low_mm", stock.low_mm},
      {"y_low_mm", stock.y_low_mm},
      {"step_mm", stock.step_mm},
      {"bottom_mm", stock.bottom_mm},
      {"span", stock.span},
      {"is_cut_off", stock.is_cut_off},
      {"ran", stock.ran},
      {"notes", not_checked_sentences(stock.notes)},
      {"arrays",
       {array_row("start", stock.start), array_row("nominal", stock.nominal), array_row("tolerances", stock.tolerances),
        array_row("places", stock.places), array_row("heights", stock.heights), array_row("moments", stock.moments)}}};
}

}  // namespace

std::string stock_bytes(const app::StockRun& stock) {
  std::string head = dump(head_of(stock));
  head.resize((head.size() + kAligned - 1) / kAligned * kAligned, ' ');
  const auto length = static_cast<std::uint32_t>(head.size());
  std::string out = "DFS1";
  append(out, std::vector<std::uint32_t>{length});
  out += head;
  append(out, stock.start);
  append(out, stock.nominal);
  append(out, stock.tolerances);
  append(out, stock.places);
  append(out, stock.heights);
  append(out, stock.moments);
  return out;
}

}  // namespace dripfeed::json
