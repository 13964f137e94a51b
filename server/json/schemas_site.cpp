// The server itself: health, session, problems, and the live events that are no document of a thing.
#include <fmt/format.h>

#include "server/app/out/alarms.h"
#include "server/app/out/events.h"
#include "server/json/enumerators.h"
#include "server/json/problem_codes.h"
#include "server/json/schemas.h"
#include "server/json/sentences.h"

namespace dripfeed::json {

namespace {

Schema sentence_event(std::string about) {
  return object(std::move(about), {{"machine", text("its name")}, {"text", text("one sentence")}});
}

Words kind_words() {
  Words words;
  for (std::size_t i = 0; i < app::kAlarmKinds; ++i) words.push_back(app::row_of(static_cast<app::AlarmKind>(i)).name);
  return words;
}

Schema code_of_problem() {
  Words codes;
  for (const ProblemCode& row : problem_codes()) codes.push_back(row.code);
  Schema schema = one_of(codes, "what it is, for programs; a code keeps its name, status and meaning");
  for (const ProblemCode& row : problem_codes())
    schema.meanings.push_back(fmt::format("{}: {}", row.status, row.about));
  return schema;
}

Schema alarm() {
  return object("what a person should know about a machine; it is open while it is not over or not acknowledged",
                {{"id", integer("of the alarm")},
                 {"machine", text("its name")},
                 {"kind", one_of(kind_words(), "what it is about")},
                 {"severity", one_of(names_of<app::Severity>(app::name_of), "by its kind")},
                 {"text", text("one sentence")},
                 {"said", or_null(reference("Said"))},
                 {"count", integer("how often it was raised while it was open")},
                 {"raised_at_ms", time_ms("the first time")},
                 {"last_at_ms", time_ms("the last time")},
                 {"cleared_at_ms", or_null(time_ms("when its condition was over; null: it lasts"))},
                 {"acknowledged_by", or_null(text("who acknowledged it"))},
                 {"acknowledged_at_ms", or_null(time_ms("since when"))},
                 {"shelved_by", or_null(text("who shelved it"))},
                 {"shelved_until_ms", or_null(time_ms("it asks for no person until then"))},
                 {"shelf_reason", or_null(text("why it was shelved"))},
                 {"job", or_null(integer("that it is about"))}});
}

}  // namespace

Schemas site_schemas() {
  const std::string_view well[] = {"ok"};
  return {
      {"Problem", object("why a request was not answered (RFC 9457)",
                         {{"type", text("about:blank")},
                          {"title", text("the kind of problem, the same for each of its kind")},
                          {"status", integer(400, 599, "of HTTP")},
                          {"code", code_of_problem()},
                          {"detail", text("one sentence for a person")},
                          {"said", or_null(reference("Said")), kOptional},
                          {"errors",
                           list_of(object("one place that is wrong",
                                          {{"pointer", text("JSON pointer into the request's body"), kOptional},
                                           {"line", integer("of a text, from 1"), kOptional},
                                           {"column", integer("of that line, from 1, in bytes"), kOptional},
                                           {"text", text("what is wrong there")}}),
                                   "each place that is wrong"),
                           kOptional}})},
      {"Said",
       object("a sentence as an id with values, for other languages; null where it has none",
              {{"id", one_of(sentence_ids(), "of the sentence, the same in every version")},
               {"values", map_of(object("what the sentence names", {{"text", text("as it stands in the sentence")},
                                                                    {"said", or_null(reference("Said"))}}),
                                 "by name; `detail`: what is added in brackets")}})},
      {"Health",
       object("the server is alive", {{"status", one_of(well, "of the server")}, {"version", text("of the server")}})},
      {"OpenApi", object("the API's description (OpenAPI 3.1)", {{"openapi", text("its version")},
                                                                 {"info", any("as OpenAPI has it")},
                                                                 {"servers", any("as OpenAPI has it")},
                                                                 {"tags", any("groups of routes")},
                                                                 {"security", any("as OpenAPI has it")},
                                                                 {"paths", any("by path")},
                                                                 {"webhooks", any("what is posted to others, by type")},
                                                                 {"components", any("schemas by name")}})},
      {"Alarm", alarm()},
      {"EventAlarm", alarm()},
      {"EventReceipt", sentence_event("a control has punched, or its operator has asked for something")},
      {"EventReset",
       object("events were lost, or the server is a new one: all that is shown has to be requested again", {})},
  };
}

}  // namespace dripfeed::json
