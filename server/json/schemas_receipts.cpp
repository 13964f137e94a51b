// What controls punched, and what their operators asked for.
#include "protocol/receive/program_name.h"
#include "protocol/receive/receiver.h"
#include "protocol/receive/transfer.h"
#include "server/app/out/events.h"
#include "server/json/enumerators.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

Words name_styles() {
  Words words = names_of<receive::NameStyle>(receive::name);
  words.push_back("time");
  return words;
}

Schema likeness() {
  return object("the stored program of the same name; null: none, or the receipt is decided",
                {{"program", integer("its id")},
                 {"revision", integer("of its text, the newest")},
                 {"same", flag("the texts are equal")},
                 {"difference", or_null(text("the first one, as a sentence"))}});
}

Schema received_values() {
  return object("which values of a part make its family give a received text",
                {{"program", integer("id of the stored program of the same name")},
                 {"revision", integer("of its text, the newest")},
                 {"family", text("from which that was rendered")},
                 {"part", or_null(text("whose values it has; null: of none"))},
                 {"part_revision", or_null(integer("of the part's values"))},
                 {"explains_all", flag("rendered with these values, every number is the received one")},
                 {"why_not", or_null(text("why not; null: they explain all"))},
                 {"values", list_of(object("a parameter with another value", {{"name", text("of the parameter")},
                                                                              {"before", text("with its unit")},
                                                                              {"after", text("with its unit")}}),
                                    "in the family's order")},
                 {"rest", list_of(object("a line that they do not explain", {{"line", integer("of the received text")},
                                                                             {"stored", text("the line there")},
                                                                             {"received", text("the line")}}),
                                  "20 at most")}});
}

Schema receipt() {
  return object("a program that a control punched",
                {{"id", integer("of the receipt")},
                 {"machine", text("whose control punched it")},
                 {"at_ms", time_ms("when it ended")},
                 {"name", text("as the program names itself, or by its time")},
                 {"named_by", one_of(name_styles(), "where the name was found")},
                 {"state", one_of(store::kNames<store::ReceiptState>, "of the receipt")},
                 {"reason", or_null(text("why it is in quarantine"))},
                 {"sha256", text("of what is kept, in hexadecimal")},
                 {"bytes", integer("of what is kept")},
                 {"raw_bytes", integer("as they came on the wire")},
                 {"code", one_of(names_of<receive::TextCode>(receive::name), "in which it came")},
                 {"ended_by", one_of(names_of<receive::EndedBy>(receive::name), "the sign that ended it")},
                 {"stored", or_null(likeness())},
                 {"program", or_null(integer("that it became"))},
                 {"revision", or_null(integer("of that program"))},
                 {"decided_by", or_null(text("who accepted or discarded it"))},
                 {"decided_reason", or_null(text("what they wrote"))},
                 {"decided_at_ms", or_null(time_ms("when"))}});
}

// Outcomes of remote_requests.cpp; a PLC may ring with a number that is no verb of ours, so verbs are no list.
Schema operator_request() {
  static constexpr std::string_view kOutcomes[] = {"answered", "queued", "armed", "refused", "stored"};
  return object(
      "what an operator asked for at the control",
      {{"id", integer("of the request")},
       {"machine", text("where it was asked")},
       {"at_ms", time_ms("when")},
       {"verb", text("load, drip, dir, save, cancel, status, restart, call; of a doorbell also \"request 9\"")},
       {"argument", text("of the verb; empty: none")},
       {"text", text("as the operator wrote it")},
       {"outcome", one_of(kOutcomes, "the result")},
       {"detail", text("for people")},
       {"job", or_null(integer("that it made or armed"))}});
}

}  // namespace

Schemas receipt_schemas() {
  return {{"Receipt", receipt()}, {"ReceivedValues", received_values()}, {"OperatorRequest", operator_request()}};
}

}  // namespace dripfeed::json
