// One function reads each body and describes it. A planner's own data goes through as it came.
#include "server/json/orders.h"

#include <algorithm>

#include <fmt/format.h>

#include "protocol/feed/feed.h"
#include "server/app/base/names.h"
#include "server/json/bodies.h"
#include "server/json/parse.h"
#include "server/json/records.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

constexpr std::int64_t kMostParts = 1'000'000'000;

void read_metadata(ObjectReader& o, std::string& into) {
  constexpr std::size_t kLongest = 4096;
  const Document* metadata = o.member("metadata", map_of(any("of the planner"), ""));
  if (metadata == nullptr) return;
  if (!metadata->is_object()) return o.fault("metadata", "must be an object");
  // By its names: the same order sent again is the same, in whatever order its sender's library writes them.
  into = nlohmann::json::parse(dump(*metadata)).dump();
  if (into.size() > kLongest) o.fault("metadata", fmt::format("must not have more than {} bytes", kLongest));
}

void read_members(ObjectReader& o, store::OrderPlan& into) {
  constexpr std::int64_t kMostPriority = 100;
  o.proper_name("part", into.part);
  o.integer("quantity", into.quantity, 1, kMostParts, true);
  o.text("machine", into.machine);
  o.integer("due_at_ms", into.due_at_ms, 1, kMaxId);
  o.integer("priority", into.priority, 0, kMostPriority);
  read_metadata(o, into.metadata);
}

void read_members(ObjectReader& o, store::NewOrder& into) {
  o.proper_name("number", into.number);
  o.proper_name("operation", into.operation, false);
  read_members(o, into.plan);
}

void read_members(ObjectReader& o, OrderMoveBody& into) {
  if (const auto to = o.choice("to", store::kNames<store::OrderState>, true))
    into.to = static_cast<store::OrderState>(*to);
  o.words("reason", into.reason);
  const bool needs_reason = into.to == store::OrderState::held || into.to == store::OrderState::cancelled;
  if (needs_reason && !o.has("reason")) o.fault("reason", "is missing");
}

void read_members(ObjectReader& o, store::PartsReport& into) {
  o.integer("good", into.good, 0, kMostParts);
  o.integer("scrap", into.scrap, 0, kMostParts);
  o.text("note", into.note);
}

void read_plan(ObjectReader& o, app::JobPlan& into) {
  o.integer("order", into.order, 1, kMaxId);
  o.integer("not_before_ms", into.not_before_ms, 1, kMaxId);
  read_end_check(o, into.end_check);
}

void read_members(ObjectReader& o, JobBody& into) {
  o.integer("release", into.release, 1, kMaxId, true);
  read_plan(o, into.plan);
}

void read_members(ObjectReader& o, app::ChoiceOrder& into) {
  o.integer("program", into.program, 1, kMaxId, true);
  o.integer("revision", into.revision, 1, kMaxId);
  if (const auto delivery = o.choice("delivery", store::kNames<store::Delivery>))
    into.delivery = static_cast<store::Delivery>(*delivery);
  read_plan(o, into.plan);
}

void read_members(ObjectReader& o, ArmBody& into) {
  o.number("minutes", into.minutes, 0.01, 60.0);
  o.integer("rounds", into.rounds, 1, feed::kMaxRounds);
  o.text("early_reason", into.early_reason);
}

void read_members(ObjectReader& o, MoveBody& into) { o.integer("before", into.before, 1, kMaxId); }

void read_members(ObjectReader& o, ScheduleBody& into) { o.integer("not_before_ms", into.not_before_ms, 1, kMaxId); }

void read_members(ObjectReader& o, EndBody& into) { o.text("note", into.note); }

void read_members(ObjectReader& o, StopReasonBody& into) {
  o.proper_name("reason", into.reason);
  o.text("note", into.note);
}

Document document_of(const app::StopReason& one) {
  return {{"job", one.job}, {"reason", one.reason}, {"note", one.note}, {"by", one.by}, {"at_ms", one.at_ms}};
}

}  // namespace

// One line, which fits on a button's dialog.
void read_end_check(ObjectReader& o, std::string& into) {
  std::string text;
  o.text("end_check", text);
  if (text.empty()) return;
  if (const std::string why = app::why_no_name(text); !why.empty()) return o.fault("end_check", why);
  into = std::move(text);
}

app::Result<JobBody> read_job_body(std::string_view body) { return read_by<JobBody>(read_members, body); }
app::Result<app::ChoiceOrder> read_choice_body(std::string_view body) {
  return read_by<app::ChoiceOrder>(read_members, body);
}
app::Result<ArmBody> read_arm_body(std::string_view body) { return read_by<ArmBody>(read_members, or_empty(body)); }
app::Result<MoveBody> read_move_body(std::string_view body) { return read_by<MoveBody>(read_members, body); }
app::Result<ScheduleBody> read_schedule_body(std::string_view body) {
  return read_by<ScheduleBody>(read_members, body);
}
app::Result<EndBody> read_end_body(std::string_view body) { return read_by<EndBody>(read_members, or_empty(body)); }

