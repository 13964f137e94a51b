// Rounds on a thread of its own: a request may arm a job, and arming waits for the store.
#include "server/app/receive/receiving.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "protocol/receive/program_name.h"
#include "server/app/base/text_difference.h"
#include "server/app/library/stored_program.h"

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kRound{250};
constexpr std::uint64_t kLongestCompared = receive::Settings::kMaxBytes;

std::string bytes_of(const Reception& reception) {
  std::string bytes;
  bytes.reserve(reception.raw.size());
  for (const std::byte byte : reception.raw) bytes += static_cast<char>(byte);
  return bytes;
}

// "R20261122-113000", for a program that gives itself no name.
std::string name_by_time(std::int64_t wall_ms) {
  const std::chrono::sys_time<std::chrono::milliseconds> at{std::chrono::milliseconds(wall_ms)};
  const auto day = std::chrono::floor<std::chrono::days>(at);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss time(std::chrono::floor<std::chrono::seconds>(at - day));
  return fmt::format("R{:04}{:02}{:02}-{:02}{:02}{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), time.hours().count(),
                     time.minutes().count(), time.seconds().count());
}

}  // namespace

Receiving::Receiving(const Parts& parts)
    : store_(parts.store),
      lines_(parts.lines),
      jobs_(parts.jobs),
      programs_(parts.programs),
      events_(parts.events),
      alarms_(parts.alarms),
      clock_(parts.clock),
      documents_(parts.documents),
      thread_("receiving", kRound, Urgency::usual, [this] { round(); }) {}

Receiving::~Receiving() { stop(); }

void Receiving::round() {
  const std::lock_guard lock(round_mutex_);
  for (const std::string& machine : lines_.machines()) {
    const auto line = lines_.find(machine);  // one line at a time: work for one holds no other
    if (!line) continue;
    expect_read_back(machine, line->report());
    for (const Reception& reception : line->take_receptions()) {
      const auto profile = profile_of(machine);
      if (profile) {
        take(machine, *profile, reception);
      } else {
        spdlog::error("{}: {}", machine, profile.error().text);
      }
    }
    if (const auto ring = line->take_ring()) {
      const auto profile = profile_of(machine);
      if (profile) {
        handle_ring(machine, *profile, *ring, *line);
      } else {
        spdlog::error("{}: {}", machine, profile.error().text);
      }
    }
    expire_read_backs(machine);
    send_due(machine, *line);
  }
}

Result<machine::Profile> Receiving::profile_of(const std::string& machine) {
  const auto row = lift(store_.machines().get(machine));
  if (!row) return std::unexpected(row.error());
  auto profile = documents_.read_profile(row->profile);
  if (!profile) return profile;
  auto line = machine::effective_line(profile->line);  // the URL may say how the control starts
  if (!line) return fail(ErrorCode::refused, line.error());
  profile->line = std::move(*line);
  return profile;
}

store::Stamp Receiving::stamp(std::string_view actor) const { return {std::string(actor), clock_.wall_ms()}; }

void Receiving::alarm(const std::string& machine, AlarmKind kind, std::string text, store::Id job) {
  alarms_.raise(machine, kind, std::move(text), job);
}

void Receiving::record(const std::string& machine, std::string text) {
  spdlog::info("{}: {}", machine, text);
  events_.publish({.id = 0,
                   .kind = EventKind::receipt,
                   .machine = machine,
                   .job = {},
                   .verdict = 0,
                   .outcome = {},
                   .text = std::move(text)});
}

