// The table program says which revision is the newest; program_revision has them all.
#include "store/sql/program_table.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "store/sql/audit_table.h"
#include "store/sql/event_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Id;
using store::NewProgramText;
using store::Program;
using store::ProgramRevision;
using store::Result;
using store::Revision;
using store::Stamp;

constexpr std::string_view kRevisionColumns =
    "r.program, r.revision, r.sha256, c.bytes, r.places_sha256, r.blocks, r.facts, coalesce(r.origin, 'uploaded'), "
    "r.family, "
    "r.family_revision, r.part, r.part_revision, r.part_values, r.machine, r.machine_revision, r.mode, r.actor, "
    "r.at_ms";

ProgramRevision read_revision(Query& query) {
  ProgramRevision read;
  read.program = query.number();
  read.revision = query.number();
  read.sha256 = query.text();
  read.bytes = query.number();
  read.places_sha256 = query.text();
  read.blocks = query.number();
  read.facts = query.text();
  read.origin.kind = query.value<store::OriginKind>();
  read.origin.family = query.text();
  read.origin.family_revision = query.number();
  read.origin.part = query.text();
  read.origin.part_revision = query.number();
  read.origin.values = query.text();
  read.origin.machine = query.text();
  read.origin.machine_revision = query.number();
  read.origin.mode = query.text();
  read.created_by = query.text();
  read.created_at_ms = query.signed_number();
  return read;
}

// Tags come in one text, a line each.
std::vector<std::string> read_tags(std::string_view lines) {
  std::vector<std::string> tags;
  while (!lines.empty()) {
    const std::string_view tag = lines.substr(0, lines.find('\n'));
    tags.emplace_back(tag);
    lines.remove_prefix(std::min(lines.size(), tag.size() + 1));
  }
  std::ranges::sort(tags);
  return tags;
}

Program read_program(Query& query) {
  Program program;
  program.name = query.text();
  program.dialect = query.text();
  program.folder = query.text();
  program.archived.at_ms = query.signed_number();
  program.archived.by = query.text();
  program.archived.reason = query.text();
  program.deleted.at_ms = query.signed_number();
  program.deleted.by = query.text();
  program.deleted.reason = query.text();
  program.id = query.number();
  program.change = query.number();
  program.tags = read_tags(query.text());
  program.newest = read_revision(query);
  program.newest.program = program.id;
  return program;
}

std::string newest_where(std::string_view rest) {
  return fmt::format(
      "SELECT p.name, p.dialect, p.folder, p.archived_at_ms, p.archived_by, p.archive_reason, "
      "p.deleted_at_ms, p.deleted_by, p.delete_reason, p.id, p.change_number, "
      "(SELECT group_concat(t.tag, '\n') FROM program_tag t WHERE t.program = p.id), {} FROM program p LEFT JOIN "
      "program_revision r ON r.program = p.id AND r.revision = "
      "p.revision "
      "LEFT JOIN content c ON c.sha256 = r.sha256 WHERE {}",
      kRevisionColumns, rest);
}

std::string revisions_where(std::string_view rest) {
  return fmt::format("SELECT {} FROM program_revision r JOIN content c ON c.sha256 = r.sha256 WHERE {}",
                     kRevisionColumns, rest);
}

// A pattern of LIKE for what begins so when its ASCII letters are small ones: people who name folders do not
// distinguish their case.
std::string beginning_with(std::string_view text) {
  std::string pattern;
  for (const char c : text) {
    if (c == '%' || c == '_' || c == '\\') pattern += '\\';
    pattern += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return pattern + '%';
}

std::string subject_of(Id program) { return fmt::format("program/{}", program); }

void write_revision(Session& session, Id program, Revision revision, const NewProgramText& text, const Stamp& by,
                    std::string_view action) {
  const store::Origin& origin = text.origin;
  session.run(
      "INSERT INTO program_revision (program, revision, sha256, places_sha256, blocks, facts, origin, family, "
      "family_revision, part, part_revision, part_values, machine, machine_revision, mode, actor, at_ms) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      program, revision, text.sha256, OrNull{text.places_sha256}, text.blocks, text.facts, origin.kind,
      OrNull{origin.family}, NumberOrNull{origin.family_revision}, OrNull{origin.part},
      NumberOrNull{origin.part_revision}, origin.values, OrNull{origin.machine}, NumberOrNull{origin.machine_revision},
      origin.mode, by.actor, by.at_ms);
  add_audit_row(session,
                {.action = std::string(action),
                 .subject = subject_of(program),
                 .detail = fmt::format("revision {} sha256 {} {}", revision, text.sha256, store::name_of(origin.kind))},
                by);
}

// `word`: one of store::kProgramEvents. The program as it is now.
Result<Program> with_event(Session& session, Result<Program> program, std::string_view word, const Stamp& by) {
  if (!program) return program;
  add_event_row(session,
                {.topic = store::EventTopic::program,
                 .word = std::string(word),
                 .subject = program->id,
                 .machine = program->newest.origin.machine,
                 .program = program->id,
                 .revision = program->newest.revision,
                 .text = program->name},
                by);
  return program;
}

}  // namespace

