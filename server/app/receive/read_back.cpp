// Memory loads that are punched back and compared. The transfer itself is over when its job is; the result of the
// read-back stands next to it by name: "waiting for read-back", "equal", "differs: …", "expired: …", "superseded: …".
#include "server/app/receive/read_back.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "protocol/receive/program_name.h"
#include "server/app/base/text_difference.h"
#include "server/app/receive/receiving.h"

namespace dripfeed::app {

namespace {

constexpr std::uint64_t kLongestCompared = receive::Settings::kMaxBytes;
constexpr std::uint32_t kJobsLookedAt = 20;

std::int64_t ms_of(double minutes) { return static_cast<std::int64_t>(minutes * 60e3); }

}  // namespace

std::string read_back_result(std::string_view sent, std::string_view punched) {
  const auto difference = first_difference(sent, punched);
  return difference ? "differs: " + sentence_of(*difference) : std::string(kReadBackEqual);
}

// The ledger first: whoever sees the job's word finds its row.
void Receiving::note_read_back(const std::string& machine, store::Id id, std::string_view result,
                               std::optional<AlarmKind> kind) {
  if (const auto interval = store_.ledger().interval(id)) {
    const store::NewLedgerRow row{.job = id, .counts = interval->last, .note = fmt::format("read-back {}", result)};
    const auto written = store_.ledger().append(std::span(&row, 1), clock_.wall_ms());
    if (!written) spdlog::error("ledger: job {}: {}", id, store::message_of(written.error()));
  }
  const auto job = store_.jobs().set_read_back(id, result, stamp("dripfeed"));
  if (!job) return alarm(machine, AlarmKind::request_failed, "read-back: " + store::message_of(job.error()), id);
  events_.publish({.id = 0,
                   .kind = EventKind::job,
                   .machine = machine,
                   .job = *job,
                   .verdict = 0,
                   .outcome = {},
                   .text = fmt::format("read-back {}", result)});
  std::string text = fmt::format("job {}: read-back {}", id, result);
  if (!kind) return record(machine, std::move(text));
  alarm(machine, *kind, std::move(text), id);
}

// After a start: what the jobs themselves say of loads that no one compared.
void Receiving::find_open_read_backs(const std::string& machine, Waiting& waiting) {
  waiting.looked = true;
  const auto jobs = store_.jobs().list({.limit = kJobsLookedAt, .after = {}}, {.machine = machine, .state = {}});
  if (!jobs) return alarm(machine, AlarmKind::request_failed, "read-back: " + store::message_of(jobs.error()));
  const auto profile = profile_of(machine);
  const double minutes =
      profile ? profile->line.receive.read_back_minutes : machine::ReceiveSettings{}.read_back_minutes;
  for (const store::Job& job : jobs->items) {
    if (job.read_back != kReadBackWaits) continue;
    waiting.read_backs.insert(waiting.read_backs.begin(),
                              {job.id, job.program, job.text_sha256, job.ended_at_ms + ms_of(minutes)});
  }
}

// A memory load that is over waits for the operator's punch, where the control can punch. An older load of the same
// program is not in the control any more.
void Receiving::expect_read_back(const std::string& machine, const LineReport& report) {
  Waiting& waiting = waiting_[machine];
  if (!waiting.looked) find_open_read_backs(machine, waiting);
  if (report.job == 0 || report.end != JobEnd::done || report.job == waiting.read_back) return;
  const auto job = store_.jobs().get(report.job);
  if (job && !store::ended(job->state)) return;  // its last row is not written yet
  waiting.read_back = report.job;
  const auto profile = profile_of(machine);
  if (!job || !profile || job->delivery != store::Delivery::memory || !job->read_back.empty()) return;
  if (!profile->line.receive.read_back) return;
  std::erase_if(waiting.read_backs, [&](const OpenReadBack& open) {
    if (open.program != job->program) return false;
    note_read_back(machine, open.job, fmt::format("superseded: job {} loaded the program again", job->id));
    return true;
  });
  waiting.read_backs.push_back(
      {job->id, job->program, job->text_sha256, clock_.wall_ms() + ms_of(profile->line.receive.read_back_minutes)});
  note_read_back(machine, job->id, kReadBackWaits);
}

void Receiving::expire_read_backs(const std::string& machine) {
  Waiting& waiting = waiting_[machine];
  std::erase_if(waiting.read_backs, [&](const OpenReadBack& open) {
    if (clock_.wall_ms() < open.expires_at_ms) return false;
    note_read_back(machine, open.job, kReadBackExpired, AlarmKind::read_back_expired);
    return true;
  });
}

// True where the program is what a job loaded and is the same: it is no receipt then.
bool Receiving::compare_read_back(const std::string& machine, std::string_view program) {
  std::vector<OpenReadBack>& all = waiting_[machine].read_backs;
  const auto name = receive::find_name(program);
  for (auto open = all.rbegin(); name && open != all.rend(); ++open) {
    const auto sent = store::read_whole(store_.contents(), open->sha256, kLongestCompared);
    if (!sent) continue;
    const auto sent_name = receive::find_name(*sent);
    if (!sent_name || sent_name->name != name->name) continue;
    const std::string result = read_back_result(*sent, program);
    const bool equal = result == kReadBackEqual;
    const store::Id job = open->job;
    all.erase(std::next(open).base());
    note_read_back(machine, job, result, equal ? std::nullopt : std::optional(AlarmKind::read_back_differs));
    return equal;
  }
  return false;
}

}  // namespace dripfeed::app
