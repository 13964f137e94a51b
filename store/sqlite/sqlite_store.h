// The store on one SQLite file: its database and one table object per repository.
#pragma once

#include <optional>

#include "store/sqlite/alarm_table.h"
#include "store/sqlite/answer_table.h"
#include "store/sqlite/audit_table.h"
#include "store/sqlite/browser_session_table.h"
#include "store/sqlite/checkpointer.h"
#include "store/sqlite/content_table.h"
#include "store/sqlite/event_table.h"
#include "store/sqlite/family_table.h"
#include "store/sqlite/job_table.h"
#include "store/sqlite/ledger_table.h"
#include "store/sqlite/machine_table.h"
#include "store/sqlite/order_table.h"
#include "store/sqlite/owner_lock.h"
#include "store/sqlite/part_table.h"
#include "store/sqlite/program_table.h"
#include "store/sqlite/receipt_table.h"
#include "store/sqlite/release_table.h"
#include "store/sqlite/reply_table.h"
#include "store/sqlite/token_table.h"
#include "store/sqlite/user_table.h"
#include "store/sqlite/verdict_table.h"
#include "store/sqlite/webhook_table.h"
#include "store/store.h"

namespace dripfeed::sqlite {

class SqliteStore final : public store::Store {
 public:
  SqliteStore(std::optional<OwnerLock> lock, std::unique_ptr<Database> database,
              std::unique_ptr<Checkpointer> checkpointer)
      : lock_(std::move(lock)), database_(std::move(database)), checkpointer_(std::move(checkpointer)) {}

  store::Machines& machines() override { return machines_; }
  store::Families& families() override { return families_; }
  store::Parts& parts() override { return parts_; }
  ContentTable& contents() override { return contents_; }
  store::Programs& programs() override { return programs_; }
  store::Verdicts& verdicts() override { return verdicts_; }
  store::Releases& releases() override { return releases_; }
  store::Jobs& jobs() override { return jobs_; }
  store::Orders& orders() override { return orders_; }
  store::Receipts& receipts() override { return receipts_; }
  store::Ledger& ledger() override { return ledger_; }
  store::Answers& answers() override { return answers_; }
  store::Alarms& alarms() override { return alarms_; }
  store::EventLog& event_log() override { return event_log_; }
  store::Webhooks& webhooks() override { return webhooks_; }
  store::Audit& audit() override { return audit_; }
  store::Users& users() override { return users_; }
  store::Tokens& tokens() override { return tokens_; }
  store::BrowserSessions& browser_sessions() override { return browser_sessions_; }
  store::Replies& replies() override { return replies_; }

  store::Result<void> atomically(const std::function<store::Result<void>()>& work) override;
  store::Result<void> atomically_shared(const std::function<store::Result<void>()>& work) override;
  store::Result<std::uint64_t> version() override { return database_->version(); }
  [[nodiscard]] store::StoreUse use() const override { return database_->use(); }
  store::Result<void> backup(const std::string& path) override;
  store::Result<void> check() override;

 private:
  std::optional<OwnerLock> lock_;  // let go last
  std::unique_ptr<Database> database_;
  std::unique_ptr<Checkpointer> checkpointer_;  // nothing: commits do it
  MachineTable machines_{*database_};
  FamilyTable families_{*database_};
  PartTable parts_{*database_};
  ContentTable contents_{*database_};
  ProgramTable programs_{*database_};
  VerdictTable verdicts_{*database_};
  ReleaseTable releases_{*database_, verdicts_};
  AnswerTable answers_{*database_};
  JobTable jobs_{*database_, releases_, answers_};
  OrderTable orders_{*database_};
  LedgerTable ledger_{*database_};
  ReceiptTable receipts_{*database_};
  AlarmTable alarms_{*database_};
  EventTable event_log_{*database_};
  WebhookTable webhooks_{*database_};
  AuditTable audit_{*database_};
  UserTable users_{*database_};
  TokenTable tokens_{*database_};
  BrowserSessionTable browser_sessions_{*database_};
  ReplyTable replies_{*database_};
};

}  // namespace dripfeed::sqlite
