// A receipt is decided once; its other columns never change (a trigger says so, too).
#include "store/sql/receipt_table.h"

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/event_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Id;
using store::Receipt;
using store::ReceiptState;
using store::Result;
using store::Stamp;

constexpr std::string_view kRequestColumns =
    "SELECT id, machine, verb, argument, body, outcome, detail, job, at_ms FROM request";

std::string receipts_where(std::string_view rest) {
  return fmt::format(
      "SELECT r.id, r.machine, r.name, r.style, r.sha256, r.raw_bytes, r.code, r.ended_by, r.state, r.reason, c.bytes, "
      "r.at_ms, r.program, r.revision, r.decided_by, r.decided_reason, r.decided_at_ms FROM receipt r "
      "JOIN content c ON c.sha256 = r.sha256 WHERE {}",
      rest);
}

Receipt read_receipt(Query& query) {
  Receipt read;
  read.id = query.number();
  read.of.machine = query.text();
  read.of.name = query.text();
  read.of.style = query.text();
  read.of.sha256 = query.text();
  read.of.raw_bytes = query.number();
  read.of.code = query.text();
  read.of.ended_by = query.text();
  read.state = query.value<ReceiptState>();
  read.of.reason = query.text();
  read.of.quarantined = !read.of.reason.empty();
  read.bytes = query.number();
  read.at_ms = query.signed_number();
  read.program = query.number();
  read.revision = query.number();
  read.decided_by = query.text();
  read.decided_reason = query.text();
  read.decided_at_ms = query.signed_number();
  return read;
}

store::Request read_request(Query& query) {
  store::Request read;
  read.id = query.number();
  read.of.machine = query.text();
  read.of.verb = query.text();
  read.of.argument = query.text();
  read.of.text = query.text();
  read.of.outcome = query.text();
  read.of.detail = query.text();
  read.of.job = query.number();
  read.at_ms = query.signed_number();
  return read;
}

std::string subject_of(Id receipt) { return fmt::format("receipt/{}", receipt); }

// The receipt as it is now; what became of it is an event.
Result<Receipt> with_event(Session& session, Result<Receipt> receipt, const Stamp& by) {
  if (!receipt) return receipt;
  add_event_row(session,
                {.topic = store::EventTopic::receipt,
                 .word = std::string(store::name_of(receipt->state)),
                 .subject = receipt->id,
                 .machine = receipt->of.machine,
                 .program = receipt->program,
                 .revision = receipt->revision,
                 .text = receipt->of.name},
                by);
  return receipt;
}

bool decided(const Receipt& receipt) {
  return receipt.state == ReceiptState::accepted || receipt.state == ReceiptState::discarded;
}

}  // namespace

