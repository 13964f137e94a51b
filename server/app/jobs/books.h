// The books of all lines, kept by three threads that wait for none of those that use them: the ledger's, the one that
// follows with the jobs' states, and the one that reads texts ahead. Use cases leave what they did here and wait, where
// they want to see its effect, for a bounded time.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "server/app/base/disk_reserve.h"
#include "server/app/jobs/job_follower.h"
#include "server/app/jobs/ledger_writer.h"
#include "server/app/lines/text_reader.h"

namespace dripfeed::app {

class Books {
 public:
  Books(store::Store& store, Lines& lines, Events& events, Alarms& alarms, const Clock& clock,
        DiskReserve* disk_reserve = nullptr);
  // All that the lines did is booked and followed first.
  ~Books();
  Books(const Books&) = delete;
  Books& operator=(const Books&) = delete;

  // Some line changed. From any thread, cheap.
  void wake() { ledger_.wake(); }
  // See LedgerWriter.
  void expect(store::Id job, std::uint64_t session, std::string_view machine);
  void note(store::Id job, std::string_view text) { ledger_.note(job, text); }
  void reset_confirmed(const std::string& machine, std::string_view reason);
  [[nodiscard]] std::string why_refused(const std::string& machine) { return ledger_.why_refused(machine); }
  // The text of one arming, to be read ahead of its feed.
  void read_for(std::uint64_t session, std::shared_ptr<ContentSource> source);
  // The line did not take the arming.
  void forget(std::uint64_t session) { texts_.arming_is_over(session); }
  // Until what the lines did by now is booked and the jobs follow it. False when that takes longer than people should
  // wait for an answer; it happens all the same, as soon as the disk lets it.
  bool wait_until_booked();
  // Until the texts are read as far ahead as they may be. For a test, whose feeds take no time of their own.
  bool read_ahead(std::chrono::milliseconds patience) { return texts_.wait_for_round(patience); }
  // See JobFollower.
  [[nodiscard]] Asks asks_of(const std::string& machine) const { return follower_.asks_of(machine); }
  [[nodiscard]] const LineTotals& totals() const { return follower_.totals(); }
  [[nodiscard]] const DiskReserve* disk_reserve() const { return disk_reserve_; }

 private:
  DiskReserve* disk_reserve_;
  TextReader texts_;
  JobFollower follower_;
  LedgerWriter ledger_;
};

}  // namespace dripfeed::app
