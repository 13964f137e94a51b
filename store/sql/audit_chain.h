// The chain of the audit, for whoever checks rows outside a store.
#pragma once

#include <string>

#include "store/audit.h"

namespace dripfeed::sql {

// The hash that a row must have: of all its fields, each with its length before it, the hash of the row before first.
std::string audit_hash(const store::AuditRow& row);

// Checks rows in their order, from the first one of a store.
class AuditChain {
 public:
  // False when the row does not follow the one before, or is not what was written.
  bool follows(const store::AuditRow& row);
  [[nodiscard]] const std::string& head() const { return head_; }
  [[nodiscard]] std::uint64_t rows() const { return rows_; }

 private:
  std::string head_;
  std::uint64_t rows_ = 0;
};

}  // namespace dripfeed::sql
