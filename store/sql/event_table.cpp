// Rows are added by the tables whose changes they report, too.
#include "store/sql/event_table.h"

#include <algorithm>

#include <fmt/format.h>

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::LoggedEvent;
using store::Result;

}  // namespace

std::uint64_t add_event_row(Session& session, const store::NewEvent& event, const store::Stamp& by) {
  session.run(
      "INSERT INTO event (topic, word, subject, machine, job, program, revision, cause, body, actor, at_ms) VALUES "
      "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      event.topic, event.word, event.subject, event.machine, event.job, event.program, event.revision, event.cause,
      event.text, by.actor, by.at_ms);
  return session.last_id();
}

LoggedEvent read_event(Query& query) {
  LoggedEvent event;
  event.seq = query.number();
  event.of.topic = query.value<store::EventTopic>();
  event.of.word = query.text();
  event.of.subject = query.number();
  event.of.machine = query.text();
  event.of.job = query.number();
  event.of.program = query.number();
  event.of.revision = query.number();
  event.of.cause = query.text();
  event.of.text = query.text();
  event.by.actor = query.text();
  event.by.at_ms = query.signed_number();
  return event;
}

std::uint64_t newest_event(Session& session) {
  Query query(session, session.words().newest_event);
  return query.next() ? query.number() : 0;
}

Result<LoggedEvent> EventTable::append(const store::NewEvent& event, const store::Stamp& by) {
  return database_.write("event", [&](Session& session) -> Result<LoggedEvent> {
    if (event.word.empty()) return session.refuse(ErrorCode::invalid_value, "an event has a word");
    LoggedEvent added{.seq = add_event_row(session, event, by), .of = event, .by = by};
    return added;
  });
}

Result<std::vector<LoggedEvent>> EventTable::after(std::uint64_t seq, std::uint32_t most) {
  return database_.read("events", [&](Session& session) -> Result<std::vector<LoggedEvent>> {
    static const std::string kSql =
        fmt::format("SELECT {} FROM event e WHERE e.seq > ? ORDER BY e.seq LIMIT ?", kEventColumns);
    Query query(session, kSql, seq, most);
    std::vector<LoggedEvent> found;
    while (query.next()) found.push_back(read_event(query));
    return found;
  });
}

Result<std::uint64_t> EventTable::newest() {
  return database_.read("events", [](Session& session) -> Result<std::uint64_t> { return newest_event(session); });
}

Result<std::optional<std::uint64_t>> EventTable::seen_by(std::string_view reader) {
  return database_.read("events", [&](Session& session) -> Result<std::optional<std::uint64_t>> {
    Query query(session, "SELECT seen FROM event_reader WHERE name = ?", reader);
    if (!query.next()) return std::nullopt;
    return query.number();
  });
}

Result<void> EventTable::note_seen(std::string_view reader, std::uint64_t seq) {
  return database_.write("events", [&](Session& session) -> Result<void> {
    session.run(
        "INSERT INTO event_reader (name, seen) VALUES (?, ?) ON CONFLICT (name) DO UPDATE SET seen = excluded.seen",
        reader, seq);
    return {};
  });
}

// A webhook that had not come so far has missed them; it says so in its row when it comes there.
Result<std::uint64_t> EventTable::forget(const store::EventLimits& limits) {
  return database_.write("events", [&](Session& session) -> Result<std::uint64_t> {
    std::uint64_t rows = 0;
    {
      Query count(session, "SELECT count(*) FROM event");
      if (count.next()) rows = count.number();
    }
    const std::uint64_t over = std::min<std::uint64_t>(rows > limits.most ? rows - limits.most : 0, limits.at_once);
    session.run("DELETE FROM event WHERE seq IN (SELECT seq FROM event ORDER BY seq LIMIT ?)", over);
    std::uint64_t gone = session.changed_rows();
    session.run("DELETE FROM event WHERE seq IN (SELECT seq FROM event WHERE at_ms < ? ORDER BY seq LIMIT ?)",
                limits.before_ms, limits.at_once - over);
    gone += session.changed_rows();
    session.run(
        "DELETE FROM webhook_delivery WHERE id IN (SELECT id FROM webhook_delivery WHERE state = 'delivered' AND "
        "last_at_ms < ? LIMIT ?)",
        limits.delivered_before_ms, limits.at_once);
    return gone;
  });
}

}  // namespace dripfeed::sql
