// Jobs in their queues and on their lines, and what a person orders of them. Arming one is arming.cpp.
#include "server/app/jobs/jobs.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "protocol/receive/program_name.h"
#include "protocol/tape_code/wire_encoder.h"
#include "server/app/checks/workers.h"
#include "server/app/lines/content_source.h"
#include "server/app/lines/folder_line.h"
#include "server/machine/file_drop.h"
#include "server/machine/line_protocol.h"

namespace dripfeed::app {

namespace {

// A folder gives whole files: a control that runs one as it comes would not be fed by us.
Result<void> refuse_drip_into_folder(const machine::Profile& profile, store::Delivery delivery) {
  if (profile.line.link.kind != machine::LinkKind::dir || delivery == store::Delivery::memory) return {};
  return fail(
      ErrorCode::refused,
      fmt::format("machine {} fetches whole files from a folder: release the program for memory", profile.name));
}

// Wire bytes of a text on this line, without what packets add; a mailbox has its text's bytes.
Result<std::uint64_t> wire_bytes(const machine::Profile& profile, const feed::ProgramFacts& facts) {
  const machine::LinkKind kind = profile.line.link.kind;
  if (kind == machine::LinkKind::dir)
    return tape_code::wire_length(folder_format(profile.line), facts.text_bytes(), facts.eobs(), facts.odd_blocks());
  if (!machine::feeds_characters(kind)) return facts.text_bytes();
  const auto line = machine::effective_line(profile.line);
  if (!line) return fail(ErrorCode::refused, line.error());
  return tape_code::wire_length(machine::wire_format_of(*line), facts.text_bytes(), facts.eobs(), facts.odd_blocks());
}

}  // namespace

Jobs::Jobs(store::Store& store, Lines& lines, Books& books, Events& events, const Clock& clock,
           const Documents& documents, CalledPrograms called, HookSettings hook)
    : store_(store),
      lines_(lines),
      books_(books),
      events_(events),
      clock_(clock),
      documents_(documents),
      called_(called),
      hook_(std::move(hook)) {}

store::Stamp Jobs::stamp(std::string_view actor) const { return {std::string(actor), clock_.wall_ms()}; }

void Jobs::publish(const store::Job& job, std::string_view text) {
  events_.publish({.id = 0,
                   .kind = EventKind::job,
                   .machine = job.machine,
                   .job = job,
                   .verdict = 0,
                   .outcome = {},
                   .text = std::string(text)});
}

// A verdict on the machine as it was says nothing of the machine as it is, and one with a called program as it was
// nothing of the program as it is. The approval stays: a new check is enough.
Result<void> Jobs::refuse_outdated(std::string_view text_sha256, const store::Machine& machine,
                                   store::Delivery delivery) {
  const auto verdict = lift(store_.verdicts().newest(text_sha256, machine.name, delivery));
  if (!verdict) return std::unexpected(verdict.error());
  if (!*verdict) return {};  // the store says so in its own words
  if ((*verdict)->of.machine_revision == machine.revision) return called_.refuse_changed(**verdict);
  return fail(ErrorCode::refused, fmt::format("machine {} was changed after verdict {}: check the text for it again",
                                              machine.name, (*verdict)->id));
}

Result<void> Jobs::refuse_changed_calls(const store::Release& release) {
  const auto verdict = lift(store_.verdicts().newest(release.text_sha256, release.of.machine, release.of.delivery));
  if (!verdict) return std::unexpected(verdict.error());
  return *verdict ? called_.refuse_changed(**verdict) : Result<void>{};
}

// "" where the line is no folder and sends no name. What a control calls its files is a rule for folders; where a name
// is only sent, the control makes of it what it will.
Result<std::string> Jobs::file_name(const machine::Profile& profile, store::Id program) {
  const bool sends_name = machine::sends_name(profile.line);
  if (profile.line.link.kind != machine::LinkKind::dir && !sends_name) return std::string();
  const auto row = store_.programs().get(program);
  if (!row) return std::unexpected(from_store(row.error()));
  auto name = machine::file_name_for(profile, row->name);
  if (!name && sends_name) return row->name;
  if (!name) return fail(ErrorCode::refused, name.error());
  return std::move(*name);
}

Error Jobs::no_line(const std::string& machine) const {
  const std::string why = lines_.why_none(machine);
  return {
      ErrorCode::refused,
      why.empty() ? fmt::format("machine {} has no line", machine) : fmt::format("{} has no line: {}", machine, why),
      {}};
}

Result<std::shared_ptr<Line>> Jobs::line_with(const store::Job& job) {
  auto line = lines_.find(job.machine);
  if (!line) return std::unexpected(no_line(job.machine));
  if (line->report().job != job.id)
    return fail(ErrorCode::refused, fmt::format("job {} is not on the line of {}", job.id, job.machine));
  return line;
}

Result<CheckedTexts::Fit> Jobs::read_fit(const CheckedTexts::Key& text, std::string_view document) {
  const auto profile = documents_.read_profile(document);
  if (!profile) return std::unexpected(profile.error());
  const auto facts = check_program(store_.contents(), text.sha256, *profile, delivery_of(text.delivery));
  if (!facts) return std::unexpected(facts.error());
  if (auto whole = refuse_drip_into_folder(*profile, text.delivery); !whole) return std::unexpected(whole.error());
  const auto bytes = wire_bytes(*profile, *facts);
  if (!bytes) return std::unexpected(bytes.error());
  // A memory load makes no part: what is asked for after one is its job's own to say.
  std::string end_check = text.delivery == store::Delivery::drip ? profile->end_check : std::string();
  return CheckedTexts::Fit{.link = profile->line.link.text, .bytes_total = *bytes, .end_check = std::move(end_check)};
}

struct Jobs::Wanted {
  store::Release release;
  store::Machine machine;
  [[nodiscard]] CheckedTexts::Key text() const {
    return {release.text_sha256, machine.name, machine.revision, release.of.delivery};
  }
};

Result<Jobs::Wanted> Jobs::find_wanted(store::Id id) {
  if (auto room = refuse_on_full_disk(books_.disk_reserve()); !room) return std::unexpected(room.error());
  auto release = lift(store_.releases().get(id));
  if (!release) return std::unexpected(release.error());
  auto machine = lift(store_.machines().get(release->of.machine));
  if (!machine) return std::unexpected(machine.error());
  return Wanted{.release = std::move(*release), .machine = std::move(*machine)};
}

Result<void> Jobs::read_text(store::Id release) {
  const auto wanted = find_wanted(release);
  if (!wanted) return std::unexpected(wanted.error());
  const CheckedTexts::Key text = wanted->text();
  const auto fit = read_fit(text, wanted->machine.profile);
  if (!fit) return std::unexpected(fit.error());
  checked_texts_.keep(text, *fit);
  return {};
}

Result<void> Jobs::make_ready(store::Id release) {
  const auto wanted = find_wanted(release);
  if (!wanted) return std::unexpected(wanted.error());
  if (!checked_texts_.find(wanted->text()))
    if (auto read = read_text(release); !read) return read;
  return refuse_outdated(wanted->release.text_sha256, wanted->machine, wanted->release.of.delivery);
}

Result<std::optional<store::Job>> Jobs::add_known(store::Id release, std::string_view actor, const JobPlan& plan) {
  const auto wanted = find_wanted(release);
  if (!wanted) return std::unexpected(wanted.error());
  auto fit = checked_texts_.find(wanted->text());
  if (!fit) return std::nullopt;
  const store::Release& row = wanted->release;
  if (auto same = refuse_outdated(row.text_sha256, wanted->machine, row.of.delivery); !same)
    return std::unexpected(same.error());
  return lift(store_.jobs().add({.release = release,
                                 .link = std::move(fit->link),
                                 .bytes_total = fit->bytes_total,
                                 .order = plan.order,
                                 .not_before_ms = plan.not_before_ms,
                                 .end_check = plan.end_check.empty() ? fit->end_check : plan.end_check,
                                 .retry_of = plan.retry_of,
                                 .choice = plan.choice,
                                 .begins_choice = plan.begins_choice},
                                stamp(actor)));
}

Result<store::Job> Jobs::add(store::Id release, std::string_view actor) {
  auto job = add_known(release, actor);
  if (job && !*job) {
    if (const auto read = read_text(release); !read) return std::unexpected(read.error());
    job = add_known(release, actor);
  }
  if (!job) return std::unexpected(job.error());
  if (!*job) return fail(ErrorCode::unavailable, std::string(kMachineChanges));
  announce(**job);
  return std::move(**job);
}

void Jobs::announce(const store::Job& job) {
  publish(job, "queued");
  if (job.order == 0) return;
  // An urgent job was put before others, whose ranks are others now.
  const auto queue = store_.jobs().list({.limit = store::kPageLimitMax, .after = {}},
                                        {.machine = job.machine, .state = store::JobState::queued});
  if (!queue) return;  // whoever shows the queue reads it again
  for (const store::Job& other : queue->items)
    if (other.rank > job.rank) publish(other, fmt::format("job {} of an urgent order is before it", job.id));
}

Result<store::Job> Jobs::command(store::Id id, feed::Command command, std::string_view action, std::string_view reason,
                                 std::string_view actor, std::string_view note) {
  const bool restrains = command != feed::Command::resume && command != feed::Command::resume_as_if_dc1;
  const auto job = store_.jobs().get(id);
  if (!job) return restrains ? end_without_store(id, command, actor, job.error()) : lift(job);
  const auto line = line_with(*job);
  if (!line) return std::unexpected(line.error());
  const auto audit = [&] {
    return store_.audit().append({std::string(action), fmt::format("job/{}", id), std::string(reason)}, stamp(actor));
  };
  // The audit comes first: what lets bytes go out is never without its row. What ends them takes effect even when no
  // row can be written.
  if (!restrains) {
    if (const auto noted = audit(); !noted) return std::unexpected(from_store(noted.error()));
  }
  if (const auto done = (*line)->command(command); !done) return fail(ErrorCode::refused, done.error());
  if (restrains) {
    if (const auto noted = audit(); !noted) {
      spdlog::error("audit: {} of job {} by {}: {}", action, id, actor, store::message_of(noted.error()));
    }
  }
  if (!note.empty()) books_.note(id, note);
  static_cast<void>(books_.wait_until_booked());
  auto now = store_.jobs().get(id);
  if (!now) return std::unexpected(from_store(now.error()));
  return std::move(*now);
}

bool Jobs::protects_number(std::string_view text_sha256) {
  constexpr std::size_t kBeginning = 2048;
  std::string text(kBeginning, '\0');
  const auto count = store_.contents().read(text_sha256, 0, text);
  if (!count) return true;  // what cannot be read is not loaded either
  text.resize(*count);
  for (const std::string& program : receive::split_programs(text)) {
    const auto name = receive::find_name(program);
    if (!name || name->style != receive::NameStyle::number) continue;
    std::uint32_t number = 0;
    std::from_chars(name->name.data() + 1, name->name.data() + name->name.size(), number);
    if (number >= 8000 && number <= 9999) return true;
  }
  return false;
}

// A person stops a feed whether the store answers or not. What is known of the job then is what its line reports.
Result<store::Job> Jobs::end_without_store(store::Id id, feed::Command command, std::string_view actor,
                                           const store::Error& why) {
  if (why.code == store::ErrorCode::not_found) return std::unexpected(from_store(why));
  for (const Seat& seat : lines_.all()) {
    if (seat.line->report().job != id) continue;
    if (const auto done = seat.line->command(command); !done) return fail(ErrorCode::refused, done.error());
    spdlog::error("job {} on {} is stopped by {}, which no row says: {}", id, seat.machine, actor,
                  store::message_of(why));
    return fail(ErrorCode::unavailable, fmt::format("{} stops at a block end, but the store does not answer: {}",
                                                    seat.machine, store::message_of(why)));
  }
  return std::unexpected(from_store(why));
}

Result<store::Job> Jobs::stop(store::Id id, std::string_view actor) {
  return command(id, feed::Command::stop, "job.stop", "", actor);
}

Result<store::Job> Jobs::cancel(store::Id id, std::string_view actor) {
  const auto job = store_.jobs().get(id);
  if (!job) return end_without_store(id, feed::Command::cancel, actor, job.error());
  if (job->state == store::JobState::queued) return cancel_queued(*job, actor);
  if (job->state != store::JobState::armed) return command(id, feed::Command::cancel, "job.cancel", "", actor);
  auto disarmed = command(id, feed::Command::disarm, "job.cancel", "", actor);
  if (disarmed) return disarmed->state == store::JobState::queued ? cancel_queued(*disarmed, actor) : disarmed;
  // The control may have asked for it in between; after a round its row says so.
  static_cast<void>(books_.wait_until_booked());
  const auto now = store_.jobs().get(id);
  if (!now) return std::unexpected(from_store(now.error()));
  if (now->state == store::JobState::armed) return disarmed;
  return command(id, feed::Command::cancel, "job.cancel", "", actor);
}

Result<store::Job> Jobs::cancel_queued(const store::Job& job, std::string_view actor) {
  auto moved = lift(store_.jobs().move(
      job.id, {.to = store::JobState::cancelled, .reason = "cancelled", .torn = false, .reason_id = "cancelled"},
      stamp(actor)));
  if (moved) publish(*moved, fmt::format("cancelled by {}", actor));
  return moved;
}

Result<store::Job> Jobs::move_before(store::Id id, store::Id before, std::string_view actor) {
  const auto changed = lift(store_.jobs().move_before(id, before, stamp(actor)));
  if (!changed) return std::unexpected(changed.error());
  for (const store::Job& job : *changed) publish(job, fmt::format("reordered by {}", actor));
  return lift(store_.jobs().get(id));
}

Result<store::Job> Jobs::resume(store::Id id, std::string_view reason, std::string_view actor) {
  const auto job = store_.jobs().get(id);
  if (!job) return std::unexpected(from_store(job.error()));
  const auto line = line_with(*job);
  if (!line) return std::unexpected(line.error());
  if ((*line)->report().stop_wanted) {
    return command(id, feed::Command::resume, "job.resume", reason, actor);
  }
  if (reason.empty())
    return fail(ErrorCode::invalid, "a reason is needed to go on as if DC1 had come",
                {{.pointer = "/reason", .text = "a reason"}});
  return command(id, feed::Command::resume_as_if_dc1, "job.resume-as-if-dc1", reason, actor,
                 fmt::format("{} resumes as if DC1 had come: {}", actor, reason));
}

// A line that was torn inside an answer, or by another program, has no job.
Result<store::Job> Jobs::confirm_without_job(const std::string& machine, std::string_view reason,
                                             std::string_view actor) {
  const auto line = lines_.find(machine);
  const LineReport report = line ? line->report() : LineReport{};
  const bool is_refused = !books_.why_refused(machine).empty();
  if (is_refused && report.job != 0 && report.end == JobEnd::none && report.state != LineState::torn)
    return fail(ErrorCode::refused, fmt::format("job {} waits on the line: cancel it first", report.job));
  const bool torn = report.state == LineState::torn || is_refused;
  const auto answer = lift(store_.answers().torn_on(machine));
  if (!answer) return std::unexpected(answer.error());
  if ((!torn && !*answer) || reason.empty())
    return fail(ErrorCode::not_found, fmt::format("nothing of {} waits for a confirmation", machine));
  if (*answer) {
    const auto confirmed = lift(store_.answers().confirm_reset(machine, reason, stamp(actor)));
    if (!confirmed) return std::unexpected(confirmed.error());
  } else {
    const auto noted = lift(store_.audit().append(
        {"machine.confirm-reset", fmt::format("machine/{}", machine), std::string(reason)}, stamp(actor)));
    if (!noted) return std::unexpected(noted.error());
  }
  if (auto cleared = clear_line(machine, reason); !cleared) return std::unexpected(cleared.error());
  store::Job none;
  none.machine = machine;
  return none;
}

// A line that knows of nothing torn has no use for it, but for a block transfer: the receiver may still have the
// session of a server before this one.
Result<void> Jobs::clear_line(const std::string& machine, std::string_view reason) {
  if (const auto line = lines_.find(machine)) {
    const bool torn = line->report().state == LineState::torn;
    const auto cleared = line->command(feed::Command::confirm_reset);
    if (!cleared && torn) return fail(ErrorCode::refused, cleared.error());
  }
  books_.reset_confirmed(machine, reason);
  return {};
}

// The torn job and a torn answer are confirmed by one word: it was one reset.
Result<store::Job> Jobs::confirm_reset(std::string_view machine, std::string_view reason, std::string_view actor) {
  const std::string name(machine);
  const auto hold = lines_.hold(name);
  static_cast<void>(books_.wait_until_booked());  // what was torn is in the books before it is confirmed
  auto job = lift(store_.jobs().confirm_reset(name, reason, stamp(actor)));
  if (!job && job.error().code == ErrorCode::not_found) return confirm_without_job(name, reason, actor);
  if (!job) return job;
  const auto answer = lift(store_.answers().torn_on(name));
  if (!answer) return std::unexpected(answer.error());
  if (*answer) {
    if (auto both = lift(store_.answers().confirm_reset(name, reason, stamp(actor))); !both)
      return std::unexpected(both.error());
  }
  if (auto cleared = clear_line(name, reason); !cleared) return std::unexpected(cleared.error());
  publish(*job, fmt::format("reset confirmed by {}: {}", actor, reason));
  return job;
}

}  // namespace dripfeed::app
