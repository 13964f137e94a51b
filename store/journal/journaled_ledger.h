// The ledger of a store whose rows go to the journal first. What is asked of it has the rows that wait.
#pragma once

#include <map>

#include "store/journal/ledger_journal.h"
#include "store/ledger.h"

namespace dripfeed::journal {

class JournaledLedger final : public store::Ledger {
 public:
  JournaledLedger(store::Ledger& booked, LedgerJournal& journal) : booked_(booked), journal_(journal) {}
  store::Result<std::vector<store::LedgerFault>> append(std::span<const store::NewLedgerRow> rows,
                                                        std::int64_t at_ms) override;
  // Only those that are booked.
  store::Result<store::Page<store::LedgerRow>> rows(store::Id job, const store::PageRequest& page) override {
    return booked_.rows(job, page);
  }
  store::Result<store::LedgerInterval> interval(store::Id job) override;
  [[nodiscard]] store::LateRows late() const override { return journal_.late(); }
  store::Result<std::uint64_t> verify(store::Id job) override { return booked_.verify(job); }

 private:
  store::Ledger& booked_;
  LedgerJournal& journal_;
  std::mutex mutex_;
  std::map<store::Id, store::LedgerCounts> heads_;  // of the jobs that this process wrote rows for
};

}  // namespace dripfeed::journal
