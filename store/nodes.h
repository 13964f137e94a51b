// Nodes: servers that share one store, each near its machines. A machine's line is leased to one node, which keeps the
// lease when it is started again: its journal and its lines' records are on the same computer. Another node gets the
// line when the holder hands it over, or when a person takes it over from a holder that is not heard of any more.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "store/basics.h"
#include "store/error.h"
#include "store/event_log.h"
#include "store/jobs.h"

namespace dripfeed::store {

struct Node {
  std::string name;
  std::string url;      // where people and programs reach it; "": not said yet
  std::string version;  // of its program
  std::int64_t started_at_ms = 0;
  std::int64_t seen_at_ms = 0;  // by the database's clock
  bool is_heard = false;        // within kNodeUnheardAfter_ms
};

struct Lease {
  std::string machine;
  std::string node;
  std::uint64_t number = 0;  // one more with each new holder: who has an older number has the line no longer
  std::int64_t since_ms = 0;
  std::string given_by;
  std::string reason;
};

// What another node did.
struct NodeNews {
  std::uint64_t seq = 0;  // of its row in the log of events
  EventTopic topic = EventTopic::job;
  Id subject = 0;
  std::string machine;
};

struct Beat {
  bool leads = false;  // what one node does for all is this node's: webhooks
};

// A node says that it is there once a second.
inline constexpr std::int64_t kNodeUnheardAfter_ms = 10'000;

class Nodes : public Repository {
 public:
  // This node's name.
  [[nodiscard]] virtual const std::string& own() const = 0;
  // This node is there, at this address. Errors: in_use (another process has its name).
  virtual Result<Beat> beat(std::string_view url, std::string_view version) = 0;
  // Until another node wrote an event, or so long. From one thread.
  virtual void wait_for_news(std::chrono::milliseconds patience) = 0;
  // What other nodes did after this row of the log, at most 200, oldest first.
  virtual Result<std::vector<NodeNews>> news(std::uint64_t after) = 0;
  // Rows of the log after this one that this node wrote, or that no node did (a command), oldest first, at most so
  // many.
  virtual Result<std::vector<LoggedEvent>> own_events(std::uint64_t after, std::uint32_t most) = 0;
  // By name.
  virtual Result<std::vector<Node>> list() = 0;
  // By machine. One that no node ever had has none.
  virtual Result<std::vector<Lease>> leases() = 0;
  // A machine without a lease becomes this node's. Errors: exists (it has one), broken_reference.
  virtual Result<Lease> claim(std::string_view machine, const Stamp& by) = 0;
  // Machines without a lease become this node's.
  virtual Result<void> claim_free(const Stamp& by) = 0;
  // This node's machine becomes another's. Errors: not_found (no such node), not_leased, machine_busy (a job is on its
  // line), machine_torn, invalid_value (no reason).
  virtual Result<Lease> hand_over(std::string_view machine, std::string_view to, std::string_view reason,
                                  const Stamp& by) = 0;
  // A person takes the machine from a node that is not heard of. Its jobs on the line are interrupted and torn, and all
  // of their texts may have left: what that node did is in its journal. Errors: refused_transition (its node is heard
  // of, or is this one), not_found (no lease), invalid_value (no reason).
  virtual Result<std::vector<Job>> take_over(std::string_view machine, std::string_view reason, const Stamp& by) = 0;
};

}  // namespace dripfeed::store
