// What is raised and cleared leaves no row in the audit: machines do that, and often. What a person does leaves one.
#include "store/sql/alarm_table.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/event_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::Alarm;
using store::ErrorCode;
using store::Id;
using store::Result;
using store::Stamp;

std::string subject_of(Id alarm) { return fmt::format("alarm/{}", alarm); }

std::string alarms_where(std::string_view rest) {
  return fmt::format(
      "SELECT id, machine, kind, body, count, raised_at_ms, last_at_ms, cleared_at_ms, acknowledged_by, "
      "acknowledged_at_ms, shelved_by, shelved_until_ms, shelf_reason, job FROM alarm WHERE {}",
      rest);
}

Alarm read_alarm(Query& query) {
  Alarm alarm;
  alarm.id = query.number();
  alarm.machine = query.text();
  alarm.kind = query.text();
  alarm.text = query.text();
  alarm.count = query.number();
  alarm.raised_at_ms = query.signed_number();
  alarm.last_at_ms = query.signed_number();
  alarm.cleared_at_ms = query.signed_number();
  alarm.acknowledged_by = query.text();
  alarm.acknowledged_at_ms = query.signed_number();
  alarm.shelved_by = query.text();
  alarm.shelved_until_ms = query.signed_number();
  alarm.shelf_reason = query.text();
  alarm.job = query.number();
  return alarm;
}

template <class... P>
std::optional<Alarm> find(Session& session, const std::string& sql, const P&... parameters) {
  Query query(session, sql, parameters...);
  if (!query.next()) return std::nullopt;
  return read_alarm(query);
}

template <class... P>
std::vector<Alarm> find_all(Session& session, const std::string& sql, const P&... parameters) {
  std::vector<Alarm> found;
  Query query(session, sql, parameters...);
  while (query.next()) found.push_back(read_alarm(query));
  return found;
}

std::optional<Alarm> find_id(Session& session, Id id) {
  static const std::string kSql = alarms_where("id = ?");
  return find(session, kSql, id);
}

void write_shelf(Session& session, const Alarm& alarm) {
  session.run("UPDATE alarm SET shelved_by = ?, shelved_until_ms = ?, shelf_reason = ? WHERE id = ?", alarm.shelved_by,
              alarm.shelved_until_ms, alarm.shelf_reason, alarm.id);
}

void take_down(Alarm& alarm) {
  alarm.shelved_by.clear();
  alarm.shelved_until_ms = 0;
  alarm.shelf_reason.clear();
}

void note(Session& session, std::string_view action, const Alarm& alarm, std::string detail, const Stamp& by) {
  add_audit_row(session, {.action = std::string(action), .subject = subject_of(alarm.id), .detail = std::move(detail)},
                by);
}

// `word`: one of store::kAlarmEvents.
void log_event(Session& session, std::string_view word, const Alarm& alarm, const Stamp& by) {
  add_event_row(session,
                {.topic = store::EventTopic::alarm,
                 .word = std::string(word),
                 .subject = alarm.id,
                 .machine = alarm.machine,
                 .job = alarm.job,
                 .cause = alarm.kind,
                 .text = alarm.text},
                by);
}

constexpr std::string_view kServer = "dripfeed";  // who raises and clears

// "1700000000000-12": the time and id of the last row of the page before.
struct Place {
  std::int64_t at_ms = std::numeric_limits<std::int64_t>::max();
  std::uint64_t id = std::numeric_limits<std::int64_t>::max();
};

Result<Place> place_of(const std::string& after) {
  Place place;
  if (after.empty()) return place;
  const char* const end = after.data() + after.size();
  const auto time = std::from_chars(after.data(), end, place.at_ms);
  const bool has_id = time.ec == std::errc{} && time.ptr != end && *time.ptr == '-';
  const auto id = has_id ? std::from_chars(time.ptr + 1, end, place.id) : time;
  if (!has_id || id.ec != std::errc{} || id.ptr != end)
    return std::unexpected(
        store::Error{ErrorCode::invalid_value, fmt::format("\"{}\" is not a place of a list", after)});
  return place;
}

}  // namespace

