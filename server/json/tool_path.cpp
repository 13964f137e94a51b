// What a path has next to its points is the same wherever it is shown.
#include "server/json/tool_path.h"

#include <utility>

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

}  // namespace

std::string tool_path(const app::ToolPath& path) {
  Document document = head_document(path);
  document["points"] = path.kinds.size();
  document["kind_names"] = app::kPathKindNames;
  document["columns"] = {{"points_mm", base64_column(path.points_mm)},
                         {"kinds", base64_column(path.kinds)},
                         {"lines", base64_column(path.lines)},
                         {"feeds", base64_column(path.feeds)}};
  return dump(document);
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

}  // namespace dripfeed::json
