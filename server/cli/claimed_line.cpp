// One sentence for each reason why a line is not to be had.
#include "server/cli/claimed_line.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/logging.h"
#include "server/io/io.h"
#include "server/io/serial_identity.h"

namespace dripfeed::cli {

namespace {

void advise(const machine::LinkUrl& link) {
  if (link.kind != machine::LinkKind::serial && link.kind != machine::LinkKind::modbus_rtu) return;
  if (const std::string name = io::lasting_name(link.path); !name.empty())
    say(fmt::format("{} may be another adapter after a re-plug; {} stays this one", link.path, name));
}

}  // namespace

std::expected<std::unique_ptr<app::LineClaim>, LineRefusal> take_line(
    const machine::LinkUrl& link, const std::optional<std::string>& confirmed_reset) {
  advise(link);
  auto claim = io::claim_line(link);
  if (!claim) return std::unexpected(LineRefusal{claim.error(), kFailed});
  const std::string torn = (*claim)->torn();
  if (confirmed_reset) {
    const auto confirmed = (*claim)->confirm_reset(*confirmed_reset);
    if (!confirmed) return std::unexpected(LineRefusal{confirmed.error(), kWrongUse});
    say(torn.empty() ? "nothing was torn on this line" : fmt::format("the reset is confirmed; before it: {}", torn));
    return std::move(*claim);
  }
  if (torn.empty()) return std::move(*claim);
  return std::unexpected(
      LineRefusal{fmt::format("{}: {}. Nothing was sent. Reset the control, clear what it has of the "
                              "program, then pass --confirm-reset \"what was done\"",
                              link.text, torn),
                  kTorn});
}

std::string record_end(app::LineClaim& claim, const app::LineReport& report) {
  if (report.state != app::LineState::torn) {
    const auto ended = claim.end();
    return ended ? std::string() : ended.error();
  }
  const auto written = claim.tear(report.cause);
  const std::string sentence =
      "a block is torn at the control: what comes next would complete it. Reset the control, then pass --confirm-reset "
      "\"what was done\" with the next transfer on this line";
  return written ? sentence : fmt::format("{}. {}", sentence, written.error());
}

void add_confirm_reset(CLI::App& command, std::optional<std::string>& reason) {
  command.add_option("--confirm-reset", reason,
                     "REASON: the control was reset after a torn block on this line; without it a torn line is refused "
                     "(exit 3)");
}

}  // namespace dripfeed::cli
