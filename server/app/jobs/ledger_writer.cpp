// A round: look at every line, commit what changed and what may follow, give the lines their windows, hand on what was
// booked. The order matters: a feed is given only what is committed.
#include "server/app/jobs/ledger_writer.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/jobs/job_words.h"

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kRound{100};
constexpr feed::Time kRestoreEvery = std::chrono::seconds(10);
constexpr std::chrono::milliseconds kSlowCommit{100};
constexpr feed::Time kSlowAgain = std::chrono::seconds(10);
constexpr std::string_view kActor = "dripfeed";

void add_note(std::string& note, std::string_view more) {
  if (more.empty()) return;
  if (!note.empty()) note += "; ";
  note += more;
}

// Bytes may be wanted: the control has started, or the line starts by itself. Before that nothing is reserved, so that
// the ledger proves of a job that was only armed that nothing of it left.
bool may_leave(const LineReport& report) { return report.end == JobEnd::none && report.state != LineState::armed; }

}  // namespace

std::uint64_t reserve_window(const LineReport& report) {
  if (report.char_s <= 0.0) return kReserveOfBlocks;
  return std::max(kReserveAtLeast, static_cast<std::uint64_t>(kReserveAhead_s / report.char_s));
}

LedgerWriter::LedgerWriter(store::Store& store, Lines& lines, const Clock& clock, DiskReserve* disk_reserve, Take take)
    : store_(store),
      lines_(lines),
      clock_(clock),
      disk_reserve_(disk_reserve),
      take_(std::move(take)),
      thread_("ledger", kRound, Urgency::before_others, [this] { round(); }) {}

void LedgerWriter::expect(store::Id job, std::uint64_t session, std::string_view machine) {
  const std::lock_guard lock(mutex_);
  std::erase_if(expected_,
                [&](const auto& one) { return one.second.machine == machine; });  // an arming replaces the last
  expected_[session] = {.job = job, .machine = std::string(machine)};
}

void LedgerWriter::note(store::Id job, std::string_view text) {
  const std::lock_guard lock(mutex_);
  add_note(notes_[job], text);
}

void LedgerWriter::reset_confirmed(const std::string& machine, std::string_view reason) {
  const std::lock_guard lock(mutex_);
  confirmations_[machine] = reason;
}

void LedgerWriter::round() {
  take_(write_books(), complaint_);
  report_late();
  if (disk_reserve_ != nullptr && clock_.now() >= restore_at_) {
    restore_at_ = clock_.now() + kRestoreEvery;
    disk_reserve_->restore();
  }
}

// Has the lines only as long as it writes: whoever wants one alone waits for that.
std::vector<Booked> LedgerWriter::write_books() {
  std::vector<Due> all;
  for (Seat& seat : lines_.all()) {
    LineReport report = seat.line->report();
    Tracked& tracked = tracked_[seat.machine];
    all.push_back({.seat = std::move(seat), .report = std::move(report), .tracked = tracked});
  }
  write_confirmations(all);
  for (const Due& due : all) {
    begin(due);
    book_answer(due);
  }
  let_idle_go(all);
  const bool written = commit_rows(all);
  std::vector<Booked> booked;
  booked.reserve(all.size());
  for (const Due& due : all) {
    if (written) after_commit(due);
    booked.push_back({.machine = due.seat.machine,
                      .report = due.report,
                      .refusal = due.tracked.refused_because,
                      .left_torn = due.seat.left_torn,
                      .is_booked = written});
  }
  return booked;
}

// A line that owes the books nothing is not held while the disk takes what others owe.
void LedgerWriter::let_idle_go(std::vector<Due>& all) {
  for (Due& due : all) {
    if (due.report.job != 0 || due.tracked.is_begun || due.tracked.answer_row != 0) continue;
    due.seat.line.reset();
    due.seat.claim.reset();
  }
}

// An arming that the line has and the books do not know yet. A disarmed job may come again, and may be disarmed again
// before anyone looked.
void LedgerWriter::begin(const Due& due) {
  Tracked& tracked = due.tracked;
  if (due.report.job == 0 || (due.report.job == tracked.job && due.report.session == tracked.session)) return;
  const std::lock_guard lock(mutex_);
  const auto known = expected_.find(due.report.session);
  if (known == expected_.end() || known->second.job != due.report.job) {
    spdlog::error("{}: job {} is on the line and no person armed it", due.seat.machine, due.report.job);
    return;
  }
  expected_.erase(known);
  tracked.job = due.report.job;
  tracked.session = due.report.session;
  tracked.committed = {};
  tracked.over = false;
}

