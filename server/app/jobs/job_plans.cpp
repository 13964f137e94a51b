// What people plan of jobs and confirm of them. Nothing here arms: the store refuses what is too early or waits for a
// confirmation, and of a choice it takes the others out of the queue with the one that a person arms.
#include <fmt/format.h>

#include "server/app/jobs/jobs.h"
#include "store/hash/hash.h"

namespace dripfeed::app {

Result<store::Job> Jobs::schedule(store::Id id, std::int64_t not_before_ms, std::string_view actor) {
  auto job = lift(store_.jobs().schedule(id, not_before_ms, stamp(actor)));
  if (job) publish(*job, fmt::format("scheduled by {}", actor));
  return job;
}

Result<store::Job> Jobs::hold(store::Id id, std::string_view reason, std::string_view actor) {
  auto job = lift(store_.jobs().hold(id, reason, stamp(actor)));
  if (job) publish(*job, fmt::format("put on hold by {}: {}", actor, reason));
  return job;
}

Result<store::Job> Jobs::end_hold(store::Id id, std::string_view actor) {
  auto job = lift(store_.jobs().end_hold(id, stamp(actor)));
  if (job) publish(*job, fmt::format("taken off hold by {}", actor));
  return job;
}

Result<store::Job> Jobs::confirm_end(store::Id id, std::string_view note, std::string_view actor) {
  auto job = lift(store_.jobs().confirm_end(id, note, stamp(actor)));
  if (job) publish(*job, fmt::format("end confirmed by {}", actor));
  return job;
}

// What would be refused anyway is not asked for.
Result<void> Jobs::ask_hook(const store::Job& job, std::string_view actor) {
  if (!hook_.is_set() || job.state != store::JobState::queued) return {};
  const auto program = lift(store_.programs().get(job.program));
  if (!program) return std::unexpected(program.error());
  ArmingQuestion question{.id = fmt::format("arm_{}", hash::random_token().substr(0, 22)),
                          .at_ms = clock_.wall_ms(),
                          .job = job,
                          .program = program->name,
                          .order = std::nullopt,
                          .actor = std::string(actor)};
  if (job.order != 0) {
    auto order = lift(store_.orders().get(job.order));
    if (!order) return std::unexpected(order.error());
    question.order = std::move(*order);
  }
  const auto asked = hook_.ask(question);
  if (!asked) return std::unexpected(asked.error());
  if (!*asked) return {};
  const auto noted = lift(store_.audit().append(
      {"job.arm-unanswered", fmt::format("job/{}", job.id), fmt::format("no answer came: {}", **asked)}, stamp(actor)));
  return noted ? Result<void>{} : std::unexpected(noted.error());
}

// A line that would refuse the order is asked before the others of a choice are withdrawn for it.
Result<void> Jobs::refuse_idle_no_more(const store::Job& job) {
  if (job.choice == 0) return {};
  const LineReport report = lines_.find(job.machine)->report();
  if (report.state == LineState::idle) return {};
  const std::string why =
      report.link_error.empty() ? fmt::format("the line is {}", name_of(report.state)) : report.link_error;
  return fail(ErrorCode::refused, fmt::format("{} cannot be armed: {}", job.machine, why));
}

void Jobs::publish_withdrawn(const store::Job& armed) {
  if (armed.choice == 0) return;
  const auto others = store_.jobs().list({.limit = store::kPageLimitMax, .after = {}}, {.choice = armed.choice});
  if (!others) return;
  for (const store::Job& other : others->items)
    if (other.state == store::JobState::cancelled && other.ended_at_ms == armed.armed_at_ms)
      publish(other, other.reason);
}

}  // namespace dripfeed::app
