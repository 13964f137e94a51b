// The lines of all machines: made from their profiles, found by name. Which kind of line a link wants is decided here,
// once. Who looks for a line never waits for one that is being opened.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/lines/line.h"
#include "server/app/lines/line_history.h"
#include "server/app/ports/line_mutex.h"
#include "server/app/ports/ports.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// A machine's line, with its record where lines are claimed.
struct Seat {
  std::string machine;
  std::shared_ptr<Line> line;
  std::shared_ptr<LineClaim> claim;  // for the ledger's thread only
  std::string left_torn{};           // why it was made torn, "" where it was not
};

class Lines {
 public:
  // `changed` is called from the lines' threads after each change of any report.
  Lines(LinkThread& thread, BusSeatMaker take_seat, LineChanged changed, LineHistory history);

  // While it lives, no other caller changes this machine's line or arms on it.
  [[nodiscard]] std::unique_lock<std::mutex> hold(const std::string& machine);
  // Makes the machine's line, or rebuilds it when its settings changed, in the state in which it was left. The caller
  // holds the machine. Refused while a job is on the old one, while another process has the line, and when the settings
  // cannot be kept.
  Result<void> set(const machine::Profile& profile);
  // Whether set() would refuse because of a job or a torn block, so that a profile is not stored for nothing.
  [[nodiscard]] Result<void> may_set(const machine::Profile& profile) const;
  // Takes an idle line out and closes it, so that something else may use its link for a while; who asks for the line
  // meanwhile is given `why`. put_back() makes it again. The caller holds the machine for each of the two, and not in
  // between. Refused: a job, a torn block or a control that sends is on it.
  Result<void> take_out(const std::string& machine, std::string why);
  Result<void> put_back(const machine::Profile& profile);
  // A machine whose line is not this server's; who asks for it is given `why`. Closes the line if there is one,
  // whatever state it has: a job on it is over before, and what is torn stays in its record. The caller holds the
  // machine.
  Result<void> leave(const std::string& machine, std::string why);
  // Closes all. What was on a line is over; callers see to it before.
  void close();
  // nullptr: there is no such machine. The line lives as long as the pointer.
  [[nodiscard]] std::shared_ptr<Line> find(const std::string& machine) const;
  // Why a machine that was set has none; "" where it has.
  [[nodiscard]] std::string why_none(const std::string& machine) const;
  // Why the machine's line was made torn; "" where it was not.
  [[nodiscard]] std::string why_torn(const std::string& machine) const;
  [[nodiscard]] std::vector<std::string> machines() const;
  [[nodiscard]] std::vector<Seat> all() const;

 private:
  struct Entry {
    std::string settings;  // the link and line settings as one text, to see whether they changed
    Seat seat;
  };
  [[nodiscard]] std::optional<Entry> entry_of(const std::string& machine) const;
  [[nodiscard]] Result<void> refuse_busy(const machine::Profile& profile, const std::string& settings) const;
  Result<Seat> make_seat(const machine::Profile& profile);
  Result<void> let_go(const std::string& machine);
  std::map<std::string, Entry>::node_type take_alone(const std::string& machine, bool& is_alone);

  LinkThread& thread_;
  BusSeatMaker take_seat_;
  LineChanged changed_;
  LineHistory history_;
  mutable LineMutex mutex_{
      "the list of lines"};  // of the maps; held for a look or a change of a map, never while a line is made
  std::map<std::string, Entry> lines_;
  std::map<std::string, std::string> refusals_;                  // why a machine has no line
  std::map<std::string, std::shared_ptr<LineClaim>> taken_out_;  // with what keeps others off the link
  bool is_closed_ = false;
  std::map<std::string, std::unique_ptr<std::mutex>> holds_;
};

// A line for these settings, without a name: for one reception. Errors: `invalid`.
Result<std::unique_ptr<Line>> make_receiving_line(const machine::LineSettings& settings, LinkThread& thread,
                                                  BusSeatMaker take_seat, LineChanged changed);

// A line for these settings, without a name, as it was left. Errors: `invalid`, `refused`.
Result<std::unique_ptr<Line>> make_line(const machine::LineSettings& settings, LinkThread& thread,
                                        BusSeatMaker take_seat, LineChanged changed,
                                        feed::LeftAs left = feed::LeftAs::whole);

}  // namespace dripfeed::app
