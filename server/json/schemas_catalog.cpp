// Families and parts.
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

Members changed() {
  return {{"changed_by", text("who made this revision")}, {"changed_at_ms", time_ms("when it was made")}};
}

Members family_head() {
  return Members{{"name", text("of the family")},
                 {"title", text("for people; empty: none")},
                 {"revision", integer("of its text, from 1")}} +
         changed();
}

Schema parameter() {
  return object("a value that a part gives", {{"name", text("of the parameter")},
                                              {"kind", text("as the family's `param` line names it: length, count, "
                                                            "choice, yes_no, tool, text, list of length ...")},
                                              {"unit", text("of default, low and high; empty: a plain number")},
                                              {"default", text("as one would write it: \"100 mm\"")},
                                              {"low", or_null(number("least value, in `unit`; null: no bound"))},
                                              {"high", or_null(number("greatest value, in `unit`; null: no bound"))},
                                              {"step", number("values are `low` plus a whole number of steps, in "
                                                              "`unit`; 0: any value")},
                                              {"choices", list_of(text(""), "the words of a choice or of yes_no")},
                                              {"fewest", integer("numbers of a list; 0: it is none")},
                                              {"most", integer("numbers of a list; 0: it is none")},
                                              {"text", text("what it is, for people")},
                                              {"group", text("the heading under which forms show it; may be empty")}});
}

}  // namespace

Schemas catalog_schemas() {
  return {
      {"FamilySummary", object("a part family as a list shows it", family_head())},
      {"Family", object("a part family", family_head() + Members{{"text", text("in the family language")},
                                                                 {"parameters", list_of(parameter(),
                                                                                        "in the text's "
                                                                                        "order")}})},
      {"Part", object("a family with values", Members{{"number", text("of the part")},
                                                      {"revision", integer("of its values, from 1")},
                                                      {"family", text("its name")},
                                                      {"family_revision", integer("against which the values hold")},
                                                      {"values", map_of(text("with its unit: \"120 mm\""),
                                                                        "those that are given, by parameter")}} +
                                                  changed())},
  };
}

}  // namespace dripfeed::json
