// Follows the lines with what people and programs see: moves the jobs' states in the store after what the ledger has
// booked, publishes events and progress, raises alarms. On a thread of its own, because a store that is busy or a slow
// watcher must not delay the ledger.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/events.h"
#include "server/app/ledger_writer.h"
#include "server/app/ports/clock.h"
#include "server/app/ports/line_mutex.h"
#include "server/app/round_thread.h"
#include "server/app/text_reader.h"
#include "store/store.h"

namespace dripfeed::app {

class JobFollower {
 public:
  JobFollower(store::Store& store, Events& events, TextReader& texts, const Clock& clock);

  // What the ledger has booked, newest last. From the ledger's thread: kept until the next round.
  void take(std::vector<Booked> lines, const std::string& complaint);
  bool settle(std::chrono::milliseconds patience) { return thread_.settle(patience); }
  // One last round.
  void stop() { thread_.stop(); }

 private:
  struct Followed {
    store::Job job;
    std::uint64_t session = 0;  // of the arming that is followed
    LineReport last;
    std::string refusal;  // as an alarm reported it
    bool over = true;
    std::uint64_t starts_alarmed = 0;  // unarmed starts that an alarm has reported
    feed::Time quiet_until{};          // until then, further ones are only counted
  };

  void round();
  void follow(const Booked& booked);
  void begin(Followed& followed, const Booked& booked);
  void follow_job(Followed& followed, const Booked& booked);
  void move(Followed& followed, store::JobState to, const LineReport& report);
  void report_unarmed_starts(Followed& followed, const Booked& booked);
  void report_complaint(const std::string& complaint);
  void alarm(const std::string& machine, std::string text);
  void publish_machine(const Booked& booked);

  store::Store& store_;
  Events& events_;
  TextReader& texts_;
  const Clock& clock_;
  std::map<std::string, Followed> followed_;
  std::string complaint_;  // as published last

  LineMutex mutex_{"what the ledger leaves for the follower"};  // of what the ledger leaves
  std::map<std::string, Booked> waiting_;
  std::string waiting_complaint_;
  RoundThread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
