// store: what dripfeed keeps, as records and one interface per kind of record. Documents are opaque strings, times come
// from the caller. An engine implements it: sqlite/ (sqlite/open.h makes one). Nothing here knows JSON, dialects,
// machines' profiles or HTTP; nothing here names an engine.
#pragma once

#include <functional>

#include "store/alarms.h"
#include "store/answers.h"
#include "store/attachments.h"
#include "store/audit.h"
#include "store/browser_sessions.h"
#include "store/contents.h"
#include "store/event_log.h"
#include "store/families.h"
#include "store/jobs.h"
#include "store/ledger.h"
#include "store/machines.h"
#include "store/nodes.h"
#include "store/orders.h"
#include "store/parts.h"
#include "store/programs.h"
#include "store/receipts.h"
#include "store/releases.h"
#include "store/replies.h"
#include "store/tokens.h"
#include "store/use.h"
#include "store/users.h"
#include "store/verdicts.h"
#include "store/webhooks.h"

namespace dripfeed::store {

// All members may be called from any thread; changes wait for each other, the ledger's (and the answers' that are
// booked with it) before all others; reads do not wait. Each call is one transaction, and durable when it returns.
// Nothing may be called on it, nor a writer be alive, when it is destroyed.
class Store : public Repository {
 public:
  virtual Machines& machines() = 0;
  virtual Families& families() = 0;
  virtual Parts& parts() = 0;
  virtual Contents& contents() = 0;
  virtual Programs& programs() = 0;
  virtual Verdicts& verdicts() = 0;
  virtual Releases& releases() = 0;
  virtual Jobs& jobs() = 0;
  virtual Orders& orders() = 0;
  virtual Receipts& receipts() = 0;
  virtual Attachments& attachments() = 0;
  virtual Ledger& ledger() = 0;
  virtual Answers& answers() = 0;
  virtual Alarms& alarms() = 0;
  virtual EventLog& event_log() = 0;
  virtual Webhooks& webhooks() = 0;
  virtual Audit& audit() = 0;
  virtual Users& users() = 0;
  virtual Tokens& tokens() = 0;
  virtual BrowserSessions& browser_sessions() = 0;
  virtual Replies& replies() = 0;
  // nullptr: this store has one server.
  virtual Nodes* nodes() { return nullptr; }

  // All that `work` does on this thread is one transaction; it is undone when work returns an error. A call inside that
  // fails is undone alone. Everybody else's changes wait meanwhile, the ledger's too: only calls of the store belong
  // inside, no check, no rendering, no text of more than a few megabytes.
  virtual Result<void> atomically(const std::function<Result<void>()>& work) = 0;
  // The same for a few rows that many callers add at once: those that wait together share one commit, and each returns
  // when it is durable. `work` may run on the thread of another caller: it must not rest on its own thread, nor take a
  // lock that any caller holds. Where the commit fails it fails for all of them.
  virtual Result<void> atomically_shared(const std::function<Result<void>()>& work) = 0;
  // A number that is another one after every committed change, by this process or another. What was read after it was
  // asked for holds as long as it stays the same. It costs less than any query.
  virtual Result<std::uint64_t> version() = 0;
  // How busy it is. It waits for nothing.
  [[nodiscard]] virtual StoreUse use() const = 0;
  // A copy of the whole to a new file, while everything goes on. Errors: exists, disk_full, io_failed.
  virtual Result<void> backup(const std::string& path) = 0;
  // Reads the whole file and checks it. Errors: corrupt.
  virtual Result<void> check() = 0;
};

}  // namespace dripfeed::store
