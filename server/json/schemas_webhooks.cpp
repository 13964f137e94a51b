// What goes out to other systems, and what an admin sees of webhooks.
#include <algorithm>

#include "server/app/out/alarms.h"
#include "server/app/out/event_types.h"
#include "server/app/out/webhooks.h"
#include "server/json/enumerators.h"
#include "server/json/schemas.h"
#include "server/json/schemas_shared.h"

namespace dripfeed::json {

namespace {

Member job_or_null(std::string about) { return {"job", or_null(integer(std::move(about)))}; }

Members program_and_revision() {
  return {{"program", integer("its id")}, {"revision", integer("of the program's text")}};
}

// The envelope is the same for all; `schema` names those types whose `data` this is.
Schema cloud_event(std::string_view schema, std::string about, Members data) {
  Words types;
  for (const app::EventType& type : app::event_types())
    if (type.schema == schema) types.push_back(type.name);
  const std::string_view version[] = {"1.0"};
  const std::string_view json[] = {"application/json"};
  data.push_back({"actor", text("who did it: a person or program by its name, a machine, or dripfeed itself")});
  return object(
      std::move(about),
      {{"specversion", one_of(version, "of CloudEvents")},
       {"id", text("of the event; together with the source it is the same for each repetition, and no other")},
       {"source", text("which server sends, a URI reference")},
       {"type", one_of(types, "what happened")},
       {"subject", text("what it happened to, as \"job/12\"")},
       {"time", text("when it happened, RFC 3339, UTC")},
       {"sequence", text("number of the event, with leading zeros: the smaller of two came first")},
       {"datacontenttype", one_of(json, "of data")},
       {"data", object("what to know of it, and ids to ask for more", std::move(data))}});
}

Schema job_event() {
  return cloud_event("JobEvent", "a job has another state",
                     Members{{"job", integer("its id")},
                             {"state", one_of(store::kNames<store::JobState>, "of the job now")},
                             {"machine", text("to which it is sent")}} +
                         program_and_revision() +
                         Members{{"reason", or_null(text("of the change"))},
                                 {"reason_id", or_null(text("the same as one word or the name of a stall"))}});
}

Schema job_plan_event() {
  return cloud_event("JobPlanEvent", "a person planned a job, or confirmed its end; its state stays",
                     Members{{"job", integer("its id")}, {"machine", text("to which it is sent")}} +
                         program_and_revision() +
                         Members{{"note", or_null(text("of the person, or the time that was planned; null: none"))}});
}

Schema job_stop_event() {
  return cloud_event(
      "JobStopEvent", "a person stated why a transfer stood still or broke off; the job's state stays",
      Members{{"job", integer("its id")}, {"machine", text("to which it is sent")}} + program_and_revision() +
          Members{{"reason", text("one of the shop's list")}, {"note", or_null(text("of the person; null: none"))}});
}

Schema line_event() {
  return cloud_event("LineEvent", "a machine's line has had another state for a second",
                     {{"machine", text("its name")},
                      {"state", one_of(names_of<app::LineState>(app::name_of), "of the line now")},
                      job_or_null("that has or had the line; null: none since the server's start"),
                      {"stall", or_null(text("what it waits for"))},
                      {"link_error", or_null(text("why the link is down"))}});
}

Schema alarm_event() {
  return cloud_event("AlarmEvent", "an alarm changed",
                     {{"alarm", integer("its id")},
                      {"machine", text("its name")},
                      {"kind", text("what it is about, as Alarm has it")},
                      {"severity", one_of(names_of<app::Severity>(app::name_of), "by its kind")},
                      {"text", text("one sentence")},
                      job_or_null("that it is about")});
}

Schema release_event() {
  return cloud_event("ReleaseEvent", "a release moved on",
                     Members{{"release", integer("its id")},
                             {"state", one_of(store::kNames<store::ReleaseState>, "of the release now")},
                             {"machine", text("to which its text may go")}} +
                         program_and_revision() + Members{{"note", or_null(text("what the person wrote"))}});
}

Schema program_event() {
  return cloud_event("ProgramEvent", "a program changed",
                     {{"program", integer("its id")},
                      {"name", text("under which the control calls it")},
                      {"revision", integer("the newest of its text")},
                      {"machine", or_null(text("for which it was rendered"))}});
}

Schema order_event() {
  return cloud_event("OrderEvent", "an order is new or changed",
                     {{"order", integer("its id")},
                      {"number", text("of the order, as its planner says")},
                      {"machine", or_null(text("for which it is; null: not decided"))}});
}

Schema receipt_event() {
  return cloud_event("ReceiptEvent", "something that a control punched",
                     {{"receipt", integer("its id")},
                      {"state", one_of(store::kNames<store::ReceiptState>, "of the receipt now")},
                      {"machine", text("whose control punched it")},
                      {"name", text("as the program names itself, or by its time")},
                      {"program", or_null(integer("that it became"))},
                      {"revision", or_null(integer("of that program"))}});
}

Schema webhook_event() {
  return cloud_event("WebhookEvent", "a person tries a webhook", {{"webhook", integer("its id")}});
}

Members webhook_members() {
  return Members{
             {"id", integer("of the webhook")},
             {"url", text("where events are posted")},
             {"types", list_of(text("a type of event, \"job.*\" for all of a group, \"*\" for all"), "that it gets")},
             {"description", text("for people")},
             {"enabled", flag("events are sent")},
             {"local", flag("it may lie in a private network or on the server's computer, and may be plain http")},
             {"why_disabled", or_null(text("null: it is enabled, or a person disabled it"))},
             {"old_secret_until_ms", or_null(time_ms("until then the previous secret also signs"))},
             {"missed", integer("events that were forgotten before they could be sent")}} +
         created() + Members{{"changed_at_ms", time_ms("when a person changed it last")}};
}

Schema delivery() {
  return object("the delivery of one event to one webhook",
                {{"id", integer("of the delivery")},
                 {"webhook", integer("its id")},
                 {"event", text("its id, which is also the header webhook-id")},
                 {"type", text("of the event")},
                 {"happened_at_ms", time_ms("when the event happened")},
                 {"state", one_of(store::kNames<store::DeliveryState>,
                                  "pending: to be tried; dead: all tries failed, it may be replayed")},
                 {"attempts", integer("tries since it was made or replayed")},
                 {"next_at_ms", or_null(time_ms("of the next try"))},
                 {"last_at_ms", or_null(time_ms("of the last try"))},
                 {"last_status", or_null(integer("of HTTP; null: no answer came"))},
                 {"last_error", or_null(text("why no answer came"))}});
}

}  // namespace

Schemas webhook_schemas() {
  return {
      {"OutboundType", object("a type of event that is sent", {{"name", text("of the type")},
                                                               {"when", text("it comes")},
                                                               {"schema", text("of the event, in this description")}})},
      {"JobEvent", job_event()},
      {"JobPlanEvent", job_plan_event()},
      {"JobStopEvent", job_stop_event()},
      {"LineEvent", line_event()},
      {"AlarmEvent", alarm_event()},
      {"ReleaseEvent", release_event()},
      {"ProgramEvent", program_event()},
      {"OrderEvent", order_event()},
      {"ReceiptEvent", receipt_event()},
      {"WebhookEvent", webhook_event()},
      {"Webhook", object("who receives events by HTTP", webhook_members())},
      {"WebhookSecret", object("a webhook with its new secret, which is shown once",
                               webhook_members() + Members{{"secret", text("for the signatures: whsec_ and base64")}})},
      {"WebhookDelivery", delivery()},
      {"Replayed", object("what is tried again", {{"replayed", integer("deliveries")}})},
  };
}

}  // namespace dripfeed::json
