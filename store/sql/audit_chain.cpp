// One hash a row.
#include "store/sql/audit_chain.h"

#include <fmt/format.h>

#include "store/hash/sha256.h"

namespace dripfeed::sql {

std::string audit_hash(const store::AuditRow& row) {
  hash::Sha256 hash;
  const auto field = [&](std::string_view text) {
    hash.add(fmt::format("{}:", text.size()));
    hash.add(text);
  };
  field(row.previous_hash);
  field(fmt::format("{}", row.seq));
  field(fmt::format("{}", row.by.at_ms));
  field(row.by.actor);
  field(row.entry.action);
  field(row.entry.subject);
  field(row.entry.detail);
  return hash.hex();
}

bool AuditChain::follows(const store::AuditRow& row) {
  ++rows_;
  if (row.seq != rows_ || row.previous_hash != head_ || row.hash != audit_hash(row)) return false;
  head_ = row.hash;
  return true;
}

}  // namespace dripfeed::sql
