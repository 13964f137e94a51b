// Which lines are this server's, where several servers share a store, and what the others do. A thread says every
// second that this node is there, opens lines that became its own, and leaves lines that a person took over elsewhere:
// a job on such a line ends at its block. While the store does not answer everything stays as it is, so a feed goes on.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "server/app/base/error.h"
#include "server/app/base/round_thread.h"
#include "server/app/lines/lines.h"
#include "server/app/out/events.h"
#include "server/app/ports/clock.h"
#include "server/app/shop/catalog.h"
#include "store/store.h"

namespace dripfeed::app {

class NodeLines {
 public:
  // Refers to all it is given.
  NodeLines(store::Store& store, store::Nodes& nodes, Lines& lines, Catalog& catalog, Events& events,
            const Clock& clock, std::string version);
  ~NodeLines() { stop(); }
  NodeLines(const NodeLines&) = delete;
  NodeLines& operator=(const NodeLines&) = delete;

  // Machines that no node has become this one's. Before any line opens.
  Result<void> start();
  [[nodiscard]] bool is_ours(std::string_view machine) const;
  // This node's name.
  [[nodiscard]] const std::string& own() const { return nodes_.own(); }
  // After the lines are open.
  void follow();
  // Where people and programs reach this node.
  void announce(std::string url);
  // Whether this node does what one does for all.
  [[nodiscard]] bool leads() const { return leads_.load(); }
  // Errors: not_found, invalid (no reason), refused (another node's, a job or a torn block is on the line).
  Result<void> hand_over(const std::string& machine, std::string_view node, std::string_view reason,
                         std::string_view actor);
  // The machine becomes this node's, and torn where anything of its node may have left. Errors: not_found, invalid (no
  // reason), refused (its node answers, or is this one).
  Result<void> take_over(const std::string& machine, std::string_view reason, std::string_view actor);
  void stop();

 private:
  void round();
  void beat();
  void follow_leases();
  Result<void> read_leases();
  void look_at(const store::Lease& lease);
  void leave(const store::Lease& lease);
  Result<void> leave_line(const std::string& machine, std::string_view node);
  void follow_news();
  void publish(const store::NodeNews& news);
  [[nodiscard]] store::Stamp stamp(std::string_view actor) const;

  store::Store& store_;
  store::Nodes& nodes_;
  Lines& lines_;
  Catalog& catalog_;
  Events& events_;
  const Clock& clock_;
  std::string version_;
  mutable std::mutex mutex_;
  std::string url_;
  std::map<std::string, store::Lease, std::less<>> leases_;  // as they were read last
  std::set<std::string> left_;  // machines whose lines this server left, to be opened when they become its own again
  std::atomic<bool> leads_{false};
  feed::Time beat_at_{};
  std::set<std::string> ending_;  // machines that are another's, with a job that may end at a block
  std::uint64_t seen_ = 0;        // of the log of events
  std::string complaint_;         // why the last round failed; "": it did not
  std::atomic<bool> ends_{false};
  std::optional<RoundThread> thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
