// `data` is thin: what happened to what, and ids to ask for more. A table says which members each topic has.
#include "server/json/cloud_events.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "server/app/base/names.h"
#include "server/app/base/wall_time.h"
#include "server/app/out/alarms.h"
#include "server/json/orders.h"
#include "server/json/parse.h"

namespace dripfeed::json {

namespace {

using store::EventTopic;
using store::LoggedEvent;

constexpr std::size_t kLongestText_bytes = 2000;  // of a sentence; the whole stays far below 20 kB

// Cut at a character.
std::string_view shortened(std::string_view text) {
  if (text.size() <= kLongestText_bytes) return text;
  std::size_t end = kLongestText_bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end);
}

Document job_plan_data(const LoggedEvent& event) {
  return {{"job", event.of.subject},
          {"machine", event.of.machine},
          {"program", event.of.program},
          {"revision", event.of.revision},
          {"note", text_or_null(shortened(event.of.text))}};
}

Document job_stop_data(const LoggedEvent& event) {
  Document data = job_plan_data(event);
  data["reason"] = event.of.cause;
  return data;
}

Document job_data(const LoggedEvent& event) {
  if (event.of.word == store::kJobEvents[2]) return job_stop_data(event);
  if (std::ranges::find(store::kJobEvents, event.of.word) != store::kJobEvents.end()) return job_plan_data(event);
  return {{"job", event.of.subject},
          {"state", event.of.word},
          {"machine", event.of.machine},
          {"program", event.of.program},
          {"revision", event.of.revision},
          {"reason", text_or_null(shortened(event.of.text))},
          {"reason_id", text_or_null(event.of.cause)}};
}

Document line_data(const LoggedEvent& event) {
  return {{"machine", event.of.machine},
          {"state", event.of.word},
          {"job", id_or_null(event.of.job)},
          {"stall", text_or_null(event.of.cause)},
          {"link_error", text_or_null(shortened(event.of.text))}};
}

Document alarm_data(const LoggedEvent& event) {
  return {{"alarm", event.of.subject},        {"machine", event.of.machine},
          {"kind", event.of.cause},           {"severity", app::name_of(app::severity_of(event.of.cause))},
          {"text", shortened(event.of.text)}, {"job", id_or_null(event.of.job)}};
}

Document release_data(const LoggedEvent& event) {
  const bool stays = event.of.word == store::kReleaseSignedOff;  // it is still proved
  const std::string_view state = stays ? store::name_of(store::ReleaseState::proving) : std::string_view(event.of.word);
  return {{"release", event.of.subject},   {"state", state},
          {"machine", event.of.machine},   {"program", event.of.program},
          {"revision", event.of.revision}, {"note", text_or_null(shortened(event.of.text))}};
}

Document program_data(const LoggedEvent& event) {
  return {{"program", event.of.subject},
          {"name", shortened(event.of.text)},
          {"revision", event.of.revision},
          {"machine", text_or_null(event.of.machine)}};
}

Document receipt_data(const LoggedEvent& event) {
  return {{"receipt", event.of.subject},
          {"state", event.of.word},
          {"machine", event.of.machine},
          {"name", shortened(event.of.text)},
          {"program", id_or_null(event.of.program)},
          {"revision", id_or_null(event.of.revision)}};
}

Document webhook_data(const LoggedEvent& event) { return {{"webhook", event.of.subject}}; }

Document order_data(const LoggedEvent& event) {
  return {
      {"order", event.of.subject}, {"number", shortened(event.of.text)}, {"machine", text_or_null(event.of.machine)}};
}

using Write = Document (*)(const LoggedEvent&);
constexpr std::array<Write, 8> kData = {job_data,     line_data,    alarm_data, release_data, program_data,
                                        receipt_data, webhook_data, order_data};  // in the order of EventTopic
static_assert(kData.size() == store::kNames<EventTopic>.size());

std::string subject_of(const LoggedEvent& event) {
  if (event.of.topic == EventTopic::line) return fmt::format("machine/{}", event.of.machine);
  return fmt::format("{}/{}", store::name_of(event.of.topic), event.of.subject);
}

Document webhook_document(const store::Webhook& webhook) {
  return {{"id", webhook.id},
          {"url", webhook.of.url},
          {"types", webhook.of.types},
          {"description", webhook.of.description},
          {"enabled", webhook.of.enabled},
          {"local", webhook.of.local},
          {"why_disabled", text_or_null(webhook.why_disabled)},
          {"old_secret_until_ms", time_or_null(webhook.old_until_ms)},
          {"missed", webhook.missed},
          {"created_by", webhook.created_by},
          {"created_at_ms", webhook.created_at_ms},
          {"changed_at_ms", webhook.changed_at_ms}};
}

}  // namespace

