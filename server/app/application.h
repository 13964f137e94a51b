// The whole application: the use cases with what they share. One object a server; the command uses the parts that it
// needs.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "server/app/base/documents.h"
#include "server/app/checks/checking.h"
#include "server/app/jobs/books.h"
#include "server/app/jobs/jobs.h"
#include "server/app/jobs/shifts.h"
#include "server/app/jobs/stop_reasons.h"
#include "server/app/library/attachments.h"
#include "server/app/library/library_indexer.h"
#include "server/app/library/program_lines.h"
#include "server/app/library/programs.h"
#include "server/app/lines/lines.h"
#include "server/app/lines/link_test.h"
#include "server/app/out/alarms.h"
#include "server/app/out/events.h"
#include "server/app/out/observations.h"
#include "server/app/out/webhooks.h"
#include "server/app/ports/maintenance.h"
#include "server/app/ports/ports.h"
#include "server/app/receive/receiving.h"
#include "server/app/shop/catalog.h"
#include "server/app/shop/node_lines.h"
#include "store/store.h"

namespace dripfeed::app {

// All that is known of a machine's line besides the store.
struct LineFacts {
  LineReport report;
  Asks asks{};              // while nothing is armed
  std::string why_refused;  // why nothing may be sent before a person looked at it; "" otherwise
  std::string why_torn;     // of a line in the state `torn`; "" where no more is known
  friend bool operator==(const LineFacts&, const LineFacts&) = default;
};

// Where a machine's line stands, with the block at the sent position.
struct MachineStatus {
  LineReport report;
  std::string program;     // name of the job's program
  std::string block_text;  // the block in which the last handed character lies
  std::optional<TornBlock> needs_confirmation;
  Asks asks{};             // while nothing is armed
  bool is_certain = true;  // false: the store could not say whether a block is torn
};

class Application {
 public:
  struct Environment {
    store::Store& store;
    LinkThread& links;
    BusSeatMaker take_seat;
    const Clock& clock;
    const Documents& documents;
    DiskReserve* disk_reserve = nullptr;
    ClaimLine claim{};                  // takes lines for this process; empty: they are not claimed
    Workers* workers = nullptr;         // without them checks and renders are done in this process
    store::Library* library = nullptr;  // without it nothing is searched for
    HttpSender* sender = nullptr;       // without it there are no webhooks
    WebhookSettings webhooks{};
    Maintenance* maintenance = nullptr;  // of the store
    std::string event_source{};          // who we are for other systems, a URI
    std::string version{};               // of this program, for other nodes
    std::string rules{};                 // the revision of the code that judges; empty: no verdict is stale for it
    LibraryLimits limits{};              // of what is stored
    Shifts shifts{};
    std::vector<std::string> stop_reasons{};  // of the shop; empty: the usual ones
    HookSettings hook{};                      // asked before each arming
  };
  explicit Application(const Environment& environment);
  // Jobs on a line are cancelled at a block end, as far as their control lets them.
  ~Application();
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;

  // Receives nothing more, cancels what runs at its block end and closes the lines. What the destructor does first; a
  // server calls it before it waits for anything else.
  void end_lines();

  // After a crash: jobs that had a line become interrupted, answers that were being sent are torn. Then the machines'
  // lines open, each as it was left; nothing is armed.
  Result<void> start();

  // What the line of each machine reports, also of one that has none.
  [[nodiscard]] std::map<std::string, LineReport> reports();
  // Those of machines whose line is this server's: of another one's machine it knows no more than whose it is.
  [[nodiscard]] std::map<std::string, LineReport> own_reports();
  [[nodiscard]] MachineStatus status(const std::string& machine) { return status(machine, facts(machine)); }
  // In two steps, for who keeps what the second one said: it says the same of the same facts as long as the store is
  // the same.
  [[nodiscard]] LineFacts facts(const std::string& machine);
  [[nodiscard]] MachineStatus status(const std::string& machine, LineFacts facts);

  // What passes on a machine's line, for who looks. Errors: not_found, unavailable (no line, or no characters on it).
  Result<std::shared_ptr<WireTap>> tap(const std::string& machine);
  // Measures a machine's line whose data wires are bridged at the other end. The line is taken out meanwhile: nothing
  // is armed on it. Errors: not_found; refused: a job is on the line, a person must confirm something first, or the
  // control asks for a program and so is there.
  struct LineTested {
    machine::LineSettings line;
    std::expected<LinkTestResult, LinkTestFault> done;
  };
  Result<LineTested> test_line(const std::string& machine, const LinkTestPlan& plan, std::string_view actor);

  // What each line did since the start; takes no lock that a line takes.
  [[nodiscard]] const LineTotals& line_totals() const { return books_.totals(); }

  store::Store& store() { return store_; }
  const Clock& clock() const { return clock_; }
  const Documents& documents() const { return documents_; }
  Events& events() { return events_; }
  Alarms& alarms() { return alarms_; }
  Catalog& catalog() { return catalog_; }
  Programs& programs() { return programs_; }
  Attachments& attachments() { return attachments_; }
  [[nodiscard]] const LibraryLimits& limits() const { return quota_.limits(); }
  LineReading& line_reading() { return line_reading_; }
  Checking& checking() { return checking_; }
  Jobs& jobs() { return jobs_; }
  Receiving& receiving() { return receiving_; }
  // They are begun by the first who asks.
  Observations& observations();
  [[nodiscard]] const std::string& event_source() const { return event_source_; }
  // nullptr: this is the one server of its store.
  NodeLines* nodes() { return nodes_ ? &*nodes_ : nullptr; }
  [[nodiscard]] const Shifts& shifts() const { return shifts_; }
  StopReasons& stop_reasons() { return stop_reasons_; }
  // nullptr: there are none.
  Webhooks* webhooks() { return webhooks_ ? &*webhooks_ : nullptr; }
  // nullptr: there is none.
  Maintenance* maintenance() { return maintenance_; }
  // nullptr: there is none.
  LibraryIndexer* library() { return library_ ? &*library_ : nullptr; }

 private:
  void cancel_all();
  void line_changed();

  store::Store& store_;
  const Clock& clock_;
  const Documents& documents_;
  Events events_;
  Alarms alarms_;
  Lines lines_;
  Books books_;
  Catalog catalog_;
  Quota quota_;
  Programs programs_;
  Attachments attachments_;
  LineReading line_reading_;
  Checking checking_;
  Jobs jobs_;
  Receiving receiving_;
  std::optional<LibraryIndexer> library_;
  std::optional<NodeLines> nodes_;
  std::optional<Webhooks> webhooks_;
  Maintenance* maintenance_;
  std::string event_source_;
  Shifts shifts_;
  StopReasons stop_reasons_;
  LinkThread& links_;
  std::once_flag observed_;
  std::optional<Observations> observations_;
};

}  // namespace dripfeed::app