// The line's own record, for whoever has the line next. Where it cannot be written nothing leaves.
bool LedgerWriter::begin_record(const Due& due, std::string_view what) {
  Tracked& tracked = due.tracked;
  if (tracked.is_begun || !due.seat.claim) return true;
  const auto begun = due.seat.claim->begin(what);
  if (begun) {
    tracked.is_begun = true;
    tracked.refused_because.clear();
    return true;
  }
  tracked.refused_because = begun.error();
  if (const std::string torn = due.seat.claim->torn(); !torn.empty()) {
    const std::lock_guard lock(mutex_);
    refusals_[due.seat.machine] = torn;
  }
  return false;
}

std::string LedgerWriter::why_refused(const std::string& machine) {
  const std::lock_guard lock(mutex_);
  const auto known = refusals_.find(machine);
  return known == refusals_.end() ? std::string() : known->second;
}

void LedgerWriter::end_record(const Due& due, bool torn, std::string_view reason) {
  Tracked& tracked = due.tracked;
  if (!tracked.is_begun) return;
  const auto ended = torn ? due.seat.claim->tear(reason) : due.seat.claim->end();
  // A record that goes on saying "sending" is on the safe side: whoever has the line next asks for a confirmation.
  if (!ended) spdlog::error("{}: its line's record: {}", due.seat.machine, ended.error());
  tracked.is_begun = false;
}

void LedgerWriter::book_answer(const Due& due) {
  Tracked& tracked = due.tracked;
  const AnswerReport& answer = due.report.answer;
  if (tracked.answer_row != 0 && answer.serial != tracked.answer) return;  // after_commit() ends the old one first
  if (answer.stage != AnswerStage::sending || tracked.answer_row != 0) return;
  if (!begin_record(due, "an answer to its operator")) return;
  const auto row = store_.answers().begin(due.seat.machine, answer.total, {std::string(kActor), clock_.wall_ms()});
  if (!row) {
    complaint_ = store::message_of(row.error());
    spdlog::error("{}: an answer cannot be booked, so it does not leave: {}", due.seat.machine, complaint_);
    return;
  }
  tracked.answer = answer.serial;
  tracked.answer_row = row->id;
  due.seat.line->answer_booked(answer.serial);
}

// Tried again in the next round where the store does not take it.
void LedgerWriter::end_answer(const Due& due) {
  Tracked& tracked = due.tracked;
  const AnswerReport& answer = due.report.answer;
  const bool is_on = answer.serial == tracked.answer && answer.stage == AnswerStage::sending;
  if (tracked.answer_row == 0 || is_on) return;
  const bool torn = answer.serial == tracked.answer && answer.stage == AnswerStage::torn;
  const std::string reason = torn ? fmt::format("{}: a block is torn", answer.cause) : std::string(answer.cause);
  const auto ended =
      store_.answers().end(tracked.answer_row, torn ? store::AnswerState::torn : store::AnswerState::whole, reason,
                           {std::string(kActor), clock_.wall_ms()});
  if (!ended) return spdlog::error("{}: an answer's end: {}", due.seat.machine, store::message_of(ended.error()));
  tracked.answer_row = 0;
  end_record(due, torn, reason);
}

void LedgerWriter::write_confirmations(const std::vector<Due>& all) {
  std::map<std::string, std::string> confirmed;
  {
    const std::lock_guard lock(mutex_);
    confirmed.swap(confirmations_);
  }
  for (const Due& due : all) {
    const auto one = confirmed.find(due.seat.machine);
    if (one == confirmed.end() || !due.seat.claim || due.tracked.is_begun) continue;
    const auto done = due.seat.claim->confirm_reset(one->second);
    if (!done) {
      spdlog::error("{}: its line's record: {}", due.seat.machine, done.error());
      continue;
    }
    due.tracked.refused_because.clear();
    const std::lock_guard lock(mutex_);
    refusals_.erase(due.seat.machine);
  }
}

std::optional<store::NewLedgerRow> LedgerWriter::row_of(const Due& due) {
  const Tracked& tracked = due.tracked;
  const LineReport& report = due.report;
  if (report.job == 0 || report.job != tracked.job || tracked.over) return std::nullopt;
  store::NewLedgerRow row{
      .job = report.job,
      .counts = {.handed = report.handed, .clocked = report.clocked, .confirmed = report.confirmed, .reserve = 0},
      .note = {}};
  const bool runs = report.end == JobEnd::none;
  row.counts.reserve = std::max(tracked.committed.reserve, report.handed);
  if (may_leave(report) && begin_record(due, fmt::format("job {}", report.job))) {
    // Every row opens the window again, so that a commit may take most of a window's time and no feed meets its end.
    row.counts.reserve = std::max(row.counts.reserve, std::min(report.handed + reserve_window(report), report.total));
  }
  // A job that is over hands nothing more: what it had left of its window is given back.
  if (!runs) row.counts.reserve = report.handed;
  {
    const std::lock_guard lock(mutex_);
    if (const auto note = notes_.find(report.job); note != notes_.end()) row.note = note->second;
  }
  if (report.stall != tracked.last.stall || report.state != tracked.last.state)
    add_note(row.note, runs ? std::string(report.stall) : reason_of(report));
  add_note(row.note, new_alarm(report, tracked.last));
  if (row.counts == tracked.committed && runs && row.note.empty()) return std::nullopt;
  return row;
}

