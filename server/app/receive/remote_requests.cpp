// What an operator asks for at the control. A memory load of a released program is armed at once, because the operator
// who asked stands at the control and it waits for the control's DC1; a drip-feed is queued for a person to arm, unless
// the profile says that the operator is that person.
#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/receive/answers.h"
#include "server/app/receive/receiving.h"
#include "server/machine/program_names.h"

namespace dripfeed::app {

namespace {

constexpr double kAnswerExpires_min = 10.0;
constexpr feed::Time kAnswerExpires = std::chrono::minutes(10);
constexpr std::size_t kListedAtMost = 60;

class OwnedText final : public tape_code::TextSource {
 public:
  explicit OwnedText(std::string text) : text_(std::move(text)), source_(text_) {}
  tape_code::TextPiece next() noexcept override { return source_.next(); }

 private:
  std::string text_;
  tape_code::SpanSource source_;
};

bool usable(store::ReleaseState state) {
  return state == store::ReleaseState::proving || state == store::ReleaseState::approved;
}

}  // namespace

void Receiving::handle(const std::string& machine, const machine::Profile& profile, const receive::Request& request,
                       std::string_view text) {
  Outcome outcome = request.legal ? decide(machine, profile, request)
                                  : Outcome{.outcome = "refused",
                                            .detail = "no such name",
                                            .job = 0,
                                            .answer = {"NAME NOT UNDERSTOOD", request.as_written}};
  const auto noted = store_.receipts().add_request({.machine = machine,
                                                    .verb = std::string(receive::name(request.verb)),
                                                    .argument = request.argument,
                                                    .text = std::string(text),
                                                    .outcome = outcome.outcome,
                                                    .detail = outcome.detail,
                                                    .job = outcome.job},
                                                   stamp(operator_at(machine)));
  if (!noted)
    return alarm(machine, AlarmKind::request_failed, "a request is not answered: " + store::message_of(noted.error()));
  record(machine, fmt::format("request ({}): {}, {}", request.as_written, outcome.outcome, outcome.detail));
  Waiting& waiting = waiting_[machine];
  // A control that asks gets its answer then; one that does not needs time to begin reading.
  const bool asks = profile.line.start == feed::Start::on_dc1;
  waiting.due =
      clock_.now() +
      (asks ? feed::Time{} : feed::Time(static_cast<std::int64_t>(profile.line.receive.request_delay_s * 1e9)));
  if (outcome.answer.empty() || answer_hides_a_program(machine, profile)) return;
  waiting.answer = answer_program(profile, outcome.answer);
}

// An answer takes the place of a program of its number in the control's memory. One that the shop loads there is not
// to be lost by it.
bool Receiving::answer_hides_a_program(const std::string& machine, const machine::Profile& profile) {
  if (profile.control.dialect.starts_with("sinumerik")) return false;
  const std::string number = fmt::format("O{:04}", answer_number_of(profile.line.receive));
  if (!find_released(machine, number, store::Delivery::memory)) return false;
  alarm(machine, AlarmKind::request_failed,
        fmt::format("no answer is sent: {} is a released program; set receive.answer_number to a free number", number));
  return true;
}

Receiving::Outcome Receiving::decide(const std::string& machine, const machine::Profile& profile,
                                     const receive::Request& request) {
  switch (request.verb) {
    case receive::Verb::load: return load(machine, profile, request);
    case receive::Verb::drip: return drip(machine, profile, request);
    case receive::Verb::dir: return list(machine, request.argument);
    case receive::Verb::save: return {.outcome = "stored", .detail = "as a receipt", .job = 0, .answer = {}};
    case receive::Verb::cancel: return cancel(machine);
    case receive::Verb::status: return answer_status(machine);
    case receive::Verb::parts:
    case receive::Verb::scrap: return count_parts(machine, request);
    case receive::Verb::restart:
      return {.outcome = "refused",
              .detail = "a restart inside a program is armed by a person",
              .job = 0,
              .answer = {"RESTART NOT FROM HERE"}};
  }
  return {};
}

// The answer goes to the PLC's registers; a person reads it in the request and in the event.
void Receiving::handle_ring(const std::string& machine, const machine::Profile& profile, const modbus::Ring& ring,
                            Line& line) {
  struct OutcomeRow {
    std::string_view outcome;
    modbus::BellOutcome bell;
  };
  static constexpr std::array kOutcomes = {
      OutcomeRow{"answered", modbus::BellOutcome::answered}, OutcomeRow{"armed", modbus::BellOutcome::armed},
      OutcomeRow{"queued", modbus::BellOutcome::queued}, OutcomeRow{"refused", modbus::BellOutcome::refused}};
  const Outcome outcome = decide_ring(machine, profile, ring);
  const bool known = ring.request <= static_cast<std::uint16_t>(modbus::BellRequest::scrap);
  const std::string verb = known ? std::string(modbus::name(static_cast<modbus::BellRequest>(ring.request)))
                                 : fmt::format("request {}", ring.request);
  const std::string asked = fmt::format("doorbell {}: {} {}", ring.bell, verb, ring.program);
  const auto noted = store_.receipts().add_request({.machine = machine,
                                                    .verb = verb,
                                                    .argument = std::to_string(ring.program),
                                                    .text = asked,
                                                    .outcome = outcome.outcome,
                                                    .detail = outcome.detail,
                                                    .job = outcome.job},
                                                   stamp(operator_at(machine)));
  if (!noted) alarm(machine, AlarmKind::request_failed, "a ring is not recorded: " + store::message_of(noted.error()));
  const bool calls = ring.request == static_cast<std::uint16_t>(modbus::BellRequest::call);
  if (calls) alarm(machine, AlarmKind::person_called, outcome.detail);
  record(machine, fmt::format("{}: {}, {}", asked, outcome.outcome, outcome.detail));
  const auto row = std::ranges::find(kOutcomes, outcome.outcome, &OutcomeRow::outcome);
  line.answer_ring({.bell = ring.bell,
                    .outcome = row == kOutcomes.end() ? modbus::BellOutcome::refused : row->bell,
                    .reason = outcome.reason,
                    .job = static_cast<std::uint32_t>(outcome.job)});
}

Receiving::Outcome Receiving::decide_ring(const std::string& machine, const machine::Profile& profile,
                                          const modbus::Ring& ring) {
  struct VerbRow {
    modbus::BellRequest request;
    receive::Verb verb;
  };
  static constexpr std::array kVerbs = {VerbRow{modbus::BellRequest::load, receive::Verb::load},
                                        VerbRow{modbus::BellRequest::drip, receive::Verb::drip},
                                        VerbRow{modbus::BellRequest::cancel, receive::Verb::cancel},
                                        VerbRow{modbus::BellRequest::parts, receive::Verb::parts},
                                        VerbRow{modbus::BellRequest::scrap, receive::Verb::scrap}};
  const auto refused = [](std::string detail, modbus::BellReason reason) {
    return Outcome{.outcome = "refused", .detail = std::move(detail), .job = 0, .answer = {}, .reason = reason};
  };
  if (ring.request == static_cast<std::uint16_t>(modbus::BellRequest::call))
    return {.outcome = "answered", .detail = "the machine calls for a person", .job = 0, .answer = {}};
  for (const VerbRow& row : kVerbs) {
    if (ring.request != static_cast<std::uint16_t>(row.request)) continue;
    if (!profile.line.receive.requests)
      return refused("the machine's profile allows no requests", modbus::BellReason::not_allowed);
    const std::string number = std::to_string(ring.program);
    return decide(machine, profile, {.verb = row.verb, .argument = number, .legal = true, .as_written = "doorbell"});
  }
  return refused("there is no such request", modbus::BellReason::unknown);
}

std::vector<Receiving::Found> Receiving::released(const std::string& machine) {
  std::vector<Found> all;
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    const auto rows = store_.releases().list(page, {.program = 0, .machine = machine});
    if (!rows) break;
    for (const store::Release& release : rows->items) {
      if (!usable(release.state)) continue;
      const auto program = store_.programs().get(release.of.program);
      if (program) all.push_back({release, program->name});
    }
    page.after = rows->next;
  } while (!page.after.empty());
  return all;
}

