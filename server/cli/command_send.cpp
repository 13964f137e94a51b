// dripfeed send: one transfer without a server, with its own ledger file. It takes texts that no one checked or
// released, so it requires the option that states that this is meant.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "protocol/tape_code/character_set.h"
#include "server/app/lines/folder_line.h"
#include "server/app/receive/read_back.h"
#include "server/cli/claimed_line.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/file_ledger.h"
#include "server/cli/inputs.h"
#include "server/cli/logging.h"
#include "server/cli/output.h"
#include "server/cli/signals.h"
#include "server/cli/transfer.h"
#include "server/cli/wire_hashes.h"
#include "server/io/io.h"
#include "server/machine/file_drop.h"
#include "server/machine/line_protocol.h"

namespace dripfeed::cli {

namespace {

struct SendOptions {
  std::string file;
  std::string link;
  std::string machine;
  std::string ledger;
  std::optional<std::string> confirmed_reset;
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
      whole_file ? app::folder_format(profile.line) : machine::wire_format_of(profile.line);
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

using Possible = std::expected<void, std::string>;
using Named = std::expected<std::string, std::string>;

// The line takes what the control punches; or why it cannot.
Possible expect_punch(machine::LineSettings& line) {
  line.receive.enabled = line.receive.read_back = true;
  const auto effective = machine::effective_line(line);
  return effective ? machine::can_receive(*effective) : std::unexpected(effective.error());
}

// The name under which the control gets the text: of the file, where the link or its protocol has names.
Named file_name_of(const machine::Profile& profile, const std::string& source_name) {
  std::string name = std::filesystem::path(source_name).filename().string();
  if (profile.line.link.kind == machine::LinkKind::dir) return machine::file_name_for(profile, name);
  return machine::sends_name(profile.line) ? name : std::string();
}

int report_end(const Transferred& sent, const WireHashes& hashes, const SendOptions& options,
               const machine::LinkUrl& link) {
  const app::LineReport& report = sent.report;
  int exit_code = kDone;
  if (report.end != app::JobEnd::done) {
    exit_code = kFailed;
    say(fmt::format("{}: the control may have between byte {} and {} of {}", report.cause, report.known.from,
                    report.known.to, report.total));
  } else if (!sent.read_back.empty() && sent.read_back != app::kReadBackEqual) {
    exit_code = kFailed;
    say(fmt::format("read-back {}", sent.read_back));
  }
  if (!sent.fault.empty()) {
    exit_code = sent.torn ? kTorn : kFailed;
    say(sent.fault);
  }
  if (!options.json) return exit_code;
  const auto record = io::look_at_line(link);
  const std::string document = send_document(report, hashes, sent.read_back, record ? *record : io::LineRecord{});
  return write_output("-", document) ? exit_code : std::max(exit_code, kFailed);
}

void report_refusal(const LineRefusal& refusal, const SendOptions& options, const machine::LinkUrl& link) {
  print_error(refusal.sentence);
  if (!options.json || refusal.exit_code != kTorn) return;
  if (const auto record = io::look_at_line(link)) write_output("-", torn_document(*record));
}

int send(const SendOptions& options) {
  const Stops stops = stop_by_two_signals();
  const Logging logging;
  if (!options.unreleased) {
    print_error("send feeds a text without a release; pass --unreleased if that is meant");
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
  const auto file_name = file_name_of(*profile, source->name());
  if (!file_name) {
    print_error(file_name.error());
    return kWrongUse;
  }
  const machine::LinkUrl& link = profile->line.link;
  const auto claim = take_line(link, options.confirmed_reset);
  if (!claim) {
    report_refusal(claim.error(), options, link);
    return claim.error().exit_code;
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
  const auto sent = transfer({.text = text,
                              .facts = *facts,
                              .profile = *profile,
                              .name = source->name(),
                              .file_name = *file_name,
                              .rounds = options.rounds,
                              .read_back = options.read_back},
                             *ledger, **claim, stops);
  if (!sent) {
    print_error(sent.error());
    if (!(*claim)->torn().empty()) return kTorn;
    return sent.error().code == app::ErrorCode::invalid ? kWrongUse : kFailed;
  }
  return report_end(*sent, hashes, options, link);
}

}  // namespace

void add_send(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("send", "feeds one program to a control, without a server");
  const auto options = std::make_shared<SendOptions>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  command
      ->add_option("--link", options->link,
                   "serial:/dev/serial/by-id/NAME?baud=9600&framing=7E2, tcp://host:port, "
                   "rfc2217://host:port?baud=9600, dir:/folder, "
                   "modbus-tcp://host:port/unit")
      ->required();
  command->add_option("--machine", options->machine, "machine profile: a file or the name of a preset");
  command->add_option("--ledger", options->ledger, "ledger file (default: FILE.ledger)");
  command->add_option("--rounds", options->rounds, "how often it is sent, each time with the control's own start")
      ->check(CLI::Range(1U, feed::kMaxRounds));
  command->add_flag("--read-back", options->read_back,
                    "then wait for the operator's punch of it, as long as the profile states, and compare");
  command->add_flag("--unreleased", options->unreleased, "feed it although it has no release");
  add_confirm_reset(*command, options->confirmed_reset);
  command->footer(kExitCodes);
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->callback([options, &exit_code] { exit_code = send(*options); });
}

}  // namespace dripfeed::cli
