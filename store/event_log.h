// What happened, for other systems: a log of changes that webhooks and MQTT bring outside. A row is written in the
// transaction of the change itself, so that neither is there without the other. Rows never change; old ones are
// forgotten.
#pragma once

#include <optional>
#include <vector>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

enum class EventTopic : std::uint8_t { job, line, alarm, release, program, receipt, webhook, order };
template <>
inline constexpr std::array<std::string_view, 8> kNames<EventTopic>{"job",     "line",    "alarm",   "release",
                                                                    "program", "receipt", "webhook", "order"};

// What happens to alarms and programs, as words; jobs, releases, receipts and lines have their states.
inline constexpr std::array<std::string_view, 5> kAlarmEvents{"raised", "cleared", "acknowledged", "shelved",
                                                              "unshelved"};
inline constexpr std::array<std::string_view, 5> kProgramEvents{"added", "revised", "archived", "fetched_back",
                                                                "deleted"};
// Of a job and of an order, besides their states.
inline constexpr std::array<std::string_view, 5> kJobEvents{"scheduled", "end_confirmed", "stop_reason", "on_hold",
                                                            "off_hold"};
inline constexpr std::array<std::string_view, 3> kOrderEvents{"added", "changed", "parts"};
inline constexpr std::string_view kReleaseSignedOff = "signed_off";  // besides its states
inline constexpr std::string_view kPing = "ping";                    // of a webhook, to be tried

struct NewEvent {
  EventTopic topic = EventTopic::job;
  std::string word{};  // what happened: a state, or one of the words above
  Id subject = 0;      // of the job, alarm, release, program, receipt or webhook; 0 of a line
  std::string machine{};
  Id job = 0;  // that an alarm is about or that has the line; 0: none
  Id program = 0;
  Revision revision = 0;
  std::string cause{};  // a word: the kind of an alarm, the reason of a job; why a person says that it stood
  std::string text{};   // one sentence, a note, or a name
};

struct LoggedEvent {
  std::uint64_t seq = 0;  // 1, 2, 3, …; a number is never given twice
  NewEvent of;
  Stamp by;
};

// "job.done". One name for each thing that can happen.
std::string type_of(const NewEvent& event);
// The same as long as the row lives, and another one for each row of each store: after a restore of a backup the
// numbers begin again, the time does not.
std::string id_of(const LoggedEvent& event);

// What is kept. Whoever comes later has missed what went.
struct EventLimits {
  std::int64_t before_ms = 0;            // older ones go
  std::int64_t delivered_before_ms = 0;  // deliveries that were taken before go, too
  std::uint64_t most = 0;                // rows
  std::uint32_t at_once = 500;
};

class EventLog : public Repository {
 public:
  // For what no other repository changes: the states of lines. Errors: invalid_value (no word).
  virtual Result<LoggedEvent> append(const NewEvent& event, const Stamp& by) = 0;
  // Oldest first, at most so many.
  virtual Result<std::vector<LoggedEvent>> after(std::uint64_t seq, std::uint32_t most) = 0;
  // Of the newest row that there ever was; 0: none.
  virtual Result<std::uint64_t> newest() = 0;
  // How far a reader that is no webhook has come; nothing before its first note.
  virtual Result<std::optional<std::uint64_t>> seen_by(std::string_view reader) = 0;
  virtual Result<void> note_seen(std::string_view reader, std::uint64_t seq) = 0;
  // With their deliveries. How many went.
  virtual Result<std::uint64_t> forget(const EventLimits& limits) = 0;
};

}  // namespace dripfeed::store