std::optional<Receiving::Found> Receiving::find_released(const std::string& machine, std::string_view name,
                                                         store::Delivery delivery) {
  std::optional<Found> meant;
  for (Found& found : released(machine)) {
    if (found.release.of.delivery != delivery || !machine::is_same_program_name(found.program, name)) continue;
    if (found.program == name) return std::move(found);
    // Two programs that the name may mean: which one is not known.
    if (meant && meant->release.of.program != found.release.of.program) return std::nullopt;
    if (!meant) meant = std::move(found);
  }
  return meant;
}

Receiving::Outcome Receiving::load(const std::string& machine, const machine::Profile& profile,
                                   const receive::Request& request) {
  const auto found = find_released(machine, request.argument, store::Delivery::memory);
  if (!found) {
    const bool drips = find_released(machine, request.argument, store::Delivery::drip).has_value();
    return {.outcome = "refused",
            .detail = drips ? "released for drip-feed only" : "no released program of this name",
            .job = 0,
            .answer = {(drips ? "FOR DNC ONLY " : "NOT FOUND ") + request.argument},
            .reason = drips ? modbus::BellReason::drip_only : modbus::BellReason::not_found};
  }
  if (jobs_.protects_number(found->release.text_sha256))
    return {.outcome = "refused",
            .detail = "O8000 to O9999 are loaded by an admin",
            .job = 0,
            .answer = {"PROTECTED " + request.argument},
            .reason = modbus::BellReason::is_protected};
  return queue(machine, profile, *found, true);
}

