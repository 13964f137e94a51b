// A restart of a stored program for a stored machine: what compile::restart_at makes of it, and its approach compared
// with the part as the blocks before the line have left it. Nothing is stored and nothing is sent.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/compile/restart/restart.h"
#include "server/app/base/check_budget.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/checks/workers.h"

namespace dripfeed::app {

struct RestartOrder {
  CaseOrder of;
  std::uint32_t line = 0;
  double clearance_mm = compile::kRestartClearance_mm;
};

// Of a move of the restart: what it does to the stock or the part.
struct ApproachFinding {
  text::Severity severity = text::Severity::error;
  std::uint32_t line = 0;  // of the restart's text
  std::string text;
};

struct RestartMade {
  compile::Restart restart;
  text::Source source;  // that its diagnostics are in
  std::string sha256;   // of its text; empty without one
  std::vector<ApproachFinding> findings;
  std::string not_held;  // why it was not compared with the part; empty: it was

  // A text was made, and nothing is known of it that forbids to send it.
  [[nodiscard]] bool is_possible() const;
};

// Errors: as open_case.
Result<RestartMade> restart_case(RestartOrder order, const Documents& documents, const CheckBudget& budget,
                                 CalledBy& called);

}  // namespace dripfeed::app
