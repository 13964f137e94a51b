// The file is emptied when nothing waits, and not before it is worth it: an entry in it that is booked does no harm.
#include "store/journal/ledger_journal.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <sys/prctl.h>

namespace dripfeed::journal {
namespace {

using store::ErrorCode;
using store::LedgerFault;
using store::Result;

constexpr std::uint64_t kWorthEmptying_bytes = 65'536;
constexpr std::chrono::seconds kAgainAfter{1};
constexpr std::chrono::seconds kLastPatience{2};

// What trying again cannot change.
bool is_final(ErrorCode code) {
  using enum ErrorCode;
  constexpr std::array kFinal{not_found, broken_reference, invalid_value, refused_transition, append_only};
  return std::ranges::find(kFinal, code) != kFinal.end();
}

std::vector<LedgerFault> as_faults(const Entry& entry, const store::Error& error) {
  return {{.job = entry.rows.empty() ? 0 : entry.rows.front().job, .why = store::message_of(error), .written = false}};
}

}  // namespace

Result<std::unique_ptr<LedgerJournal>> LedgerJournal::open(JournalFile file, std::uint64_t last_booked,
                                                           BookEntry book) {
  std::vector<Entry> left = file.take_entries();
  const std::uint64_t last = std::max(last_booked, left.empty() ? 0 : left.back().serial);
  std::unique_ptr<LedgerJournal> journal(new LedgerJournal(std::move(file), last, std::move(book)));
  for (Entry& entry : left) {
    if (entry.serial > last_booked) journal->waiting_.push_back(std::move(entry));
  }
  while (!journal->waiting_.empty()) {
    if (!journal->book_next()) return std::unexpected(store::Error{ErrorCode::io_failed, journal->why_});
  }
  journal->start();
  return journal;
}

LedgerJournal::LedgerJournal(JournalFile file, std::uint64_t last, BookEntry book)
    : book_(std::move(book)), file_(std::move(file)), last_serial_(last) {}

void LedgerJournal::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) { loop(stop); });
}

LedgerJournal::~LedgerJournal() {
  if (thread_.joinable()) static_cast<void>(wait_until_booked(kLastPatience));
}

Result<std::uint64_t> LedgerJournal::keep(Entry entry) {
  const std::lock_guard lock(mutex_);
  entry.serial = last_serial_ + 1;
  if (auto kept = file_.append(entry); !kept) return std::unexpected(kept.error());
  last_serial_ = entry.serial;
  waiting_.push_back(std::move(entry));
  changed_.notify_all();
  return last_serial_;
}

bool LedgerJournal::wait_until_booked(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, patience, [this] { return waiting_.empty(); });
}

store::LateRows LedgerJournal::late() const {
  const std::lock_guard lock(mutex_);
  return {.commits = waiting_.size(), .why = why_, .faults = faults_, .last_fault = last_fault_};
}

void LedgerJournal::each_waiting(const std::function<void(const Entry&)>& visit) const {
  const std::lock_guard lock(mutex_);
  std::ranges::for_each(waiting_, visit);
}

void LedgerJournal::loop(const std::stop_token& stop) {
  ::prctl(PR_SET_NAME, "journal");
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
    }
    if (book_next()) continue;
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, kAgainAfter, [] { return false; });
  }
}

void LedgerJournal::leave_out(const std::vector<LedgerFault>& faults) {
  for (const LedgerFault& fault : faults) {
    ++faults_;
    last_fault_ = fmt::format("job {}: {}", fault.job, fault.why);
  }
}

// The database is asked without the lock: whoever keeps an entry does not wait for it.
bool LedgerJournal::book_next() {
  std::unique_lock lock(mutex_);
  const Entry& next = waiting_.front();
  lock.unlock();
  const auto booked = book_(next);
  lock.lock();
  if (!booked && !is_final(booked.error().code)) {
    why_ = store::message_of(booked.error());
    return false;
  }
  leave_out(booked ? *booked : as_faults(next, booked.error()));
  why_.clear();
  waiting_.pop_front();
  // Where it cannot be emptied it is longer than it must be, and nothing else.
  if (waiting_.empty() && file_.bytes() > kWorthEmptying_bytes) static_cast<void>(file_.clear());
  changed_.notify_all();
  return true;
}

}  // namespace dripfeed::journal
