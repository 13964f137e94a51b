// dripfeed receive: one program from a control, without a server. A broken one is kept as it came, next to the output,
// and never under the output's name.
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "protocol/receive/program_name.h"
#include "protocol/receive/transfer.h"
#include "server/app/lines/lines.h"
#include "server/cli/claimed_line.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/logging.h"
#include "server/cli/output.h"
#include "server/cli/signals.h"
#include "server/io/io.h"

namespace dripfeed::cli {

namespace {

constexpr std::chrono::milliseconds kLook{20};
constexpr std::chrono::seconds kToOpen{5};
constexpr std::chrono::milliseconds kLeaveTaking{200};

struct ReceiveOptions {
  std::string link;
  std::string machine;
  std::string output;
  std::optional<std::string> confirmed_reset;
  double timeout_s = 60.0;
  bool json = false;
};

// The first reception that is more than noise. Nothing when none began in time, or a signal came.
app::Result<std::optional<app::Reception>> wait_for(const machine::Profile& profile, const ReceiveOptions& options,
                                                    const std::stop_token& stop) {
  const auto thread = io::start_link_thread();
  auto line = app::make_receiving_line(profile.line, *thread, io::take_modbus_seat, [] {});
  if (!line) return std::unexpected(line.error());
  const auto begun = std::chrono::steady_clock::now();
  bool stopped = false;
  for (;;) {
    for (app::Reception& one : (*line)->take_receptions()) {
      const receive::Transfer transfer = receive::judge(one.raw, one.ending, one.settings);
      if (transfer.fault == receive::Fault::empty) continue;
      if (const std::string_view cause = (*line)->report().cause; !cause.empty())
        say(fmt::format("the transfer broke off: {}", cause));
      return std::move(one);
    }
    const app::LineReport report = (*line)->report();
    if (stopped) break;
    if (stop.stop_requested()) {
      // A sender of packets is informed; what came of its text so far is a broken reception. Others hear nothing.
      stopped = true;
      static_cast<void>((*line)->command(feed::Command::abort));
      std::this_thread::sleep_for(kLeaveTaking);
      continue;
    }
    const auto waited = std::chrono::steady_clock::now() - begun;
    if (report.state == app::LineState::disconnected && waited > kToOpen)
      return app::fail(app::ErrorCode::unavailable, fmt::format("{}: {}", options.link, report.link_error));
    if (report.state != app::LineState::receiving && waited > std::chrono::duration<double>(options.timeout_s)) break;
    std::this_thread::sleep_for(kLook);
  }
  return std::nullopt;
}

int keep(const app::Reception& reception, const ReceiveOptions& options) {
  const receive::Transfer transfer = receive::judge(reception.raw, reception.ending, reception.settings);
  const bool whole = transfer.fault == receive::Fault::none;
  const std::string path = whole ? options.output : options.output + ".quarantine";
  const auto name = receive::find_name(transfer.text);
  std::string raw;
  for (const std::byte byte : reception.raw) raw += static_cast<char>(byte);
  if (!write_output(path, whole ? transfer.text : raw)) return kWrongUse;
  if (options.json && !write_output("-", receive_document(reception, transfer, name ? name->name : "", path)))
    return kWrongUse;
  if (whole) {
    say(fmt::format("received {}{}{} bytes to {}", name ? name->name : "", name ? ", " : "", transfer.text.size(),
                    path));
    return kDone;
  }
  print_error(fmt::format("what came is not a program: {}{}; its bytes are in {}", receive::message(transfer.fault),
                          transfer.device.empty() ? "" : fmt::format(" (\"{}\")", transfer.device), path));
  if (transfer.first_parity_error) {
    print_error(fmt::format("{} characters with wrong parity, the first at byte {}", transfer.parity_errors,
                            transfer.first_parity_error->wire_offset));
  }
  return kFailed;
}

int receive_one(const ReceiveOptions& options) {
  const std::stop_token stop = stop_by_two_signals().first;
  const Logging logging;
  auto profile = read_machine_at(options.link, options.machine);
  if (!profile) {
    print_error(profile.error());
    return kWrongUse;
  }
  profile->line.receive.enabled = true;
  // Our own DC1 and DC3 are characters, too: a control that has a part of a block gets none of them.
  const auto claim = take_line(profile->line.link, options.confirmed_reset);
  if (!claim) {
    print_error(claim.error().sentence);
    return claim.error().exit_code;
  }
  const auto received = wait_for(*profile, options, stop);
  if (!received) {
    print_error(received.error());
    return received.error().code == app::ErrorCode::invalid ? kWrongUse : kFailed;
  }
  if (*received) return keep(**received, options);
  print_error(stop.stop_requested() ? "stopped before anything came" : "nothing came in time");
  return kFailed;
}

}  // namespace

void add_receive(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("receive", "takes one program that a control punches, without a server");
  const auto options = std::make_shared<ReceiveOptions>();
  command
      ->add_option("--link", options->link,
                   "serial:/dev/serial/by-id/NAME?baud=9600&framing=7E2, tcp://host:port, pty:/path")
      ->required();
  command->add_option("-o,--output", options->output, "where the program is written; a broken one to FILE.quarantine")
      ->required();
  command->add_option("--machine", options->machine, "machine profile: a file or the name of a preset");
  command->add_option("--timeout", options->timeout_s, "seconds to wait for the first character")
      ->check(CLI::PositiveNumber);
  add_confirm_reset(*command, options->confirmed_reset);
  command->footer(kExitCodes);
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->callback([options, &exit_code] { exit_code = receive_one(*options); });
}

}  // namespace dripfeed::cli
