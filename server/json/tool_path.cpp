// What a path has next to its points is the same wherever it is shown.
#include "server/json/tool_path.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "server/json/base64.h"
#include "server/json/control_document.h"
#include "server/json/diagnostics.h"
#include "server/json/reports.h"

namespace dripfeed::json {

namespace {

Document not_drawn_document(const app::ToolPath& path) {
  Document rows = Document::array();
  for (std::size_t i = 0; i < path.not_drawn.size(); ++i) {
    const app::NotDrawnMoves& moves = path.not_drawn[i];
    if (moves.count > 0)
      rows.push_back({{"why", app::kNotDrawnNames[i]}, {"moves", moves.count}, {"first_line", moves.first_line}});
  }
  return rows;
}

Document axes_document(std::uint16_t bits) {
  Document names = Document::array();
  for (std::size_t i = 0; i < ir::kAxisCount; ++i)
    if ((bits >> i & 1U) != 0) names.push_back(kAxisWords[i]);
  return names;
}

// As which control it was read, and what is known and not known of it.
Document head_document(const app::ToolPath& path) {
  const app::CheckReport& report = path.report;
  return {{"dialect", report.dialect},
          {"control", control_document(report)},
          {"x_is_diameter", path.x_is_diameter},
          {"segments", path.segments},
          {"low_mm", path.low_mm},
          {"high_mm", path.high_mm},
          {"cut_mm", path.cut_mm},
          {"rapid_mm", path.rapid_mm},
          {"not_drawn", not_drawn_document(path)},
          {"other_axes", axes_document(path.other_axes)},
          {"work_offsets", path.work_offsets},
          {"compensated", path.compensated},
          {"is_cut_off", path.is_cut_off},
          {"ran", report.ran},
          {"not_known", not_checked_sentences(report.checks.not_checked.list())},
          {"diagnostics", embedded(diagnostics(report.checks.diagnostics, report.source))}};
}

// What is not known is 0 in a profile: null here.
Document above_zero_or_null(double value) { return value > 0.0 ? Document(value) : Document(nullptr); }

Document holder_document(const std::vector<checks::HolderStep>& holder) {
  Document steps = Document::array();
  for (const checks::HolderStep& step : holder)
    steps.push_back({{"from_mm", step.from_mm}, {"diameter_mm", step.diameter_mm}});
  return steps;
}

Document insert_document(const std::optional<checks::Insert>& insert) {
  if (!insert) return nullptr;
  return {{"angle_deg", insert->angle_deg},
          {"entering_angle_deg", insert->entering_angle_deg},
          {"edge_mm", insert->edge_mm}};
}

Document shape_document(const std::optional<checks::Tool>& tool) {
  if (!tool) return nullptr;
  return {{"diameter_mm", above_zero_or_null(tool->diameter_mm)},
          {"corner_radius_mm", tool->corner_radius_mm},
          {"nose_radius_mm", tool->nose_radius_mm},
          {"tip", tool->tip},
          {"length_mm", tool->length_mm ? Document(*tool->length_mm) : Document(nullptr)},
          {"insert", insert_document(tool->insert)},
          {"holder", holder_document(tool->holder)}};
}

Document path_tools_document(const app::ToolPath& path) {
  Document tools = Document::array();
  for (const app::ToolMoves& one : path.tools)
    tools.push_back({{"tool", text_or_null(one.name)}, {"shape", shape_document(one.shape)}});
  return tools;
}

Document tool_changes_document(const app::ToolPath& path) {
  Document changes = Document::array();
  for (const app::ToolChange& one : path.tool_changes) changes.push_back({{"point", one.point}, {"tool", one.tool}});
  return changes;
}

Document path_time_document(const std::optional<app::PathTimes>& times) {
  if (!times) return nullptr;
  return {
      {"cycle_s", times->cycle_s}, {"is_fed", !times->buffer.empty()}, {"notes", not_checked_sentences(times->notes)}};
}

Document path_deviation_document(const std::optional<app::PathDeviations>& deviations) {
  if (!deviations) return nullptr;
  return {{"of_surface", deviations->of_surface}, {"notes", not_checked_sentences(deviations->notes)}};
}

}  // namespace

std::string tool_path(const app::ToolPath& path) {
  const app::PathTimes no_times;
  const app::PathTimes& times = path.times ? *path.times : no_times;
  const std::vector<float> no_deviations;
  Document document = head_document(path);
  document["time"] = path_time_document(path.times);
  document["why_no_time"] = text_or_null(path.why_no_times);
  document["deviation"] = path_deviation_document(path.deviations);
  document["tools"] = path_tools_document(path);
  document["tool_changes"] = tool_changes_document(path);
  document["points"] = path.kinds.size();
  document["kind_names"] = app::kPathKindNames;
  document["columns"] = {
      {"points_mm", base64_column(path.points_mm)},
      {"kinds", base64_column(path.kinds)},
      {"lines", base64_column(path.lines)},
      {"feeds", base64_column(path.feeds)},
      {"times_s", base64_column(times.times_s)},
      {"speeds", base64_column(times.speeds_mm_min)},
      {"buffer", base64_column(times.buffer)},
      {"deviations_mm", base64_column(path.deviations ? path.deviations->values_mm : no_deviations)}};
  return dump(document);
}

std::string path_picture(const app::PathPicture& picture) {
  return dump({{"view", app::kPictureViewNames[static_cast<std::size_t>(picture.view)]},
               {"width", app::PathPicture::kWidth},
               {"height", app::PathPicture::kHeight},
               {"cut", picture.cut},
               {"rapid", picture.rapid},
               {"has_all_cuts", picture.has_all_cuts}});
}

std::string statistics(const app::Statistics& statistics) {
  const app::ToolPath& path = statistics.path;
  Document tools = Document::array();
  for (std::size_t i = 0; i < path.tools.size(); ++i) {
    const app::ToolMoves& one = path.tools[i];
    const double time_s = i < statistics.tool_times_s.size() ? statistics.tool_times_s[i] : 0.0;
    if (one.name.empty() && one.cut_mm == 0.0 && one.rapid_mm == 0.0 && time_s == 0.0) continue;
    tools.push_back({{"tool", text_or_null(one.name)},
                     {"first_line", id_or_null(one.first_line)},
                     {"cut_mm", one.cut_mm},
                     {"rapid_mm", one.rapid_mm},
                     {"time_s", statistics.time_s ? Document(time_s) : Document(nullptr)}});
  }
  Document document = head_document(path);
  document.update({{"lines", statistics.lines},
                   {"bytes", statistics.bytes},
                   {"blocks", path.report.blocks},
                   {"time_s", statistics.time_s ? Document(*statistics.time_s) : Document(nullptr)},
                   {"why_no_time", text_or_null(statistics.why_no_time)},
                   {"tools", std::move(tools)}});
  return dump(document);
}

// --- the stock along it; numbers are copied as they lie in memory

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
