// Opening a store, and what concerns the whole of it.
#include <fmt/format.h>

#include "store/journal/journaled_answers.h"
#include "store/journal/journaled_ledger.h"
#include "store/journal/local_contents.h"
#include "store/postgresql/journal_booking.h"
#include "store/postgresql/node_table.h"
#include "store/postgresql/open.h"
#include "store/postgresql/server.h"
#include "store/sql/table_store.h"
#include "store/sql/verifier.h"

namespace dripfeed::postgresql {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

// What a feed needs while the database does not answer.
struct Local {
  Local(sql::TableStore& tables, std::unique_ptr<journal::LedgerJournal> opened, const std::string& folder)
      : journal(std::move(opened)),
        ledger(tables.ledger(), *journal),
        answers(tables.answers(), *journal),
        contents(tables.contents(), folder) {}
  std::unique_ptr<journal::LedgerJournal> journal;
  journal::JournaledLedger ledger;
  journal::JournaledAnswers answers;
  journal::LocalContents contents;
};

class PostgresqlStore final : public sql::TableStore {
 public:
  using TableStore::TableStore;

  store::Ledger& ledger() override { return local_ ? local_->ledger : TableStore::ledger(); }
  store::Answers& answers() override { return local_ ? local_->answers : TableStore::answers(); }
  store::Contents& contents() override { return local_ ? local_->contents : TableStore::contents(); }

  store::Nodes* nodes() override { return nodes_ ? &*nodes_ : nullptr; }
  void be_node(const std::string& name, Listener listener) {
    nodes_.emplace(database(), NodeTable::Others{TableStore::jobs(), TableStore::answers(), TableStore::ledger()}, name,
                   std::move(listener));
  }

  // Before anything else is done with the store.
  Result<void> keep_locally(const std::string& folder) {
    auto journal = open_journal(database(), {TableStore::ledger(), TableStore::answers()}, folder + "/ledger.journal");
    if (!journal) return std::unexpected(journal.error());
    auto local = std::make_unique<Local>(*this, std::move(*journal), folder);
    local_ = std::move(local);
    return {};
  }

  // The server has its own means, which know its files and its log.
  Result<void> backup(const std::string& /*path*/) override {
    return std::unexpected(Error{ErrorCode::invalid_value, "a store on PostgreSQL is backed up with pg_dump"});
  }

  Result<void> check() override {
    const auto found = sql::verify(database());
    if (!found) return std::unexpected(found.error());
    if (found->faults.empty()) return {};
    const sql::VerifyFault& first = found->faults.front();
    return std::unexpected(Error{ErrorCode::corrupt, fmt::format("{}: {}", first.subject, first.what)});
  }

 private:
  std::optional<NodeTable> nodes_;
  std::unique_ptr<Local> local_;  // before the tables that it writes to go
};

}  // namespace

Result<std::unique_ptr<store::Store>> open(const std::string& url, const OpenSettings& settings) {
  auto server = Server::open(url, settings);
  if (!server) return std::unexpected(server.error());
  const std::shared_ptr<const Pulse> pulse = (*server)->pulse();
  auto database = sql::Database::open(std::move(*server));
  if (!database) return std::unexpected(database.error());
  auto opened = std::make_unique<PostgresqlStore>(std::move(*database));
  if (!settings.node.empty()) opened->be_node(settings.node, Listener(url, pulse));
  // Another node may be writing a content that nothing refers to yet.
  if (settings.own && settings.node.empty()) {
    if (auto dropped = opened->drop_unused_contents(); !dropped) return std::unexpected(dropped.error());
  }
  if (!settings.local_folder.empty()) {
    if (auto kept = opened->keep_locally(settings.local_folder); !kept) return std::unexpected(kept.error());
  }
  return opened;
}

}  // namespace dripfeed::postgresql
