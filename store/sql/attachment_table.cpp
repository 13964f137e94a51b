// `content` refers to the bytes while the attachment is there; `sha256` says for ever what they were.
#include "store/sql/attachment_table.h"

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::AttachedTo;
using store::Attachment;
using store::ErrorCode;
using store::Id;
using store::Page;
using store::Result;
using store::Stamp;

std::string subject_of(Id attachment) { return fmt::format("attachment/{}", attachment); }

std::string select_where(std::string_view rest) {
  return fmt::format(
      "SELECT id, program, family, part, work_order, name, media_type, sha256, bytes, added_by, added_at_ms, "
      "removed_by, removed_reason, removed_at_ms FROM attachment WHERE {}",
      rest);
}

Attachment read_attachment(Query& query) {
  Attachment read;
  read.id = query.number();
  read.of.to.program = query.number();
  read.of.to.family = query.text();
  read.of.to.part = query.text();
  read.of.to.order = query.number();
  read.of.name = query.text();
  read.of.media_type = query.text();
  read.of.sha256 = query.text();
  read.bytes = query.number();
  read.added_by = query.text();
  read.added_at_ms = query.signed_number();
  read.removed_by = query.text();
  read.removed_reason = query.text();
  read.removed_at_ms = query.signed_number();
  return read;
}

int owners_in(const AttachedTo& of) {
  return int{of.program != 0} + int{!of.family.empty()} + int{!of.part.empty()} + int{of.order != 0};
}

// The column of the owner that is given, and its name as the audit has it. A program's where none is.
std::string_view column_of(const AttachedTo& of) {
  if (!of.family.empty()) return "family";
  if (!of.part.empty()) return "part";
  return of.order != 0 ? "work_order" : "program";
}

std::string words_of(const AttachedTo& of) {
  if (!of.family.empty()) return fmt::format("family/{}", of.family);
  if (!of.part.empty()) return fmt::format("part/{}", of.part);
  return of.order != 0 ? fmt::format("order/{}", of.order) : fmt::format("program/{}", of.program);
}

// Runs `body` on a query whose one parameter before `more` is the owner.
template <class F, class... P>
auto with_owner(Session& session, const std::string& sql, const AttachedTo& of, F&& body, const P&... more) {
  const std::string& name = of.family.empty() ? of.part : of.family;
  if (!name.empty()) {
    Query query(session, sql, name, more...);
    return body(query);
  }
  Query query(session, sql, of.order != 0 ? of.order : of.program, more...);
  return body(query);
}

bool has_name(Session& session, const store::NewAttachment& attachment) {
  const std::string sql =
      fmt::format("SELECT 1 FROM attachment WHERE {} = ? AND name = ? AND removed_at_ms = 0", column_of(attachment.to));
  return with_owner(session, sql, attachment.to, [](Query& query) { return query.next(); }, attachment.name);
}

bool is_deleted(Session& session, Id program) {
  Query query(session, "SELECT 1 FROM program WHERE id = ? AND deleted_at_ms <> 0", program);
  return query.next();
}

}  // namespace

Result<Attachment> AttachmentTable::add(const store::NewAttachment& attachment, const Stamp& by) {
  return database_.write("attachment", [&](Session& session) -> Result<Attachment> {
    if (owners_in(attachment.to) != 1)
      return session.refuse(ErrorCode::invalid_value, "an attachment is of one program, family, part or order");
    if (attachment.name.empty() || attachment.media_type.empty())
      return session.refuse(ErrorCode::invalid_value, "an attachment has a name and a media type");
    if (is_deleted(session, attachment.to.program))
      return session.refuse(ErrorCode::refused_transition, "the program is deleted");
    if (has_name(session, attachment))
      return session.refuse(ErrorCode::exists, fmt::format("{} of {}", attachment.name, words_of(attachment.to)));
    const AttachedTo& to = attachment.to;
    session.run(
        "INSERT INTO attachment (program, family, part, work_order, name, media_type, sha256, content, bytes, "
        "added_by, "
        "added_at_ms) VALUES (?, ?, ?, ?, ?, ?, ?, ?, coalesce((SELECT bytes FROM content WHERE sha256 = ?), 0), ?, ?)",
        NumberOrNull{to.program}, OrNull{to.family}, OrNull{to.part}, NumberOrNull{to.order}, attachment.name,
        attachment.media_type, attachment.sha256, attachment.sha256, attachment.sha256, by.actor, by.at_ms);
    if (!session.ok()) return std::unexpected(session.error());
    const Id id = session.last_id();
    add_audit_row(session,
                  {.action = "attachment.add",
                   .subject = subject_of(id),
                   .detail = fmt::format("{} of {} sha256 {}", attachment.name, words_of(to), attachment.sha256)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(id);
  });
}

Result<Attachment> AttachmentTable::remove(Id attachment, std::string_view reason, const Stamp& by) {
  return database_.write(subject_of(attachment), [&](Session& session) -> Result<Attachment> {
    const auto old = get(attachment);
    if (!old) return old;
    if (reason.empty()) return session.refuse(ErrorCode::invalid_value, "an attachment is removed with a reason");
    if (old->is_removed()) return session.refuse(ErrorCode::refused_transition, "it is removed already");
    session.run(
        "UPDATE attachment SET content = NULL, removed_by = ?, removed_reason = ?, removed_at_ms = ? WHERE id = ?",
        by.actor, reason, by.at_ms, attachment);
    add_audit_row(session,
                  {.action = "attachment.remove",
                   .subject = subject_of(attachment),
                   .detail = fmt::format("{} of {}: {}", old->of.name, words_of(old->of.to), reason)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(attachment);
  });
}

Result<Attachment> AttachmentTable::get(Id attachment) {
  return database_.read(subject_of(attachment), [&](Session& session) -> Result<Attachment> {
    static const std::string kSql = select_where("id = ?");
    Query query(session, kSql, attachment);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_attachment(query);
  });
}

Result<Page<Attachment>> AttachmentTable::list(const store::PageRequest& page, const AttachedTo& of) {
  return database_.read("attachments", [&](Session& session) -> Result<Page<Attachment>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const int owners = owners_in(of);
    if (owners > 1)
      return session.refuse(ErrorCode::invalid_value, "an attachment is of one program, family, part or order");
    const std::string owner = owners == 0 ? "? = 0" : fmt::format("{} = ?", column_of(of));
    const std::string sql =
        select_where(fmt::format("{} AND removed_at_ms = 0 AND id < ? ORDER BY id DESC LIMIT ?", owner));
    const auto rows = [&](Query& query) {
      return collect(query, page, read_attachment, [](const Attachment& one) { return fmt::format("{}", one.id); });
    };
    return with_owner(session, sql, of, rows, from->after, from->rows);
  });
}

}  // namespace dripfeed::sql
