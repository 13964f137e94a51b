// The table program says which revision is the newest; program_revision has them all.
#include "store/sqlite/program_table.h"

#include <fmt/format.h>

#include "store/sqlite/audit_table.h"
#include "store/sqlite/paging.h"

namespace dripfeed::sqlite {
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
    "r.program, r.revision, r.sha256, c.bytes, r.places_sha256, r.blocks, r.facts, r.origin, r.family, "
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

Program read_program(Query& query) {
  Program program;
  program.name = query.text();
  program.dialect = query.text();
  program.newest = read_revision(query);
  program.id = program.newest.program;
  return program;
}

std::string newest_where(std::string_view rest) {
  return fmt::format(
      "SELECT p.name, p.dialect, {} FROM program p JOIN program_revision r ON r.program = p.id AND r.revision = "
      "p.revision "
      "JOIN content c ON c.sha256 = r.sha256 WHERE {}",
      kRevisionColumns, rest);
}

std::string revisions_where(std::string_view rest) {
  return fmt::format("SELECT {} FROM program_revision r JOIN content c ON c.sha256 = r.sha256 WHERE {}",
                     kRevisionColumns, rest);
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

}  // namespace

Result<Program> ProgramTable::add(std::string_view name, std::string_view dialect, const NewProgramText& text,
                                  const Stamp& by) {
  return database_.write("program", [&](Session& session) -> Result<Program> {
    if (name.empty()) return session.refuse(ErrorCode::invalid_value, "a program needs a name");
    session.run("INSERT INTO program (name, dialect, revision) VALUES (?, ?, 1)", name, dialect);
    const Id program = session.last_id();
    write_revision(session, program, 1, text, by, "program.add");
    if (!session.ok()) return std::unexpected(session.error());
    return get(program);
  });
}

Result<Program> ProgramTable::add_revision(Id program, Revision expected, const NewProgramText& text, const Stamp& by) {
  return database_.write(subject_of(program), [&](Session& session) -> Result<Program> {
    const auto old = get(program);
    if (!old) return old;
    if (old->newest.revision != expected) return session.refuse(ErrorCode::stale_revision);
    session.run("UPDATE program SET revision = ? WHERE id = ?", expected + 1, program);
    write_revision(session, program, expected + 1, text, by, "program.change");
    if (!session.ok()) return std::unexpected(session.error());
    return get(program);
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
    const std::string sql = newest_where(
        fmt::format("{} AND {} AND p.id < ? ORDER BY p.id DESC LIMIT ?", filter.name.empty() ? "? = ''" : "p.name = ?",
                    filter.part.empty() ? "? = ''" : "p.id IN (SELECT program FROM program_revision WHERE part = ?)"));
    Query query(session, sql, filter.name, filter.part, from->after, from->rows);
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

Result<std::string> text_of_revision(Session& session, Id program, Revision revision) {
  Query query(session, "SELECT sha256 FROM program_revision WHERE program = ? AND revision = ?", program, revision);
  if (!query.next()) {
    return session.refuse(ErrorCode::broken_reference, fmt::format("program {} revision {}", program, revision));
  }
  return query.text();
}

}  // namespace dripfeed::sqlite
