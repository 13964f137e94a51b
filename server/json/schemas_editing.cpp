// What an editor asks for, and the toolpath next to it.
#include "dialects/compile/dialect/language.h"
#include "dialects/compile/dialect/outline.h"
#include "dialects/compile/render/optimized.h"
#include "dialects/compile/translate/convert.h"
#include "server/app/checks/path_picture.h"
#include "server/app/checks/tool_path.h"
#include "server/json/schemas.h"
#include "server/json/schemas_checks.h"
#include "server/json/schemas_shared.h"

namespace dripfeed::json {

namespace {

Members range() {
  return {{"line", integer("where it begins, from 1")},
          {"column_chars", integer("where it begins, from 1, in characters")},
          {"end_line", integer("where it ends")},
          {"end_column_chars", integer("of the first character after it")}};
}

Schema fault() {
  return object(
      "a fault in the text",
      Members{{"id", text("of the kind of fault")}, {"severity", severity()}} + range() +
          Members{{"text", text("one sentence")},
                  {"help", text("the fault and its cure")},
                  {"alarm", control_alarm()},
                  {"notes", list_of(object("what belongs to it",
                                           {{"line", integer("of the text")}, {"text", text("one sentence")}}),
                                    "elsewhere in the text")},
                  {"fix", or_null(object("what would mend it; null: nothing for certain",
                                         range() + Members{{"text", text("that stands in its place then")}}))}});
}

// What is known of a program's motions next to its points.
Members path_members() {
  const auto place = [](std::string about) { return list_of(3, number("x y z, x as radius"), std::move(about)); };
  return {{"dialect", text("in which the text was read")},
          {"control", control()},
          {"x_is_diameter", flag("the program's x words are diameters")},
          {"segments", integer("straight ones; an arc is chords with a deviation of 0.005 mm at most")},
          {"low_mm", place("the lowest of all points")},
          {"high_mm", place("the highest of all points")},
          {"cut_mm", number("length of all cuts and threads")},
          {"rapid_mm", number("length of all rapids, as straight lines")},
          {"not_drawn", list_of(object("moves that the path does not have",
                                       {{"why", one_of(app::kNotDrawnNames, "they are not there")},
                                        {"moves", integer("of that kind")},
                                        {"first_line", integer("of the first one; 0: in a called program")}}),
                                "each reason once")},
          {"other_axes", list_of(text("letter of an axis"), "that move, other than x, y and z")},
          {"work_offsets",
           list_of(integer("0: none, 1: G54, …"), "that the moves lie in; their zeros are drawn in one place")},
          {"compensated", flag("moves have tool radius compensation, which the path does not have")},
          {"is_cut_off", flag("there are more points than these")},
          {"ran", flag("the program ran to its end")},
          {"not_known", list_of(text("one sentence"), "what the run found and did not know, as in a verdict")},
          {"diagnostics", diagnostics_schema("of reading, validating and running the text; the first of each kind")}};
}

Members path_of_machine_members() {
  const auto notes = [] { return list_of(text("one sentence"), "what they leave out"); };
  const Schema step = object("from a height on it is this wide",
                             {{"from_mm", number("above the tip")}, {"diameter_mm", number("up to the next step")}});
  const Schema insert = object("of a turning tool; null: not known",
                               {{"angle_deg", number("between its two edges")},
                                {"entering_angle_deg", number("of the leading edge against the direction of feed")},
                                {"edge_mm", number("length of an edge")}});
  const Schema shape = or_null(object("its shape, as the machine's profile or the family has it; null: not known",
                                      {{"diameter_mm", or_null(number("of a mill; null: not known"))},
                                       {"corner_radius_mm", number("of a mill: 0 is flat")},
                                       {"nose_radius_mm", number("of a turning tool")},
                                       {"tip", integer("of a turning tool, 0 to 9; 0 of others")},
                                       {"length_mm", or_null(number("from the gauge line to the tip; null: not "
                                                                    "known"))},
                                       {"insert", or_null(insert)},
                                       {"holder", list_of(step,
                                                          "shank and holder of a mill, from below; empty: not "
                                                          "known")}}));
  return {{"time", or_null(object("when the points are reached on the machine; null: not known",
                                  {{"cycle_s", number("of the whole program, all waiting included")},
                                   {"is_fed", flag("it is fed over the machine's line while it runs")},
                                   {"notes", notes()}}))},
          {"why_no_time", or_null(text("why no times are known; null: they are"))},
          {"deviation",
           or_null(object("how far from the nominal the blocks cut; null: no nominal is known",
                          {{"of_surface", flag("that the tool leaves; otherwise of the path")}, {"notes", notes()}}))},
          {"tools", list_of(object("a tool", {{"tool", or_null(text("as the program names it; null: none is taken"))},
                                              {"shape", shape}}),
                            "in the order in which they are taken first")},
          {"tool_changes", list_of(object("from a point on, another tool",
                                          {{"point", integer("from 0")}, {"tool", integer("of tools, from 0")}}),
                                   "in the order of the path")}};
}

Schema statistics() {
  const Schema tool =
      object("what one tool does", {{"tool", or_null(text("as the program names it; null: before any is taken"))},
                                    {"first_line", or_null(integer("that takes it; null: none of the text"))},
                                    {"cut_mm", number("length of its cuts and threads")},
                                    {"rapid_mm", number("length of its rapids")},
                                    {"time_s", or_null(number("of its moves, dwells and change; null: not known"))}});
  return object(
      "what a text amounts to; without the programs that it calls",
      path_members() +
          Members{{"lines", integer("of the text")},
                  {"bytes", integer("of the text")},
                  {"blocks", integer("that were executed")},
                  {"time_s",
                   or_null(number(
                       "of all moves, dwells and tool changes, without waiting for control or line; null: not known"))},
                  {"why_no_time", or_null(text("why no time is known; null: it is"))},
                  {"tools", list_of(tool, "in the order in which they are taken first")}});
}

Schema compute_cost(std::string of) {
  return object(std::move(of), {{"total_ms", number("of all that is computed")},
                                {"longest_ms", number("computed before one move, at most")},
                                {"longest_line", integer("of the text, where that move is")},
                                {"moves", integer("of the run")},
                                {"blocks", integer("that were executed")}});
}

// An interval: each figure of the cost model may be off by its spread.
Schema saving(std::string of) {
  return or_null(object(std::move(of), {{"ms", number("by the cost model; below zero: it costs more")},
                                        {"least_ms", number("if each figure of the model is off to its disadvantage")},
                                        {"most_ms", number("if each is off to its advantage")}}));
}

Schema optimized_schema() {
  std::vector<std::string_view> names;
  for (const optimize::RuleRow& row : optimize::kRuleRows) names.push_back(row.name);
  const Schema rule = one_of(names, "that was applied");
  return object(
      "a text made faster for its control; it is not stored",
      {{"text", or_null(text("the new text; unchanged where nothing was gained; null: it could not be read"))},
       {"origins", list_of(integer("line of the given text; 0: of none"),
                           "where each line of the new text comes from; empty: it is unchanged")},
       {"passes", list_of(object("a rule that changed something",
                                 {{"rule", rule},
                                  {"edits", integer("how many of the changes are its own")},
                                  {"saved", saving("next to the text with the rules before it alone; null: not run")}}),
                          "in the order of the rules")},
       {"changes", list_of(object("a change",
                                  {{"line", integer("of the given text")}, {"rule", rule}, {"what", text("a clause")}}),
                           "in the order in which they were made")},
       {"left_because", or_null(text("why the text is unchanged; null: it is not"))},
       {"not_verified", or_null(text("why running both does not show that they move the same; null: it does"))},
       {"proved_max_mm",
        or_null(number("how far both paths lie apart at most, where a rule changed it; null: they are the same"))},
       {"not_merged", or_null(text("why no blocks were merged; null: they were, or it was not asked for"))},
       {"not_tabulated", or_null(text("why no formula is a table; null: one is, or it was not asked for"))},
       {"not_inlined",
        list_of(object("a call that stays", {{"line", integer("of the given text")},
                                             {"program", or_null(text("that is called; null: a value decides"))},
                                             {"why", text("a clause")}}),
                "in the order of the text; empty where the rule is off")},
       {"saved", saving("by all rules; null: it was not run")},
       {"before", or_null(compute_cost("what the given text's run costs; null: it was not run"))},
       {"after", or_null(compute_cost("what the new text's run costs; null: it was not run"))},
       {"cost",
        object("the cost model", {{"source", one_of(ir::kCostSourceNames, "of its figures")},
                                  {"origin", text("where they are from")},
                                  {"spread", number("each time lies between time / spread and time * spread")}})},
       {"diagnostics", diagnostics_schema("of reading the given text")}});
}

}  // namespace

Schemas editing_schemas() {
  return {
      {"Diagnosed",
       object("what reading and validating a text finds; it is not run",
              {{"dialect", text("in which it was read")},
               {"control", control()},
               {"faults", list_of(fault(), "in the order of the text; the first of each kind")},
               {"folded", folded()},
               {"outline", list_of(object("a place", {{"sort", one_of(compile::kOutlineSortNames, "of place")},
                                                      {"line", integer("of the text")},
                                                      {"text", text("of that line")}}),
                                   "programs, labels, calls, tools and stops in the order of the text")},
               {"outline_is_cut", flag("there are more places than these")}})},
      {"SplitText",
       object("the programs of a text",
              {{"programs", list_of(object("a program", {{"name", or_null(text("that it gives itself; null: none"))},
                                                         {"comment", or_null(text("its first; null: none"))},
                                                         {"text", text("with its own line ends")}}),
                                    "in their order; one where the text is not several")}})},
      {"Converted",
       object("a text in another control's language; it is not stored",
              {{"from", text("dialect that it was read in")},
               {"to", text("dialect that it was translated to")},
               {"mode", one_of(compile::kConvertModeNames, "of translation")},
               {"text", or_null(text("the translation; null: refused, and the diagnostics state why"))},
               {"verified", flag("both texts were run and made the same moves")},
               {"not_verified", or_null(text("why that cannot be stated; null: it is, or nothing was translated"))},
               {"origins", list_of(integer("line of the given text; 0: of none"),
                                   "where each line of the translation comes from; empty: the text itself")},
               {"diagnostics", diagnostics_schema("of the given text; the first of each kind")},
               {"folded", folded()}})},
      {"Optimized", optimized_schema()},
      {"Rewritten", object("a rewritten text; it is not stored",
                           {{"text", or_null(text("the same program; null: refused"))},
                            {"numbers", integer("blocks that have a number now; where numbers were asked for")},
                            {"references", integer("words that name one of them")},
                            {"assumptions", list_of(text("one sentence"), "what was taken for granted")},
                            {"refused", list_of(object("what stands against it",
                                                       {{"line", or_null(integer("of the given text; null: of none"))},
                                                        {"text", text("why")}}),
                                                "none: it was done")}})},
      {"DialectWords",
       object("the words of a control's language",
              {{"dialect", text("its name")},
               {"title", text("of the control, for people")},
               {"comment", object("what a comment stands in", {{"open", text("its start")},
                                                               {"close", or_null(text("null: the end of the line"))}})},
               {"touching", flag("words may follow each other without blanks: XROUND[#1] is X and ROUND")},
               {"words", list_of(object("a word",
                                        {{"word", text("as the control's manual writes it")},
                                         {"sort", one_of(ir::kWordSortNames, "of word")},
                                         {"about", text("a few words")},
                                         {"reference", or_null(text("manual and section; null: none"))},
                                         {"last", or_null(integer("of numbered variables the last; null: just one"))}}),
                                 "each once")}})},
  };
}

Schemas path_schemas() {
  return {
      {"ToolPath",
       object(
           "what is known of a program's toolpath: the programmed one, without tool radius compensation, in the active "
           "work offset",
           path_members() + path_of_machine_members() +
               Members{
                   {"points", integer("rows of the columns")},
                   {"kind_names", list_of(one_of(app::kPathKindNames, "of segment"), "by the numbers of the column")},
                   {"columns",
                    object(
                        "one row for each point; numbers little-endian, as base64",
                        {{"points_mm", text("x y z as 32-bit floats, x as radius")},
                         {"kinds", text("what leads to the point, a byte; begin: nothing does")},
                         {"lines", text("of the program's text as 32-bit integers; 0: in a called program")},
                         {"feeds", text("as programmed, 32-bit floats: mm/min, mm/rev or 1/min by the kind")},
                         {"times_s", text("when the point is reached, 32-bit floats; NaN: not known; empty: of none")},
                         {"speeds", text("mean speed of the segment to the point, mm/min, 32-bit floats; NaN: not "
                                         "known; empty: of none")},
                         {"buffer", text("bytes in the control when the motion to the point begins, 32-bit "
                                         "integers; empty: nothing is fed")},
                         {"deviations_mm", text("of what the point's block cuts from the nominal, 32-bit floats; "
                                                "positive: material is left; NaN: not measured; empty: of none")}})}})},
      {"PathPicture",
       object("a program's toolpath as a small drawing of lines",
              {{"view", one_of(app::kPictureViewNames, "of it: turning has z to the right and x up")},
               {"width", integer("of the drawing; its top left is 0 0")},
               {"height", integer("of the drawing")},
               {"cut", text("path data as SVG has them; empty: no cut is known")},
               {"rapid", text("path data; may lie outside of the drawing; empty: no rapid is known")},
               {"has_all_cuts", flag("it was run to its end, and no cut lies at a position that is not known")}})},
      {"Statistics", statistics()}};
}

}  // namespace dripfeed::json
