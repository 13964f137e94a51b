// The nominal is that of the family revision and values that the text was rendered from, so that it is what was
// ordered, not what was printed.
#include "server/app/checks/checking.h"

#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

// Longest text that is checked whole.
constexpr std::uint64_t kTextLimit = std::uint64_t{256} << 20U;

// "profile 12-60,70-71", as programs.cpp writes it.
std::vector<family::LineRange> read_profile_lines(std::string_view facts) {
  constexpr std::string_view kHead = "profile ";
  if (!facts.starts_with(kHead)) return {};
  return read_line_ranges(facts.substr(kHead.size())).value_or(std::vector<family::LineRange>{});
}

Result<void> add_rendered(store::Store& store, const Documents& documents, StoredCase& one) {
  const store::Origin& origin = one.revision.origin;
  const auto family = lift(store.families().get(origin.family, origin.family_revision));
  if (!family) return std::unexpected(family.error());
  auto values = documents.read_values(origin.values);
  if (!values) return std::unexpected(values.error());
  one.order.nominal = NominalCase{
      .family = family->name, .revision = family->revision, .text = family->text, .values = std::move(*values)};
  one.order.profile_lines = read_profile_lines(one.revision.facts);
  return {};
}

Result<void> add_nominal(store::Store& store, const CheckOrder& order, StoredCase& one) {
  const auto family = lift(store.families().get(order.nominal->family));
  if (!family) return std::unexpected(family.error());
  one.order.nominal = NominalCase{.family = family->name,
                                  .revision = family->revision,
                                  .text = family->text,
                                  .values = order.nominal->values,
                                  .is_from_request = true};
  one.order.profile_lines = order.profile_lines;
  return {};
}

Result<void> add_geometry(store::Store& store, const Documents& documents, const CheckOrder& order, StoredCase& one) {
  const bool rendered = one.revision.origin.kind == store::OriginKind::rendered;
  const auto refuse = [](const char* pointer, const char* text) {
    return fail(ErrorCode::invalid, text, {{.pointer = pointer, .text = text}});
  };
  if (rendered && order.nominal) return refuse("/nominal", "a rendered program has the nominal of its family");
  if (!order.nominal && !order.profile_lines.empty()) return refuse("/profile", "lines make a profile of a nominal");
  if (rendered) return add_rendered(store, documents, one);
  return order.nominal ? add_nominal(store, order, one) : Result<void>{};
}

}  // namespace

std::optional<std::vector<family::LineRange>> read_line_ranges(std::string_view text) {
  std::vector<family::LineRange> ranges;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (at < end) {
    family::LineRange range;
    const auto first = std::from_chars(at, end, range.first);
    if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '-') return std::nullopt;
    const auto last = std::from_chars(first.ptr + 1, end, range.last);
    if (last.ec != std::errc{} || range.first == 0 || range.last < range.first) return std::nullopt;
    ranges.push_back(range);
    at = last.ptr;
    if (at == end) break;
    if (*at != ',' || ++at == end) return std::nullopt;
  }
  return ranges;
}

Result<StoredCase> load_case(store::Store& store, const Documents& documents, const CheckOrder& order) {
  auto program = lift(store.programs().get(order.program));
  if (!program) return std::unexpected(program.error());
  auto revision = order.revision == 0 ? Result<store::ProgramRevision>(program->newest)
                                      : lift(store.programs().get_revision(order.program, order.revision));
  if (!revision) return std::unexpected(revision.error());
  auto machine = lift(store.machines().get(order.machine));
  if (!machine) return std::unexpected(machine.error());
  const auto profile = documents.read_profile(machine->profile);
  if (!profile) return std::unexpected(profile.error());
  if (profile->control.dialect != program->dialect) {
    return fail(ErrorCode::invalid, fmt::format("program {} is {}, machine {} is {}", program->name, program->dialect,
                                                machine->name, profile->control.dialect));
  }
  auto text = lift(store::read_whole(store.contents(), revision->sha256, kTextLimit));
  if (!text) return std::unexpected(text.error());

  StoredCase one{
      .program = std::move(*program), .revision = std::move(*revision), .machine = std::move(*machine), .order = {}};
  one.order = {.machine = one.machine.name,
               .folder = one.program.folder,
               .name = one.program.name,
               .dialect = one.program.dialect,
               .text = std::move(*text),
               .profile = one.machine.profile,
               .delivery = order.delivery,
               .nominal = {},
               .profile_lines = {}};
  if (auto known = add_geometry(store, documents, order, one); !known) return std::unexpected(known.error());
  return one;
}

namespace {

std::vector<store::VerdictCall> calls_of(const std::vector<CalledText>& called) {
  std::vector<store::VerdictCall> calls;
  for (const CalledText& one : called)
    if (one.program != 0) calls.push_back({.name = one.key, .program = one.program, .revision = one.revision});
  return calls;
}

}  // namespace

Checking::Checking(store::Store& store, Events& events, const Clock& clock, const Documents& documents,
                   Workers* workers)
    : store_(store), events_(events), clock_(clock), documents_(documents), workers_(workers) {}

Result<store::Verdict> Checking::check(const CheckOrder& order, std::string_view actor, const Waiter& waiter) {
  auto loaded = load_case(store_, documents_, order);
  if (!loaded) return std::unexpected(loaded.error());
  StoredCase& stored = *loaded;
  CalledBy none;
  auto done = workers_ != nullptr ? workers_->check(stored.order, waiter)
                                  : check_case(std::move(stored.order), documents_, {}, none);
  if (!done) return std::unexpected(done.error());

  const store::NewVerdict row{.program = stored.program.id,
                              .revision = stored.revision.revision,
                              .machine = stored.machine.name,
                              .machine_revision = stored.machine.revision,
                              .delivery = order.delivery,
                              .outcome = done->outcome,
                              .report = std::move(done->report),
                              .calls = calls_of(done->called),
                              .points = std::move(done->points)};
  auto verdict = lift(store_.verdicts().add(row, {std::string(actor), clock_.wall_ms()}));
  if (!verdict) return std::unexpected(verdict.error());
  events_.publish({.id = 0,
                   .kind = EventKind::verdict,
                   .machine = stored.machine.name,
                   .job = {},
                   .verdict = verdict->id,
                   .outcome = verdict->of.outcome,
                   .text = stored.program.name});
  return verdict;
}

}  // namespace dripfeed::app
