// A store with a person who looks at each commit of the ledger before it is made, and may let it through, hold it up or
// fail it; and an audit that may be closed. All else goes to the store under it.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "store/store.h"

namespace dripfeed::test {

class WatchedLedger final : public store::Ledger {
 public:
  // Called on the thread that commits. An error is what the commit gives.
  using Look = std::function<std::optional<store::Error>(std::span<const store::NewLedgerRow> rows)>;

  explicit WatchedLedger(store::Ledger& ledger) : ledger_(ledger) {}
  void watch(Look look) {
    const std::lock_guard lock(mutex_);
    look_ = std::move(look);
  }

  store::Result<std::vector<store::LedgerFault>> append(std::span<const store::NewLedgerRow> rows,
                                                        std::int64_t at_ms) override {
    Look look;
    {
      const std::lock_guard lock(mutex_);
      look = look_;
    }
    if (look) {
      if (auto error = look(rows)) return std::unexpected(std::move(*error));
    }
    return ledger_.append(rows, at_ms);
  }
  store::Result<store::Page<store::LedgerRow>> rows(store::Id job, const store::PageRequest& page) override {
    return ledger_.rows(job, page);
  }
  store::Result<store::LedgerInterval> interval(store::Id job) override { return ledger_.interval(job); }
  store::Result<std::uint64_t> verify(store::Id job) override { return ledger_.verify(job); }

 private:
  store::Ledger& ledger_;
  std::mutex mutex_;
  Look look_;
};

class ClosableAudit final : public store::Audit {
 public:
  explicit ClosableAudit(store::Audit& audit) : audit_(audit) {}
  void close(bool closed) { closed_ = closed; }

  store::Result<store::AuditRow> append(const store::AuditEntry& entry, const store::Stamp& by) override {
    if (closed_) return std::unexpected(store::Error{store::ErrorCode::disk_full, "no room"});
    return audit_.append(entry, by);
  }
  store::Result<store::AuditRow> append(const store::AuditEntry& entry, const store::NewEvent& event,
                                        const store::Stamp& by) override {
    if (closed_) return std::unexpected(store::Error{store::ErrorCode::disk_full, "no room"});
    return audit_.append(entry, event, by);
  }
  store::Result<store::Page<store::AuditRow>> list(const store::PageRequest& page,
                                                   const store::AuditFilter& filter) override {
    return audit_.list(page, filter);
  }
  store::Result<store::AuditCheck> verify() override { return audit_.verify(); }

 private:
  store::Audit& audit_;
  bool closed_ = false;
};

class WatchedStore final : public store::Store {
 public:
  explicit WatchedStore(store::Store& store) : store_(store), ledger_(store.ledger()), audit_(store.audit()) {}
  ClosableAudit& closable_audit() { return audit_; }
  WatchedLedger& watched_ledger() { return ledger_; }

  store::Machines& machines() override { return store_.machines(); }
  store::Families& families() override { return store_.families(); }
  store::Parts& parts() override { return store_.parts(); }
  store::Contents& contents() override { return store_.contents(); }
  store::Programs& programs() override { return store_.programs(); }
  store::Verdicts& verdicts() override { return store_.verdicts(); }
  store::Releases& releases() override { return store_.releases(); }
  store::Jobs& jobs() override { return store_.jobs(); }
  store::Receipts& receipts() override { return store_.receipts(); }
  store::Attachments& attachments() override { return store_.attachments(); }
  store::Ledger& ledger() override { return ledger_; }
  store::Answers& answers() override { return store_.answers(); }
  store::Alarms& alarms() override { return store_.alarms(); }
  store::EventLog& event_log() override { return store_.event_log(); }
  store::Webhooks& webhooks() override { return store_.webhooks(); }
  store::Audit& audit() override { return audit_; }
  store::Orders& orders() override { return store_.orders(); }
  store::Users& users() override { return store_.users(); }
  store::Tokens& tokens() override { return store_.tokens(); }
  store::BrowserSessions& browser_sessions() override { return store_.browser_sessions(); }
  store::Replies& replies() override { return store_.replies(); }
  store::Result<void> atomically(const std::function<store::Result<void>()>& work) override {
    return store_.atomically(work);
  }
  store::Result<void> atomically_shared(const std::function<store::Result<void>()>& work) override {
    return store_.atomically_shared(work);
  }
  store::Result<std::uint64_t> version() override { return store_.version(); }
  [[nodiscard]] store::StoreUse use() const override { return store_.use(); }
  store::Result<void> backup(const std::string& path) override { return store_.backup(path); }
  store::Result<void> check() override { return store_.check(); }

 private:
  store::Store& store_;
  WatchedLedger ledger_;
  ClosableAudit audit_;
};

}  // namespace dripfeed::test