Receiving::Outcome Receiving::drip(const std::string& machine, const machine::Profile& profile,
                                   const receive::Request& request) {
  if (!profile.line.receive.remote_drip)
    return {.outcome = "refused",
            .detail = "the machine's profile allows no DNC from the control",
            .job = 0,
            .answer = {"DNC NOT ALLOWED FROM HERE"},
            .reason = modbus::BellReason::not_allowed};
  const auto found = find_released(machine, request.argument, store::Delivery::drip);
  if (!found)
    return {.outcome = "refused",
            .detail = "no released program of this name",
            .job = 0,
            .answer = {"NOT FOUND " + request.argument},
            .reason = modbus::BellReason::not_found};
  return queue(machine, profile, *found, profile.line.receive.remote_arm);
}

Receiving::Outcome Receiving::queue(const std::string& machine, const machine::Profile& profile, const Found& found,
                                    bool arm) {
  cancel_waiting(machine);
  const auto job = jobs_.add(found.release.id, operator_at(machine));
  if (!job)
    return {.outcome = "refused",
            .detail = job.error().text,
            .job = 0,
            .answer = {"REFUSED", job.error().text},
            .reason = modbus::BellReason::busy};
  Waiting& waiting = waiting_[machine];
  waiting.job = job->id;
  if (!arm)
    return {.outcome = "queued",
            .detail = fmt::format("{} as job {}; a person arms it", found.program, job->id),
            .job = job->id,
            .answer = {fmt::format("QUEUED {} JOB {}", found.program, job->id), "ARM IT AT DRIPFEED"}};
  // A PLC takes a transfer when it is ready for one; a control without DC1 needs time to begin reading.
  if (profile.line.start == feed::Start::at_once && !machine::is_modbus(profile.line.link.kind)) {
    waiting.arm = job->id;
    return {.outcome = "armed",
            .detail = fmt::format("{} as job {}, after the request delay", found.program, job->id),
            .job = job->id,
            .answer = {}};
  }
  const auto armed = jobs_.arm(job->id, kAnswerExpires_min, operator_at(machine));
  if (armed) waiting.expires_at = clock_.now() + kAnswerExpires;
  if (armed)
    return {.outcome = "armed",
            .detail = fmt::format("{} as job {}", found.program, job->id),
            .job = job->id,
            .answer = {}};
  cancel_waiting(machine);
  return {.outcome = "refused",
          .detail = armed.error().text,
          .job = job->id,
          .answer = {"REFUSED", armed.error().text},
          .reason = modbus::BellReason::busy};
}

Receiving::Outcome Receiving::list(const std::string& machine, std::string_view mask) {
  std::set<std::string> lines;
  for (const Found& found : released(machine)) {
    const bool fits = mask.empty() || receive::fits_mask(found.program, mask);
    const bool memory = found.release.of.delivery == store::Delivery::memory;
    if (fits) lines.insert(fmt::format("{} {}", found.program, memory ? "LOAD" : "DNC"));
  }
  std::vector<std::string> answer = {fmt::format("{} PROGRAMS", lines.size())};
  for (const std::string& line : lines) {
    if (answer.size() > kListedAtMost) {
      answer.emplace_back("...");
      break;
    }
    answer.push_back(line);
  }
  return {.outcome = "answered",
          .detail = fmt::format("{} released programs", lines.size()),
          .job = 0,
          .answer = std::move(answer)};
}

