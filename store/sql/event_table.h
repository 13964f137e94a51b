// The log of events in the database.
#pragma once

#include "store/event_log.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

// Adds a row within the caller's transaction; its number. A fault stays in the session.
std::uint64_t add_event_row(Session& session, const store::NewEvent& event, const store::Stamp& by);
// "e.seq, …" of a table `event e`, as read_event() reads them.
inline constexpr std::string_view kEventColumns =
    "e.seq, e.topic, e.word, e.subject, e.machine, e.job, e.program, e.revision, e.cause, e.body, e.actor, e.at_ms";
store::LoggedEvent read_event(Query& query);
// Of the newest row that there ever was.
std::uint64_t newest_event(Session& session);

class EventTable final : public store::EventLog {
 public:
  explicit EventTable(Database& database) : database_(database) {}
  store::Result<store::LoggedEvent> append(const store::NewEvent& event, const store::Stamp& by) override;
  store::Result<std::vector<store::LoggedEvent>> after(std::uint64_t seq, std::uint32_t most) override;
  store::Result<std::uint64_t> newest() override;
  store::Result<std::optional<std::uint64_t>> seen_by(std::string_view reader) override;
  store::Result<void> note_seen(std::string_view reader, std::uint64_t seq) override;
  store::Result<std::uint64_t> forget(const store::EventLimits& limits) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
