// The audit's rows and their chain of hashes.
#pragma once

#include "store/audit.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

// Adds a row within the caller's transaction. A fault stays in the session.
store::AuditRow add_audit_row(Session& session, const store::AuditEntry& entry, const store::Stamp& by);

class AuditTable final : public store::Audit {
 public:
  explicit AuditTable(Database& database) : database_(database) {}
  store::Result<store::AuditRow> append(const store::AuditEntry& entry, const store::Stamp& by) override;
  store::Result<store::AuditRow> append(const store::AuditEntry& entry, const store::NewEvent& event,
                                        const store::Stamp& by) override;
  store::Result<store::Page<store::AuditRow>> list(const store::PageRequest& page,
                                                   const store::AuditFilter& filter) override;
  store::Result<store::AuditCheck> verify() override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
