// Verdicts with what the checks report. Lengths are millimeters and times seconds; a value that is not known is null.
#include "server/json/schemas_checks.h"

#include "checks/verdict.h"
#include "dialects/ir/cost_model.h"
#include "server/app/out/events.h"
#include "server/json/profile_words.h"
#include "server/json/schemas_shared.h"

namespace dripfeed::json {

namespace {

Schema finding() {
  return object("what a check found at one place", {{"id", text("of the kind of finding")},
                                                    {"severity", severity()},
                                                    {"line", integer("of the program, from 1; 0: of the whole")},
                                                    {"program", integer("index into `programs`; 0: the main one")},
                                                    {"value", or_null(number("that was found"))},
                                                    {"limit", or_null(number("that it breaks"))},
                                                    {"text", text("one sentence")},
                                                    {"alarm", control_alarm()}});
}

Members findings() {
  return {{"findings", list_of(finding(), "the first ones of each kind")},
          {"counts", map_of(integer("how many there are"), "all findings, by their id")}};
}

Schema point(std::string about) { return list_of(2, number(""), std::move(about)); }

Members deviation() {
  return {{"points", integer("places that were measured")},
          {"max_mm", number("largest deviation; positive: material is left, negative: too much is taken")},
          {"max_at_line", integer("of the program; 0: none")},
          {"max_at", point("where; turning: Z and radius, milling: X and Y")},
          {"mean_mm", number("of the size, along the path")},
          {"rmse_mm", number("root of the mean square")}};
}

Schema limited() {
  Members members;
  for (const std::string_view word : names_of<timing::Limiter>(timing::name_of))
    members.push_back({std::string(word), number("in seconds")});
  return object("how long each was what the machine waited for, in seconds", std::move(members));
}

Schema stretch() {
  return object("lines in a row that wait for the same",
                {{"limited_by", one_of(names_of<timing::Limiter>(timing::name_of), "what they wait for")},
                 {"first_line", integer("of the program")},
                 {"last_line", integer("of the program")},
                 {"start_s", number("since the start")},
                 {"duration_s", number("of all of them")}});
}

Schema without_stall() {
  return object("what would let the program run without a standstill; null: not needed, or nothing would",
                {{"feed_share", or_null(number("of the programmed feed, 0 to 1"))},
                 {"feed_mm_min", or_null(number("the highest programmed feed"))},
                 {"baud", or_null(number("of the line"))},
                 {"standard_baud", or_null(number("the next usual one"))}});
}

Schema verdict_word(std::string about) { return one_of(store::kNames<store::Outcome>, std::move(about)); }

Members waivers() {
  return {
      {"points", list_of(text("one sentence"),
                         "what stands between it and a pass; none: it is waived as a whole, or not at all")},
      {"waivers",
       list_of(object("a person answers for it",
                      {{"name", text("of the person")},
                       {"reason", text("why")},
                       {"at_ms", time_ms("when")},
                       {"point", or_null(text("that it is for; null: for all of them"))},
                       {"expires_at_ms", or_null(time_ms("from then on it no longer counts; null: it does not end"))}}),
               "of this verdict")}};
}

Members verdict_head() {
  return Members{{"id", integer("of the verdict")},
                 {"program", integer("its id")},
                 {"revision", integer("of the program's text")},
                 {"sha256", text("of the text, in hexadecimal")},
                 {"machine", text("for which it was checked")},
                 {"machine_revision", integer("of that machine's profile")},
                 {"delivery", one_of(store::kNames<store::Delivery>, "for which it was checked")},
                 {"verdict", verdict_word("pass needs everything that moves, shifts or writes to be understood")},
                 {"rules", or_null(text("the revision of the code that judged; null: an older server did"))},
                 {"stale", flag("the machine's profile, the family, a called program or the code that judges has "
                                "changed since")}} +
         created();
}

// Of the four checks, each is null where it was not made.
Members report() {
  return {{"dialect", text("in which the text was read")},
          {"control", control()},
          {"diagnostics", diagnostics_schema("of reading, validating and running the text; the first of each kind")},
          {"folded", folded()},
          {"blocks", integer("that ran")},
          {"ran", flag("it ran to its end")},
          {"timing", or_null(reference("Timing"))},
          {"accuracy", or_null(reference("Accuracy"))},
          {"envelope", or_null(reference("Envelope"))},
          {"gouge", or_null(reference("Gouge"))},
          {"not_checked", not_checked()},
          {"programs", list_of(text("name of a program"), "the main one first, then those that it calls")}};
}

}  // namespace

Schema control() {
  return object("as which control the text was read",
                {{"title", text("for people")},
                 {"kind", one_of(ir::kMachineKindNames, "of machine")},
                 {"g_system", one_of(kGSystemWords, "G code system of a lathe")},
                 {"feed_mode", one_of(kFeedModeWords, "at power-on")},
                 {"because_line", integer("by which it was inferred; 0: it was named, or is the default")},
                 {"inferred", flag("the control was inferred from the text")}});
}

Schema folded() {
  return list_of(object("how many more of a kind there are", {{"id", text("of the kind of fault")},
                                                              {"severity", severity()},
                                                              {"more", integer("that are not listed")}}),
                 "of the diagnostics");
}

Schema not_checked() { return list_of(text("one sentence"), "what was not checked, and why"); }

Members envelope_members() {
  return findings() +
         Members{{"moves", integer("that were checked")},
                 {"machine_travel", map_of(list_of(2, or_null(number("")), "least and greatest"),
                                           "reached in machine coordinates, in millimeters or degrees, by axis")},
                 {"feed_max_mm_min", number("the highest")},
                 {"spindle_max_rpm", number("the highest")}};
}

Members gouge_members() {
  return findings() + Members{{"rapids", integer("that were checked")},
                              {"cuts", integer("that were checked")},
                              {"deepest_rapid_mm", number("into stock or part")},
                              {"deepest_cut_mm", number("below the nominal")}};
}

Members accuracy_members() {
  const std::string_view measured[] = {"surface", "path"};
  return Members{{"blocks", integer("that were measured")},
                 {"points", integer("places that were measured")},
                 {"max_mm", number("size of the largest deviation")},
                 {"max_at_line", integer("of the program; 0: none")},
                 {"mean_mm", number("of the size, along the path")},
                 {"rmse_mm", number("root of the mean square")},
                 {"chord_bound_mm", or_null(number("proved from the curve; null: none"))},
                 {"measured", one_of(measured, "of what the figures above are")},
                 {"path", object("of the programmed path", deviation())},
                 {"surface", or_null(object("of what the tool leaves; null: the tool is not known", deviation()))},
                 {"overrun_mm", number("farthest reach of the path beyond the ends of the nominal")},
                 {"covered", flag("the path passes all of the nominal")}} +
         findings();
}

Members timing_members() {
  return {{"blocks", integer("that ran")},
          {"cycle_s", number("of the whole program")},
          {"motion_s", number("of motion alone")},
          {"compute_s", number("of the control's computing alone")},
          {"line_s", number("of the line alone")},
          {"stalls", integer("standstills while the control waits for blocks")},
          {"stall_s", number("how much longer the program takes because of them")},
          {"first_stall_line", integer("of the program; 0: none")},
          {"compute_low_s", number("compute_s may be as little, as far as the cost model is known")},
          {"compute_high_s", number("and as much")},
          {"compute_source", one_of(ir::kCostSourceNames, "of the cost model; calibrated: at this machine")},
          {"compute_origin", text("of the cost model, in words")},
          {"standstill_s", number("all standstills together")},
          {"first_stall_at_s", number("since the start")},
          {"longest_standstill_s", number("of all")},
          {"longest_standstill_line", integer("of the program; 0: none")},
          {"first_move_s", number("since the start")},
          {"rapid_s", number("of rapid motion")},
          {"path_mm", number("of all motion")},
          {"blocks_per_s", number("on average")},
          {"limited_s", limited()},
          {"whole", flag("the times are those of the whole program, not of its beginning")},
          {"course", list_of(list_of(2, number(""), "a line and when it begins, in seconds since the start"),
                             "some lines in their order; empty where lines run more than once")},
          {"stretches", list_of(stretch(), "the first ones, in their order")},
          {"stretch_count", integer("how many there are in all")},
          {"lowest_buffer_bytes", or_null(number("in the control; null: it is not fed over a line"))},
          {"lowest_buffer_blocks", or_null(number("in the control; null: it is not fed over a line"))},
          {"without_stall", without_stall()}};
}

Schema calls() {
  return list_of(
      object("a program of the library that the text was run with", {{"name", text("by which it is called")},
                                                                     {"program", integer("id of the program")},
                                                                     {"revision", integer("of the program")}}),
      "called programs; the verdict holds while these revisions are the ones that are called");
}

Schemas check_schemas() {
  return {
      {"Timing", object("how long a program takes", timing_members())},
      {"Accuracy", object("how far a program lies from its nominal", accuracy_members())},
      {"Envelope", object("whether a program stays inside the machine", envelope_members())},
      {"Gouge", object("whether a program cuts where it must not", gouge_members())},
      {"VerdictSummary", object("what the checks found in a program, without their report",
                                verdict_head() + Members{{"calls", calls()}} + waivers())},
      {"PreviewVerdict",
       object("what a check of a rendered program would find; it is stored nowhere, and releases nothing",
              Members{{"verdict", verdict_word("pass needs everything that moves, shifts or writes to be understood")},
                      {"points", list_of(text("one sentence"), "what stands between it and a pass")}} +
                  report())},
      {"Verdict", object("what the checks found in a program",
                         verdict_head() + report() + Members{{"calls", calls()}} + waivers())},
      {"EventVerdict", object("a program was checked", {{"id", integer("of the verdict")},
                                                        {"verdict", verdict_word("of the checks")},
                                                        {"machine", text("for which it was checked")},
                                                        {"text", text("one sentence")}})},
  };
}

}  // namespace dripfeed::json