Result<Alarm> AlarmTable::raise(const store::NewAlarm& alarm, std::int64_t at_ms) {
  return database_.write(fmt::format("machine/{}", alarm.machine), [&](Session& session) -> Result<Alarm> {
    if (alarm.kind.empty() || alarm.text.empty() || alarm.count == 0)
      return session.refuse(ErrorCode::invalid_value, "an alarm has a kind, a text and a count");
    static const std::string kOpen = alarms_where("machine = ? AND kind = ? AND body = ? AND closed = 0");
    const std::int64_t cleared_at_ms = alarm.lasts ? 0 : at_ms;
    if (auto open = find(session, kOpen, alarm.machine, alarm.kind, alarm.text)) {
      const bool was_over = open->cleared_at_ms != 0;
      open->count += alarm.count;
      open->last_at_ms = at_ms;
      open->cleared_at_ms = cleared_at_ms;
      session.run("UPDATE alarm SET count = ?, last_at_ms = ?, cleared_at_ms = ? WHERE id = ?", open->count,
                  open->last_at_ms, open->cleared_at_ms, open->id);
      if (alarm.lasts && was_over) log_event(session, "raised", *open, {std::string(kServer), at_ms});
      return *open;
    }
    session.run(
        "INSERT INTO alarm (machine, kind, body, count, raised_at_ms, last_at_ms, cleared_at_ms, job) VALUES (?, ?, ?, "
        "?, ?, ?, ?, ?)",
        alarm.machine, alarm.kind, alarm.text, alarm.count, at_ms, at_ms, cleared_at_ms, NumberOrNull{alarm.job});
    Alarm added;
    added.id = session.last_id();
    added.machine = alarm.machine;
    added.kind = alarm.kind;
    added.text = alarm.text;
    added.count = alarm.count;
    added.raised_at_ms = added.last_at_ms = at_ms;
    added.cleared_at_ms = cleared_at_ms;
    added.job = alarm.job;
    log_event(session, "raised", added, {std::string(kServer), at_ms});
    return added;
  });
}

Result<std::vector<Alarm>> AlarmTable::clear(std::string_view machine, std::string_view kind, std::int64_t at_ms) {
  return database_.write(fmt::format("machine/{}", machine), [&](Session& session) -> Result<std::vector<Alarm>> {
    static const std::string kSql = alarms_where("machine = ? AND kind = ? AND cleared_at_ms = 0 ORDER BY id");
    std::vector<Alarm> over = find_all(session, kSql, machine, kind);
    for (Alarm& alarm : over) {
      alarm.cleared_at_ms = at_ms;
      session.run("UPDATE alarm SET cleared_at_ms = ? WHERE id = ?", at_ms, alarm.id);
      log_event(session, "cleared", alarm, {std::string(kServer), at_ms});
    }
    return over;
  });
}

Result<std::vector<Alarm>> AlarmTable::lasting() {
  return database_.read("alarms", [&](Session& session) -> Result<std::vector<Alarm>> {
    static const std::string kSql = alarms_where("cleared_at_ms = 0 ORDER BY id");
    return find_all(session, kSql);
  });
}

Result<Alarm> AlarmTable::acknowledge(Id id, const Stamp& by) {
  return database_.write(subject_of(id), [&](Session& session) -> Result<Alarm> {
    auto alarm = find_id(session, id);
    if (!alarm) return session.refuse(ErrorCode::not_found);
    if (by.actor.empty()) return session.refuse(ErrorCode::invalid_value, "an acknowledgement needs a name");
    if (alarm->acknowledged_at_ms != 0) return *alarm;
    alarm->acknowledged_by = by.actor;
    alarm->acknowledged_at_ms = by.at_ms;
    session.run("UPDATE alarm SET acknowledged_by = ?, acknowledged_at_ms = ? WHERE id = ?", by.actor, by.at_ms, id);
    note(session, "alarm.acknowledge", *alarm,
         fmt::format("{} on {}, {} times: {}", alarm->kind, alarm->machine, alarm->count, alarm->text), by);
    log_event(session, "acknowledged", *alarm, by);
    return *alarm;
  });
}

Result<Alarm> AlarmTable::shelve(Id id, std::int64_t until_ms, std::string_view reason, const Stamp& by) {
  return database_.write(subject_of(id), [&](Session& session) -> Result<Alarm> {
    auto alarm = find_id(session, id);
    if (!alarm) return session.refuse(ErrorCode::not_found);
    if (reason.empty() || by.actor.empty())
      return session.refuse(ErrorCode::invalid_value, "shelving needs a reason and a name");
    if (until_ms <= by.at_ms) return session.refuse(ErrorCode::invalid_value, "shelving needs a time to come");
    if (!alarm->is_open()) return session.refuse(ErrorCode::refused_transition, "it is closed");
    alarm->shelved_by = by.actor;
    alarm->shelved_until_ms = until_ms;
    alarm->shelf_reason = reason;
    write_shelf(session, *alarm);
    note(session, "alarm.shelve", *alarm,
         fmt::format("{} on {} for {} s: {}", alarm->kind, alarm->machine, (until_ms - by.at_ms) / 1000, reason), by);
    log_event(session, "shelved", *alarm, by);
    return *alarm;
  });
}