Result<Receipt> ReceiptTable::add(const store::NewReceipt& receipt, const Stamp& by) {
  return database_.write("receipt", [&](Session& session) -> Result<Receipt> {
    if (receipt.quarantined == receipt.reason.empty()) {
      return session.refuse(ErrorCode::invalid_value, "a receipt in quarantine has a reason, and no other");
    }
    const ReceiptState state = receipt.quarantined ? ReceiptState::quarantined : ReceiptState::stored;
    session.run(
        "INSERT INTO receipt (machine, name, style, sha256, raw_bytes, code, ended_by, state, reason, at_ms) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        receipt.machine, receipt.name, receipt.style, receipt.sha256, receipt.raw_bytes, receipt.code, receipt.ended_by,
        state, receipt.reason, by.at_ms);
    const Id id = session.last_id();
    add_audit_row(session,
                  {.action = "receipt.add",
                   .subject = subject_of(id),
                   .detail = fmt::format("{} from {} sha256 {} {}", receipt.name, receipt.machine, receipt.sha256,
                                         store::name_of(state))},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return with_event(session, get(id), by);
  });
}

Result<Receipt> ReceiptTable::accept(Id receipt, Id program, store::Revision revision, std::string_view reason,
                                     const Stamp& by) {
  return database_.write(subject_of(receipt), [&](Session& session) -> Result<Receipt> {
    const auto old = get(receipt);
    if (!old) return old;
    if (decided(*old)) return session.refuse(ErrorCode::refused_transition, "it was decided before");
    if (old->of.quarantined && reason.empty())
      return session.refuse(ErrorCode::invalid_value, "a reason is needed to take it out of quarantine");
    session.run(
        "UPDATE receipt SET state = ?, program = ?, revision = ?, decided_by = ?, decided_reason = ?, decided_at_ms = "
        "? "
        "WHERE id = ?",
        ReceiptState::accepted, program, revision, by.actor, reason, by.at_ms, receipt);
    add_audit_row(session,
                  {.action = "receipt.accept",
                   .subject = subject_of(receipt),
                   .detail = fmt::format("program/{} revision {}{}{}", program, revision,
                                         old->of.quarantined ? ", out of quarantine: "
                                         : reason.empty()    ? ""
                                                             : ": ",
                                         reason)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return with_event(session, get(receipt), by);
  });
}

Result<Receipt> ReceiptTable::discard(Id receipt, std::string_view reason, const Stamp& by) {
  return database_.write(subject_of(receipt), [&](Session& session) -> Result<Receipt> {
    if (reason.empty()) return session.refuse(ErrorCode::invalid_value, "a reason is needed");
    const auto old = get(receipt);
    if (!old) return old;
    if (decided(*old)) return session.refuse(ErrorCode::refused_transition, "it was decided before");
    session.run("UPDATE receipt SET state = ?, decided_by = ?, decided_reason = ?, decided_at_ms = ? WHERE id = ?",
                ReceiptState::discarded, by.actor, reason, by.at_ms, receipt);
    add_audit_row(session, {.action = "receipt.discard", .subject = subject_of(receipt), .detail = std::string(reason)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return with_event(session, get(receipt), by);
  });
}

Result<Receipt> ReceiptTable::get(Id receipt) {
  return database_.read(subject_of(receipt), [&](Session& session) -> Result<Receipt> {
    static const std::string kSql = receipts_where("r.id = ?");
    Query query(session, kSql, receipt);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_receipt(query);
  });
}

Result<store::Page<Receipt>> ReceiptTable::list(const store::PageRequest& page, const store::ReceiptFilter& filter) {
  return database_.read("receipts", [&](Session& session) -> Result<store::Page<Receipt>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const std::string sql = receipts_where(fmt::format("{} AND {} AND r.id < ? ORDER BY r.id DESC LIMIT ?",
                                                       filter.machine.empty() ? "? = ''" : "r.machine = ?",
                                                       filter.state ? "r.state = ?" : "? = ''"));
    const std::string_view state = filter.state ? store::name_of(*filter.state) : std::string_view();
    Query query(session, sql, filter.machine, state, from->after, from->rows);
    return collect(query, page, read_receipt, [](const Receipt& one) { return fmt::format("{}", one.id); });
  });
}

Result<store::Request> ReceiptTable::add_request(const store::NewRequest& request, const Stamp& by) {
  return database_.write("request", [&](Session& session) -> Result<store::Request> {
    session.run(
        "INSERT INTO request (machine, verb, argument, body, outcome, detail, job, at_ms) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
        request.machine, request.verb, request.argument, request.text, request.outcome, request.detail,
        NumberOrNull{request.job}, by.at_ms);
    const Id id = session.last_id();
    add_audit_row(
        session,
        {.action = "request." + request.verb,
         .subject = fmt::format("machine/{}", request.machine),
         .detail = fmt::format("request {} {}: {}, {}", id, request.argument, request.outcome, request.detail)},
        by);
    if (!session.ok()) return std::unexpected(session.error());
    return store::Request{.id = id, .of = request, .at_ms = by.at_ms};
  });
}

Result<store::Page<store::Request>> ReceiptTable::requests(const store::PageRequest& page, std::string_view machine) {
  return database_.read("requests", [&](Session& session) -> Result<store::Page<store::Request>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const std::string sql = fmt::format("{} WHERE {} AND id < ? ORDER BY id DESC LIMIT ?", kRequestColumns,
                                        machine.empty() ? "? = ''" : "machine = ?");
    Query query(session, sql, machine, from->after, from->rows);
    return collect(query, page, read_request, [](const store::Request& one) { return fmt::format("{}", one.id); });
  });
}

}  // namespace dripfeed::sql