void Receiving::take(const std::string& machine, const machine::Profile& profile, const Reception& reception) {
  const receive::Transfer transfer = receive::judge(reception.raw, reception.ending, reception.settings);
  switch (transfer.fault) {
    case receive::Fault::none: break;
    case receive::Fault::empty: return;
    case receive::Fault::device_text:
      // It may say so at each new connection: one receipt is enough.
      if (waiting_[machine].device == transfer.device) return;
      waiting_[machine].device = transfer.device;
      alarm(machine, AlarmKind::device_text,
            fmt::format("the device server reports \"{}\": that is not a program", transfer.device));
      return quarantine(machine, reception, transfer);
    case receive::Fault::too_long:
    case receive::Fault::link_lost:
    case receive::Fault::parity:
    case receive::Fault::binary:
    case receive::Fault::interrupted:
    case receive::Fault::no_start:
    case receive::Fault::no_end:
    case receive::Fault::flow_taken: return quarantine(machine, reception, transfer);
  }
  waiting_[machine].device.clear();
  if (profile.line.receive.requests) {
    const auto request = receive::find_request(transfer.text, machine::request_grammar_of(profile.line.receive));
    if (request && request->verb == receive::Verb::save && request->legal && !request->argument.empty()) {
      handle(machine, profile, *request, transfer.text);
      return keep(machine, reception, transfer, transfer.text, request->argument);
    }
    if (request && request->verb != receive::Verb::save) return handle(machine, profile, *request, transfer.text);
  }
  for (const std::string& program : receive::split_programs(transfer.text)) {
    if (compare_read_back(machine, program)) continue;
    keep(machine, reception, transfer, program, "");
  }
}

void Receiving::quarantine(const std::string& machine, const Reception& reception, const receive::Transfer& transfer) {
  const auto content = store_.contents().put(bytes_of(reception));
  if (!content)
    return alarm(machine, AlarmKind::reception_lost,
                 "a broken reception is lost: " + store::message_of(content.error()));
  const auto name = receive::find_name(transfer.text);
  std::string reason(receive::message(transfer.fault));
  if (transfer.first_parity_error) {
    reason +=
        fmt::format(" ({}, the first at byte {})", transfer.parity_errors, transfer.first_parity_error->wire_offset);
  }
  if (!transfer.device.empty()) reason += fmt::format(" (\"{}\")", transfer.device);
  const auto receipt = store_.receipts().add({.machine = machine,
                                              .name = name ? name->name : name_by_time(clock_.wall_ms()),
                                              .style = std::string(name ? receive::name(name->style) : "time"),
                                              .sha256 = content->sha256,
                                              .raw_bytes = reception.raw.size(),
                                              .code = std::string(receive::name(transfer.code)),
                                              .ended_by = std::string(receive::name(reception.ending.by)),
                                              .quarantined = true,
                                              .reason = reason},
                                             stamp(machine));
  if (!receipt)
    return alarm(machine, AlarmKind::reception_lost,
                 "a broken reception is lost: " + store::message_of(receipt.error()));
  // The alarm names no receipt, so that those of a line that chatters fold.
  alarm(machine, AlarmKind::quarantined,
        fmt::format("what the control sent is in quarantine: {}", receive::message(transfer.fault)));
  record(machine, fmt::format("receipt {} is in quarantine: {}", receipt->id, reason));
}

void Receiving::keep(const std::string& machine, const Reception& reception, const receive::Transfer& transfer,
                     std::string_view text, std::string_view given) {
  const auto content = store_.contents().put(text);
  if (!content)
    return alarm(machine, AlarmKind::reception_lost,
                 "a received program is lost: " + store::message_of(content.error()));
  const auto found = receive::find_name(text);
  std::string name(given);
  if (name.empty()) name = found ? found->name : name_by_time(clock_.wall_ms());
  const auto receipt = store_.receipts().add({.machine = machine,
                                              .name = name,
                                              .style = std::string(found ? receive::name(found->style) : "time"),
                                              .sha256 = content->sha256,
                                              .raw_bytes = reception.raw.size(),
                                              .code = std::string(receive::name(transfer.code)),
                                              .ended_by = std::string(receive::name(reception.ending.by)),
                                              .quarantined = false,
                                              .reason = {}},
                                             stamp(machine));
  if (!receipt)
    return alarm(machine, AlarmKind::reception_lost,
                 "a received program is lost: " + store::message_of(receipt.error()));
  record(machine, fmt::format("received {} ({} bytes), receipt {}", name, text.size(), receipt->id));
}

// --- what people decide
// -----------------------------------------------------------------------------------------------------------------

