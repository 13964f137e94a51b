// Alarms: the one place that raises, folds, clears, acknowledges and shelves them. Whoever raises leaves a line and
// goes on; a thread of its own writes, at most once a second for each machine and kind, and publishes what it wrote.
//
// An alarm that lasts is over when its condition is, and who watches the condition says so. A torn block is looked up
// in the store, so that its alarm can neither be lost nor doubled by an end of the server.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/base/round_thread.h"
#include "server/app/out/events.h"
#include "server/app/ports/clock.h"
#include "server/app/ports/line_mutex.h"
#include "store/store.h"

namespace dripfeed::app {

enum class AlarmKind : std::uint8_t {
  torn_block,         // nothing leaves before a person confirms that the control was reset
  reset_suspected,    // stopped by a person, and the control asked again
  line_refused,       // the line's record lets nothing leave
  ledger_failed,      // the books cannot be written
  link_lost,          // for some time, or while a job was on it
  line_flooded,       // more comes than a line can bring
  link_note,          // what a device server did not confirm, a ring that was not seen to come
  machine_alarm,      // the control's own, as its PLC says
  person_called,      // by the machine's doorbell
  reception_lost,     // the store did not take what a control punched
  quarantined,        // a reception is broken
  device_text,        // a device server speaks to us
  request_failed,     // what an operator asked for at the control could not be done
  request_expired,    // it was not fetched
  read_back_differs,  // the control does not have what was sent
  read_back_expired,  // it was not punched back
};
inline constexpr std::size_t kAlarmKinds = 16;

enum class Severity : std::uint8_t { critical, warning, notice };
std::string_view name_of(Severity severity);

struct AlarmKindRow {
  AlarmKind kind;
  std::string_view name;  // as documents have it
  Severity severity;
  bool lasts;  // until it is cleared; else it is an event
};
const AlarmKindRow& row_of(AlarmKind kind);
// Of a stored kind; one that this server does not know is a warning.
Severity severity_of(std::string_view kind);

class Alarms {
 public:
  Alarms(store::Store& store, Events& events, const Clock& clock);

  // From any thread; neither waits for the store. A kind that lasts has one text at a time: another one takes its
  // place.
  void raise(const std::string& machine, AlarmKind kind, std::string text, store::Id job = 0);
  // The condition of a kind that lasts is over. Costs next to nothing where it was not on.
  void clear(const std::string& machine, AlarmKind kind);
  // Whether the machine's line is torn, as it reports; `why` where the store does not know. The store is looked at,
  // too.
  void line_is_torn(const std::string& machine, bool torn, std::string why);
  // For the start of a server: looks for torn blocks at all machines. Errors: those of the store.
  Result<void> start();

  // By a person. Errors: not_found; refused (it is closed; a critical one is not shelved); invalid.
  Result<store::Alarm> acknowledge(store::Id alarm, std::string_view actor);
  Result<store::Alarm> shelve(store::Id alarm, std::uint32_t minutes, std::string_view reason, std::string_view actor);
  Result<store::Alarm> unshelve(store::Id alarm, std::string_view actor);

  // Until what was raised by now is written, where it is its time.
  bool wait_for_round(std::chrono::milliseconds patience) { return thread_.wait_for_round(patience); }
  void stop() { thread_.stop(); }

 private:
  using Key = std::pair<std::string, AlarmKind>;
  struct Raised {
    std::string text;
    store::Id job = 0;
    std::uint64_t count = 0;
    std::int64_t at_ms = 0;
    bool is_published = false;  // as an alarm that could not be written yet
  };
  // What came for one machine and kind since the last write.
  struct Pending {
    std::vector<Raised> raised;
    bool is_over = false;  // the last word was clear()
    std::string last{};    // the text that was raised last
    std::int64_t over_at_ms = 0;
  };
  struct Torn {
    bool on_line = false;
    std::string why;
  };

  void round();
  bool load();
  void look_at_torn();
  [[nodiscard]] bool is_due(const Key& key) const;
  bool write(const Key& key, Pending& pending);
  bool write_raised(const Key& key, Raised& raised);
  bool write_cleared(const Key& key, std::int64_t at_ms);
  void keep(const Key& key, Pending pending);
  void publish_unwritten(const Key& key, Raised& raised);
  void end_shelves();
  void forget();
  void publish(const store::Alarm& alarm);

  store::Store& store_;
  Events& events_;
  const Clock& clock_;

  LineMutex mutex_{"what is raised"};  // of what others leave for the next round
  std::map<Key, Pending> pending_;
  std::map<std::string, Torn> torn_news_;

  // Of the thread alone.
  bool is_loaded_ = false;
  std::map<Key, std::string> lasting_;  // text of what is on now, as the store has it
  std::map<std::string, Torn> torn_;    // lines that are torn, or may have been
  std::map<Key, feed::Time> next_write_;
  feed::Time next_look_{};
  feed::Time next_forget_{};
  bool is_failing_ = false;
  RoundThread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
