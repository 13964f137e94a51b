// The path of a program's tool: columns of numbers, and what is known of them in words.
#include "server/json/tool_path.h"

#include "server/json/base64.h"
#include "server/json/control_document.h"
#include "server/json/diagnostics.h"
#include "server/json/parse.h"
#include "server/json/reports.h"
#include "server/json/schemas.h"
#include "server/json/schemas_checks.h"
#include "server/json/schemas_shared.h"

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

}  // namespace

std::string tool_path(const app::ToolPath& path) {
  const app::CheckReport& report = path.report;
  return dump({{"dialect", report.dialect},
               {"control", control_document(report)},
               {"x_is_diameter", path.x_is_diameter},
               {"points", path.kinds.size()},
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
               {"diagnostics", embedded(diagnostics(report.checks.diagnostics, report.source))},
               {"kind_names", app::kPathKindNames},
               {"columns",
                {{"points_mm", base64_column(path.points_mm)},
                 {"kinds", base64_column(path.kinds)},
                 {"lines", base64_column(path.lines)},
                 {"feeds", base64_column(path.feeds)}}}});
}

Schemas path_schemas() {
  const auto place = [](std::string about) { return list_of(3, number("x y z, x as radius"), std::move(about)); };
  return {
      {"ToolPath",
       object(
           "the path of a program's tool, as far as it is known: the programmed one, without compensation of the "
           "tool, in the work offset that is active",
           {{"dialect", text("in which the text was read")},
            {"control", control()},
            {"x_is_diameter", flag("the program's x words are diameters")},
            {"points", integer("rows of the columns")},
            {"segments", integer("straight ones; arcs are chords that lie 0.005 mm beside them at most")},
            {"low_mm", place("the lowest of all points")},
            {"high_mm", place("the highest of all points")},
            {"cut_mm", number("length of all cuts and threads")},
            {"rapid_mm", number("length of all rapids, as straight lines")},
            {"not_drawn", list_of(object("moves that the path does not have",
                                         {{"why", one_of(app::kNotDrawnNames, "they are not there")},
                                          {"moves", integer("of that kind")},
                                          {"first_line", integer("of the first one; 0: in a called program")}}),
                                  "each reason once")},
            {"other_axes", list_of(text("letter of an axis"), "that move beside x, y and z")},
            {"work_offsets",
             list_of(integer("0: none, 1: G54, …"), "that the moves lie in; their zeros are drawn in one place")},
            {"compensated", flag("moves have tool radius compensation, which the path does not have")},
            {"is_cut_off", flag("there are more points than these")},
            {"ran", flag("the program ran to its end")},
            {"not_known", list_of(text("one sentence"), "what the run met and did not know, as a verdict has it")},
            {"diagnostics", diagnostics_schema("of reading, validating and running the text; the first of each kind")},
            {"kind_names", list_of(one_of(app::kPathKindNames, "of segment"), "by the numbers of the column")},
            {"columns",
             object("a row a point; numbers little-endian, as base64",
                    {{"points_mm", text("x y z as 32-bit floats, x as radius")},
                     {"kinds", text("what leads to the point, a byte; begin: nothing does")},
                     {"lines", text("of the program's text as 32-bit integers; 0: in a called program")},
                     {"feeds", text("as programmed, 32-bit floats: mm/min, mm/rev or 1/min by the kind")}})}})}};
}

}  // namespace dripfeed::json
