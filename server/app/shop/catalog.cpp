// Check, store, publish; in this order.
#include "server/app/shop/catalog.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/text/fold.h"
#include "server/app/base/names.h"

namespace dripfeed::app {

Catalog::Catalog(store::Store& store, Lines& lines, Events& events, const Clock& clock, const Documents& documents)
    : store_(store), lines_(lines), events_(events), clock_(clock), documents_(documents) {}

store::Stamp Catalog::stamp(std::string_view actor) const { return {std::string(actor), clock_.wall_ms()}; }

void Catalog::publish(const std::string& machine) {
  events_.publish(
      {.id = 0, .kind = EventKind::machine, .machine = machine, .job = {}, .verdict = 0, .outcome = {}, .text = {}});
}

Result<void> Catalog::open_line(const std::string& machine) {
  const auto profile = this->profile(machine);
  if (!profile) return std::unexpected(profile.error());
  const auto hold = lines_.hold(machine);
  return lines_.set(*profile);
}

// A machine of another node is changed there, where its line is.
Result<void> Catalog::refuse_elsewhere(std::string_view machine) {
  store::Nodes* const nodes = store_.nodes();
  if (nodes == nullptr) return {};
  const auto leases = lift(nodes->leases());
  if (!leases) return std::unexpected(leases.error());
  const auto lease = std::ranges::find(*leases, machine, &store::Lease::machine);
  if (lease == leases->end() || lease->node == nodes->own()) return {};
  return fail(ErrorCode::refused, fmt::format("the line of {} is with node {}: change it there", machine, lease->node));
}

// A new machine is this node's.
Result<store::Machine> Catalog::store_machine(const std::string& name, std::string_view document,
                                              std::string_view actor) {
  store::Result<store::Machine> stored;
  const auto done = store_.atomically([&]() -> store::Result<void> {
    stored = store_.machines().add(name, document, stamp(actor));
    if (!stored) return std::unexpected(stored.error());
    if (store::Nodes* const nodes = store_.nodes()) {
      if (auto leased = nodes->claim(name, stamp(actor)); !leased) return std::unexpected(leased.error());
    }
    return {};
  });
  if (!done) return std::unexpected(from_store(done.error()));
  return std::move(*stored);
}

Result<void> Catalog::open_lines(const store::OfMachines& of) {
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    const auto machines = store_.machines().list(page);
    if (!machines) return std::unexpected(from_store(machines.error()));
    for (const store::Machine& machine : machines->items) {
      if (of && !of(machine.name)) continue;
      const auto profile = documents_.read_profile(machine.profile);
      const auto hold = lines_.hold(machine.name);
      const auto set = profile ? lines_.set(*profile) : Result<void>(std::unexpected(profile.error()));
      if (!set) spdlog::error("{} has no line: {}", machine.name, set.error().text);
    }
    page.after = machines->next;
  } while (!page.after.empty());
  return {};
}

Result<machine::Profile> Catalog::checked_profile(std::string_view document) {
  auto profile = documents_.read_profile(document);
  if (!profile) return profile;
  const auto control = control_of(*profile);
  if (!control) return std::unexpected(control.error());
  return profile;
}

Result<store::Machine> Catalog::add_machine(std::string_view document, std::string_view actor) {
  const auto profile = checked_profile(document);
  if (!profile) return std::unexpected(profile.error());
  const auto hold = lines_.hold(profile->name);
  auto stored = store_machine(profile->name, document, actor);
  if (!stored) return stored;
  const auto line = lines_.set(*profile);
  if (!line) spdlog::error("{} has no line: {}", profile->name, line.error().text);
  publish(profile->name);
  return stored;
}

Result<store::Machine> Catalog::change_machine(std::string_view name, store::Revision expected,
                                               std::string_view document, std::string_view actor) {
  const auto profile = checked_profile(document);
  if (!profile) return std::unexpected(profile.error());
  if (profile->name != name) {
    return fail(ErrorCode::invalid, "a machine keeps its name",
                {{.pointer = "/name", .text = fmt::format("must be \"{}\"", name)}});
  }
  const auto hold = lines_.hold(profile->name);
  const auto on_line = lift(store_.jobs().on_line(name));
  if (!on_line) return std::unexpected(on_line.error());
  if (*on_line) return fail(ErrorCode::refused, fmt::format("job {} is on the line of {}", (*on_line)->id, name));
  if (auto here = refuse_elsewhere(name); !here) return std::unexpected(here.error());
  if (auto free = lines_.may_set(*profile); !free) return std::unexpected(free.error());
  auto stored = lift(store_.machines().change(name, expected, document, stamp(actor)));
  if (!stored) return stored;
  const auto line = lines_.set(*profile);
  if (!line) return std::unexpected(line.error());
  publish(profile->name);
  return stored;
}

Result<machine::Profile> Catalog::profile(std::string_view name) {
  const auto row = lift(store_.machines().get(name));
  if (!row) return std::unexpected(row.error());
  return documents_.read_profile(row->profile);
}

