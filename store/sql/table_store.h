// The store on a database: one table object per repository. An engine adds what concerns the whole of it.
#pragma once

#include "store/sql/alarm_table.h"
#include "store/sql/answer_table.h"
#include "store/sql/attachment_table.h"
#include "store/sql/audit_table.h"
#include "store/sql/browser_session_table.h"
#include "store/sql/content_table.h"
#include "store/sql/event_table.h"
#include "store/sql/family_table.h"
#include "store/sql/job_table.h"
#include "store/sql/ledger_table.h"
#include "store/sql/machine_table.h"
#include "store/sql/order_table.h"
#include "store/sql/part_table.h"
#include "store/sql/program_table.h"
#include "store/sql/receipt_table.h"
#include "store/sql/release_table.h"
#include "store/sql/reply_table.h"
#include "store/sql/token_table.h"
#include "store/sql/user_table.h"
#include "store/sql/verdict_table.h"
#include "store/sql/webhook_table.h"
#include "store/store.h"

namespace dripfeed::sql {

class TableStore : public store::Store {
 public:
  explicit TableStore(std::unique_ptr<Database> database) : database_(std::move(database)) {}

  store::Machines& machines() override { return machines_; }
  store::Families& families() override { return families_; }
  store::Parts& parts() override { return parts_; }
  store::Contents& contents() override { return contents_; }
  store::Programs& programs() override { return programs_; }
  store::Verdicts& verdicts() override { return verdicts_; }
  store::Releases& releases() override { return releases_; }
  store::Jobs& jobs() override { return jobs_; }
  store::Orders& orders() override { return orders_; }
  store::Receipts& receipts() override { return receipts_; }
  store::Attachments& attachments() override { return attachments_; }
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

  // See ContentTable.
  store::Result<void> drop_unused_contents() { return contents_.drop_unused(); }
  store::Result<void> atomically(const std::function<store::Result<void>()>& work) override;
  store::Result<void> atomically_shared(const std::function<store::Result<void>()>& work) override;
  store::Result<std::uint64_t> version() override { return database_->version(); }
  [[nodiscard]] store::StoreUse use() const override { return database_->use(); }

 protected:
  [[nodiscard]] Database& database() const { return *database_; }

 private:
  std::unique_ptr<Database> database_;
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
  AttachmentTable attachments_{*database_};
  AlarmTable alarms_{*database_};
  EventTable event_log_{*database_};
  WebhookTable webhooks_{*database_};
  AuditTable audit_{*database_};
  UserTable users_{*database_};
  TokenTable tokens_{*database_};
  BrowserSessionTable browser_sessions_{*database_};
  ReplyTable replies_{*database_};
};

}  // namespace dripfeed::sql
