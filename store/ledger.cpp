// The rule that a job's counts keep from row to row.
#include "store/ledger.h"

namespace dripfeed::store {
namespace {

bool in_order(const LedgerCounts& counts) {
  return counts.reserve >= counts.handed && counts.handed >= counts.clocked && counts.clocked >= counts.confirmed;
}

bool falls(const LedgerCounts& from, const LedgerCounts& to) {
  return to.handed < from.handed || to.clocked < from.clocked || to.confirmed < from.confirmed;
}

}  // namespace

std::optional<LedgerFault> fault_of(Id job, const LedgerCounts& before, const LedgerCounts& counts) {
  if (!in_order(counts)) return LedgerFault{job, "the counts contradict each other", false};
  if (falls(before, counts)) return LedgerFault{job, "a count fell", false};
  if (counts.handed > before.reserve) return LedgerFault{job, "more was handed than reserved", true};
  return std::nullopt;
}

}  // namespace dripfeed::store
