// dripfeed simulate: simulated controls on pseudo-terminals or TCP ports, or a simulated PLC.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/logging.h"
#include "server/cli/output.h"
#include "server/cli/signals.h"
#include "server/cli/wire_hashes.h"
#include "server/simulator/fault.h"
#include "server/simulator/fleet.h"
#include "server/simulator/plc.h"
#include "server/simulator/uart.h"

namespace dripfeed::cli {

namespace {

struct SimulateOptions {
  std::string link;
  std::string machine;
  std::string record;
  std::string protocol = "dc";
  std::string punch;
  bool then_read = false;
  double speed = 1.0;
  double operator_s = 0.0;
  double patience_s = 60.0;
  bool repeat = false;
  std::size_t count = 1;
  std::string uart = "16550";
  bool uart_given = false;
  double clock_ppm = 0.0;
  std::uint32_t seed = 1;
  std::vector<std::string> fault_texts;
  bool json = false;
};

simulator::BlockClockSettings clock_settings(const machine::Profile& profile) {
  simulator::BlockClockSettings settings;
  settings.comment_open = profile.control.dialect.starts_with("sinumerik") ? ';' : '(';
  for (const checks::MachineAxis& axis : profile.machine.axes) {
    if (axis.axis == ir::Axis::x) settings.x_is_diameter = axis.is_diameter;
  }
  if (!profile.machine.axes.empty()) {
    settings.rapid_mm_min = profile.machine.axes.front().rapid_mm_min;
    settings.acceleration_mm_s2 = profile.machine.axes.front().acceleration_mm_s2;
  }
  if (profile.machine.timing.cost) settings.block_ms = profile.machine.timing.cost->block_ms;
  return settings;
}

// Without --uart the delay is what the profile's budget leaves for it.
void set_latency(const machine::LineSettings& line, const SimulateOptions& options, const simulator::Uart& uart,
                 simulator::ControlSettings& settings) {
  settings.host_latency_chars = std::min(line.latency_chars, line.overrun_budget - line.unsent);
  if (!options.uart_given) return;
  settings.host_latency_chars = 1 + uart.chars;  // its own time and the receiver's
  settings.host_latency_ns = uart.fixed_ns;
}

app::Result<simulator::Faults> faults_of(const SimulateOptions& options) {
  simulator::Faults faults;
  for (const std::string& text : options.fault_texts) {
    const auto fault = simulator::parse_fault(text);
    if (!fault) return app::fail(app::ErrorCode::invalid, fault.error());
    faults.push_back(*fault);
  }
  return faults;
}

app::Result<simulator::ControlSettings> control_settings(const machine::Profile& profile,
                                                         const SimulateOptions& options) {
  const auto wrong = [](std::string text) { return app::fail(app::ErrorCode::invalid, std::move(text)); };
  simulator::ControlSettings settings;
  settings.protocol = options.protocol;
  const machine::LineProtocol protocol = profile.line.protocol;
  if (machine::packet_protocol_of(protocol)) settings.protocol = machine::name_of(protocol);
  settings.payload_bytes = profile.line.payload_bytes;
  settings.counted_frames = profile.line.counted_frames;
  settings.messages_end_with_cr = profile.line.messages_end_with_cr;
  settings.framing = profile.line.framing;
  settings.baud = profile.line.baud;
  settings.code = profile.line.code;
  settings.eia_specials = profile.line.eia_specials;
  settings.eob = profile.line.eob;
  if (profile.machine.buffer.bytes > 0) settings.buffer_bytes = profile.machine.buffer.bytes;
  settings.overrun_budget = profile.line.overrun_budget;
  // What follows its own DC3 at the most must still fit.
  settings.stop_free_bytes = std::max(settings.buffer_bytes / 8, profile.line.overrun_budget + 1);
  settings.go_free_bytes = settings.buffer_bytes / 2;
  const auto uart = simulator::find_uart(options.uart);
  if (!uart) return wrong(uart.error());
  set_latency(profile.line, options, *uart, settings);
  settings.clock_ppm = options.clock_ppm;
  settings.speed = options.speed;
  settings.clock = clock_settings(profile);
  auto faults = faults_of(options);
  if (!faults) return std::unexpected(faults.error());
  settings.faults = std::move(*faults);
  return settings;
}

std::vector<simulator::PlcReport> reports_of(const simulator::Plc& plc, std::size_t count) {
  std::vector<simulator::PlcReport> reports;
  for (std::size_t i = 0; i < count; ++i) reports.push_back(plc.report(i));
  return reports;
}

bool all_complete(const std::vector<simulator::PlcReport>& reports) {
  return std::ranges::all_of(reports, &simulator::PlcReport::complete);
}

// --record F writes F, and F-n for each of several.
bool write_record(const SimulateOptions& options, std::size_t index, std::size_t count, const std::string& text) {
  if (options.record.empty()) return true;
  return write_output(count == 1 ? options.record : fmt::format("{}-{}", options.record, index + 1), text);
}

void print_plcs(const std::string& link, const std::vector<simulator::PlcReport>& reports) {
  std::vector<FleetMember> members;
  for (const simulator::PlcReport& report : reports) {
    simulator::ControlReport shown;
    shown.bytes = report.text.size();
    shown.blocks_run = report.blocks_run;
    shown.line_use = 1.0;
    shown.state = report.complete ? simulator::ControlState::ended : simulator::ControlState::reading;
    const std::string hash = hash::sha256_hex(report.text);
    members.push_back({link, shown, {.wire_sha256 = hash, .text_sha256 = hash}});
  }
  write_output("-",
               members.size() == 1 ? simulate_document(members[0].report, members[0].hashes) : fleet_document(members));
}

// Several are units of one server, from the link's unit on.
int run_plc(const machine::LinkUrl& link, const machine::Profile& profile, const SimulateOptions& options,
            const std::stop_token& stop) {
  auto faults = faults_of(options);
  if (!faults) {
    print_error(faults.error());
    return kWrongUse;
  }
  const auto plc =
      simulator::Plc::start(link, {.buffer_bytes = std::max<std::uint32_t>(profile.machine.buffer.bytes, 1024),
                                   .speed = options.speed,
                                   .boot_counter = 1,
                                   .units = options.count,
                                   .has_words = true,
                                   .clock = clock_settings(profile),
                                   .faults = std::move(*faults)});
  if (!plc) {
    print_error(plc.error());
    return kWrongUse;
  }
  say(fmt::format("simulated PLC at {}", link.text));
  // The host reads the end from the registers, so they stay for a while after it.
  constexpr std::chrono::seconds kStayAfterEnd{2};
  auto ended = std::chrono::steady_clock::time_point::max();
  while (!stop.stop_requested() && (options.repeat || std::chrono::steady_clock::now() < ended)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (ended == std::chrono::steady_clock::time_point::max() && all_complete(reports_of(**plc, options.count)))
      ended = std::chrono::steady_clock::now() + kStayAfterEnd;
  }
  const std::vector<simulator::PlcReport> reports = reports_of(**plc, options.count);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (!write_record(options, i, reports.size(), reports[i].text)) return kWrongUse;
  }
  if (options.json) print_plcs(link.text, reports);
  return all_complete(reports) ? kDone : kFailed;
}

// The wire of the n-th of several: {n} in a path is its number from 1 (put after where there is none), ports count up.
std::optional<machine::LinkUrl> link_of(const machine::LinkUrl& link, std::size_t n, std::size_t count) {
  machine::LinkUrl one = link;
  if (count == 1) return one;
  if (link.kind == machine::LinkKind::pty) {
    const std::size_t at = link.path.find("{n}");
    one.path = at == std::string::npos ? fmt::format("{}-{}", link.path, n)
                                       : fmt::format("{}{}{}", link.path.substr(0, at), n, link.path.substr(at + 3));
    return one;
  }
  if (link.port + n - 1 > UINT16_MAX) return std::nullopt;
  one.port = static_cast<std::uint16_t>(link.port + n - 1);
  return one;
}

// What one control got: the hashes of it, and every byte where it is to be kept.
struct Received {
  explicit Received(const tape_code::DecodeFormat& format) : hasher(format) {}
  WireHasher hasher;
  std::string wire;
};

// Few are looked at as often as their lines need; many together, so that hundreds fit into one process.
simulator::Time_ns grid_for(std::size_t count) {
  constexpr std::size_t kFew = 16;
  constexpr simulator::Time_ns kGrid_ns = 10'000'000;
  return count <= kFew ? 0 : kGrid_ns;
}

app::Result<void> add_all(const machine::LinkUrl& link, const simulator::ControlSettings& settings,
                          const tape_code::DecodeFormat& format, const SimulateOptions& options,
                          std::vector<std::unique_ptr<Received>>& received, simulator::Fleet& fleet) {
  const bool keep = !options.record.empty();
  for (std::size_t n = 1; n <= options.count; ++n) {
    const auto own = link_of(link, n, options.count);
    if (!own) return app::fail(app::ErrorCode::invalid, fmt::format("{}: the ports end at 65535", link.text));
    received.push_back(std::make_unique<Received>(format));
    const auto added = fleet.add({.link = *own,
                                  .control = settings,
                                  .record =
                                      [keep, into = received.back().get()](std::uint8_t byte) {
                                        into->hasher.add(byte);
                                        if (keep) into->wire += static_cast<char>(byte);
                                      },
                                  .seed = options.seed + static_cast<std::uint32_t>(n) - 1,
                                  .operator_s = options.operator_s,
                                  .patience_s = options.patience_s,
                                  .repeat = options.repeat});
    if (!added) return app::fail(app::ErrorCode::invalid, added.error());
  }
  return {};
}

bool write_records(const SimulateOptions& options, const std::vector<std::unique_ptr<Received>>& received) {
  for (std::size_t i = 0; i < received.size(); ++i) {
    if (!write_record(options, i, received.size(), received[i]->wire)) return false;
  }
  return true;
}

int run_controls(const machine::LinkUrl& link, const machine::Profile& profile, const SimulateOptions& options,
                 const std::stop_token& stop) {
  auto settings = control_settings(profile, options);
  if (!settings) {
    print_error(settings.error());
    return kWrongUse;
  }
  if (!options.punch.empty()) {
    const auto punched = read_source(options.punch);
    if (!punched) {
      print_error(punched.error());
      return kWrongUse;
    }
    settings->punches = punched->text();
    if (settings->protocol != "dc") {
      settings->protocol = "punch-" + settings->protocol;
    } else {
      settings->protocol = options.then_read ? "punch-read" : "punch";
    }
  }
  std::vector<std::unique_ptr<Received>> received;
  simulator::Fleet fleet(grid_for(options.count));
  if (const auto added = add_all(link, *settings, machine::decode_format_of(profile.line), options, received, fleet);
      !added) {
    print_error(added.error());
    return kWrongUse;
  }
  say(fmt::format("simulated control at {}", fleet.address(0)));
  if (options.count > 1) say(fmt::format("... to {}, {} controls", fleet.address(options.count - 1), options.count));
  fleet.run(stop);
  if (!write_records(options, received)) return kWrongUse;
  std::vector<FleetMember> members;
  bool all_ended = true;
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    members.push_back({fleet.address(i), fleet.report(i), received[i]->hasher.finish()});
    const simulator::ControlReport& report = members.back().report;
    all_ended = all_ended && report.state == simulator::ControlState::ended;
    if (options.json) continue;
    say(fmt::format("{}: {} bytes, {} blocks run, {} holds, {} characters after DC3 at most, {} stalls{}{}",
                    members.back().link, report.bytes, report.blocks_run, report.holds, report.after_dc3_max,
                    report.stalls, report.alarm.empty() ? "" : ", alarm ", report.alarm));
  }
  if (options.json) {
    write_output(
        "-", members.size() == 1 ? simulate_document(members[0].report, members[0].hashes) : fleet_document(members));
  }
  return all_ended ? kDone : kFailed;
}

