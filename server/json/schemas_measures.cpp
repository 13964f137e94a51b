// Figures that are measured and not kept.
#include "server/app/ports/workplace.h"
#include "server/json/schemas_checks.h"

namespace dripfeed::json {

namespace {

Members cmm_members() {
  return {{"points", integer("measured points")},
          {"min_mm", number("least deviation, with its sign")},
          {"max_mm", number("greatest deviation, with its sign")},
          {"mean_mm", number("with its sign")},
          {"rmse_mm", number("root of the mean square")},
          {"max_at_row", integer("of the largest deviation, from 1")}};
}

Schema cmm() {
  const Members fit = {{"shift_mm", list_of(2, number(""), "of the part: Z and X, or X and Y")},
                       {"turn_deg", number("of the part")}};
  return object(
      "points that were measured at a part, compared with the nominal",
      cmm_members() +
          Members{{"best_fit", object("after the part is shifted and turned to fit best", cmm_members() + fit),
                   kOptional}});
}

Members validated() { return {{"validated", flag("the text was validated before it ran")}}; }

Schema trial() {
  return object("the result for a set of values", {{"passes", flag("all checks")},
                                                   {"check", text("that fails; empty: none")},
                                                   {"text", text("its text; empty: none")}});
}

Schema side(std::string about) {
  return or_null(object(std::move(about), {{"fails_at", number("nearest value that fails, in the parameter's unit")},
                                           {"check", text("that fails there")},
                                           {"text", text("its text")}}));
}

Schema share(std::string about) {
  return object(std::move(about), {{"tried", integer("sets of values")}, {"passed", integer("of these")}});
}

Schema sweep() {
  const Schema parameter = object(
      "one parameter, from its standard value to both ends of its range; others as usual",
      {{"name", text("of the parameter")},
       {"unit", text("of its values; empty: a plain number")},
       {"low", number("end of its range")},
       {"high", number("end of its range")},
       {"standard", number("from which it is moved")},
       {"passes", list_of(2, number(""), "least and greatest value that passes, to the precision of the bisection"),
        kOptional},
       {"low_bound", side("what fails below; null: the range ends there"), kOptional},
       {"high_bound", side("what fails above; null: the range ends there"), kOptional}});
  const Schema failure = object("the values nearest to the standard that fail; null: none was found",
                                {{"passes", flag("false")},
                                 {"check", text("that fails")},
                                 {"text", text("its text")},
                                 {"values", map_of(number("in the parameter's unit"), "by parameter")},
                                 {"changed", list_of(text("name of a parameter"), "that differ from the standard")}});
  return object("for which values a family passes", {{"parameters", list_of(parameter, "in the family's order")},
                                                     {"standard", trial()},
                                                     {"corners", share("all parameters at an end of their range")},
                                                     {"samples", share("values drawn at random")},
                                                     {"smallest_failure", or_null(failure)},
                                                     {"trials", integer("programs that were rendered and checked")}});
}

Schema work() {
  return object("heavy work that waits for a worker process or runs in one",
                {{"id", integer("since the server's start")},
                 {"kind", text("check, render, accuracy, gouge, timing or sweep")},
                 {"subject", text("the program or family")},
                 {"machine", text("that it is done for; empty: none")},
                 {"actor", text("who asked for it")},
                 {"state", one_of(app::kWorkStates, "of the work")},
                 {"place", or_null(integer("in the queue, from 1; null: it runs"))},
                 {"waiting_since_ms", time_ms("when it was asked for")},
                 {"running_since_ms", or_null(time_ms("when its process began"))},
                 {"budget_s", or_null(integer("of its process; null: not known yet"))}});
}

}  // namespace

Schemas measure_schemas() {
  return {
      {"AccuracyFigures",
       object("how far a program lies from the nominal",
              accuracy_members() + validated() + Members{{"cmm", cmm(), kOptional}, {"not_checked", not_checked()}})},
      {"GougeFigures", object("where a program cuts what it must not",
                              gouge_members() + validated() + Members{{"not_checked", not_checked()}})},
      {"TimingFigures", object("how long a program takes on its machine and line", timing_members() + validated())},
      {"SweepFigures", sweep()},
      {"Work", work()},
  };
}

}  // namespace dripfeed::json
