// A release moves by the table of store/releases.h; each step is a row that never changes.
#include "store/sql/release_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/event_table.h"
#include "store/sql/job_rows.h"
#include "store/sql/paging.h"
#include "store/sql/program_table.h"
#include "store/sql/user_table.h"

namespace dripfeed::sql {
namespace {

using store::Clearance;
using store::Error;
using store::ErrorCode;
using store::Id;
using store::NewRelease;
using store::Release;
using store::ReleaseMove;
using store::ReleaseState;
using store::ReleaseStep;
using store::Result;
using store::Stamp;

constexpr std::string_view kColumns =
    "id, program, revision, machine, delivery, sha256, state, transfers_allowed, transfers_done, created_by, "
    "created_at_ms, approved_by, sign_off, changed_at_ms, restart_of, restart_line";
constexpr std::string_view kInsert =
    "INSERT INTO text_release (program, revision, sha256, machine, delivery, state, transfers_allowed, transfers_done, "
    "created_by, created_at_ms, approved_by, sign_off, changed_at_ms, restart_of, restart_line) VALUES (?, ?, ?, ?, ?, "
    "'draft', 0, 0, ?, ?, '', '', ?, ?, ?)";
constexpr std::string_view kUpdate =
    "UPDATE text_release SET state = ?, transfers_allowed = ?, transfers_done = ?, approved_by = ?, sign_off = ?, "
    "changed_at_ms = ? WHERE id = ?";
constexpr std::string_view kStep =
    "INSERT INTO release_step (text_release, n, from_state, to_state, actor, note, at_ms) VALUES "
    "(?, 1 + (SELECT count(*) FROM release_step WHERE text_release = ?), ?, ?, ?, ?, ?)";

Release read_release(Query& query) {
  Release release;
  release.id = query.number();
  release.of.program = query.number();
  release.of.revision = query.number();
  release.of.machine = query.text();
  release.of.delivery = query.value<store::Delivery>();
  release.text_sha256 = query.text();
  release.state = query.value<ReleaseState>();
  release.transfers_allowed = query.number();
  release.transfers_done = query.number();
  release.created_by = query.text();
  release.created_at_ms = query.signed_number();
  release.approved_by = query.text();
  release.sign_off = query.text();
  release.changed_at_ms = query.signed_number();
  release.of.restart.release = query.number();
  release.of.restart.line = query.number();
  return release;
}

std::string subject_of(Id release) { return fmt::format("release/{}", release); }

// Who wrote the revision or drew up the release is no second pair of eyes.
Result<void> refuse_own_eyes(Session& session, const Release& release, const Stamp& by) {
  if (!needs_four_eyes(session, release.of.machine)) return {};
  if (by.actor == release.created_by) return session.refuse(ErrorCode::four_eyes, by.actor + " made the release");
  if (wrote_text(session, release.text_sha256, by.actor))
    return session.refuse(ErrorCode::four_eyes, by.actor + " wrote the text");
  return {};
}

void log_event(Session& session, const Release& release, std::string_view word, std::string_view note,
               const Stamp& by) {
  add_event_row(session,
                {.topic = store::EventTopic::release,
                 .word = std::string(word),
                 .subject = release.id,
                 .machine = release.of.machine,
                 .program = release.of.program,
                 .revision = release.of.revision,
                 .text = std::string(note)},
                by);
}

// A sign-off is a step from proving to proving. It counts for the proving in which it was made: one that begins
// again has none.
void add_proof(Session& session, Release& release) {
  if (release.transfers_done == 0) return;  // nothing was there to sign off
  Query step(session,
             "SELECT from_state, to_state, actor, note FROM release_step WHERE text_release = ? ORDER BY n DESC",
             release.id);
  while (step.next()) {
    const auto from = step.value<ReleaseState>();
    const auto to = step.value<ReleaseState>();
    if (to == ReleaseState::approved || to == ReleaseState::obsolete) continue;
    if (from != ReleaseState::proving || to != ReleaseState::proving) return;  // it began, or was sent back
    release.proved_by = step.text();
    release.proof = step.text();
    return;
  }
}

// Whether a transfer of it has ended well since its proving began.
bool was_transferred(Session& session, Id release) {
  Query query(session,
              "SELECT 1 FROM job WHERE text_release = ? AND state = 'done' AND started_at_ms >= (SELECT coalesce("
              "max(at_ms), 0) FROM release_step WHERE text_release = ? AND to_state = 'proving' AND from_state <> "
              "'proving') LIMIT 1",
              release, release);
  return query.next();
}

std::string select_where(std::string_view rest) {
  return fmt::format("SELECT {} FROM text_release WHERE {}", kColumns, rest);
}

}  // namespace

Result<Release> ReleaseTable::add(const NewRelease& release, const Stamp& by) {
  return database_.write("release", [&](Session& session) -> Result<Release> {
    const auto sha256 = text_of_revision(session, release.program, release.revision);
    if (!sha256) return std::unexpected(sha256.error());
    if (auto usable = refuse_archived(session, release.program); !usable) return std::unexpected(usable.error());
    if (auto begun = refuse_restart_of(session, release); !begun) return std::unexpected(begun.error());
    note_program_change(session, release.program);
    session.run(kInsert, release.program, release.revision, *sha256, release.machine, release.delivery, by.actor,
                by.at_ms, by.at_ms, NumberOrNull{release.restart.release}, release.restart.line);
    const Id id = session.last_id();
    add_audit_row(session,
                  {.action = "release.add",
                   .subject = subject_of(id),
                   .detail = fmt::format("text {} for {} by {}{}", *sha256, release.machine,
                                         store::name_of(release.delivery), store::words_of(release.restart))},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    auto added = get(id);
    if (added) log_event(session, *added, store::name_of(added->state), {}, by);
    return added;
  });
}

Result<void> ReleaseTable::refuse_restart_of(Session& session, const NewRelease& release) {
  if (!release.restart.is_one()) return {};
  const auto of = get(release.restart.release);
  if (!of) return session.refuse(ErrorCode::broken_reference, subject_of(release.restart.release));
  const bool released = of->state == ReleaseState::proving || of->state == ReleaseState::approved;
  if (!released || of->of.machine != release.machine || of->of.delivery != release.delivery)
    return session.refuse(ErrorCode::broken_reference,
                          fmt::format("{} is not released for this machine and delivery", subject_of(of->id)));
  return {};
}

Result<void> ReleaseTable::check(const Release& release, const ReleaseMove& move, std::int64_t now_ms) {
  const auto refuse = [&](ErrorCode code, std::string detail) {
    return std::unexpected(Error{code, std::move(detail)});
  };
  const auto rows = store::release_transitions();
  const auto row = std::ranges::find_if(rows, [&](const store::ReleaseTransition& transition) {
    return transition.from == release.state && transition.to == move.to;
  });
  if (row == rows.end()) {
    return refuse(ErrorCode::refused_transition,
                  fmt::format("{} to {}", store::name_of(release.state), store::name_of(move.to)));
  }
  if (release.of.restart.is_one() && move.to == ReleaseState::approved)
    return refuse(ErrorCode::refused_transition, "a restart is released for one transfer, by its proving");
  if (release.of.restart.is_one() && move.to == ReleaseState::proving) {
    if (move.transfers != 1) return refuse(ErrorCode::invalid_value, "a restart is released for one transfer");
    if (move.shown_sha256 != release.text_sha256)
      return refuse(ErrorCode::invalid_value, "the text that was shown is not that of the restart");
  }
  if (row->needs_transfers && move.transfers == 0) {
    return refuse(ErrorCode::invalid_value, "proving needs at least one transfer");
  }
  if (row->needs_sign_off && move.note.empty()) return refuse(ErrorCode::sign_off_missing, subject_of(release.id));
  if (row->needs_verdict) {
    const auto verdict = clearing_verdict(release, now_ms);
    if (!verdict) return std::unexpected(verdict.error());
    if (verdict->stale) return refuse(ErrorCode::verdict_stale, fmt::format("verdict {}", verdict->id));
  }
  return {};
}

Result<Release> ReleaseTable::move(Id release, const ReleaseMove& move, const Stamp& by) {
  return database_.write(subject_of(release), [&](Session& session) -> Result<Release> {
    auto moved = get(release);
    if (!moved) return moved;
    if (auto fits = check(*moved, move, by.at_ms); !fits) return std::unexpected(fits.error());
    const bool shown = moved->of.restart.is_one() && move.to == ReleaseState::proving;
    if (move.to == ReleaseState::approved && moved->proved_by.empty() &&
        needs_operator_sign_off(session, moved->of.machine))
      return session.refuse(ErrorCode::not_signed_off, subject_of(release));
    if (move.to == ReleaseState::proving || move.to == ReleaseState::approved) {
      if (auto other = refuse_own_eyes(session, *moved, by); !other) return std::unexpected(other.error());
    }
    const bool stays = move.to == ReleaseState::proving || move.to == ReleaseState::approved;
    if (auto free = stays ? Result<void>() : refuse_armed(session, "text_release", release); !free)
      return std::unexpected(free.error());
    const ReleaseState from = moved->state;
    moved->state = move.to;
    moved->changed_at_ms = by.at_ms;
    if (move.to == ReleaseState::proving) {
      moved->transfers_allowed = move.transfers;
      moved->transfers_done = 0;
      moved->proved_by.clear();
      moved->proof.clear();
    }
    if (shown) {
      moved->approved_by = by.actor;
      moved->sign_off = move.note;
    }
    if (move.to == ReleaseState::approved) {
      moved->approved_by = by.actor;
      moved->sign_off = move.note;
    }
    session.run(kUpdate, moved->state, moved->transfers_allowed, moved->transfers_done, moved->approved_by,
                moved->sign_off, moved->changed_at_ms, release);
    session.run(kStep, release, release, from, move.to, by.actor, move.note, by.at_ms);
    add_audit_row(session,
                  {.action = "release.move",
                   .subject = subject_of(release),
                   .detail = fmt::format("{} to {}: {}{}", store::name_of(from), store::name_of(move.to), move.note,
                                         shown ? " (shown: " + move.shown_sha256 + ")" : "")},
                  by);
    log_event(session, *moved, store::name_of(moved->state), move.note, by);
    return moved;
  });
}

Result<Release> ReleaseTable::sign_off(Id release, std::string_view note, const Stamp& by) {
  return database_.write(subject_of(release), [&](Session& session) -> Result<Release> {
    auto signed_off = get(release);
    if (!signed_off) return signed_off;
    if (signed_off->state != ReleaseState::proving)
      return session.refuse(ErrorCode::refused_transition,
                            fmt::format("it is {}: a proving is signed off", store::name_of(signed_off->state)));
    if (signed_off->of.restart.is_one())
      return session.refuse(ErrorCode::refused_transition, "a restart is released for one transfer, by its proving");
    if (note.empty()) return session.refuse(ErrorCode::sign_off_missing, subject_of(release));
    if (!was_transferred(session, release)) return session.refuse(ErrorCode::not_proved, subject_of(release));
    signed_off->proved_by = by.actor;
    signed_off->proof = note;
    session.run(kStep, release, release, ReleaseState::proving, ReleaseState::proving, by.actor, note, by.at_ms);
    add_audit_row(session, {.action = "release.sign-off", .subject = subject_of(release), .detail = std::string(note)},
                  by);
    log_event(session, *signed_off, store::kReleaseSignedOff, note, by);
    if (!session.ok()) return std::unexpected(session.error());
    return signed_off;
  });
}

Result<Release> ReleaseTable::get(Id release) {
  return database_.read(subject_of(release), [&](Session& session) -> Result<Release> {
    static const std::string kSql = select_where("id = ?");
    Query query(session, kSql, release);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    Release found = read_release(query);
    add_proof(session, found);
    return found;
  });
}

Result<store::Page<Release>> ReleaseTable::list(const store::PageRequest& page, const store::ReleaseFilter& filter) {
  return database_.read("releases", [&](Session& session) -> Result<store::Page<Release>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const std::string sql = select_where(fmt::format("{} AND {} AND id < ? ORDER BY id DESC LIMIT ?",
                                                     filter.program == 0 ? "? = 0" : "program = ?",
                                                     filter.machine.empty() ? "? = ''" : "machine = ?"));
    Query query(session, sql, filter.program, filter.machine, from->after, from->rows);
    auto found =
        collect(query, page, read_release, [](const Release& release) { return fmt::format("{}", release.id); });
    for (Release& release : found.items) add_proof(session, release);
    return found;
  });
}

Result<std::vector<ReleaseStep>> ReleaseTable::history(Id release) {
  return database_.read(subject_of(release), [&](Session& session) -> Result<std::vector<ReleaseStep>> {
    if (const auto known = get(release); !known) return std::unexpected(known.error());
    std::vector<ReleaseStep> steps;
    Query query(session,
                "SELECT from_state, to_state, actor, note, at_ms FROM release_step WHERE text_release = ? ORDER BY n",
                release);
    while (query.next()) {
      ReleaseStep step;
      step.from = query.value<ReleaseState>();
      step.to = query.value<ReleaseState>();
      step.actor = query.text();
      step.note = query.text();
      step.at_ms = query.signed_number();
      steps.push_back(std::move(step));
    }
    return steps;
  });
}

Result<store::Verdict> ReleaseTable::clearing_verdict(const Release& release, std::int64_t now_ms) {
  auto verdict = verdicts_.newest(release.text_sha256, release.of.machine, release.of.delivery);
  if (!verdict) return std::unexpected(verdict.error());
  if (!*verdict) return std::unexpected(Error{ErrorCode::no_verdict, subject_of(release.id)});
  if (!store::clears(**verdict, now_ms)) {
    return std::unexpected(Error{ErrorCode::verdict_not_passed, fmt::format("verdict {}: {}", (*verdict)->id,
                                                                            store::why_not_clear(**verdict, now_ms))});
  }
  return std::move(**verdict);
}

Result<Clearance> ReleaseTable::clearance_of(const Release& release, std::int64_t now_ms) {
  const bool proving = release.state == ReleaseState::proving;
  if (!proving && release.state != ReleaseState::approved) {
    return std::unexpected(
        Error{ErrorCode::not_released, fmt::format("release {} is {}", release.id, store::name_of(release.state))});
  }
  if (proving && release.transfers_done >= release.transfers_allowed) {
    return std::unexpected(Error{ErrorCode::transfers_used_up,
                                 fmt::format("{} of {}", release.transfers_done, release.transfers_allowed)});
  }
  auto verdict = clearing_verdict(release, now_ms);
  if (!verdict) return std::unexpected(verdict.error());
  return Clearance{release, std::move(*verdict)};
}

Result<Clearance> ReleaseTable::released_for(std::string_view text_sha256, std::string_view machine,
                                             store::Delivery delivery, std::int64_t now_ms) {
  return database_.read("release", [&](Session& session) -> Result<Clearance> {
    static const std::string kSql = select_where("sha256 = ? AND machine = ? AND delivery = ? AND state <> 'obsolete'");
    Query query(session, kSql, text_sha256, machine, delivery);
    if (!query.next()) {
      return session.refuse(ErrorCode::not_released, fmt::format("text {} on {}", text_sha256, machine));
    }
    return clearance_of(read_release(query), now_ms);
  });
}

void ReleaseTable::count_transfer(Session& session, Id release) {
  session.run("UPDATE text_release SET transfers_done = transfers_done + 1 WHERE id = ? AND state = 'proving'",
              release);
}

}  // namespace dripfeed::sql
