// Tables that came with a later schema are asked for only where the file has them.
#include "store/sqlite/state.h"

#include "store/sql/session.h"
#include "store/sqlite/migrations.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;

constexpr std::uint32_t kAnswersFrom = 5;

constexpr std::string_view kMachines =
    "SELECT m.name, r.profile FROM machine m JOIN machine_revision r ON r.machine = m.name AND r.revision = m.revision "
    "ORDER BY m.name";
constexpr std::string_view kHollow =
    "SELECT count(*) FROM content c WHERE c.sha256 IS NOT NULL AND c.bytes > 0 AND NOT EXISTS "
    "(SELECT 1 FROM content_chunk k WHERE k.content = c.id)";
constexpr std::string_view kTornJobs = "SELECT count(DISTINCT machine) FROM job WHERE torn AND confirmed_at_ms = 0";
constexpr std::string_view kTorn =
    "SELECT count(*) FROM (SELECT machine FROM job WHERE torn AND confirmed_at_ms = 0 UNION "
    "SELECT machine FROM answer WHERE state = 'torn' AND confirmed_at_ms = 0)";

std::uint64_t number_of(Session& session, std::string_view sql) {
  Query query(session, sql);
  return query.next() ? query.number() : 0;
}

}  // namespace

store::Result<StoreState> look_at_store(const std::string& path) {
  auto connection = Connection::open(path, {}, Access::read);
  if (!connection) return std::unexpected(connection.error());
  const auto version = schema_version(**connection);
  if (!version) return std::unexpected(version.error());
  StoreState state;
  state.schema = *version;
  state.program_schema = migrations().back().version;
  if (state.schema > state.program_schema || state.schema == 0) return state;
  Session session(**connection, "store");
  state.contents = number_of(session, "SELECT count(*) FROM content WHERE sha256 IS NOT NULL");
  state.hollow_contents = number_of(session, kHollow);
  state.newest_row_ms = static_cast<std::int64_t>(number_of(session, "SELECT coalesce(max(at_ms), 0) FROM audit"));
  state.torn_machines = number_of(session, state.schema >= kAnswersFrom ? kTorn : kTornJobs);
  Query query(session, kMachines);
  while (query.next()) {
    state.machines.emplace_back();
    state.machines.back().name = query.text();
    state.machines.back().profile = query.text();
  }
  if (!session.ok()) return std::unexpected(session.error());
  return state;
}

}  // namespace dripfeed::sqlite