int simulate(const SimulateOptions& options) {
  const std::stop_token stop = stop_by_two_signals().first;
  const Logging logging;
  const auto link = machine::parse_link_url(options.link);
  if (!link) {
    print_error(link.error());
    return kWrongUse;
  }
  const auto profile = read_machine(options.machine);
  if (!profile) {
    print_error(profile.error());
    return kWrongUse;
  }
  if (machine::is_modbus(link->kind)) return run_plc(*link, *profile, options, stop);
  machine::Profile speaking = *profile;
  speaking.line.link.options = link->options;  // ?baud=…&framing=… say how the simulated control speaks, too
  const auto settings = machine::effective_line(speaking.line);
  if (!settings) {
    print_error(settings.error());
    return kWrongUse;
  }
  speaking.line = *settings;
  if (machine::packet_protocol_of(speaking.line.protocol)) {
    if (const auto possible = machine::packet_settings_of(speaking.line); !possible) {
      print_error(possible.error());
      return kWrongUse;
    }
  }
  return run_controls(*link, speaking, options, stop);
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("simulate", "a simulated control at the other end of a line");
  const auto options = std::make_shared<SimulateOptions>();
  command
      ->add_option("--link", options->link,
                   "pty:/path, tcp-listen://:port, modbus-tcp://:port/unit or modbus-rtu:/path")
      ->required();
  command->add_option("--machine", options->machine, "machine profile: a file or the name of a preset")->required();
  command->add_option("--protocol", options->protocol, "what the control speaks")
      ->check(CLI::IsMember(simulator::control_protocols()));
  command->add_option("--punch", options->punch, "the control punches this file once it is connected");
  command->add_flag("--then-read", options->then_read, "and reads what the host answers");
  command->add_option("--speed", options->speed, "how many times faster than a machine it runs")
      ->check(CLI::Range(0.001, 1e6));
  command->add_option("--operator", options->operator_s,
                      "after so many seconds without a character the operator presses RESET and START");
  command->add_option("--patience", options->patience_s,
                      "the same inside a program whose host is still there; 60 by default");
  command->add_flag("--repeat", options->repeat, "the operator starts the next program after the end of one");
  command
      ->add_option("--count", options->count,
                   "how many controls, at pty:/path-{n} or on ports that count up; of PLCs: units")
      ->check(CLI::Range(1, 4096));
  const CLI::Option* uart = command->add_option("--uart", options->uart,
                                                "what lies between host and line: 16550, ftdi, device-server, ideal");
  command->add_option("--clock-ppm", options->clock_ppm, "by how much the line's clock is off, in parts per million")
      ->check(CLI::Range(-50'000.0, 50'000.0));
  command->add_option("--seed", options->seed, "start of the random faults; each further control has the next one");
  std::string names;
  for (const simulator::FaultRow& row : simulator::fault_table())
    names += fmt::format("\n{}=N: {}", row.name, row.meaning);
  command->add_option("--fault", options->fault_texts, "K=N, one of" + names);
  command->add_option("--record", options->record, "write every byte that arrived to this file");
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->callback([options, uart, &exit_code] {
    options->uart_given = uart->count() > 0;
    exit_code = simulate(*options);
  });
}

}  // namespace dripfeed::cli
