// The line of a command that works without a server: taken before it is opened, refused where a block may be torn at
// its control, until a person confirms that the control was reset.
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <string>

#include "server/app/lines/line.h"
#include "server/app/ports/line_claims.h"

namespace CLI {
class App;
}

namespace dripfeed::cli {

// What a command ends with that did not get its line.
struct LineRefusal {
  std::string sentence;
  int exit_code;  // kTorn, kFailed (another process has it), kWrongUse (no reason given)
};

// `confirmed_reset`: the reason that a person gave, where one was.
std::expected<std::unique_ptr<app::LineClaim>, LineRefusal> take_line(
    const machine::LinkUrl& link, const std::optional<std::string>& confirmed_reset);

// Writes into the line's record how a transfer ended. Empty, or one sentence: that the block is torn and what to do, or
// why the record could not be written.
std::string record_end(app::LineClaim& claim, const app::LineReport& report);

// The option --confirm-reset REASON.
void add_confirm_reset(CLI::App& command, std::optional<std::string>& reason);

}  // namespace dripfeed::cli