Schemas job_request_schemas() {
  return {
      described<JobBody>("NewJob", read_members, "which release is transferred, and when it may be"),
      described<app::ChoiceOrder>("NewChoice", read_members, "which program is queued for a group of machines"),
      described<ArmBody>("ArmOrder", read_members, "how a job is armed"),
      described<MoveBody>("Move", read_members, "the new place of a queued job"),
      described<ScheduleBody>("JobSchedule", read_members, "when a queued job may be armed"),
      described<StopReasonBody>("NewStopReason", read_members, "why a transfer stood still or broke off"),
      described<EndBody>("JobEnd", read_members, "a person has done what the job's end asks for"),
  };
}

std::string choice(const app::Choice& choice) {
  Document jobs = Document::array();
  for (const store::Job& one : choice.jobs) jobs.push_back(embedded(job(one)));
  Document left_out = Document::array();
  for (const app::LeftOut& one : choice.left_out) left_out.push_back({{"machine", one.machine}, {"why", one.why}});
  return dump({{"choice", choice.id}, {"jobs", std::move(jobs)}, {"left_out", std::move(left_out)}});
}

app::Result<store::NewOrder> read_order_body(std::string_view body) {
  return read_by<store::NewOrder>(read_members, body);
}
app::Result<store::OrderPlan> read_order_plan_body(std::string_view body) {
  return read_by<store::OrderPlan>(read_members, body);
}
app::Result<OrderMoveBody> read_order_move_body(std::string_view body) {
  return read_by<OrderMoveBody>(read_members, body);
}
app::Result<store::PartsReport> read_parts_body(std::string_view body) {
  return read_by<store::PartsReport>(read_members, body);
}

Schemas order_request_schemas() {
  return {
      described<store::NewOrder>("NewOrder", read_members, "what is to be made"),
      described<store::OrderPlan>("OrderPlan", read_members, "the new plan of an order, as a whole"),
      described<OrderMoveBody>("OrderMove", read_members, "one step of an order"),
      described<store::PartsReport>("PartsReport", read_members, "parts that were made since the last report"),
  };
}

std::string order(const store::Order& order) {
  const store::OrderPlan& plan = order.of.plan;
  return dump({{"id", order.id},
               {"number", order.of.number},
               {"operation", text_or_null(order.of.operation)},
               {"part", plan.part},
               {"quantity", plan.quantity},
               {"machine", text_or_null(plan.machine)},
               {"due_at_ms", time_or_null(plan.due_at_ms)},
               {"priority", plan.priority},
               {"metadata", embedded(plan.metadata)},
               {"state", store::name_of(order.state)},
               {"reason", text_or_null(order.reason)},
               {"good", order.good},
               {"scrap", order.scrap},
               {"open", plan.quantity - std::min(plan.quantity, order.good)},
               {"transfers", order.transfers},
               {"waiting", order.waiting},
               {"revision", order.revision},
               {"created_by", order.created_by},
               {"created_at_ms", order.created_at_ms},
               {"changed_at_ms", order.changed_at_ms}});
}

app::Result<StopReasonBody> read_stop_reason_body(std::string_view body) {
  return read_by<StopReasonBody>(read_members, body);
}

std::string stop_reason(const app::StopReason& reason) { return dump(document_of(reason)); }

std::string job_stop_reasons(const std::vector<app::StopReason>& reasons) {
  Document rows = Document::array();
  for (const app::StopReason& one : reasons) rows.push_back(document_of(one));
  return dump({{"reasons", std::move(rows)}});
}

std::string stop_reason_counts(const std::vector<std::string>& offered,
                               const std::vector<app::StopReasonCount>& counts) {
  Document rows = Document::array();
  for (const app::StopReasonCount& one : counts)
    rows.push_back({{"machine", one.machine}, {"reason", one.reason}, {"count", one.count}});
  return dump({{"offered", offered}, {"counts", std::move(rows)}});
}

Schemas stop_reason_schemas() {
  return {{"StopReason", object("why a transfer stood still or broke off, as a person stated it",
                                {{"job", integer("its id")},
                                 {"reason", text("of the shop's list of that time")},
                                 {"note", text("what they wrote; empty: nothing")},
                                 {"by", text("who stated it")},
                                 {"at_ms", time_ms("when")}})},
          {"JobStopReasons", object("what people stated of a job",
                                    {{"reasons", list_of(reference("StopReason"), "newest first, 1000 at most")}})},
          {"StopReasonCounts",
           object("which reasons there are, and how often each was stated",
                  {{"offered", list_of(text("a reason"), "that people choose from; --stop-reason")},
                   {"counts", list_of(object("a reason at a machine", {{"machine", text("its name")},
                                                                       {"reason", text("of the list of that time")},
                                                                       {"count", integer("how often it was stated")}}),
                                      "in the time that is asked for, the most frequent first")}})}};
}

}  // namespace dripfeed::json
