// A verdict row never changes but for growing stale; waivers are rows of their own.
#include "store/sql/verdict_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "store/hash/sha256.h"
#include "store/sql/audit_table.h"
#include "store/sql/paging.h"
#include "store/sql/program_table.h"
#include "store/sql/user_table.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Id;
using store::NewVerdict;
using store::Result;
using store::Stamp;
using store::Verdict;

constexpr std::string_view kColumns =
    "id, program, revision, machine, machine_revision, delivery, outcome, report, sha256, rules, stale, actor, at_ms";
// An older machine than the newest was judged: nothing rests on that.
constexpr std::string_view kInsert =
    "INSERT INTO verdict (program, revision, sha256, machine, machine_revision, delivery, outcome, report, rules, "
    "actor, at_ms, stale) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
    "CASE WHEN EXISTS (SELECT 1 FROM machine WHERE name = ? AND revision > ?) THEN 1 ELSE 0 END)";

void read_waivers(Session& session, Verdict& verdict) {
  Query query(session, "SELECT name, reason, at_ms, point, expires_at_ms FROM waiver WHERE verdict = ? ORDER BY n",
              verdict.id);
  while (query.next()) {
    store::Waiver waiver;
    waiver.name = query.text();
    waiver.reason = query.text();
    waiver.at_ms = query.signed_number();
    waiver.point = query.text();
    waiver.expires_at_ms = query.signed_number();
    verdict.waivers.push_back(std::move(waiver));
  }
}

// A verdict rests on the texts that were called, too.
void read_calls(Session& session, Verdict& verdict) {
  Query query(session,
              "SELECT c.name, c.program, c.revision, CASE WHEN p.revision > c.revision THEN 1 ELSE 0 END FROM "
              "verdict_call c LEFT JOIN program p ON p.id = c.program WHERE c.verdict = ? ORDER BY c.name",
              verdict.id);
  while (query.next()) {
    store::VerdictCall call;
    call.name = query.text();
    call.program = query.number();
    call.revision = query.number();
    verdict.stale = query.flag() || verdict.stale;
    verdict.of.calls.push_back(std::move(call));
  }
}

void read_points(Session& session, Verdict& verdict) {
  Query query(session, "SELECT text FROM verdict_point WHERE verdict = ? ORDER BY n", verdict.id);
  while (query.next()) verdict.of.points.push_back(query.text());
}

void read_what_belongs(Session& session, Verdict& verdict) {
  read_points(session, verdict);
  read_calls(session, verdict);
  read_waivers(session, verdict);
}

std::string subject_of(Id verdict) { return fmt::format("verdict/{}", verdict); }

// "known", "known; for: line 7: …; until 1700000000000".
std::string detail_of(const store::NewWaiver& waiver) {
  std::string detail = waiver.reason;
  if (!waiver.point.empty()) detail += fmt::format("; for: {}", waiver.point);
  if (waiver.expires_at_ms != 0) detail += fmt::format("; until {}", waiver.expires_at_ms);
  return detail;
}

std::string select_where(std::string_view rest) {
  return fmt::format("SELECT {} FROM verdict WHERE {}", kColumns, rest);
}

}  // namespace

Verdict VerdictTable::read(Query& query) const {
  Verdict verdict;
  verdict.id = query.number();
  verdict.of.program = query.number();
  verdict.of.revision = query.number();
  verdict.of.machine = query.text();
  verdict.of.machine_revision = query.number();
  verdict.of.delivery = query.value<store::Delivery>();
  verdict.of.outcome = query.value<store::Outcome>();
  verdict.of.report = query.text();
  verdict.text_sha256 = query.text();
  verdict.rules = query.text();
  verdict.stale = query.flag() || (!rules_.empty() && verdict.rules != rules_);
  verdict.created_by = query.text();
  verdict.created_at_ms = query.signed_number();
  return verdict;
}