namespace {

struct ReadFamily {
  text::Source source;
  compile::FamilyDescription description;
};

Result<ReadFamily> read_family(std::string_view text) {
  ReadFamily read{.source = text::Source("family", std::string(text)), .description = {}};
  read.description = compile::describe_family(read.source);
  const auto fine = refuse_errors(read.description.diagnostics, read.source, "the family");
  if (!fine) return std::unexpected(fine.error());
  if (const std::string why = why_no_name(read.description.name); !why.empty()) {
    return fail(ErrorCode::invalid, fmt::format("the name of the family {}", why),
                {{.pointer = "/text", .text = fmt::format("the name after \"family\" {}", why)}});
  }
  return read;
}

}  // namespace

Result<compile::FamilyDescription> Catalog::check_family(std::string_view text, std::string_view name) {
  auto read = read_family(text);
  if (!read) return std::unexpected(read.error());
  if (!name.empty() && read->description.name != name) {
    return fail(ErrorCode::invalid,
                fmt::format("the text is of family \"{}\", not of \"{}\"", read->description.name, name));
  }
  return std::move(read->description);
}

Result<store::Family> Catalog::add_checked_family(std::string_view name, std::string_view text,
                                                  std::string_view actor) {
  return lift(store_.families().add(name, text, stamp(actor)));
}

Result<store::Family> Catalog::change_checked_family(std::string_view name, store::Revision expected,
                                                     std::string_view text, std::string_view actor) {
  return lift(store_.families().change(name, expected, text, stamp(actor)));
}

Result<store::Family> Catalog::add_family(std::string_view text, std::string_view actor) {
  const auto checked = check_family(text);
  return checked ? add_checked_family(checked->name, text, actor) : std::unexpected(checked.error());
}

Result<store::Family> Catalog::change_family(std::string_view name, store::Revision expected, std::string_view text,
                                             std::string_view actor) {
  const auto checked = check_family(text, name);
  return checked ? change_checked_family(name, expected, text, actor) : std::unexpected(checked.error());
}

Result<store::PartValues> Catalog::check_values(std::string_view family, const Values& values) {
  const auto row = lift(store_.families().get(family));
  if (!row) return std::unexpected(row.error());
  const text::Source source(row->name, row->text);
  const auto bound = compile::check_values(source, overrides_of(values));
  const auto fine = refuse_errors(bound, source, fmt::format("the values of family {}", family));
  if (!fine) return std::unexpected(fine.error());
  return store::PartValues{
      .family = row->name, .family_revision = row->revision, .values = documents_.write_values(values)};
}

Result<store::PartValues> Catalog::check_values_of(std::string_view number, const Values& values) {
  const auto part = lift(store_.parts().get(number));
  return part ? check_values(part->made_of.family, values) : std::unexpected(part.error());
}

Result<store::Part> Catalog::add_checked_part(std::string_view number, const store::PartValues& values,
                                              std::string_view actor) {
  return lift(store_.parts().add(number, values, stamp(actor)));
}

Result<store::Part> Catalog::change_checked_part(std::string_view number, store::Revision expected,
                                                 const store::PartValues& values, std::string_view actor) {
  return lift(store_.parts().change(number, expected, values, stamp(actor)));
}

Result<store::Part> Catalog::add_part(std::string_view number, std::string_view family, const Values& values,
                                      std::string_view actor) {
  const auto made_of = check_values(family, values);
  return made_of ? add_checked_part(number, *made_of, actor) : std::unexpected(made_of.error());
}

Result<store::Part> Catalog::change_part(std::string_view number, store::Revision expected, const Values& values,
                                         std::string_view actor) {
  const auto made_of = check_values_of(number, values);
  return made_of ? change_checked_part(number, expected, *made_of, actor) : std::unexpected(made_of.error());
}

std::vector<family::Override> overrides_of(const Values& values) {
  std::vector<family::Override> overrides;
  overrides.reserve(values.size());
  for (const auto& [name, value] : values) overrides.push_back({name, value});
  return overrides;
}

Result<ir::Control> control_of(const machine::Profile& profile) {
  const compile::Dialect* dialect = compile::find_dialect(profile.control.dialect);
  if (dialect == nullptr) {
    std::string known;
    for (const compile::Dialect& one : compile::dialects())
      known += fmt::format("{}{}", known.empty() ? "" : ", ", one.name);
    return fail(ErrorCode::invalid,
                fmt::format("dialect \"{}\" is not known; known are {}", profile.control.dialect, known),
                {{.pointer = "/dialect", .text = "known are " + known}});
  }
  return machine::control_of(profile, dialect->control(profile.control.kind, profile.control.g_system));
}

Result<void> refuse_errors(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source,
                           std::string_view what) {
  std::vector<ErrorPlace> places;
  std::size_t errors = 0;
  text::DiagnosticFold fold;
  for (const text::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity != text::Severity::error) continue;
    ++errors;
    if (!fold.shows(diagnostic)) continue;
    const text::Position at = source.position(diagnostic.span.begin);
    places.push_back({.pointer = {}, .line = at.line, .column = at.column, .text = text::message_of(diagnostic)});
  }
  if (places.empty()) return {};
  std::string sentence = fmt::format("{} has {} error{}: line {}, column {}: {}", what, errors, errors == 1 ? "" : "s",
                                     places.front().line, places.front().column, places.front().text);
  return fail(ErrorCode::invalid, std::move(sentence), std::move(places));
}

}  // namespace dripfeed::app