Result<Alarm> AlarmTable::unshelve(Id id, const Stamp& by) {
  return database_.write(subject_of(id), [&](Session& session) -> Result<Alarm> {
    auto alarm = find_id(session, id);
    if (!alarm) return session.refuse(ErrorCode::not_found);
    if (alarm->shelved_until_ms == 0) return *alarm;
    note(session, "alarm.unshelve", *alarm, fmt::format("{} on {}", alarm->kind, alarm->machine), by);
    take_down(*alarm);
    write_shelf(session, *alarm);
    log_event(session, "unshelved", *alarm, by);
    return *alarm;
  });
}

Result<std::vector<Alarm>> AlarmTable::end_shelves(std::int64_t now_ms) {
  static const std::string kSql = alarms_where("shelved_until_ms <> 0 AND shelved_until_ms <= ? ORDER BY id");
  // Looked at first without a turn of the writer: mostly there is none.
  auto due = database_.read(
      "alarms", [&](Session& session) -> Result<std::vector<Alarm>> { return find_all(session, kSql, now_ms); });
  if (!due || due->empty()) return due;
  return database_.write("alarms", [&](Session& session) -> Result<std::vector<Alarm>> {
    std::vector<Alarm> ended = find_all(session, kSql, now_ms);
    for (Alarm& alarm : ended) {
      take_down(alarm);
      write_shelf(session, alarm);
      log_event(session, "unshelved", alarm, {std::string(kServer), now_ms});
    }
    return ended;
  });
}

Result<Alarm> AlarmTable::get(Id id) {
  return database_.read(subject_of(id), [&](Session& session) -> Result<Alarm> {
    auto alarm = find_id(session, id);
    if (!alarm) return session.refuse(ErrorCode::not_found);
    return *alarm;
  });
}

Result<store::Page<Alarm>> AlarmTable::list(const store::PageRequest& page, const store::AlarmFilter& filter) {
  return database_.read("alarms", [&](Session& session) -> Result<store::Page<Alarm>> {
    const auto rows = rows_of(page);
    if (!rows) return std::unexpected(rows.error());
    const auto place = place_of(page.after);
    if (!place) return std::unexpected(place.error());
    const std::string sql = alarms_where(
        fmt::format("{} AND {} AND (last_at_ms, id) < (?, ?) ORDER BY last_at_ms DESC, id DESC LIMIT ?",
                    filter.machine.empty() ? "? = ''" : "machine = ?", filter.open_only ? "closed = 0" : "TRUE"));
    Query query(session, sql, filter.machine, place->at_ms, place->id, *rows);
    return collect(query, page, read_alarm,
                   [](const Alarm& alarm) { return fmt::format("{}-{}", alarm.last_at_ms, alarm.id); });
  });
}

Result<std::vector<store::OpenAlarms>> AlarmTable::count_open() {
  return database_.read("alarms", [](Session& session) -> Result<std::vector<store::OpenAlarms>> {
    std::vector<store::OpenAlarms> found;
    Query query(session,
                "SELECT machine, kind, count(*) FROM alarm WHERE closed = 0 GROUP BY machine, kind "
                "ORDER BY machine, kind");
    while (query.next()) {
      found.emplace_back();
      found.back().machine = query.text();
      found.back().kind = query.text();
      found.back().count = query.number();
    }
    return found;
  });
}

Result<std::uint64_t> AlarmTable::forget(std::int64_t before_ms, std::uint64_t most, std::uint32_t at_once) {
  return database_.write("alarms", [&](Session& session) -> Result<std::uint64_t> {
    std::uint64_t closed = 0;
    {
      Query count(session, "SELECT count(*) FROM alarm WHERE closed = 1");
      if (count.next()) closed = count.number();
    }
    const std::uint64_t over = std::min<std::uint64_t>(closed > most ? closed - most : 0, at_once);
    session.run("DELETE FROM alarm WHERE id IN (SELECT id FROM alarm WHERE closed = 1 ORDER BY last_at_ms, id LIMIT ?)",
                over);
    session.run(
        "DELETE FROM alarm WHERE id IN (SELECT id FROM alarm WHERE closed = 1 AND last_at_ms < ? ORDER BY last_at_ms, "
        "id LIMIT ?)",
        before_ms, at_once - over);
    std::uint64_t left = 0;
    Query count(session, "SELECT count(*) FROM alarm WHERE closed = 1");
    if (count.next()) left = count.number();
    return closed - left;
  });
}

}  // namespace dripfeed::sql
