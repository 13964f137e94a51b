// What an editor asks for.
#include "dialects/compile/convert.h"
#include "dialects/compile/language.h"
#include "dialects/compile/outline.h"
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
      {"DialectWords",
       object("the words of a control's language",
              {{"dialect", text("its name")},
               {"title", text("of the control, for people")},
               {"comment", object("what a comment stands in", {{"open", text("its begin")},
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

}  // namespace dripfeed::json
