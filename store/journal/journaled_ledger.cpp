// The rule of LedgerCounts is held here, as the store's answer comes later. A job that this process has not fed begins
// with zeros: what a process before it fed was interrupted when this one started.
#include "store/journal/journaled_ledger.h"

#include <utility>

namespace dripfeed::journal {

using store::LedgerFault;
using store::NewLedgerRow;
using store::Result;

Result<std::vector<LedgerFault>> JournaledLedger::append(std::span<const NewLedgerRow> rows, std::int64_t at_ms) {
  const std::lock_guard lock(mutex_);
  std::vector<LedgerFault> faults;
  Entry entry{.serial = 0, .at_ms = at_ms, .rows = {}, .answer = {}};
  for (const NewLedgerRow& row : rows) {
    auto fault = store::fault_of(row.job, heads_[row.job], row.counts);
    if (!fault || fault->written) entry.rows.push_back(row);
    if (fault) faults.push_back(std::move(*fault));
  }
  if (entry.rows.empty()) return faults;
  const std::vector<NewLedgerRow> kept = entry.rows;
  if (auto durable = journal_.keep(std::move(entry)); !durable) return std::unexpected(durable.error());
  for (const NewLedgerRow& row : kept) heads_[row.job] = row.counts;
  return faults;
}

// The rows that wait are looked at first: one that is booked meanwhile is counted once, as the store's is not older.
Result<store::LedgerInterval> JournaledLedger::interval(store::Id job) {
  std::vector<std::pair<std::int64_t, store::LedgerCounts>> waiting;
  journal_.each_waiting([&](const Entry& entry) {
    for (const NewLedgerRow& row : entry.rows) {
      if (row.job == job) waiting.emplace_back(entry.at_ms, row.counts);
    }
  });
  auto known = booked_.interval(job);
  if (!known) return known;
  for (const auto& [at_ms, counts] : waiting) {
    if (at_ms <= known->at_ms) continue;
    *known = {.low = counts.clocked, .high = counts.reserve, .seq = known->seq + 1, .at_ms = at_ms, .last = counts};
  }
  return known;
}

}  // namespace dripfeed::journal
