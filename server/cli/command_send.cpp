// dripfeed send: one transfer without a server, with its own ledger file. It takes texts that nobody checked or
// released, so it wants to be told that this is meant.
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "protocol/receive/transfer.h"
#include "protocol/tape_code/character_set.h"
#include "server/app/drop_line.h"
#include "server/app/ledger_writer.h"
#include "server/app/lines.h"
#include "server/app/read_back.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/file_ledger.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/cli/signals.h"
#include "server/cli/wire_hashes.h"
#include "server/io/io.h"
#include "server/machine/file_drop.h"
#include "server/machine/line_protocol.h"

namespace dripfeed::cli {

namespace {

constexpr std::chrono::milliseconds kRound{50};
constexpr std::uint64_t kJob = 1;
// A protocol's leave-taking is let out before the link is closed, which drops what is unsent.
constexpr std::chrono::milliseconds kLeaveTaking{200};

struct Options {
  std::string file;
  std::string link;
  std::string machine;
  std::string ledger;
  std::uint32_t rounds = 1;
  bool unreleased = false;
  bool read_back = false;
  bool json = false;
};

// EOBs as LF, whatever the file has.
std::string with_lf(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  tape_code::EobReader reader;
  for (const char c : text) reader.put(c, out);
  reader.finish(out);
  return out;
}

app::Result<feed::ProgramFacts> facts_of(const std::string& text, const machine::Profile& profile,
                                         const std::string& file) {
  tape_code::CharacterCheck characters(machine::characters_of(profile.line));
  characters.append(text);
  if (characters.count() > 0) {
    const tape_code::IllegalCharacter& first = characters.found().front();
    return app::fail(app::ErrorCode::invalid,
                     fmt::format("{}:{}:{}: {} ({} such)", file, first.line, first.column,
                                 machine::character_refusal(profile.line, first), characters.count()));
  }
  const bool whole_file = profile.line.link.kind == machine::LinkKind::dir;
  feed::ProgramCheck check(machine::program_syntax_of(profile, whole_file ? ir::Delivery::memory : ir::Delivery::drip));
  check.append(text);
  const auto facts = check.finish();
  if (facts) return *facts;
  return app::fail(app::ErrorCode::invalid, fmt::format("{}:{}:{}: {}", file, facts.error().line, facts.error().column,
                                                        feed::message(facts.error().fault)));
}

// The hashes of what goes out: the text as it is, the wire as the encoder makes it.
WireHashes hashes_of(const std::string& text, const machine::Profile& profile, std::uint32_t rounds) {
  if (machine::is_modbus(profile.line.link.kind))
    return {.wire_sha256 = hash::sha256_hex(text), .text_sha256 = hash::sha256_hex(text)};
  const bool whole_file = profile.line.link.kind == machine::LinkKind::dir;
  const tape_code::WireFormat format =
      whole_file ? app::drop_format(profile.line) : machine::wire_format_of(profile.line);
  WireHasher hasher(whole_file ? tape_code::DecodeFormat{.eighth_bit = format.eighth_bit, .eob = format.eob}
                               : machine::decode_format_of(profile.line));
  std::array<std::byte, 4096> wire{};
  std::array<std::uint8_t, 4096> ends{};
  for (std::uint32_t round = 0; round < rounds; ++round) {
    tape_code::SpanSource source(text);
    tape_code::WireEncoder encoder(format, source, text.size());
    auto status = tape_code::FillStatus::more;
    while (status == tape_code::FillStatus::more) {
      const auto filled = encoder.fill(wire, ends);
      for (std::size_t i = 0; i < filled.count; ++i) hasher.add(static_cast<std::uint8_t>(wire[i]));
      status = filled.status;
    }
  }
  return hasher.finish();
}

bool over(const app::LineReport& report) { return report.job == kJob && report.end != app::JobEnd::none; }

void say(app::Line& line, feed::Command command, const char* sentence) {
  fmt::print(stderr, "dripfeed: {}\n", sentence);
  if (const auto told = line.command(command); !told) fmt::print(stderr, "dripfeed: {}\n", told.error());
}

// Keeps the ledger ahead of the feed until the job is over; a signal cancels at a block end, a second one at once:
// where a control never answers there is no block end.
app::Result<app::LineReport> follow(app::Line& line, FileLedger& ledger, const app::Clock& clock, const Stops& stops,
                                    std::uint64_t reserve) {
  bool cancelled = false;
  bool aborted = false;
  app::LineReport last;
  for (;;) {
    app::LineReport report = line.report();
    const bool ended = over(report);
    const std::uint64_t window = app::reserve_window(report);
    const std::uint64_t wanted = ended || reserve >= report.handed + window / 2 ? reserve : report.handed + window;
    if (report.changes != last.changes || report.handed != last.handed || report.clocked != last.clocked ||
        wanted != reserve || ended) {
      const std::string alarm = report.machine ? app::alarm_text(*report.machine) : std::string();
      std::string note = ended ? std::string(report.cause) : std::string(report.stall);
      if (!alarm.empty()) note += note.empty() ? alarm : "; " + alarm;
      const auto written = ledger.write(clock.wall_ms(), report, wanted, note);
      if (!written) return app::fail(app::ErrorCode::unavailable, written.error());
      if (report.stall != last.stall && !report.stall.empty()) fmt::print(stderr, "dripfeed: {}\n", report.stall);
      if (!alarm.empty() && (!last.machine || last.machine->alarm != report.machine->alarm))
        fmt::print(stderr, "dripfeed: {}\n", alarm);
      reserve = wanted;
      line.extend_reserve(kJob, reserve);
    }
    last = report;
    if (ended && report.end != app::JobEnd::done) std::this_thread::sleep_for(kLeaveTaking);
    if (ended) return report;
    if (stops.first.stop_requested() && !cancelled) {
      cancelled = true;
      const bool waits = report.state == app::LineState::armed;
      say(line, waits ? feed::Command::disarm : feed::Command::cancel,
          "stopping at the end of the block; one more signal stops at once");
    }
    if (stops.second.stop_requested() && !aborted) {
      aborted = true;
      say(line, feed::Command::abort, "stopping at once");
    }
    std::this_thread::sleep_for(kRound);
  }
}

using Possible = std::expected<void, std::string>;

// The line takes what the control punches; or why it cannot.
Possible expect_punch(machine::LineSettings& line) {
  line.receive.enabled = line.receive.read_back = true;
  const auto effective = machine::effective_line(line);
  return effective ? machine::can_receive(*effective) : std::unexpected(effective.error());
}

// The operator punches what was loaded; the first program that comes is compared. What comes broken is punched again.
std::string read_back(app::Line& line, const std::string& sent, double minutes, const std::stop_token& stop) {
  fmt::print(stderr, "dripfeed: {}: punch the program at the control\n", app::kReadBackWaits);
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(minutes * 60.0);
  while (!stop.stop_requested() && std::chrono::steady_clock::now() < until) {
    for (const app::Reception& one : line.take_receptions()) {
      const receive::Transfer transfer = receive::judge(one.raw, one.ending, one.settings);
      if (transfer.fault == receive::Fault::none) return app::read_back_result(sent, transfer.text);
      if (transfer.fault != receive::Fault::empty)
        fmt::print(stderr, "dripfeed: what came is no program: {}\n", receive::message(transfer.fault));
    }
    std::this_thread::sleep_for(kRound);
  }
  return std::string(app::kReadBackExpired);
}

struct Sent {
  app::LineReport report;
  std::string read_back;  // empty: none was due
};

app::Result<Sent> transfer(const std::string& text, const feed::ProgramFacts& facts, const machine::Profile& profile,
                           const std::string& file_name, FileLedger& ledger, const Stops& stops,
                           const Options& options) {
  const auto thread = io::start_link_thread();
  auto line = app::make_line(profile.line, *thread, io::take_modbus_seat, [] {});
  if (!line) return std::unexpected(line.error());
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while ((*line)->report().state == app::LineState::disconnected && !stops.first.stop_requested()) {
    if (std::chrono::steady_clock::now() > patience)
      return app::fail(app::ErrorCode::unavailable,
                       fmt::format("{}: {}", profile.line.link.text, (*line)->report().link_error));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const std::uint64_t reserve = app::reserve_window((*line)->report());
  const auto first = ledger.write(thread->clock().wall_ms(), {}, reserve, "armed");
  if (!first) return app::fail(app::ErrorCode::unavailable, first.error());
  const auto session = static_cast<std::uint64_t>(thread->clock().wall_ms()) & 0xFFFFFFFFU;
  const auto armed = (*line)->arm({.job = kJob,
                                   .facts = facts,
                                   .source = std::make_shared<tape_code::SpanSource>(text, options.rounds),
                                   .expires_after = feed::kArmingExpiry,
                                   .reserve = reserve,
                                   .rounds = options.rounds,
                                   .session = session | 1U,
                                   .file_name = file_name});
  if (!armed) return app::fail(app::ErrorCode::refused, armed.error());
  auto report = follow(**line, ledger, thread->clock(), stops, reserve);
  if (!report) return std::unexpected(report.error());
  Sent sent{.report = *report, .read_back = {}};
  if (sent.report.end != app::JobEnd::done || !options.read_back) return sent;
  sent.read_back = read_back(**line, text, profile.line.receive.read_back_minutes, stops.first);
  const auto noted =
      ledger.write(thread->clock().wall_ms(), sent.report, sent.report.handed, "read-back " + sent.read_back);
  if (!noted) return app::fail(app::ErrorCode::unavailable, noted.error());
  return sent;
}

int send(const Options& options) {
  const Stops stops = stop_by_two_signals();
  if (!options.unreleased) {
    print_error("send feeds a text that no release stands behind; say --unreleased if that is meant");
    return kWrongUse;
  }
  const auto source = read_source(options.file);
  auto profile = read_machine_at(options.link, options.machine);
  if (!source || !profile) {
    print_error(!source ? source.error() : profile.error());
    return kWrongUse;
  }
  if (const auto receives = options.read_back ? expect_punch(profile->line) : Possible(); !receives) {
    print_error(receives.error());
    return kWrongUse;
  }
  std::string text = with_lf(source->text());
  if (machine::drops_bare_files(*profile)) text = machine::file_part(text);
  const auto facts = facts_of(text, *profile, source->name());
  if (!facts) {
    print_error(facts.error());
    return kFailed;
  }
  std::string file_name =
      machine::tells_name(profile->line) ? std::filesystem::path(source->name()).filename().string() : std::string();
  if (profile->line.link.kind == machine::LinkKind::dir) {
    auto named = machine::file_name_for(*profile, std::filesystem::path(source->name()).filename().string());
    if (!named) {
      print_error(named.error());
      return kWrongUse;
    }
    file_name = std::move(*named);
  }
  const WireHashes hashes = hashes_of(text, *profile, options.rounds);
  const std::string ledger_path =
      !options.ledger.empty() ? options.ledger : fmt::format("{}.ledger", options.file == "-" ? "stdin" : options.file);
  auto ledger =
      FileLedger::create(ledger_path, fmt::format("dripfeed ledger: text {} to {}", hashes.text_sha256, options.link));
  if (!ledger) {
    print_error(ledger.error());
    return kWrongUse;
  }
  const auto sent = transfer(text, *facts, *profile, file_name, *ledger, stops, options);
  if (!sent) {
    print_error(sent.error());
    return sent.error().code == app::ErrorCode::invalid ? kWrongUse : kFailed;
  }
  const app::LineReport& report = sent->report;
  if (options.json) fmt::print("{}", send_document(report, hashes, sent->read_back));
  if (report.end == app::JobEnd::done) {
    if (sent->read_back.empty() || sent->read_back == app::kReadBackEqual) return kDone;
    print_error(fmt::format("read-back {}", sent->read_back));
    return kFailed;
  }
  print_error(fmt::format("{}: the control may have between byte {} and {} of {}", report.cause, report.known.from,
                          report.known.to, report.total));
  return kFailed;
}

}  // namespace

void add_send(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("send", "feeds one program to a control, without a server");
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  command
      ->add_option(
          "--link", options->link,
          "serial:/dev/ttyS0?baud=9600&framing=7E2, tcp://host:port, rfc2217://host:port?baud=9600, dir:/folder, "
          "modbus-tcp://host:port/unit")
      ->required();
  command->add_option("--machine", options->machine, "machine profile: a file or the name of a preset");
  command->add_option("--ledger", options->ledger, "ledger file (default: FILE.ledger)");
  command->add_option("--rounds", options->rounds, "send it so many times, each with the control's own start")
      ->check(CLI::Range(1U, feed::kMaxRounds));
  command->add_flag("--read-back", options->read_back,
                    "then wait for the operator's punch of it, as long as the profile says, and compare");
  command->add_flag("--unreleased", options->unreleased, "feed it although no release stands behind it");
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->callback([options, &exit_code] { exit_code = send(*options); });
}

}  // namespace dripfeed::cli
