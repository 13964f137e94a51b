// The server itself: health, session, problems, and the live events that are no document of a thing.
#include "server/app/events.h"
#include "server/json/enumerators.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

Schema sentence_event(std::string about) {
  return object(std::move(about), {{"machine", text("its name")}, {"text", text("one sentence")}});
}

}  // namespace

Schemas site_schemas() {
  const std::string_view well[] = {"ok"};
  return {
      {"Problem", object("why a request was not answered (RFC 9457)",
                         {{"type", text("about:blank")},
                          {"title", text("the kind of problem, the same for each of its kind")},
                          {"status", integer(400, 599, "of HTTP")},
                          {"detail", text("one sentence for a person")},
                          {"errors",
                           list_of(object("one place that is wrong",
                                          {{"pointer", text("JSON pointer into the request's body"), kOptional},
                                           {"line", integer("of a text, from 1"), kOptional},
                                           {"column", integer("of that line, from 1, in bytes"), kOptional},
                                           {"text", text("what is wrong there")}}),
                                   "each place that is wrong"),
                           kOptional}})},
      {"Health",
       object("the server is alive", {{"status", one_of(well, "of the server")}, {"version", text("of the server")}})},
      {"OpenApi", object("the API's description (OpenAPI 3.1)", {{"openapi", text("its version")},
                                                                 {"info", any("as OpenAPI has it")},
                                                                 {"security", any("as OpenAPI has it")},
                                                                 {"paths", any("by path")},
                                                                 {"components", any("schemas by name")}})},
      {"Session",
       object("who calls", {{"name", text("of the token")},
                            {"role", one_of(store::kNames<store::Role>,
                                            "what the caller may do: each role may do what those before it may")}})},
      {"EventAlarm", sentence_event("something that a person should know of a machine")},
      {"EventReceipt", sentence_event("a control has punched, or its operator has asked for something")},
      {"EventReset",
       object("events were lost, or the server is a new one: all that is shown has to be asked for anew", {})},
  };
}

}  // namespace dripfeed::json
