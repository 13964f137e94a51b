// Arming is the only door to a line: the store says that the text is released and the machine free, the ledger has its
// first row, then the line gets the order. If the line refuses, the job waits again and no byte went out.
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/checks/workers.h"
#include "server/app/jobs/jobs.h"
#include "server/app/lines/content_source.h"
#include "store/hash/hash.h"

namespace dripfeed::app {

namespace {

constexpr double kLongestArming_min = 60.0;

// A number that no earlier job had: identifies the job at a PLC. Not 0.
std::uint64_t random_session() {
  const std::string digest = hash::sha256_hex(hash::random_token());
  std::uint32_t session = 1;
  for (std::size_t i = 0; i < 8; ++i) {
    session = session * 16 + static_cast<std::uint32_t>(digest[i] <= '9' ? digest[i] - '0' : digest[i] - 'a' + 10);
  }
  return session | 1U;
}

}  // namespace

// What an arming needs, all of it known before the job moves: after that only the line can refuse.
struct Jobs::Arming {
  store::Job job;
  machine::Profile profile;
  feed::ProgramFacts facts;
  std::string file_name;
  std::shared_ptr<ContentSource> source;
  std::optional<std::int64_t> forecast_ms{};
};

// Of a drip feed, which lasts as long as its program. Between rounds the control waits for its operator.
std::optional<std::int64_t> Jobs::forecast_ms(const store::Job& job, std::uint32_t rounds) {
  if (job.delivery != store::Delivery::drip || rounds != 1) return std::nullopt;
  const auto verdict = store_.verdicts().newest(job.text_sha256, job.machine, job.delivery);
  if (!verdict || !*verdict) return std::nullopt;
  const auto cycle_s = documents_.cycle_s((*verdict)->of.report);
  return cycle_s ? std::optional(std::llround(*cycle_s * 1e3)) : std::nullopt;
}

Result<Jobs::Arming> Jobs::prepare_arming(store::Id id, std::uint32_t rounds) {
  if (auto room = refuse_on_full_disk(books_.disk_reserve()); !room) return std::unexpected(room.error());
  const auto job = lift(store_.jobs().get(id));
  if (!job) return std::unexpected(job.error());
  const auto machine = lift(store_.machines().get(job->machine));
  if (!machine) return std::unexpected(machine.error());
  const auto profile = documents_.read_profile(machine->profile);
  if (!profile) return std::unexpected(profile.error());
  const auto text = lift(store_.contents().reader(job->text_sha256));
  if (!text) return std::unexpected(text.error());
  const auto part = part_for(store_.contents(), job->text_sha256, *profile);
  if (!part) return std::unexpected(part.error());
  const auto facts = check_program(*text, *part, *profile, delivery_of(job->delivery));
  if (!facts) return std::unexpected(facts.error());
  if (auto same = refuse_outdated(job->text_sha256, *machine, job->delivery); !same)
    return std::unexpected(same.error());
  auto name = file_name(*profile, job->program);
  if (!name) return std::unexpected(name.error());
  auto source = std::make_shared<ContentSource>(*text, rounds, *part);
  return Arming{.job = *job,
                .profile = *profile,
                .facts = *facts,
                .file_name = std::move(*name),
                .source = std::move(source),
                .forecast_ms = forecast_ms(*job, rounds)};
}

Result<store::Job> Jobs::arm(store::Id id, std::optional<double> given, std::string_view actor, std::uint32_t rounds,
                             std::string_view early_reason) {
  if (rounds == 0 || rounds > feed::kMaxRounds) {
    return fail(ErrorCode::invalid, std::string(feed::message(feed::Refusal::rounds)),
                {{.pointer = "/rounds", .text = "1 <= rounds <= 1000000"}});
  }
  if (given && (!std::isfinite(*given) || *given <= 0 || *given > kLongestArming_min)) {
    return fail(ErrorCode::invalid, "an arming lasts more than 0 and at most 60 minutes",
                {{.pointer = "/minutes", .text = "0 < minutes <= 60"}});
  }
  const auto named = lift(store_.jobs().get(id));
  if (!named) return std::unexpected(named.error());
  if (named->restart.is_one() && rounds > 1) return fail(ErrorCode::refused, "a restart is sent once");
  // First of all: no lock is held while another system is asked.
  if (const auto asked = ask_hook(*named, actor); !asked) return std::unexpected(asked.error());
  // Until the line has the order no one gives the machine another line or profile.
  const auto hold = lines_.hold(named->machine);
  const auto arming = prepare_arming(id, rounds);
  if (!arming) return std::unexpected(arming.error());
  if (!lines_.find(named->machine)) return std::unexpected(no_line(named->machine));
  if (const auto idle = refuse_idle_no_more(*named); !idle) return std::unexpected(idle.error());
  const double minutes = given.value_or(arming->profile.line.arming_minutes);
  const std::int64_t expires_at_ms = clock_.wall_ms() + static_cast<std::int64_t>(minutes * 60e3);
  auto armed = lift(store_.jobs().move(id,
                                       {.to = store::JobState::armed,
                                        .reason = "armed",
                                        .torn = false,
                                        .expires_at_ms = expires_at_ms,
                                        .reason_id = "armed",
                                        .forecast_ms = arming->forecast_ms,
                                        .early_reason = std::string(early_reason)},
                                       stamp(actor)));
  if (!armed) return armed;
  publish_withdrawn(*armed);
  // Nothing is reserved before the control's start: of a job that was only armed the ledger proves that nothing left.
  const std::string armed_text =
      (rounds == 1 ? "armed" : fmt::format("armed for {} rounds", rounds)) + store::words_of(named->restart);
  const store::NewLedgerRow first{.job = id, .counts = {}, .note = armed_text};
  const auto written = store_.ledger().append(std::span(&first, 1), clock_.wall_ms());
  if (!written) return disarm_after(*armed, store::message_of(written.error()), actor);
  if (!written->empty()) return disarm_after(*armed, written->front().why, actor);
  if (const auto on_line = put_on_line(*arming, minutes, rounds); !on_line)
    return disarm_after(*armed, on_line.error().text, actor);
  spdlog::info("job {} armed on {} by {}", id, armed->machine, actor);
  publish(*armed, fmt::format("{} by {}", armed_text, actor));
  return armed;
}

// The books know the arming before the line does: the control's start may come at once.
Result<void> Jobs::put_on_line(const Arming& arming, double minutes, std::uint32_t rounds) {
  const std::uint64_t session = random_session();
  books_.expect(arming.job.id, session, arming.job.machine);
  books_.read_for(session, arming.source);
  const auto line = lines_.find(arming.job.machine);
  const auto on_line = line->arm({.job = arming.job.id,
                                  .facts = arming.facts,
                                  .source = arming.source,
                                  .expires_after = feed::Time(static_cast<std::int64_t>(minutes * 60e9)),
                                  .reserve = 0,
                                  .rounds = rounds,
                                  .session = session,
                                  .file_name = arming.file_name});
  if (!on_line) {
    books_.forget(session);
    return fail(ErrorCode::refused, on_line.error());
  }
  books_.wake();
  return {};
}

// Nothing went out: the job waits again, and the caller hears why.
Result<store::Job> Jobs::disarm_after(const store::Job& job, const std::string& why, std::string_view actor) {
  const auto moved = store_.jobs().move(
      job.id, {.to = store::JobState::queued, .reason = why, .torn = false, .reason_id = "not_armed"}, stamp(actor));
  if (moved) publish(*moved, why);
  return fail(ErrorCode::refused, fmt::format("{} cannot be armed: {}", job.machine, why));
}

}  // namespace dripfeed::app
