// What controls send by themselves: programs that are kept, requests that are answered (punched, or rung by a PLC's
// doorbell), read-backs that are compared.
// Nothing that comes in here starts or resumes motion: what goes out is a short answer or a released program for the
// control's memory, when the control asks for it.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "protocol/modbus/doorbell.h"
#include "protocol/receive/request.h"
#include "protocol/receive/transfer.h"
#include "server/app/base/round_thread.h"
#include "server/app/jobs/jobs.h"
#include "server/app/library/programs.h"
#include "server/app/out/alarms.h"

namespace dripfeed::app {

// What an accepted receipt becomes: a revision of a program, or a program of its own.
struct AcceptOrder {
  store::Id program = 0;         // 0: a new one
  store::Revision revision = 0;  // of that program, as the caller knows it; 0: the newest
  std::string name;              // of a new one; empty: the receipt's
  std::string reason;            // needed for one in quarantine
};

// The stored program of the same name, as a hint for whoever decides.
struct StoredLikeness {
  store::Id program = 0;
  store::Revision revision = 0;
  bool same = false;
  std::string difference;  // a sentence where they differ
};

// Who asks there, for the records.
inline std::string operator_at(const std::string& machine) { return "operator at " + machine; }

class Receiving {
 public:
  struct Parts {
    store::Store& store;
    Lines& lines;
    Jobs& jobs;
    Programs& programs;
    Events& events;
    Alarms& alarms;
    const Clock& clock;
    const Documents& documents;
  };
  explicit Receiving(const Parts& parts);
  ~Receiving();
  Receiving(const Receiving&) = delete;
  Receiving& operator=(const Receiving&) = delete;

  // Some line changed. From any thread, cheap.
  void wake() { thread_.wake(); }
  // One round now, on the caller's thread. For tests.
  void round();
  // One last round, then nothing is taken any more; for the end of a server.
  void stop() { thread_.stop(); }

  // Of one in quarantine the text as far as it can be read, see readable(). Errors: not_found, refused (decided before,
  // nothing to read), invalid (quarantine without a reason), stale.
  Result<store::Receipt> accept(store::Id receipt, const AcceptOrder& order, std::string_view actor);
  Result<store::Receipt> discard(store::Id receipt, std::string_view reason, std::string_view actor);
  // The text of a receipt; of one in quarantine what its bytes say in the code that it came in.
  Result<std::string> readable(const store::Receipt& receipt);
  // Nothing where no program has the receipt's name.
  Result<std::optional<StoredLikeness>> likeness(const store::Receipt& receipt);

 private:
  // A memory load that was not compared yet.
  struct OpenReadBack {
    store::Id job = 0;
    store::Id program = 0;
    std::string sha256;
    std::int64_t expires_at_ms = 0;
  };
  // What waits for the control of one machine.
  struct Waiting {
    store::Id job = 0;                     // a remote request's
    std::string answer;                    // a text that is to be armed
    store::Id arm = 0;                     // a job that is to be armed
    feed::Time due{};                      // not before
    feed::Time expires_at{};               // of `job`, where it was armed at once
    store::Id read_back = 0;               // the last job whose end was looked at
    bool looked = false;                   // for loads that a server before this one left open
    std::vector<OpenReadBack> read_backs;  // oldest first
    std::string device;                    // what the device server said last
  };
  struct Found {
    store::Release release;
    std::string program;
  };
  struct Outcome {
    std::string outcome;
    std::string detail;
    store::Id job = 0;
    std::vector<std::string> answer;                       // lines; none: no answer
    modbus::BellReason reason = modbus::BellReason::none;  // for a doorbell, where it is refused
  };

  Result<machine::Profile> profile_of(const std::string& machine);
  void take(const std::string& machine, const machine::Profile& profile, const Reception& reception);
  void quarantine(const std::string& machine, const Reception& reception, const receive::Transfer& transfer);
  void keep(const std::string& machine, const Reception& reception, const receive::Transfer& transfer,
            std::string_view text, std::string_view name);
  void handle(const std::string& machine, const machine::Profile& profile, const receive::Request& request,
              std::string_view text);
  void handle_ring(const std::string& machine, const machine::Profile& profile, const modbus::Ring& ring, Line& line);
  Outcome decide_ring(const std::string& machine, const machine::Profile& profile, const modbus::Ring& ring);
  Outcome decide(const std::string& machine, const machine::Profile& profile, const receive::Request& request);
  Outcome load(const std::string& machine, const machine::Profile& profile, const receive::Request& request);
  Outcome drip(const std::string& machine, const machine::Profile& profile, const receive::Request& request);
  Outcome queue(const std::string& machine, const machine::Profile& profile, const Found& found, bool arm);
  Outcome list(const std::string& machine, std::string_view mask);
  Outcome answer_status(const std::string& machine);
  Outcome cancel(const std::string& machine);
  Outcome count_parts(const std::string& machine, const receive::Request& request);
  bool cancel_waiting(const std::string& machine);
  std::vector<Found> released(const std::string& machine);
  std::optional<Found> find_released(const std::string& machine, std::string_view name, store::Delivery delivery);
  void expire_request(const std::string& machine);
  void send_due(const std::string& machine, Line& line);
  void expect_read_back(const std::string& machine, const LineReport& report);
  void find_open_read_backs(const std::string& machine, Waiting& waiting);
  void expire_read_backs(const std::string& machine);
  bool compare_read_back(const std::string& machine, std::string_view program);
  // Into the job, the ledger and the events.
  void note_read_back(const std::string& machine, store::Id job, std::string_view result,
                      std::optional<AlarmKind> alarm = std::nullopt);
  void alarm(const std::string& machine, AlarmKind kind, std::string text, store::Id job = 0);
  // An event that asks for no person.
  void record(const std::string& machine, std::string text);
  bool answer_hides_a_program(const std::string& machine, const machine::Profile& profile);
  [[nodiscard]] store::Stamp stamp(std::string_view actor) const;

  store::Store& store_;
  Lines& lines_;
  Jobs& jobs_;
  Programs& programs_;
  Events& events_;
  Alarms& alarms_;
  const Clock& clock_;
  const Documents& documents_;
  std::mutex round_mutex_;
  std::map<std::string, Waiting> waiting_;
  RoundThread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
