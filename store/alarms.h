// Alarms: what a person should know of a machine and say that they know. One is open until it is both acknowledged and
// over; equal ones fold into the open one and count. A shelved one asks for no one until its shelf time ends.
#pragma once

#include <optional>
#include <vector>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

struct NewAlarm {
  std::string machine{};
  std::string kind{};  // the application's word, not read here
  std::string text{};  // one sentence
  bool lasts = false;  // until clear() says that it is over; an event is over at once
  Id job = 0;          // 0: none
  std::uint64_t count = 1;
};

struct Alarm {
  Id id = 0;
  std::string machine{};
  std::string kind{};
  std::string text{};
  std::uint64_t count = 1;  // how often it was raised while it is open
  std::int64_t raised_at_ms = 0;
  std::int64_t last_at_ms = 0;
  std::int64_t cleared_at_ms = 0;  // 0: it lasts
  std::string acknowledged_by{};
  std::int64_t acknowledged_at_ms = 0;  // 0: not yet
  std::string shelved_by{};
  std::int64_t shelved_until_ms = 0;  // 0: it is on no shelf
  std::string shelf_reason{};
  Id job = 0;

  [[nodiscard]] bool is_open() const { return cleared_at_ms == 0 || acknowledged_at_ms == 0; }
};

// How many alarms of one kind are open at one machine.
struct OpenAlarms {
  std::string machine{};
  std::string kind{};
  std::uint64_t count = 0;
};

struct AlarmFilter {
  std::string machine{};  // empty: all
  bool open_only = false;
};

class Alarms : public Repository {
 public:
  // Folds into the open alarm with this machine, kind and text, or adds one. One that was over and lasts is on again.
  // Errors: broken_reference (no such machine), invalid_value (an empty kind or text).
  virtual Result<Alarm> raise(const NewAlarm& alarm, std::int64_t at_ms) = 0;
  // All of this machine and kind that last are over; those that changed.
  virtual Result<std::vector<Alarm>> clear(std::string_view machine, std::string_view kind, std::int64_t at_ms) = 0;
  // The alarms that last now, of all machines.
  virtual Result<std::vector<Alarm>> lasting() = 0;
  // By a person; one that has its name already keeps it. Errors: not_found.
  virtual Result<Alarm> acknowledge(Id alarm, const Stamp& by) = 0;
  // Errors: not_found, refused_transition (it is not open), invalid_value (no reason, or no time to come).
  virtual Result<Alarm> shelve(Id alarm, std::int64_t until_ms, std::string_view reason, const Stamp& by) = 0;
  // One that is on no shelf stays as it is. Errors: not_found.
  virtual Result<Alarm> unshelve(Id alarm, const Stamp& by) = 0;
  // Takes down what was shelved until then or earlier; those that changed.
  virtual Result<std::vector<Alarm>> end_shelves(std::int64_t now_ms) = 0;
  // Errors: not_found.
  virtual Result<Alarm> get(Id alarm) = 0;
  // Newest `last_at_ms` first.
  virtual Result<Page<Alarm>> list(const PageRequest& page, const AlarmFilter& filter = {}) = 0;
  // Each machine and kind of which at least one is open.
  virtual Result<std::vector<OpenAlarms>> count_open() = 0;
  // Drops closed ones, oldest first: all that are older, and of the others what is over `most`; at most `at_once` of
  // them in one short transaction. How many went.
  virtual Result<std::uint64_t> forget(std::int64_t before_ms, std::uint64_t most, std::uint32_t at_once) = 0;
};

}  // namespace dripfeed::store