Result<Program> ProgramTable::add(std::string_view name, std::string_view dialect, const NewProgramText& text,
                                  const Stamp& by) {
  return database_.write("program", [&](Session& session) -> Result<Program> {
    if (name.empty()) return session.refuse(ErrorCode::invalid_value, "a program needs a name");
    session.run("INSERT INTO program (name, dialect, revision) VALUES (?, ?, 1)", name, dialect);
    const Id program = session.last_id();
    note_program_change(session, program);
    write_revision(session, program, 1, text, by, "program.add");
    if (!session.ok()) return std::unexpected(session.error());
    return with_event(session, get(program), "added", by);
  });
}

Result<Program> ProgramTable::add_revision(Id program, Revision expected, const NewProgramText& text, const Stamp& by) {
  return database_.write(subject_of(program), [&](Session& session) -> Result<Program> {
    const auto old = get(program);
    if (!old) return old;
    if (old->newest.revision != expected) return session.refuse(ErrorCode::stale_revision);
    if (old->is_archived()) return session.refuse(ErrorCode::refused_transition, "the program is archived");
    session.run("UPDATE program SET revision = ? WHERE id = ?", expected + 1, program);
    note_program_change(session, program);
    write_revision(session, program, expected + 1, text, by, "program.change");
    if (!session.ok()) return std::unexpected(session.error());
    return with_event(session, get(program), "revised", by);
  });
}

namespace {

void write_tags(Session& session, Id program, const std::vector<std::string>& tags) {
  session.run("DELETE FROM program_tag WHERE program = ?", program);
  for (const std::string& tag : tags)
    session.run("INSERT INTO program_tag (program, tag) VALUES (?, ?) ON CONFLICT DO NOTHING", program, tag);
}

// What keeps a program from being archived; "" where nothing does.
std::string in_work(Session& session, Id program) {
  {
    Query job(session,
              "SELECT id FROM job WHERE program = ? AND state IN ('queued', 'armed', 'feeding', 'held', 'draining')",
              program);
    if (job.next()) return fmt::format("job {} of it has not ended", job.number());
  }
  Query release(session, "SELECT id, state FROM text_release WHERE program = ? AND state IN ('proving', 'approved')",
                program);
  if (!release.next()) return {};
  const Id id = release.number();
  return fmt::format("release {} of it is {}", id, release.text());
}

}  // namespace