std::vector<store::NewLedgerRow> LedgerWriter::rows_of(const std::vector<Due>& all) {
  std::vector<store::NewLedgerRow> rows;
  for (const Due& due : all) {
    if (auto row = row_of(due)) rows.push_back(std::move(*row));
  }
  return rows;
}

// False: nothing was reserved, so the feeds stop at what they have and report that they wait for the ledger.
bool LedgerWriter::commit_rows(const std::vector<Due>& all) {
  const std::vector<store::NewLedgerRow> rows = rows_of(all);
  if (rows.empty()) return true;
  const auto faults = append(rows);
  if (!faults) {
    std::string error = store::message_of(faults.error());
    if (error != complaint_) spdlog::error("ledger: {}", error);  // once and not ten times a second
    complaint_ = std::move(error);
    return false;
  }
  if (!complaint_.empty()) spdlog::info("ledger: it is written again");
  complaint_.clear();
  for (const store::LedgerFault& fault : *faults) spdlog::error("ledger: job {}: {}", fault.job, fault.why);
  give_windows(rows, *faults, all);
  return true;
}

// On a full disk the reserve makes room, once.
store::Result<std::vector<store::LedgerFault>> LedgerWriter::append(std::span<const store::NewLedgerRow> rows) {
  const auto begun = std::chrono::steady_clock::now();
  auto faults = store_.ledger().append(rows, clock_.wall_ms());
  report_slow_commit(std::chrono::steady_clock::now() - begun);
  const bool full = !faults && faults.error().code == store::ErrorCode::disk_full;
  if (full && disk_reserve_ != nullptr && disk_reserve_->give_up()) {
    restore_at_ = clock_.now() + kRestoreEvery;
    faults = store_.ledger().append(rows, clock_.wall_ms());
  }
  return faults;
}

// A feed runs for half a second on what is reserved for it; a start waits for its first window.
void LedgerWriter::report_slow_commit(std::chrono::nanoseconds took) {
  if (took < kSlowCommit || clock_.now() < slow_again_at_) return;
  slow_again_at_ = clock_.now() + kSlowAgain;
  spdlog::warn("ledger: a commit took {} ms; the disk of the store is slow",
               std::chrono::duration_cast<std::chrono::milliseconds>(took).count());
}

// Once when the database stops to answer, and once when all is booked.
void LedgerWriter::report_late() {
  store::LateRows late = store_.ledger().late();
  if (late.faults != late_.faults) spdlog::error("ledger: {} rows were refused: {}", late.faults, late.last_fault);
  if (!late.why.empty() && late_.why.empty())
    spdlog::error("ledger: the database does not take it ({}): feeds go on, and are booked later", late.why);
  if (late.why.empty() && !late_.why.empty()) spdlog::info("ledger: the database takes it again");
  late_ = std::move(late);
}

// The rows are durable: their windows may be used.
void LedgerWriter::give_windows(std::span<const store::NewLedgerRow> rows, std::span<const store::LedgerFault> faults,
                                const std::vector<Due>& all) {
  auto next = rows.begin();  // they stand in the order of `all`
  for (const Due& due : all) {
    Tracked& tracked = due.tracked;
    if (next == rows.end() || due.report.job != tracked.job || next->job != tracked.job) continue;
    const auto row = next++;
    const auto fault = std::ranges::find(faults, tracked.job, &store::LedgerFault::job);
    if (fault != faults.end() && !fault->written) continue;
    tracked.committed = row->counts;
    {
      const std::lock_guard lock(mutex_);
      const auto note = notes_.find(tracked.job);
      if (note != notes_.end() && row->note.starts_with(note->second)) notes_.erase(note);
    }
    if (due.report.end == JobEnd::none) due.seat.line->extend_reserve(tracked.job, row->counts.reserve);
  }
}

void LedgerWriter::after_commit(const Due& due) {
  Tracked& tracked = due.tracked;
  end_answer(due);
  tracked.last = due.report;
  if (due.report.job != tracked.job || tracked.over || due.report.end == JobEnd::none) return;
  tracked.over = true;
  if (tracked.answer_row != 0) return;  // an answer is on its heels: its end is the record's
  end_record(due, due.report.state == LineState::torn, reason_of(due.report));
}

}  // namespace dripfeed::app