std::string cloud_event(const LoggedEvent& event, std::string_view source) {
  Document data = kData[static_cast<std::size_t>(event.of.topic)](event);
  data["actor"] = event.by.actor;
  return dump({{"specversion", "1.0"},
               {"id", store::id_of(event)},
               {"source", source},
               {"type", store::type_of(event.of)},
               {"subject", subject_of(event)},
               {"time", app::rfc3339(event.by.at_ms)},
               {"sequence", fmt::format("{:020}", event.seq)},
               {"datacontenttype", "application/json"},
               {"data", std::move(data)}});
}

std::string event_type(const app::EventType& type) {
  return dump({{"name", type.name}, {"when", type.when}, {"schema", type.schema}});
}

std::string webhook(const store::Webhook& webhook) { return dump(webhook_document(webhook)); }

std::string webhook_with_secret(const store::Webhook& webhook) {
  Document document = webhook_document(webhook);
  document["secret"] = webhook.secret;
  return dump(document);
}

std::string webhook_delivery(const store::WebhookDelivery& delivery) {
  return dump({{"id", delivery.id},
               {"webhook", delivery.webhook},
               {"event", store::id_of(delivery.event)},
               {"type", store::type_of(delivery.event.of)},
               {"happened_at_ms", delivery.event.by.at_ms},
               {"state", store::name_of(delivery.state)},
               {"attempts", delivery.attempts},
               {"next_at_ms", time_or_null(delivery.next_at_ms)},
               {"last_at_ms", time_or_null(delivery.last_at_ms)},
               {"last_status", id_or_null(delivery.last_status)},
               {"last_error", text_or_null(delivery.last_error)}});
}

std::string replayed(std::uint64_t count) { return dump({{"replayed", count}}); }

namespace {

// The words of another system are shown to people: one line, not endless, printable.
constexpr std::size_t kMostWords_bytes = 200;
constexpr std::array<std::uint32_t, 3> kRefusals = {403, 409, 422};

// "" where it is not a text that can be shown. A character that the cut halves goes as a whole.
std::string words_of(const Document& answer, const char* member) {
  if (!answer.is_object()) return {};
  const auto found = answer.find(member);
  if (found == answer.end() || !found->is_string()) return {};
  const auto& given = found->get_ref<const std::string&>();
  const bool is_cut = given.size() > kMostWords_bytes;
  std::string words = given.substr(0, kMostWords_bytes);
  constexpr int kMostOfCharacter_bytes = 4;
  for (int i = 0; i < kMostOfCharacter_bytes; ++i) {
    while (words.ends_with(' ')) words.pop_back();
    if (app::why_no_name(words).empty()) return words;
    if (!is_cut || words.empty()) break;
    words.pop_back();
  }
  return {};
}

std::string reason_in(const Document& answer) {
  for (const char* const member : {"reason", "detail"})
    if (std::string words = words_of(answer, member); !words.empty()) return words;
  return "it gives no reason";
}

}  // namespace

std::string arming_question(const app::ArmingQuestion& question) {
  const store::Job& job = question.job;
  return dump({{"type", "dripfeed.job.arming"},
               {"id", question.id},
               {"at_ms", question.at_ms},
               {"job", job.id},
               {"machine", job.machine},
               {"program", {{"id", job.program}, {"name", question.program}, {"revision", job.revision}}},
               {"sha256", job.text_sha256},
               {"delivery", store::name_of(job.delivery)},
               {"release", job.release},
               {"order", question.order ? embedded(json::order(*question.order)) : Document(nullptr)},
               {"operator", question.actor}});
}

app::HookAnswer read_hook_answer(std::uint32_t status, std::string_view body) {
  using Kind = app::HookAnswer::Kind;
  const auto parsed = parse(body);
  const Document answer = parsed ? *parsed : Document(nullptr);
  const auto allow = answer.is_object() ? answer.find("allow") : answer.end();
  const bool says = allow != answer.end() && allow->is_boolean();
  if (status == 200 && says && allow->get<bool>()) return {.kind = Kind::allowed};
  if ((status == 200 && says) || std::ranges::find(kRefusals, status) != kRefusals.end())
    return {.kind = Kind::refused, .why = reason_in(answer)};
  return {.kind = Kind::none, .why = fmt::format("it answered {} without \"allow\"", status)};
}

}  // namespace dripfeed::json