Result<Program> ProgramTable::label(Id program, const store::ProgramLabels& labels, const Stamp& by) {
  return database_.write(subject_of(program), [&](Session& session) -> Result<Program> {
    const auto known = get(program);
    if (!known) return known;
    if (known->is_deleted()) return session.refuse(ErrorCode::refused_transition, "it is deleted");
    std::string detail;
    if (labels.tags) {
      if (std::ranges::find(*labels.tags, "") != labels.tags->end())
        return session.refuse(ErrorCode::invalid_value, "a tag is not empty");
      write_tags(session, program, *labels.tags);
      detail = fmt::format("tags {}", fmt::join(*labels.tags, ", "));
    }
    if (labels.folder) {
      session.run("UPDATE program SET folder = ? WHERE id = ?", *labels.folder, program);
      detail += fmt::format("{}folder {}", detail.empty() ? "" : "; ", *labels.folder);
    }
    note_program_change(session, program);
    add_audit_row(session, {.action = "program.label", .subject = subject_of(program), .detail = std::move(detail)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(program);
  });
}

Result<Program> ProgramTable::archive(Id program, std::string_view reason, const Stamp& by) {
  return database_.write(subject_of(program), [&](Session& session) -> Result<Program> {
    const auto old = get(program);
    if (!old) return old;
    if (reason.empty()) return session.refuse(ErrorCode::invalid_value, "a program is archived with a reason");
    if (old->is_archived()) return session.refuse(ErrorCode::refused_transition, "it is archived already");
    if (std::string why = in_work(session, program); !why.empty())
      return session.refuse(ErrorCode::refused_transition, std::move(why));
    session.run("UPDATE program SET archived_at_ms = ?, archived_by = ?, archive_reason = ? WHERE id = ?", by.at_ms,
                by.actor, reason, program);
    note_program_change(session, program);
    add_audit_row(session, {.action = "program.archive", .subject = subject_of(program), .detail = std::string(reason)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return with_event(session, get(program), "archived", by);
  });
}

Result<Program> ProgramTable::fetch_back(Id program, std::string_view reason, const Stamp& by) {
  return database_.write(subject_of(program), [&](Session& session) -> Result<Program> {
    const auto old = get(program);
    if (!old) return old;
    if (reason.empty()) return session.refuse(ErrorCode::invalid_value, "a program is fetched back with a reason");
    if (!old->is_archived()) return session.refuse(ErrorCode::refused_transition, "it is in use");
    if (old->is_deleted()) return session.refuse(ErrorCode::refused_transition, "it is deleted");
    session.run("UPDATE program SET archived_at_ms = 0, archived_by = '', archive_reason = '' WHERE id = ?", program);
    note_program_change(session, program);
    add_audit_row(session,
                  {.action = "program.fetch_back", .subject = subject_of(program), .detail = std::string(reason)}, by);
    if (!session.ok()) return std::unexpected(session.error());
    return with_event(session, get(program), "fetched_back", by);
  });
}

namespace {

// What keeps an archived program from being deleted; "" where nothing does.
std::string still_named(Session& session, Id program) {
  if (std::string why = in_work(session, program); !why.empty()) return why;
  {
    Query release(session, "SELECT id, state FROM text_release WHERE program = ? AND state <> 'obsolete'", program);
    if (release.next()) {
      const Id id = release.number();
      return fmt::format("release {} of it is {}", id, release.text());
    }
  }
  Query calls(session,
              "SELECT j.id FROM job j JOIN verdict v ON v.sha256 = j.sha256 AND v.machine = j.machine "
              "JOIN verdict_call c ON c.verdict = v.id WHERE c.program = ? "
              "AND j.state IN ('queued', 'armed', 'feeding', 'held', 'draining')",
              program);
  return calls.next() ? fmt::format("job {} calls it and has not ended", calls.number()) : std::string();
}

// Revisions that nothing else speaks of.
constexpr std::string_view kEraseRevisions =
    "DELETE FROM program_revision WHERE program = ? "
    "AND NOT EXISTS (SELECT 1 FROM verdict v WHERE v.program = program_revision.program "
    "AND v.revision = program_revision.revision) "
    "AND NOT EXISTS (SELECT 1 FROM text_release t WHERE t.program = program_revision.program "
    "AND t.revision = program_revision.revision) "
    "AND NOT EXISTS (SELECT 1 FROM job j WHERE j.program = program_revision.program "
    "AND j.revision = program_revision.revision) "
    "AND NOT EXISTS (SELECT 1 FROM receipt r WHERE r.program = program_revision.program "
    "AND r.revision = program_revision.revision) "
    "AND NOT EXISTS (SELECT 1 FROM verdict_call c WHERE c.program = program_revision.program "
    "AND c.revision = program_revision.revision)";

}  // namespace

Result<Program> ProgramTable::erase(Id program, std::int64_t archived_until_ms, std::string_view reason,
                                    const Stamp& by) {
  return database_.write(subject_of(program), [&](Session& session) -> Result<Program> {
    const auto old = get(program);
    if (!old) return old;
    if (reason.empty()) return session.refuse(ErrorCode::invalid_value, "a program is deleted with a reason");
    if (old->is_deleted()) return session.refuse(ErrorCode::refused_transition, "it is deleted already");
    if (!old->is_archived()) return session.refuse(ErrorCode::refused_transition, "it is in use: archive it first");
    if (old->archived.at_ms > archived_until_ms)
      return session.refuse(ErrorCode::refused_transition, "it was archived too short a time ago");
    if (std::string why = still_named(session, program); !why.empty())
      return session.refuse(ErrorCode::refused_transition, std::move(why));
    session.run("UPDATE program SET deleted_at_ms = ?, deleted_by = ?, delete_reason = ? WHERE id = ?", by.at_ms,
                by.actor, reason, program);
    session.run(
        "UPDATE attachment SET content = NULL, removed_by = ?, removed_reason = ?, removed_at_ms = ? "
        "WHERE program = ? AND removed_at_ms = 0",
        by.actor, reason, by.at_ms, program);
    session.run(kEraseRevisions, program);
    const std::uint64_t erased = session.changed_rows();
    session.run("DELETE FROM program_tag WHERE program = ?", program);
    note_program_change(session, program);
    add_audit_row(
        session,
        {.action = "program.delete",
         .subject = subject_of(program),
         .detail = fmt::format("{} of folder \"{}\", {} revisions erased: {}", old->name, old->folder, erased, reason)},
        by);
    if (!session.ok()) return std::unexpected(session.error());
    return with_event(session, get(program), "deleted", by);
  });
}

Result<std::vector<Program>> ProgramTable::changed_after(std::uint64_t change, std::uint32_t most) {
  return database_.read("programs", [&](Session& session) -> Result<std::vector<Program>> {
    static const std::string kSql = newest_where("p.change_number > ? ORDER BY p.change_number LIMIT ?");
    Query query(session, kSql, change, most);
    std::vector<Program> found;
    while (query.next()) found.push_back(read_program(query));
    return found;
  });
}

Result<std::uint64_t> ProgramTable::count_changed_after(std::uint64_t change) {
  return database_.read("programs", [&](Session& session) -> Result<std::uint64_t> {
    Query query(session, "SELECT count(*) FROM program WHERE change_number > ?", change);
    return query.next() ? query.number() : 0;
  });
}

Result<Program> ProgramTable::get(Id program) {
  return database_.read(subject_of(program), [&](Session& session) -> Result<Program> {
    static const std::string kSql = newest_where("p.id = ?");
    Query query(session, kSql, program);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_program(query);
  });
}

Result<ProgramRevision> ProgramTable::get_revision(Id program, Revision revision) {
  return database_.read(subject_of(program), [&](Session& session) -> Result<ProgramRevision> {
    static const std::string kSql = revisions_where("r.program = ? AND r.revision = ?");
    Query query(session, kSql, program, revision);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_revision(query);
  });
}

Result<store::Page<Program>> ProgramTable::list(const store::PageRequest& page, const store::ProgramFilter& filter) {
  return database_.read("programs", [&](Session& session) -> Result<store::Page<Program>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    // A filter that is off compares a parameter with itself, so that the parameters stay the same.
    constexpr std::array kShelves = {"p.archived_at_ms = 0", "p.archived_at_ms <> 0 AND p.deleted_at_ms = 0",
                                     "p.deleted_at_ms = 0"};
    const std::string sql = newest_where(
        fmt::format("{} AND {} AND {} AND {} AND {} AND p.id < ? ORDER BY p.id DESC LIMIT ?",
                    filter.name.empty() ? "? = ''" : "p.name = ?",
                    filter.part.empty() ? "? = ''" : "p.id IN (SELECT program FROM program_revision WHERE part = ?)",
                    filter.tag.empty() ? "? = ''" : "p.id IN (SELECT program FROM program_tag WHERE tag = ?)",
                    filter.folder.empty() ? "? = ''" : "lower(p.folder || '/') LIKE ? ESCAPE '\\'",
                    kShelves[static_cast<std::size_t>(filter.shelf)]));
    const std::string below = filter.folder.empty() ? std::string() : beginning_with(filter.folder + "/");
    Query query(session, sql, filter.name, filter.part, filter.tag, below, from->after, from->rows);
    return collect(query, page, read_program, [](const Program& program) { return fmt::format("{}", program.id); });
  });
}

Result<store::Page<ProgramRevision>> ProgramTable::revisions(Id program, const store::PageRequest& page) {
  return database_.read(subject_of(program), [&](Session& session) -> Result<store::Page<ProgramRevision>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    static const std::string kSql =
        revisions_where("r.program = ? AND r.revision < ? ORDER BY r.revision DESC LIMIT ?");
    Query query(session, kSql, program, from->after, from->rows);
    return collect(query, page, read_revision,
                   [](const ProgramRevision& revision) { return fmt::format("{}", revision.revision); });
  });
}

void note_program_change(Session& session, Id program) {
  session.run(
      "UPDATE program SET change_number = (SELECT coalesce(max(change_number), 0) + 1 FROM program) WHERE id = ?",
      program);
}

Result<void> refuse_archived(Session& session, Id program) {
  Query query(session, "SELECT archive_reason FROM program WHERE id = ? AND archived_at_ms <> 0", program);
  if (!query.next()) return {};
  return session.refuse(ErrorCode::refused_transition, fmt::format("program {} is archived", program));
}

Result<std::string> text_of_revision(Session& session, Id program, Revision revision) {
  Query query(session, "SELECT sha256 FROM program_revision WHERE program = ? AND revision = ?", program, revision);
  if (!query.next()) {
    return session.refuse(ErrorCode::broken_reference, fmt::format("program {} revision {}", program, revision));
  }
  return query.text();
}

bool wrote_text(Session& session, std::string_view text_sha256, std::string_view name) {
  Query query(session,
              "SELECT 1 FROM program_revision r LEFT JOIN family_revision f ON f.family = r.family AND f.revision = "
              "r.family_revision WHERE r.sha256 = ? AND (r.actor = ? OR f.actor = ?) LIMIT 1",
              text_sha256, name, name);
  return query.next();
}

}  // namespace dripfeed::sql
