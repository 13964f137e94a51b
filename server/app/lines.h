// The lines of all machines: made from their profiles, found by name. Which kind of line a link wants is decided here,
// once.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/app/error.h"
#include "server/app/line.h"
#include "server/app/ports/ports.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

class Lines {
 public:
  // `changed` is called from the lines' threads after each change of any report.
  Lines(LinkThread& thread, BusSeatMaker take_seat, LineChanged changed);

  // Makes the machine's line, or makes it anew when its settings changed. Refused while a job is on the old one, and
  // when the settings cannot be kept.
  Result<void> set(const machine::Profile& profile);
  // Whether set() would refuse because of a job or a torn block, so that a profile is not stored for nothing.
  [[nodiscard]] Result<void> may_set(const machine::Profile& profile) const;
  // Closes all. What was on a line is over; callers see to it before.
  void close();
  // nullptr: there is no such machine. The line lives as long as the pointer.
  [[nodiscard]] std::shared_ptr<Line> find(const std::string& machine) const;
  // Why a machine that was set has none; "" where it has.
  [[nodiscard]] std::string why_none(const std::string& machine) const;
  [[nodiscard]] std::vector<std::pair<std::string, std::shared_ptr<Line>>> all() const;

 private:
  [[nodiscard]] Result<void> refuse_busy(const machine::Profile& profile, const std::string& settings) const;

  struct Entry {
    std::string settings;  // the link and line settings as one text, to see whether they changed
    std::shared_ptr<Line> line;
  };
  LinkThread& thread_;
  BusSeatMaker take_seat_;
  LineChanged changed_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> lines_;
  std::map<std::string, std::string> refusals_;  // why a machine has no line
};

// A line for these settings, without a name: for one reception. Errors: `invalid`.
Result<std::unique_ptr<Line>> make_receiving_line(const machine::LineSettings& settings, LinkThread& thread,
                                                  BusSeatMaker take_seat, LineChanged changed);

// A line for these settings, without a name: for one transfer. Errors: `invalid`.
Result<std::unique_ptr<Line>> make_line(const machine::LineSettings& settings, LinkThread& thread,
                                        BusSeatMaker take_seat, LineChanged changed);

}  // namespace dripfeed::app
