// Answers to operators, booked in the journal first. What is asked of a machine has the answer that waits.
#pragma once

#include <map>

#include "store/answers.h"
#include "store/journal/ledger_journal.h"

namespace dripfeed::journal {

class JournaledAnswers final : public store::Answers {
 public:
  JournaledAnswers(store::Answers& booked, LedgerJournal& journal) : booked_(booked), journal_(journal) {}
  // The number is one of this process; in the store the answer has another one.
  store::Result<store::Answer> begin(std::string_view machine, std::uint64_t bytes_total,
                                     const store::Stamp& by) override;
  store::Result<store::Answer> end(store::Id answer, store::AnswerState to, std::string_view reason,
                                   const store::Stamp& by) override;
  store::Result<std::optional<store::Answer>> torn_on(std::string_view machine) override;
  // Waits for the rows before it. Errors besides: busy, where the database does not answer.
  store::Result<store::Answer> confirm_reset(std::string_view machine, std::string_view reason,
                                             const store::Stamp& by) override;
  store::Result<std::vector<store::Answer>> tear_unfinished(const store::Stamp& by,
                                                            const store::OfMachines& of) override {
    return booked_.tear_unfinished(by, of);
  }
  store::Result<store::Page<store::Answer>> list(const store::PageRequest& page, std::string_view machine) override {
    return booked_.list(page, machine);
  }

 private:
  store::Answers& booked_;
  LedgerJournal& journal_;
  std::mutex mutex_;
  std::map<store::Id, store::Answer> begun_;  // by this process, and not ended
};

}  // namespace dripfeed::journal
