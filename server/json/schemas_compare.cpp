// Two revisions compared.
#include "server/app/library/compare.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

Schema answer_word(std::string about) { return one_of(app::kLikenessWords, std::move(about)); }

Members answer_members() {
  const auto lines = [](std::string of) {
    return list_of(object("a line", {{"line", integer("of that text, from 1")}, {"text", text("its text")}}),
                   std::move(of));
  };
  return {{"answer", answer_word("the result")},
          {"why", or_null(text("it was not compared; null: it was"))},
          {"changes",
           list_of(object("lines that are others", {{"first", lines("of the first program; none: it has none there")},
                                                    {"second", lines("of the second")}}),
                   "in their order, 200 at most of 50 lines each")},
          {"change_count", integer("all changes, shown or not")}};
}

Schema side(std::string about) {
  return object(std::move(about), {{"program", integer("its id")},
                                   {"name", text("of the program")},
                                   {"revision", or_null(integer("of its text; null: a text that was given"))}});
}

Schema motions() {
  return object(
      "whether both move the axes the same, in order, with the same feeds, tools and states",
      {{"answer", answer_word("the result")},
       {"why", or_null(text("it was not compared; null: it was"))},
       {"moves", integer("that are the same, up to the first difference")},
       {"first_line", or_null(integer("of the first difference in the first program; null: none, or it has ended"))},
       {"second_line", or_null(integer("of the first difference in the second program"))},
       {"first", or_null(text("what the first program does there"))},
       {"second", or_null(text("what the second program does there"))},
       {"deviation_mm", or_null(number("largest difference of end points and arc centres, of diameters half of it; "
                                       "null: not compared, or they do not consist of the same moves"))},
       {"deviation_deg", or_null(number("the same of rotary axes"))}});
}

}  // namespace

Schemas compare_schemas() {
  return {
      {"Comparison",
       object("two revisions, compared",
              {{"first", side("of the path")},
               {"second", side("of `with`")},
               {"text", object("line by line; forms of the end of a block, blank lines and blanks at the end of a "
                               "line do not count",
                               answer_members())},
               {"meaning", object("as the dialect's reader understands it: block numbers, blanks, comments, the case "
                                  "of letters, leading zeros and forms of decimals do not count",
                                  answer_members())},
               {"motions", motions()}})}};
}

}  // namespace dripfeed::json
