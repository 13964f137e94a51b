// What the store keeps and the lines report, as the API shows it. Each function gives the JSON text of one thing;
// `list` puts things on a page.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/render/render.h"
#include "server/app/application.h"
#include "server/app/jobs/history.h"
#include "server/app/jobs/utilisation.h"
#include "server/app/library/program_uses.h"
#include "server/app/ports/maintenance.h"
#include "server/app/ports/workplace.h"
#include "server/json/problem_codes.h"

namespace dripfeed::json {

std::string list(std::span<const std::string> items, std::string_view next);

std::string machine_status(const app::MachineStatus& status);
std::string machine(const store::Machine& machine, const app::MachineStatus& status);
// What a list shows of a stored profile. Reading the profile costs many times what the rest of a list's row does.
struct ProfileHead {
  std::string title;
  std::string dialect;
  std::string kind;
  std::string link;
};
ProfileHead profile_head(std::string_view profile);
std::string machine_summary(const store::Machine& machine, const ProfileHead& head, const app::MachineStatus& status);
std::string family(const store::Family& family, const compile::FamilyDescription& description);
// Of a list: without text and parameters.
std::string family_summary(const store::Family& family, std::string_view title);
std::string part(const store::Part& part);
std::string program(const store::Program& program);
std::string program_revision(const store::ProgramRevision& revision);
// The legend of a macro; and what that wrote, read back.
std::string legend(std::span<const compile::LegendEntry> entries);
std::vector<compile::LegendEntry> read_legend(std::string_view text);
std::string rendered(const app::Rendered& rendered, const text::Source& family);
std::string preview(const app::Preview& preview);
std::string release(const store::Release& release);
// What came of reading a job's program back, as one word.
inline constexpr std::string_view kReadBackStates[] = {"waiting", "equal", "differs", "expired", "superseded"};
std::string job(const store::Job& job);
std::string receipt(const store::Receipt& receipt, const std::optional<app::StoredLikeness>& stored);
std::string request(const store::Request& request);
// `id` is null while the store could not take it yet.
std::string alarm(const store::Alarm& alarm);
std::string program_lines(std::uint64_t from, const app::ProgramLines& found);
std::string utilisation(std::span<const app::DayOfUse> days);
std::string history_sums(const app::HistorySums& sums, app::SumsBy by);
std::string ledger(std::span<const store::LedgerRow> rows, std::string_view next, const store::LedgerInterval& interval,
                   bool confirms);
// `waiting`: changes that are not in the library yet.
struct SearchHit {
  store::LibraryHit hit;
  store::Program program;
};
std::string search_result(std::span<const SearchHit> hits, std::string_view next, const store::LibraryState& state,
                          std::uint64_t waiting);
std::string program_uses(const app::ProgramUses& uses);
std::string attachment(const store::Attachment& attachment);
std::string work(const app::Work& work);
// A line of the log, without its end.
std::string log_line(std::int64_t at_ms, std::string_view level, std::string_view text);
// A server of the store with the machines whose lines it has; `is_this`: the one that answers.
std::string node(const store::Node& node, std::span<const store::Lease> leases, bool is_this);
std::string store_room(const app::StoreRoom& room);
std::string backup(const app::BackupFile& file);

// The data line of a live event, and its name.
std::string_view event_name(app::EventKind kind);
std::string event_data(const app::Event& event);
std::string progress(std::string_view machine, const app::MachineStatus& status);

// application/problem+json.
std::string problem(const ProblemCode& code, const app::Error& error);

}  // namespace dripfeed::json
