// Programs, their revisions, and what rendering says.
#include "dialects/compile/render/render.h"
#include "server/app/out/events.h"
#include "server/json/enumerators.h"
#include "server/json/schemas.h"
#include "server/json/schemas_shared.h"

namespace dripfeed::json {

namespace {

Words render_modes() { return names_of<compile::RenderMode>(compile::name_of); }

Schema origin() {
  return object("where the text comes from; an uploaded one has its kind alone",
                {{"kind", one_of(store::kNames<store::OriginKind>, "of origin")},
                 {"family", text("that was rendered"), kOptional},
                 {"family_revision", integer("of that family"), kOptional},
                 {"part", or_null(text("whose values were taken; null: values of the request")), kOptional},
                 {"part_revision", integer("of that part; 0: none"), kOptional},
                 {"machine", text("for which it was rendered"), kOptional},
                 {"machine_revision", integer("of that machine's profile"), kOptional},
                 {"mode", one_of(render_modes(), "how it was rendered"), kOptional}});
}

Members revision() {
  return Members{{"revision", integer("of the text, from 1")}, {"sha256", text("of the text, in hexadecimal")}} +
         Members{{"bytes", integer("of the text")},
                 {"blocks", integer("lines of the text that are not empty and no %")},
                 {"origin", origin()}} +
         created();
}

Schema legend_entry() {
  return object("a variable, or a list of some in a row",
                {{"variable", text("as the control names it; of a list the first")},
                 {"count", integer("how many, in a row; 1: no list")},
                 {"name", text("in the family")},
                 {"meaning", or_null(text("of the parameter; null: none is stated"))},
                 {"unit", or_null(text("of the number in the variable; null: none, or not known"))},
                 {"kind", one_of(compile::kLegendKindNames,
                                 "parameter: people may change it; derived: it follows from those; computed: the "
                                 "program changes it")},
                 {"value", or_null(number("that the text gives it; null: a list, or computed"))}});
}

Members rendering() {
  return {{"mode", one_of(render_modes(), "that was taken")},
          {"because", text("why this mode, as one sentence")},
          {"blocks", integer("lines of the text that are not empty and no %")},
          {"bytes", integer("of the text")},
          {"variables", integer("different user variables that the text touches")},
          {"legend", list_of(reference("LegendEntry"),
                             "what the variables of a macro mean, by their numbers; empty: plain blocks")},
          {"diagnostics", diagnostics_schema("of the family's text")}};
}

Schema place(std::string about) { return list_of(2, number("mm"), std::move(about)); }

Schema drawn_view() {
  const auto of = [] { return one_of(family::kDrawnOfNames, "what it is a line of"); };
  return object(
      "one view",
      {{"axes", text("two letters, the first one across; zx: x is a radius")},
       {"lines", list_of(object("a line", {{"of", of()}, {"points", list_of(place("across and up"), "in order")}}),
                         "of the part")},
       {"circles",
        list_of(object("a circle", {{"of", of()}, {"center", place("across and up")}, {"diameter_mm", number("mm")}}),
                "of the part")},
       {"dimensions",
        list_of(object("where a parameter is seen", {{"parameter", text("its name")},
                                                     {"kind", one_of(family::kDimensionKindNames, "of the dimension")},
                                                     {"value", text("with its unit")},
                                                     {"from", place("across and up")},
                                                     {"to", place("across and up")},
                                                     {"at", or_null(place("corner of an angle; else null"))}}),
                "in the order of the family's text")}});
}

}  // namespace

Schemas program_schemas() {
  return {
      {"LegendEntry", legend_entry()},
      {"Program",
       object(
           "a program with its newest revision",
           Members{{"id", integer("of the program")},
                   {"name", text("of the program")},
                   {"dialect", text("of its text")},
                   {"tags", list_of(text("a tag"), "that people gave it, sorted")},
                   {"folder", or_null(text("in which people put it, as \"customer/pumps\"; null: in none"))},
                   {"archived",
                    or_null(object("who put it aside; null: it is in use",
                                   {{"by", text("who did")}, {"reason", text("why")}, {"at_ms", time_ms("when")}}))},
                   {"deleted",
                    or_null(object("who deleted it; null: it is not; the revision is 0 where nothing names its text",
                                   {{"by", text("who did")}, {"reason", text("why")}, {"at_ms", time_ms("when")}}))}} +
               revision())},
      {"ProgramRevision", object("one revision of a program", Members{{"id", integer("of the program")}} + revision())},
      {"ProgramLines",
       object("some lines of a revision",
              {{"from", integer("the first of them, from 1")},
               {"count_all", integer("lines of the revision")},
               {"lines",
                list_of(object("a line of the text, and what it was rendered from",
                               {{"line", integer("of the text, from 1")},
                                {"text", text("its text")},
                                {"family_line", or_null(integer("of the family; null: not known"))},
                                {"family_text", or_null(text("that line; null: not known"))},
                                {"values", or_null(map_of(number("of the variable"),
                                                          "variables of that line at this block; null: not known"))}}),
                        "in their order")}})},
      {"Preview", object("what rendering would store; nothing is stored",
                         Members{{"text", text("of the program")}, {"drawing", list_of(drawn_view(), "of the part")}} +
                             rendering())},
      {"Rendered",
       object("a program that was rendered and stored", Members{{"program", integer("its id")},
                                                                {"name", text("of the program")},
                                                                {"revision", integer("of its text")},
                                                                {"sha256", text("of the text, in hexadecimal")}} +
                                                            rendering())},
  };
}

}  // namespace dripfeed::json
