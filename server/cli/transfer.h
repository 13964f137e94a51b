// One transfer on a line that is ours: opened, armed, followed to its end with a ledger in a file, and recorded in the
// line's record. What is sent, and what the command prints of it, is the command's matter.
#pragma once

#include <cstdint>
#include <string>

#include "protocol/feed/feed.h"
#include "server/app/base/error.h"
#include "server/app/lines/line.h"
#include "server/app/ports/line_claims.h"
#include "server/cli/file_ledger.h"
#include "server/cli/signals.h"
#include "server/machine/profile.h"

namespace dripfeed::cli {

struct TransferOrder {
  const std::string& text;
  const feed::ProgramFacts& facts;
  const machine::Profile& profile;
  std::string name;       // of the program, for the line's record
  std::string file_name;  // under which the control gets it; mostly empty
  std::uint32_t rounds = 1;
  bool read_back = false;
};

struct Transferred {
  app::LineReport report;
  std::string read_back;  // empty: none was due
  bool torn = false;      // nothing may be sent on the line until a person confirms a reset
  std::string fault;      // next to the report's own: the ledger, or the line's record; empty: none
};

// An error where nothing was sent: the link does not open, the line takes no job, nothing can be recorded. A signal
// cancels at a block end, a second one at once: where a control never answers there is no block end.
app::Result<Transferred> transfer(const TransferOrder& order, FileLedger& ledger, app::LineClaim& claim,
                                  const Stops& stops);

}  // namespace dripfeed::cli
