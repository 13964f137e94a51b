// dripfeed link test: measures a line before a machine hangs on it.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/app/lines/link_test.h"
#include "server/cli/claimed_line.h"
#include "server/cli/cli.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/io/io.h"
#include "server/json/link_test.h"

namespace dripfeed::cli {

namespace {

struct LinkOptions {
  std::string link;
  std::string machine;
  std::uint32_t round_trips = 50;
  std::uint32_t holds = 50;
  std::optional<std::string> confirmed_reset;
  bool json = false;
};

std::string ms(feed::Time time) { return text::format_fixed(static_cast<double>(time.count()) / 1e6, 3); }

void print_text(const app::LinkTestResult& r, const machine::LineSettings& line, bool kept) {
  const auto median = r.latencies[r.latencies.size() / 2];
  fmt::print("one character takes {} ms\n", ms(r.char_time));
  fmt::print("latency beyond it: median {} ms, worst {} ms of {}: {} characters\n", ms(median), ms(r.latencies.back()),
             r.latencies.size(), r.latency_chars);
  fmt::print("characters after DC3: median {}, worst {} of {} holds\n", r.after_dc3[r.after_dc3.size() / 2],
             r.after_dc3.back(), r.after_dc3.size());
  fmt::print("characters sent {}, came back wrong {}; the UART counted {} parity, {} framing, {} overrun, {} break\n",
             r.characters, r.wrong, r.errors.parity, r.errors.framing, r.errors.overrun, r.errors.breaks);
  fmt::print("budget of the machine: {} characters; {} by these settings (unsent {}, latency_chars {}){}\n",
             line.overrun_budget, kept ? "kept" : "NOT kept", line.unsent, line.latency_chars,
             r.latency_chars > line.latency_chars
                 ? fmt::format("; the latency measured asks for latency_chars {}", r.latency_chars)
                 : "");
}

int link_test(const LinkOptions& options) {
  const auto profile = read_machine_at(options.link, options.machine);
  if (!profile) {
    print_error(profile.error());
    return kWrongUse;
  }
  const machine::LineSettings& line = profile->line;
  const auto claim = take_line(line.link, options.confirmed_reset);
  if (!claim) {
    print_error(claim.error().sentence);
    return claim.error().exit_code;
  }
  const auto thread = io::start_link_thread();
  const auto result = app::test_link(
      line, *thread,
      {.round_trips = options.round_trips, .holds = options.holds, .patience = std::chrono::seconds(3), .stop = {}});
  if (!result) {
    print_error(fmt::format("{}: {}", options.link, result.error().text));
    return kFailed;
  }
  const bool kept = app::keeps_budget(*result, line);
  if (options.json) {
    fmt::print("{}\n", json::link_test(*result, line));
  } else {
    print_text(*result, line, kept);
  }
  return kept ? kDone : kFailed;
}

}  // namespace

void add_link(CLI::App& app, int& exit_code) {
  CLI::App* link = app.add_subcommand("link", "lines by themselves");
  link->require_subcommand(1);
  CLI::App* command = link->add_subcommand(
      "test", "measures latency and characters after DC3 on a line whose data wires are bridged at its other end");
  const auto options = std::make_shared<LinkOptions>();
  command->add_option("--link", options->link, "the line, as a machine's profile has it")->required();
  command->add_option("--machine", options->machine, "machine profile (a file or the name of a preset) for its budget");
  command->add_option("--round-trips", options->round_trips, "single characters to send")->check(CLI::Range(1, 10'000));
  command->add_option("--holds", options->holds, "streams to hold")->check(CLI::Range(1, 10'000));
  add_confirm_reset(*command, options->confirmed_reset);
  command->footer(kExitCodes);
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->callback([options, &exit_code] { exit_code = link_test(*options); });
}

}  // namespace dripfeed::cli
