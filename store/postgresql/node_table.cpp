// Whether a node is heard of is decided by the database's clock, which is one for all nodes.
#include "store/postgresql/node_table.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/event_table.h"

namespace dripfeed::postgresql {
namespace {

using sql::Query;
using sql::Session;
using store::ErrorCode;
using store::Job;
using store::Lease;
using store::Node;
using store::Result;
using store::Stamp;

constexpr std::string_view kNodes =
    "SELECT name, url, program_version, started_at_ms, seen_at_ms, now_ms() FROM node ORDER BY name";
constexpr std::string_view kLeases =
    "SELECT machine, node, number, since_ms, given_by, reason FROM line_lease ORDER BY machine";
constexpr std::string_view kLease =
    "SELECT machine, node, number, since_ms, given_by, reason FROM line_lease WHERE machine = ?";
constexpr std::string_view kFree =
    "SELECT name FROM machine m WHERE NOT EXISTS (SELECT 1 FROM line_lease WHERE machine = m.name) ORDER BY name";
constexpr std::string_view kNews =
    "SELECT seq, topic, subject, machine FROM event WHERE seq > ? AND node <> ? ORDER BY seq LIMIT 200";
// A lock of the connection that writes: whoever has it keeps it until that ends.
constexpr std::string_view kLead =
    "SELECT CASE WHEN EXISTS (SELECT 1 FROM pg_locks WHERE locktype = 'advisory' AND classid = 1146243408 AND objid = "
    "3 "
    "AND pid = pg_backend_pid()) THEN true ELSE pg_try_advisory_lock(1146243408, 3) END";
constexpr std::string_view kGive =
    "INSERT INTO line_lease (machine, node, number, since_ms, given_by, reason) VALUES (?, ?, 1, ?, ?, ?) "
    "ON CONFLICT (machine) DO UPDATE SET node = excluded.node, number = line_lease.number + 1, since_ms = "
    "excluded.since_ms, given_by = excluded.given_by, reason = excluded.reason";

Node read_node(Query& query) {
  Node node;
  node.name = query.text();
  node.url = query.text();
  node.version = query.text();
  node.started_at_ms = query.signed_number();
  node.seen_at_ms = query.signed_number();
  node.is_heard = query.signed_number() - node.seen_at_ms < store::kNodeUnheardAfter_ms;
  return node;
}

Lease read_lease(Query& query) {
  Lease lease;
  lease.machine = query.text();
  lease.node = query.text();
  lease.number = query.number();
  lease.since_ms = query.signed_number();
  lease.given_by = query.text();
  lease.reason = query.text();
  return lease;
}

template <class Row, class Read>
std::vector<Row> rows_of(Session& session, std::string_view sql, const Read& read) {
  std::vector<Row> rows;
  Query query(session, sql);
  while (query.next()) rows.push_back(read(query));
  return rows;
}

std::optional<Lease> lease_of(Session& session, std::string_view machine) {
  Query query(session, kLease, machine);
  return query.next() ? std::optional(read_lease(query)) : std::nullopt;
}

std::optional<Node> node_of(Session& session, std::string_view name) {
  for (Node& node : rows_of<Node>(session, kNodes, read_node)) {
    if (node.name == name) return std::move(node);
  }
  return std::nullopt;
}

Lease give(Session& session, std::string_view machine, std::string_view node, std::string_view reason, const Stamp& by,
           std::string_view action) {
  session.run(kGive, machine, node, by.at_ms, by.actor, reason);
  sql::add_audit_row(
      session,
      {.action = std::string(action),
       .subject = fmt::format("machine/{}", machine),
       .detail = reason.empty() ? fmt::format("node {}", node) : fmt::format("node {}: {}", node, reason)},
      by);
  return lease_of(session, machine).value_or(Lease{});
}

// "armed for 5 rounds": how often the text may have left. The first row of a job's ledger says it.
std::uint64_t rounds_in(std::string_view note) {
  constexpr std::string_view kBegin = "armed for ";
  std::uint64_t rounds = 1;
  if (note.starts_with(kBegin)) std::from_chars(note.data() + kBegin.size(), note.data() + note.size(), rounds);
  return std::max<std::uint64_t>(rounds, 1);
}

}  // namespace

Result<store::Beat> NodeTable::beat(std::string_view url, std::string_view version) {
  return database_.write("node", [&](Session& session) -> Result<store::Beat> {
    session.run("UPDATE node SET seen_at_ms = now_ms(), url = ?, program_version = ? WHERE name = ?", url, version,
                own_);
    Query query(session, kLead);
    return store::Beat{.leads = query.next() && query.flag()};
  });
}

void NodeTable::wait_for_news(std::chrono::milliseconds patience) { listener_.wait(patience); }

Result<std::vector<store::NodeNews>> NodeTable::news(std::uint64_t after) {
  return database_.read("news", [&](Session& session) -> Result<std::vector<store::NodeNews>> {
    std::vector<store::NodeNews> found;
    Query query(session, kNews, after, own_);
    while (query.next()) {
      store::NodeNews news;
      news.seq = query.number();
      news.topic = query.value<store::EventTopic>();
      news.subject = query.number();
      news.machine = query.text();
      found.push_back(std::move(news));
    }
    return found;
  });
}

Result<std::vector<store::LoggedEvent>> NodeTable::own_events(std::uint64_t after, std::uint32_t most) {
  return database_.read("events", [&](Session& session) -> Result<std::vector<store::LoggedEvent>> {
    static const std::string kSql = fmt::format(
        "SELECT {} FROM event e WHERE e.seq > ? AND e.node IN (?, '') ORDER BY e.seq LIMIT ?", sql::kEventColumns);
    std::vector<store::LoggedEvent> found;
    Query query(session, kSql, after, own_, most);
    while (query.next()) found.push_back(sql::read_event(query));
    return found;
  });
}

Result<std::vector<Node>> NodeTable::list() {
  return database_.read("nodes", [&](Session& session) -> Result<std::vector<Node>> {
    return rows_of<Node>(session, kNodes, read_node);
  });
}

Result<std::vector<Lease>> NodeTable::leases() {
  return database_.read("leases", [&](Session& session) -> Result<std::vector<Lease>> {
    return rows_of<Lease>(session, kLeases, read_lease);
  });
}

Result<Lease> NodeTable::claim(std::string_view machine, const Stamp& by) {
  return database_.write(fmt::format("lease/{}", machine), [&](Session& session) -> Result<Lease> {
    if (lease_of(session, machine)) return session.refuse(ErrorCode::exists);
    return give(session, machine, own_, "", by, "machine.lease");
  });
}

Result<void> NodeTable::claim_free(const Stamp& by) {
  return database_.write("leases", [&](Session& session) -> Result<void> {
    const auto free = rows_of<std::string>(session, kFree, [](Query& query) { return query.text(); });
    for (const std::string& machine : free) give(session, machine, own_, "", by, "machine.lease");
    return {};
  });
}

Result<Lease> NodeTable::hand_over(std::string_view machine, std::string_view to, std::string_view reason,
                                   const Stamp& by) {
  return database_.write(fmt::format("lease/{}", machine), [&](Session& session) -> Result<Lease> {
    if (reason.empty()) return session.refuse(ErrorCode::invalid_value, "a reason is needed");
    const auto lease = lease_of(session, machine);
    if (!lease || lease->node != own_) return session.refuse(ErrorCode::not_leased);
    if (!node_of(session, to)) return session.refuse(ErrorCode::not_found, fmt::format("node {}", to));
    const auto on_line = others_.jobs.on_line(machine);
    if (!on_line) return std::unexpected(on_line.error());
    if (*on_line) return session.refuse(ErrorCode::machine_busy, fmt::format("job {} on {}", (*on_line)->id, machine));
    const auto torn = others_.jobs.torn_on(machine);
    const auto torn_answer = others_.answers.torn_on(machine);
    if (!torn || !torn_answer) return std::unexpected(torn ? torn_answer.error() : torn.error());
    if (*torn || *torn_answer) return session.refuse(ErrorCode::machine_torn);
    return give(session, machine, to, reason, by, "machine.hand-over");
  });
}

// A job of that node may have gone on without the database as far as its text goes, and one that was armed may have
// begun. The ledger says so before the job is interrupted.
Result<void> NodeTable::doubt(std::string_view machine, std::string_view node, const Stamp& by) {
  const auto job = others_.jobs.on_line(machine);
  if (!job) return std::unexpected(job.error());
  if (!*job) return {};
  const auto known = others_.ledger.interval((*job)->id);
  if (!known) return std::unexpected(known.error());
  const auto first = others_.ledger.rows((*job)->id, {.limit = 1, .after = {}});
  if (!first) return std::unexpected(first.error());
  store::NewLedgerRow row{.job = (*job)->id, .counts = known->last};
  const std::uint64_t rounds = first->items.empty() ? 1 : rounds_in(first->items.front().note);
  row.counts.reserve = std::max(known->high, (*job)->bytes_total * rounds);
  row.note = fmt::format("taken over from node {}: what it sent after this is not known here", node);
  const auto written = others_.ledger.append(std::span(&row, 1), by.at_ms);
  return written ? Result<void>() : std::unexpected(written.error());
}

Result<std::vector<Job>> NodeTable::take_over(std::string_view machine, std::string_view reason, const Stamp& by) {
  return database_.write(fmt::format("lease/{}", machine), [&](Session& session) -> Result<std::vector<Job>> {
    if (reason.empty()) return session.refuse(ErrorCode::invalid_value, "a reason is needed");
    const auto lease = lease_of(session, machine);
    if (!lease) return session.refuse(ErrorCode::not_found);
    if (lease->node == own_)
      return session.refuse(ErrorCode::refused_transition, fmt::format("{} is this node's", machine));
    const auto holder = node_of(session, lease->node);
    if (holder && holder->is_heard)
      return session.refuse(ErrorCode::refused_transition,
                            fmt::format("node {} has {} and answers: it hands it over", lease->node, machine));
    if (auto doubted = doubt(machine, lease->node, by); !doubted) return std::unexpected(doubted.error());
    const auto of = [&](std::string_view one) { return one == machine; };
    auto jobs = others_.jobs.interrupt_unfinished(by, of);
    if (!jobs) return jobs;
    if (auto torn = others_.answers.tear_unfinished(by, of); !torn) return std::unexpected(torn.error());
    give(session, machine, own_, reason, by, "machine.take-over");
    return jobs;
  });
}

}  // namespace dripfeed::postgresql
