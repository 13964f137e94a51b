// Follows the lines with what people and programs see: moves the jobs' states in the store after what the ledger has
// booked, publishes events and progress, reports what its alarms are
// about. On a thread of its own, because a store that is busy or a slow
// watcher must not delay the ledger.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/round_thread.h"
#include "server/app/jobs/ledger_writer.h"
#include "server/app/lines/asks.h"
#include "server/app/lines/line_totals.h"
#include "server/app/lines/text_reader.h"
#include "server/app/out/alarms.h"
#include "server/app/out/events.h"
#include "server/app/ports/clock.h"
#include "server/app/ports/line_mutex.h"
#include "store/store.h"

namespace dripfeed::app {

class JobFollower {
 public:
  JobFollower(store::Store& store, Events& events, Alarms& alarms, TextReader& texts, const Clock& clock);

  // What the ledger has booked, newest last. From the ledger's thread: kept until the next round.
  void take(std::vector<Booked> lines, const std::string& complaint);
  bool wait_for_round(std::chrono::milliseconds patience) { return thread_.wait_for_round(patience); }
  // Who asks while nothing is armed. From any thread.
  [[nodiscard]] Asks asks_of(const std::string& machine) const { return asks_.of(machine); }
  [[nodiscard]] const LineTotals& totals() const { return totals_; }
  // One last round.
  void stop() { thread_.stop(); }

 private:
  struct Followed {
    store::Job job;
    std::uint64_t session = 0;  // of the arming that is followed
    LineReport last;
    bool over = true;
    // What the alarms got last.
    bool is_seen = false;  // the line was looked at
    std::string refusal;
    std::string link_note;
    bool is_torn = false;
    bool reset_suspected = false;
    bool is_down = false;
    bool is_lost = false;  // ... and an alarm says so
    feed::Time down_since{};
    std::uint32_t machine_alarm = 0;
  };

  void round();
  void follow(const Booked& booked);
  void begin(Followed& followed, const Booked& booked);
  void follow_job(Followed& followed, const Booked& booked);
  void move(Followed& followed, store::JobState to, const LineReport& report);
  void report_line(Followed& followed, const Booked& booked);
  void report_link(Followed& followed, const Booked& booked);
  void forget_old(const Booked& booked);
  void report_note(Followed& followed, const Booked& booked);
  void report_machine(Followed& followed, const Booked& booked);
  void report_complaint(const std::string& complaint);
  void publish_machine(const Booked& booked);

  store::Store& store_;
  Events& events_;
  Alarms& alarms_;
  TextReader& texts_;
  const Clock& clock_;
  std::map<std::string, Followed> followed_;
  AskWatch asks_;
  LineTotals totals_;
  std::string complaint_;  // as published last

  LineMutex mutex_{"what the ledger leaves for the follower"};  // of what the ledger leaves
  std::map<std::string, Booked> waiting_;
  std::string waiting_complaint_;
  RoundThread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