Result<std::string> Receiving::readable(const store::Receipt& receipt) {
  auto stored = lift(store::read_whole(store_.contents(), receipt.of.sha256, kLongestCompared));
  if (!stored || !receipt.of.quarantined) return stored;
  const auto profile = profile_of(receipt.of.machine);
  if (!profile) return std::unexpected(profile.error());
  const auto code = receive::text_code(receipt.of.code);
  if (!code) return fail(ErrorCode::internal, fmt::format("receipt {} has no code", receipt.id));
  return receive::read_as(*code, std::as_bytes(std::span(*stored)), machine::receive_settings_of(profile->line));
}

Result<store::Receipt> Receiving::accept(store::Id receipt, const AcceptOrder& order, std::string_view actor) {
  const auto row = lift(store_.receipts().get(receipt));
  if (!row) return std::unexpected(row.error());
  if (row->of.quarantined && order.reason.empty())
    return fail(ErrorCode::invalid, "a receipt in quarantine is taken for a program with a reason only",
                {{.pointer = "/reason", .text = "a reason"}});
  const auto text = readable(*row);
  if (!text) return std::unexpected(text.error());
  if (text->find_first_not_of("\n ") == std::string::npos)
    return fail(ErrorCode::refused, "nothing of it can be read: punch it again, or discard it");
  const auto profile = profile_of(row->of.machine);
  if (!profile) return std::unexpected(profile.error());
  const auto kept = programs_.keep_text(profile->control.dialect, *text);
  if (!kept) return std::unexpected(kept.error());
  // The revision and the decision are one: a receipt that was decided meanwhile adds none.
  Result<store::Receipt> accepted = fail(ErrorCode::internal, "");
  const auto done = store_.atomically([&]() -> store::Result<void> {
    Result<store::Program> program = fail(ErrorCode::internal, "");
    if (order.program == 0) {
      program = programs_.add(order.name.empty() ? row->of.name : order.name, profile->control.dialect, *kept, actor);
    } else {
      const auto known = store_.programs().get(order.program);
      if (!known) return std::unexpected(known.error());
      const store::Revision expected = order.revision == 0 ? known->newest.revision : order.revision;
      program = programs_.add_revision(order.program, expected, *kept, actor);
    }
    if (!program) {
      accepted = std::unexpected(program.error());
      return std::unexpected(store::Error{store::ErrorCode::invalid_value, program.error().text});
    }
    auto moved = store_.receipts().accept(receipt, program->id, program->newest.revision, order.reason, stamp(actor));
    if (!moved) return std::unexpected(moved.error());
    accepted = std::move(*moved);
    return {};
  });
  if (!done && (accepted || accepted.error().code == ErrorCode::internal))
    return std::unexpected(from_store(done.error()));
  return accepted;
}

Result<store::Receipt> Receiving::discard(store::Id receipt, std::string_view reason, std::string_view actor) {
  if (reason.empty())
    return fail(ErrorCode::invalid, "a reason is needed", {{.pointer = "/reason", .text = "a reason"}});
  return lift(store_.receipts().discard(receipt, reason, stamp(actor)));
}

Result<std::optional<StoredLikeness>> Receiving::likeness(const store::Receipt& receipt) {
  const auto known = stored_program(store_, receipt.of.name);
  if (!known) return std::unexpected(known.error());
  if (!*known) return std::nullopt;
  const store::ProgramRevision& newest = (*known)->newest;
  StoredLikeness likeness{.program = newest.program, .revision = newest.revision, .same = true, .difference = {}};
  if (newest.sha256 == receipt.of.sha256) return likeness;
  const auto stored = lift(store::read_whole(store_.contents(), newest.sha256, kLongestCompared));
  const auto received = lift(store::read_whole(store_.contents(), receipt.of.sha256, kLongestCompared));
  if (!stored || !received) return std::nullopt;  // too long to be compared here
  const auto difference = first_difference(*stored, *received);
  likeness.same = !difference;
  if (difference) likeness.difference = sentence_of(*difference);
  return likeness;
}

}  // namespace dripfeed::app