Receiving::Outcome Receiving::answer_status(const std::string& machine) {
  const auto line = lines_.find(machine);
  std::vector<std::string> answer = {fmt::format("LINE {}", line ? name_of(line->report().state) : "NONE")};
  const auto jobs = store_.jobs().list({.limit = 1, .after = {}}, {.machine = machine, .state = {}});
  if (jobs && !jobs->items.empty()) {
    const store::Job& job = jobs->items.front();
    answer.push_back(fmt::format("JOB {} {}", job.id, store::name_of(job.state)));
    if (!job.read_back.empty()) answer.push_back("READ-BACK " + job.read_back);
  }
  return {.outcome = "answered", .detail = answer.front(), .job = 0, .answer = std::move(answer)};
}

Receiving::Outcome Receiving::cancel(const std::string& machine) {
  const bool any = cancel_waiting(machine);
  return {.outcome = "answered",
          .detail = any ? "what waited is cancelled" : "nothing waited",
          .job = 0,
          .answer = {any ? "CANCELLED" : "NOTHING TO CANCEL"}};
}

// One request waits for a machine: a new one, or a cancel, takes the place of the last. Only what a request made.
bool Receiving::cancel_waiting(const std::string& machine) {
  Waiting& waiting = waiting_[machine];
  bool any = !waiting.answer.empty();
  waiting.answer.clear();
  waiting.arm = 0;
  waiting.expires_at = {};
  const store::Id id = std::exchange(waiting.job, 0);
  if (id == 0) return any;
  jobs_.wait_until_booked();  // the request itself disarmed what waited
  const auto job = store_.jobs().get(id);
  if (!job || (job->state != store::JobState::queued && job->state != store::JobState::armed)) return any;
  const auto cancelled = jobs_.cancel(id, operator_at(machine));
  if (!cancelled) spdlog::warn("{}: job {}: {}", machine, id, cancelled.error().text);
  return any || cancelled.has_value();
}

// A load that no one fetched in time is over: its line disarmed it, and no one is to find it in the queue later.
void Receiving::expire_request(const std::string& machine) {
  Waiting& waiting = waiting_[machine];
  if (waiting.expires_at == feed::Time{} || clock_.now() < waiting.expires_at) return;
  const auto job = store_.jobs().get(waiting.job);
  const bool by_a_person = job && job->armed_by != operator_at(machine);
  if (job && !by_a_person && job->state == store::JobState::armed) return;  // the line says so in a moment
  waiting.expires_at = {};
  if (!job || by_a_person || job->state != store::JobState::queued) return;
  waiting.job = 0;
  const auto cancelled = jobs_.cancel(job->id, "dripfeed");
  if (!cancelled)
    return alarm(machine, AlarmKind::request_failed, fmt::format("job {}: {}", job->id, cancelled.error().text),
                 job->id);
  alarm(machine, AlarmKind::request_expired, "a request expired: its program was not fetched at the control", job->id);
}

// What is due goes to the line.
void Receiving::send_due(const std::string& machine, Line& line) {
  expire_request(machine);
  Waiting& waiting = waiting_[machine];
  if (clock_.now() < waiting.due) return;
  if (const store::Id id = std::exchange(waiting.arm, 0); id != 0) {
    const auto armed = jobs_.arm(id, kAnswerExpires_min, operator_at(machine));
    if (armed) waiting.expires_at = clock_.now() + kAnswerExpires;
    if (!armed) alarm(machine, AlarmKind::request_failed, fmt::format("job {}: {}", id, armed.error().text), id);
  }
  if (waiting.answer.empty()) return;
  const std::string text = std::exchange(waiting.answer, {});
  const auto profile = profile_of(machine);
  if (!profile) return alarm(machine, AlarmKind::request_failed, profile.error().text);
  feed::ProgramCheck check(answer_syntax(*profile));
  check.append(text);
  const auto facts = check.finish();
  if (!facts)
    return alarm(machine, AlarmKind::request_failed,
                 fmt::format("the answer cannot be sent: {}", feed::message(facts.error().fault)));
  const auto sent = line.answer({.facts = *facts, .source = std::make_shared<OwnedText>(text)});
  if (!sent) alarm(machine, AlarmKind::request_failed, "the answer is not sent: " + sent.error());
}

}  // namespace dripfeed::app
