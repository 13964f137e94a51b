// dripfeed simulate: simulated controls on a pseudo-terminal or a TCP port, or a simulated PLC.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/cli/signals.h"
#include "server/cli/wire_hashes.h"
#include "server/simulator/fleet.h"
#include "server/simulator/plc.h"

namespace dripfeed::cli {

namespace {

struct Options {
  std::string link;
  std::string machine;
  std::string record;
  std::string protocol = "dc";
  double speed = 1.0;
  double operator_s = 0.0;
  bool repeat = false;
  std::vector<std::string> faults;
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

simulator::ControlSettings control_settings(const machine::Profile& profile, const Options& options) {
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
  if (profile.machine.buffer.bytes > 0) settings.buffer_bytes = profile.machine.buffer.bytes;
  settings.overrun_budget = profile.line.overrun_budget;
  // What follows its own DC3 at the most must still fit.
  settings.stop_free_bytes = std::max(settings.buffer_bytes / 8, profile.line.overrun_budget + 1);
  settings.go_free_bytes = settings.buffer_bytes / 2;
  settings.host_latency_chars = std::min(profile.line.latency_chars, profile.line.overrun_budget - profile.line.unsent);
  settings.speed = options.speed;
  settings.clock = clock_settings(profile);
  return settings;
}

// --fault cut=N: the cable is cut after N bytes.
app::Result<std::optional<std::uint64_t>> cut_of(const std::vector<std::string>& faults) {
  std::optional<std::uint64_t> cut;
  for (const std::string& fault : faults) {
    std::uint64_t count = 0;
    const std::string_view value = std::string_view(fault).substr(std::min<std::size_t>(4, fault.size()));
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), count);
    if (!fault.starts_with("cut=") || error != std::errc{} || end != value.data() + value.size()) {
      return app::fail(app::ErrorCode::invalid, fmt::format("--fault \"{}\": use cut=BYTES", fault));
    }
    cut = count;
  }
  return cut;
}

int run_plc(const machine::LinkUrl& link, const machine::Profile& profile, const Options& options,
            const std::stop_token& stop) {
  const auto plc =
      simulator::Plc::start(link, {.buffer_bytes = std::max<std::uint32_t>(profile.machine.buffer.bytes, 1024),
                                   .speed = options.speed,
                                   .boot_counter = 1,
                                   .clock = clock_settings(profile)});
  if (!plc) {
    print_error(plc.error());
    return kWrongUse;
  }
  fmt::print(stderr, "simulated PLC at {}\n", link.text);
  // The host reads the end from the registers, so they stay for a while behind it.
  constexpr std::chrono::seconds kStayAfterEnd{2};
  auto ended = std::chrono::steady_clock::time_point::max();
  while (!stop.stop_requested() && (options.repeat || std::chrono::steady_clock::now() < ended)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const bool complete = (*plc)->report().complete;
    if (complete && ended == std::chrono::steady_clock::time_point::max())
      ended = std::chrono::steady_clock::now() + kStayAfterEnd;
  }
  const simulator::PlcReport report = (*plc)->report();
  if (!options.record.empty() && !write_output(options.record, report.text)) return kWrongUse;
  if (options.json) {
    simulator::ControlReport shown;
    shown.bytes = report.text.size();
    shown.blocks_run = report.blocks_run;
    shown.line_use = 1.0;
    shown.state = report.complete ? simulator::ControlState::ended : simulator::ControlState::reading;
    const std::string hash = hash::sha256_hex(report.text);
    fmt::print("{}", simulate_document(shown, {.wire_sha256 = hash, .text_sha256 = hash}));
  }
  return report.complete ? kDone : kFailed;
}

int run_control(const machine::LinkUrl& link, const machine::Profile& profile, const Options& options,
                const std::stop_token& stop) {
  const auto cut = cut_of(options.faults);
  if (!cut) {
    print_error(cut.error());
    return kWrongUse;
  }
  const simulator::ControlSettings settings = control_settings(profile, options);
  WireHasher hasher(machine::decode_format_of(profile.line));
  std::string wire;
  const bool keep = !options.record.empty();
  simulator::Fleet fleet;
  const auto added = fleet.add({.link = link,
                                .control = settings,
                                .record =
                                    [&](std::uint8_t byte) {
                                      hasher.add(byte);
                                      if (keep) wire += static_cast<char>(byte);
                                    },
                                .cut_after = *cut,
                                .operator_s = options.operator_s,
                                .repeat = options.repeat});
  if (!added) {
    print_error(added.error());
    return kWrongUse;
  }
  fmt::print(stderr, "simulated control at {}\n", fleet.address(*added));
  fleet.run(stop);
  const simulator::ControlReport report = fleet.report(*added);
  if (keep && !write_output(options.record, wire)) return kWrongUse;
  if (options.json) {
    fmt::print("{}", simulate_document(report, hasher.finish()));
  } else {
    fmt::print(stderr, "{} bytes, {} blocks run, {} holds, {} characters after DC3 at most, {} stalls{}{}\n",
               report.bytes, report.blocks_run, report.holds, report.after_dc3_max, report.stalls,
               report.alarm.empty() ? "" : ", alarm ", report.alarm);
  }
  return report.state == simulator::ControlState::ended ? kDone : kFailed;
}

int simulate(const Options& options) {
  const std::stop_token stop = stop_by_signal();
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
  if (link->kind == machine::LinkKind::modbus_tcp) return run_plc(*link, *profile, options, stop);
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
  return run_control(*link, speaking, options, stop);
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("simulate", "a simulated control at the other end of a line");
  const auto options = std::make_shared<Options>();
  command->add_option("--link", options->link, "pty:/path, tcp-listen://:port or modbus-tcp://:port/unit")->required();
  command->add_option("--machine", options->machine, "machine profile: a file or the name of a preset")->required();
  command->add_option("--protocol", options->protocol, "what the control speaks")
      ->check(CLI::IsMember(simulator::control_protocols()));
  command->add_option("--speed", options->speed, "runs so much faster than a machine")->check(CLI::Range(0.001, 1e6));
  command->add_option("--operator", options->operator_s,
                      "after so many seconds without a character the operator presses RESET and START");
  command->add_flag("--repeat", options->repeat, "the operator starts the next program after the end of one");
  command->add_option("--fault", options->faults, "cut=BYTES: the cable is cut after so many bytes");
  command->add_option("--record", options->record, "write every byte that arrived to this file");
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->callback([options, &exit_code] { exit_code = simulate(*options); });
}

}  // namespace dripfeed::cli
