// In the order of a text's stages: program, release, job, line; then what people look after.
#include "server/app/out/event_types.h"

#include <algorithm>
#include <string>
#include <vector>

#include "store/webhooks.h"

namespace dripfeed::app {

namespace {

constexpr EventType kTypes[] = {
    {"program.added", "a program is new", "ProgramEvent"},
    {"program.revised", "a program has a new revision of its text", "ProgramEvent"},
    {"program.archived", "a program is out of use", "ProgramEvent"},
    {"program.fetched_back", "an archived program is in use again", "ProgramEvent"},
    {"program.deleted", "an archived program was deleted for good", "ProgramEvent"},
    {"order.added", "an order is new", "OrderEvent"},
    {"order.changed", "the plan of an order changed", "OrderEvent"},
    {"order.parts", "parts were reported to an order", "OrderEvent"},
    {"order.open", "jobs of an order may be queued and armed again", "OrderEvent"},
    {"order.held", "no job of an order may be queued or armed", "OrderEvent"},
    {"order.done", "a person or the MES closed an order", "OrderEvent"},
    {"order.cancelled", "an order is no longer wanted", "OrderEvent"},
    {"release.draft", "a release was made", "ReleaseEvent"},
    {"release.in_review", "a release waits for its review", "ReleaseEvent"},
    {"release.proving", "a release may be transferred some times, to prove it at the machine", "ReleaseEvent"},
    {"release.signed_off", "an operator signed off what the proving has shown", "ReleaseEvent"},
    {"release.approved", "an approver approved a release for the machine", "ReleaseEvent"},
    {"release.obsolete", "a release may no longer be transferred", "ReleaseEvent"},
    {"job.queued", "a job was queued, or it is no longer armed and back in the queue", "JobEvent"},
    {"job.armed", "a person armed the job: it waits for the control's start", "JobEvent"},
    {"job.feeding", "the control asked and the transfer began", "JobEvent"},
    {"job.done", "all was sent and the end was seen; it does not say that a part was made", "JobEvent"},
    {"job.failed", "the transfer broke off", "JobEvent"},
    {"job.cancelled", "a person ended the job", "JobEvent"},
    {"job.interrupted", "the server ended while the job had its line", "JobEvent"},
    {"job.scheduled", "a person changed the time before which a queued job is not armed", "JobPlanEvent"},
    {"job.on_hold", "a person put a queued job on hold: it is not armed", "JobPlanEvent"},
    {"job.off_hold", "a queued job is no longer on hold", "JobPlanEvent"},
    {"job.end_confirmed", "a person looked at the end of a transfer: the machine's next job may be armed",
     "JobPlanEvent"},
    {"job.stop_reason", "a person stated why a transfer stood still or broke off", "JobStopEvent"},
    {"line.disconnected", "the link to the control is not up", "LineEvent"},
    {"line.idle", "the link is up and nothing is armed", "LineEvent"},
    {"line.armed", "a job waits for the control's start", "LineEvent"},
    {"line.feeding", "blocks go out", "LineEvent"},
    {"line.held", "the control, or a person, holds the feed", "LineEvent"},
    {"line.draining", "all was handed over, the end is not seen", "LineEvent"},
    {"line.torn", "a block broke off: a person must confirm that the control was reset", "LineEvent"},
    {"line.receiving", "the control punches", "LineEvent"},
    {"line.answering", "an answer to the operator waits for the control, or is sent", "LineEvent"},
    {"alarm.raised", "an alarm is new, or is on again", "AlarmEvent"},
    {"alarm.cleared", "the condition of an alarm is over", "AlarmEvent"},
    {"alarm.acknowledged", "a person knows of an alarm", "AlarmEvent"},
    {"alarm.shelved", "a person shelved an alarm", "AlarmEvent"},
    {"alarm.unshelved", "an alarm asks for a person again", "AlarmEvent"},
    {"receipt.stored", "a control punched a program", "ReceiptEvent"},
    {"receipt.quarantined", "a control punched something that is broken", "ReceiptEvent"},
    {"receipt.accepted", "a receipt became a program's revision", "ReceiptEvent"},
    {"receipt.discarded", "a receipt is not wanted", "ReceiptEvent"},
    {"webhook.ping", "a person tries a webhook; it alone gets this", "WebhookEvent"},
};

}  // namespace

std::span<const EventType> event_types() { return kTypes; }

bool covers_a_type(std::string_view pattern) {
  const std::vector<std::string> one{std::string(pattern)};
  return std::ranges::any_of(kTypes, [&](const EventType& type) { return store::wants(one, type.name); });
}

}  // namespace dripfeed::app