Result<Verdict> VerdictTable::add(const NewVerdict& verdict, const Stamp& by) {
  return database_.write("verdict", [&](Session& session) -> Result<Verdict> {
    const auto sha256 = text_of_revision(session, verdict.program, verdict.revision);
    if (!sha256) return std::unexpected(sha256.error());
    session.run(kInsert, verdict.program, verdict.revision, *sha256, verdict.machine, verdict.machine_revision,
                verdict.delivery, verdict.outcome, verdict.report, rules_, by.actor, by.at_ms, verdict.machine,
                verdict.machine_revision);
    const Id id = session.last_id();
    for (const store::VerdictCall& call : verdict.calls)
      session.run("INSERT INTO verdict_call (verdict, name, program, revision) VALUES (?, ?, ?, ?)", id, call.name,
                  call.program, call.revision);
    std::uint64_t number = 0;
    for (const std::string& point : verdict.points)
      session.run("INSERT INTO verdict_point (verdict, n, text) VALUES (?, ?, ?)", id, ++number, point);
    add_audit_row(session,
                  {.action = "verdict.add",
                   .subject = subject_of(id),
                   .detail = fmt::format("{} for text {} on {} revision {} by {}, report sha256 {}{}{}",
                                         store::name_of(verdict.outcome), *sha256, verdict.machine,
                                         verdict.machine_revision, store::name_of(verdict.delivery),
                                         hash::sha256_hex(verdict.report), rules_.empty() ? "" : ", rules ", rules_)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(id);
  });
}

Result<Verdict> VerdictTable::waive(Id verdict, const store::NewWaiver& waiver, const Stamp& by) {
  return database_.write(subject_of(verdict), [&](Session& session) -> Result<Verdict> {
    if (waiver.reason.empty() || by.actor.empty()) {
      return session.refuse(ErrorCode::invalid_value, "a waiver needs a reason and a name");
    }
    if (waiver.expires_at_ms != 0 && waiver.expires_at_ms <= by.at_ms)
      return session.refuse(ErrorCode::invalid_value, "the end of the waiver is over");
    const auto old = get(verdict);
    if (!old) return old;
    if (!waiver.point.empty() && std::ranges::find(old->of.points, waiver.point) == old->of.points.end())
      return session.refuse(ErrorCode::invalid_value, "the verdict has no such point");
    if (old->of.outcome == store::Outcome::fail)
      return session.refuse(ErrorCode::refused_transition, "a verdict that fails is never waived: mend the program");
    if (needs_four_eyes(session, old->of.machine) && wrote_text(session, old->text_sha256, by.actor))
      return session.refuse(ErrorCode::four_eyes, by.actor + " wrote the text");
    session.run(
        "INSERT INTO waiver (verdict, n, name, reason, at_ms, point, expires_at_ms) VALUES (?, ?, ?, ?, ?, ?, ?)",
        verdict, old->waivers.size() + 1, by.actor, waiver.reason, by.at_ms, waiver.point, waiver.expires_at_ms);
    add_audit_row(session, {.action = "verdict.waive", .subject = subject_of(verdict), .detail = detail_of(waiver)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(verdict);
  });
}

Result<Verdict> VerdictTable::get(Id verdict) {
  return database_.read(subject_of(verdict), [&](Session& session) -> Result<Verdict> {
    static const std::string kSql = select_where("id = ?");
    Query query(session, kSql, verdict);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    Verdict found = read(query);
    read_what_belongs(session, found);
    return found;
  });
}

Result<std::optional<Verdict>> VerdictTable::newest(std::string_view text_sha256, std::string_view machine,
                                                    store::Delivery delivery) {
  return database_.read("verdict", [&](Session& session) -> Result<std::optional<Verdict>> {
    static const std::string kSql =
        select_where("sha256 = ? AND machine = ? AND delivery = ? ORDER BY id DESC LIMIT 1");
    Query query(session, kSql, text_sha256, machine, delivery);
    if (!query.next()) return std::nullopt;
    Verdict found = read(query);
    read_what_belongs(session, found);
    return found;
  });
}

Result<store::Page<Verdict>> VerdictTable::list(const store::PageRequest& page, const store::VerdictFilter& filter) {
  return database_.read("verdicts", [&](Session& session) -> Result<store::Page<Verdict>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const std::string sql = select_where(fmt::format("{} AND {} AND id < ? ORDER BY id DESC LIMIT ?",
                                                     filter.program == 0 ? "? = 0" : "program = ?",
                                                     filter.machine.empty() ? "? = ''" : "machine = ?"));
    Query query(session, sql, filter.program, filter.machine, from->after, from->rows);
    auto found = collect(
        query, page, [this](Query& row) { return read(row); },
        [](const Verdict& verdict) { return fmt::format("{}", verdict.id); });
    for (Verdict& verdict : found.items) read_what_belongs(session, verdict);
    return found;
  });
}

}  // namespace dripfeed::sql
