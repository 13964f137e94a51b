// A row of the audit has the job as its subject, and "REASON: NOTE" or "REASON" as its words. No reason has a colon.
#include "server/app/jobs/stop_reasons.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "server/app/base/names.h"

namespace dripfeed::app {

namespace {

constexpr std::string_view kAction = "job.stop-reason";
constexpr std::string_view kBeforeNote = ": ";
constexpr std::size_t kMostReasons = 30;
constexpr std::size_t kLongestReason = 40;

constexpr std::string_view kSubject = "job/";

std::string subject_of(store::Id job) { return fmt::format("{}{}", kSubject, job); }

store::Id job_of(std::string_view subject) {
  subject.remove_prefix(std::min(subject.size(), kSubject.size()));
  store::Id id = 0;
  std::from_chars(subject.data(), subject.data() + subject.size(), id);
  return id;
}

StopReason read(const store::AuditRow& row) {
  const std::string& words = row.entry.detail;
  const std::size_t end = words.find(kBeforeNote);
  return {.job = job_of(row.entry.subject),
          .reason = words.substr(0, end),
          .note = end == std::string::npos ? std::string() : words.substr(end + kBeforeNote.size()),
          .by = row.by.actor,
          .at_ms = row.by.at_ms};
}

// Each row of the audit that the filter lets through.
template <class Take>
Result<void> for_each_row(store::Audit& audit, store::AuditFilter filter, const Take& take) {
  filter.action = kAction;
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    const auto rows = lift(audit.list(page, filter));
    if (!rows) return std::unexpected(rows.error());
    for (const store::AuditRow& row : rows->items)
      if (const auto done = take(row); !done) return done;
    page.after = rows->next;
  } while (!page.after.empty());
  return {};
}

bool was_sent(const store::Job& job) { return job.started_at_ms != 0; }

}  // namespace

std::vector<std::string> usual_stop_reasons() {
  return {"tool broken", "tool change", "material missing", "measuring", "setting up", "program fault", "machine fault",
          "break",       "other"};
}

std::string why_no_stop_reasons(const std::vector<std::string>& reasons) {
  if (reasons.size() > kMostReasons)
    return fmt::format("there are {} reasons, {} at most", reasons.size(), kMostReasons);
  for (auto one = reasons.begin(); one != reasons.end(); ++one) {
    if (const std::string why = why_no_name(*one); !why.empty()) return fmt::format("\"{}\": {}", *one, why);
    if (one->size() > kLongestReason) return fmt::format("\"{}\" is longer than {} bytes", *one, kLongestReason);
    if (one->find(':') != std::string::npos) return fmt::format("\"{}\" has a colon", *one);
    if (std::find(reasons.begin(), one, *one) != one) return fmt::format("\"{}\" is there twice", *one);
  }
  return {};
}

Result<StopReason> StopReasons::state(store::Id id, std::string_view reason, std::string_view note,
                                      std::string_view actor) {
  if (std::ranges::find(offered_, reason) == offered_.end())
    return fail(ErrorCode::invalid,
                fmt::format("\"{}\" is not a reason of this shop: {}", reason, fmt::join(offered_, ", ")));
  if (note.size() > kLongestNote)
    return fail(ErrorCode::invalid, fmt::format("a note has {} bytes at most", kLongestNote));
  if (const std::string why = note.empty() ? std::string() : why_no_name(note); !why.empty())
    return fail(ErrorCode::invalid, fmt::format("the note: {}", why));
  const auto job = lift(store_.jobs().get(id));
  if (!job) return std::unexpected(job.error());
  if (!was_sent(*job)) return fail(ErrorCode::refused, fmt::format("nothing of job {} was ever sent", id));
  const std::string words = note.empty() ? std::string(reason) : fmt::format("{}{}{}", reason, kBeforeNote, note);
  const store::NewEvent event{.topic = store::EventTopic::job,
                              .word = std::string(store::kJobEvents[2]),
                              .subject = id,
                              .machine = job->machine,
                              .job = id,
                              .program = job->program,
                              .revision = job->revision,
                              .cause = std::string(reason),
                              .text = std::string(note)};
  const auto row = lift(store_.audit().append({std::string(kAction), subject_of(id), words}, event,
                                              {std::string(actor), clock_.wall_ms()}));
  if (!row) return std::unexpected(row.error());
  return read(*row);
}

Result<std::vector<StopReason>> StopReasons::of_job(store::Id id) {
  if (const auto job = lift(store_.jobs().get(id)); !job) return std::unexpected(job.error());
  const auto rows = lift(store_.audit().list({.limit = store::kPageLimitMax, .after = {}},
                                             {.subject = subject_of(id), .action = std::string(kAction)}));
  if (!rows) return std::unexpected(rows.error());
  std::vector<StopReason> reasons;
  reasons.reserve(rows->items.size());
  for (const store::AuditRow& row : rows->items) reasons.push_back(read(row));
  return reasons;
}

Result<std::vector<StopReasonCount>> StopReasons::counts(std::int64_t from_ms, std::int64_t to_ms,
                                                         std::string_view machine) {
  std::map<store::Id, std::string> machines;  // of jobs
  std::map<std::pair<std::string, std::string>, std::uint64_t> counts;
  const auto take = [&](const store::AuditRow& row) -> Result<void> {
    const StopReason one = read(row);
    std::string& of = machines[one.job];
    if (of.empty()) {
      const auto job = lift(store_.jobs().get(one.job));
      if (!job) return std::unexpected(job.error());
      of = job->machine;
    }
    if (machine.empty() || machine == of) ++counts[{of, one.reason}];
    return {};
  };
  if (const auto done = for_each_row(store_.audit(), {.from_ms = from_ms, .to_ms = to_ms}, take); !done)
    return std::unexpected(done.error());
  std::vector<StopReasonCount> all;
  all.reserve(counts.size());
  for (const auto& [of, count] : counts) all.push_back({of.first, of.second, count});
  // Equal ones stay by machine and reason.
  std::stable_sort(all.begin(), all.end(),
                   [](const StopReasonCount& a, const StopReasonCount& b) { return a.count > b.count; });
  return all;
}

}  // namespace dripfeed::app
