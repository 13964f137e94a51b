// Releases, jobs, ledgers.
#include "server/app/out/events.h"
#include "server/json/records.h"
#include "server/json/schemas.h"
#include "server/json/schemas_shared.h"

namespace dripfeed::json {

namespace {

Schema delivery() { return one_of(store::kNames<store::Delivery>, "how the text is sent to the control"); }

Schema restart() {
  return or_null(
      object("the restart of another release's text; null: it is none",
             {{"release", integer("whose text it continues")}, {"line", integer("of that text, where it begins")}}));
}

Schema restart_preview() {
  return object(
      "the restart of a program at a line, as it would be sent",
      {{"possible", flag("a text could be made, and nothing found forbids to send it")},
       {"text", or_null(text("the whole text; null: it is refused"))},
       {"sha256", or_null(text("of the text, in hexadecimal: what is approved"))},
       {"preamble_line", or_null(integer("of the text, where what is new begins"))},
       {"rest_line", or_null(integer("of the text, where the rest of the program begins"))},
       {"assumptions", list_of(text("a sentence"), "what must hold at the machine")},
       {"compared_moves", integer("of the rest, that are those of the whole program")},
       {"findings",
        list_of(object("what a move would do to the stock or the part",
                       {{"severity", severity()}, {"line", integer("of the text")}, {"text", text("one sentence")}}),
                "of the part as the blocks before the line have left it")},
       {"not_held", or_null(text("why the moves were not compared with the part; null: they were"))},
       {"safe_before",
        or_null(integer("nearest line before it where a restart is possible; null: none was looked for, or found"))},
       {"safe_after", or_null(integer("the same after it"))},
       {"diagnostics", diagnostics_schema("why it is refused")}});
}

Schema release() {
  return object("a text that may go to one machine by one delivery",
                Members{{"id", integer("of the release")},
                        {"state", one_of(store::kNames<store::ReleaseState>, "of the release")},
                        {"program", integer("its id")},
                        {"revision", integer("of the program's text")},
                        {"machine", text("to which it may go")},
                        {"delivery", delivery()},
                        {"sha256", text("of the text, in hexadecimal")},
                        {"restart", restart()},
                        {"transfers_allowed", integer("while it is proved")},
                        {"transfers_done", integer("of these")},
                        {"proved_by", or_null(text("the operator who signed the proving off; null: no one yet"))},
                        {"proof", or_null(text("what they wrote"))}} +
                    created() +
                    Members{{"approved_by", or_null(text("who approved it"))},
                            {"sign_off", or_null(text("what they wrote"))},
                            {"changed_at_ms", time_ms("when its state changed last")}});
}

Schema job() {
  return object(
      "one transfer of a released text to a machine",
      Members{{"id", integer("of the job")},
              {"state", one_of(store::kNames<store::JobState>, "of the job")},
              {"machine", text("to which it is sent")},
              {"release", integer("its id")},
              {"order", or_null(integer("that it belongs to; null: none"))},
              {"restart", restart()},
              {"program", integer("its id")},
              {"revision", integer("of the program's text")},
              {"sha256", text("of the text, in hexadecimal")},
              {"delivery", delivery()},
              {"link", text("URL of the line")},
              {"bytes", integer("of the transfer on the wire; 0: not known yet")},
              {"reason", text("of the last change of its state; empty: none")},
              {"reason_id", or_null(text("the same as one word or the name of a stall; null: there is none"))},
              {"reason_said", or_null(reference("Said"))},
              {"rank", integer("queued jobs of a machine go in this order, equal ones by id")}} +
          created() +
          Members{
              {"armed_by", or_null(text("who armed it last"))},
              {"armed_at_ms", or_null(time_ms("when it was armed last"))},
              {"expires_at_ms", or_null(time_ms("when its arming ends, while it is armed"))},
              {"started_at_ms", or_null(time_ms("when it first fed"))},
              {"ended_at_ms", or_null(time_ms("when it ended"))},
              {"torn", flag("it broke off inside a block: the control may hold a part of it")},
              {"needs_confirmation", flag("it is torn, and no person has confirmed yet that the control was reset")},
              {"confirmed_by", or_null(text("who confirmed that the control was reset"))},
              {"confirm_reason", or_null(text("what they wrote"))},
              {"read_back", or_null(text("the result of reading the program back from the control"))},
              {"read_back_state", or_null(one_of(kReadBackStates, "the same as one word"))},
              {"held_s", or_null(number("that its control held, in seconds; null: not counted, or not over"))},
              {"holds", or_null(integer("how often its control held; null: not counted, or not over"))},
              {"line_s",
               or_null(number("that its characters took on the line, in seconds; null: not counted, or not over"))},
              {"forecast_s",
               or_null(number("of a drip feed, how long its check expected it to take, when it was armed; "
                              "null: not known"))},
              {"not_before_ms", or_null(time_ms("before which it is armed only with a reason; null: at any time"))},
              {"on_hold", or_null(object("a queued job on hold is not armed; null: it is not on hold",
                                         {{"by", text("who put it on hold")}, {"reason", text("what they wrote")}}))},
              {"retry_of", or_null(integer("the job that ended, of which it is another transfer; null: none"))},
              {"choice", or_null(integer("of which one job is armed; null: it stands alone"))},
              {"end_check",
               or_null(text("what a person confirms after its end, before the next job of its machine is armed"))},
              {"needs_end_confirmation", flag("it has ended, and no person has confirmed `end_check` yet")},
              {"end_confirmed_by", or_null(text("who confirmed it"))},
              {"end_confirmed_at_ms", or_null(time_ms("when"))},
              {"end_note", or_null(text("what they wrote"))}});
}

Schema choice() {
  return object(
      "a program that is queued for several machines: one of the jobs is armed, the others leave the queue then",
      {{"choice", integer("id of the first of its jobs, by which they belong together")},
       {"jobs", list_of(reference("Job"), "one a machine")},
       {"left_out", list_of(object("a machine of the group that got none",
                                   {{"machine", text("its name")}, {"why", text("one sentence")}}),
                            "by machine")}});
}

Schema job_forecast() {
  return object("how long a job's program takes by its check; nothing here was seen at the machine",
                {{"job", integer("its id")},
                 {"verdict", or_null(integer("that has the times; null: it was not checked"))},
                 {"stale", flag("as of the verdict")},
                 {"cycle_s", or_null(number("of the whole program, in seconds; null: not known"))},
                 {"course", list_of(list_of(2, number(""), "a line and when it begins, in seconds since the start"),
                                    "some lines in their order; empty where nothing is known of them")},
                 {"buffer_bytes", or_null(integer("that the control holds; null: not known, or not limited so"))},
                 {"buffer_blocks", or_null(integer("that the control holds; null: not known, or not limited so"))}});
}

Schema ledger() {
  const std::string_view known[] = {"clocked", "confirmed"};
  return object(
      "what is known of a transfer",
      {{"items",
        list_of(object("what was known at a time; counts are bytes on the wire",
                       {{"seq", integer("of the row, from 1")},
                        {"at_ms", time_ms("when it was written")},
                        {"handed", integer("given to the system's port")},
                        {"clocked", integer("that have left, by line time")},
                        {"confirmed", integer("that the protocol acknowledged")},
                        {"reserve", integer("the feed hands nothing beyond it before the next row is written")},
                        {"note", text("what happened; empty: nothing but progress")}}),
                "in the order of writing")},
       {"next", or_null(text("for `after` of the next page; null: this is the last"))},
       {"interval", object("how much the control has, in bytes on the wire",
                           {{"low", integer("at least")},
                            {"high", integer("at most")},
                            {"known", one_of(known, "by what `low` is known")}})}});
}

}  // namespace

Schemas job_schemas() {
  return {{"Release", release()},
          {"RestartPreview", restart_preview()},
          {"Job", job()},
          {"JobForecast", job_forecast()},
          {"JobChoice", choice()},
          {"Ledger", ledger()},
          {"EventJob", reference("Job")}};
}

}  // namespace dripfeed::json
