// Machines, families and parts: what the shop has. Documents are checked before they are stored; a wrong one leaves
// nothing after.
#pragma once

#include <string>
#include <string_view>

#include "dialects/compile/render/render.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/lines/lines.h"
#include "server/app/out/events.h"
#include "store/store.h"

namespace dripfeed::app {

// Refers to all it is given.
class Catalog {
 public:
  Catalog(store::Store& store, Lines& lines, Events& events, const Clock& clock, const Documents& documents);

  // Opens the lines of stored machines; a profile that cannot be kept any more is logged and has no line.
  Result<void> open_lines(const store::OfMachines& of = {});
  // Errors: not_found, and those of a line that cannot be opened.
  Result<void> open_line(const std::string& machine);

  // Errors: invalid (with places), exists, stale, refused (a job is on the line).
  Result<store::Machine> add_machine(std::string_view document, std::string_view actor);
  Result<store::Machine> change_machine(std::string_view name, store::Revision expected, std::string_view document,
                                        std::string_view actor);
  Result<machine::Profile> profile(std::string_view name);

  // Errors: invalid with line and column of each fault.
  Result<store::Family> add_family(std::string_view text, std::string_view actor);
  Result<store::Family> change_family(std::string_view name, store::Revision expected, std::string_view text,
                                      std::string_view actor);

  // The same in two steps: the first reads the text, which may take long; the second writes rows alone and may share a
  // transaction. check_family gives what the text says; its name must be `name` where that is given.
  Result<compile::FamilyDescription> check_family(std::string_view text, std::string_view name = {});
  Result<store::Family> add_checked_family(std::string_view name, std::string_view text, std::string_view actor);
  Result<store::Family> change_checked_family(std::string_view name, store::Revision expected, std::string_view text,
                                              std::string_view actor);

  // The values must bind to the family's newest revision. Errors: invalid, exists, not_found.
  Result<store::Part> add_part(std::string_view number, std::string_view family, const Values& values,
                               std::string_view actor);
  Result<store::Part> change_part(std::string_view number, store::Revision expected, const Values& values,
                                  std::string_view actor);
  // The same in two steps, as with families.
  Result<store::PartValues> check_values(std::string_view family, const Values& values);
  Result<store::PartValues> check_values_of(std::string_view number, const Values& values);
  Result<store::Part> add_checked_part(std::string_view number, const store::PartValues& values,
                                       std::string_view actor);
  Result<store::Part> change_checked_part(std::string_view number, store::Revision expected,
                                          const store::PartValues& values, std::string_view actor);

 private:
  Result<void> refuse_elsewhere(std::string_view machine);
  Result<store::Machine> store_machine(const std::string& name, std::string_view document, std::string_view actor);
  Result<machine::Profile> checked_profile(std::string_view document);
  [[nodiscard]] store::Stamp stamp(std::string_view actor) const;
  void publish(const std::string& machine);

  store::Store& store_;
  Lines& lines_;
  Events& events_;
  const Clock& clock_;
  const Documents& documents_;
};

// The control of a profile: its dialect's tables with the profile's settings. Errors: invalid (no such dialect).
Result<ir::Control> control_of(const machine::Profile& profile);

std::vector<family::Override> overrides_of(const Values& values);

// Errors of a text as an Error with line and column of each; nothing when there is none.
Result<void> refuse_errors(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source,
                           std::string_view what);

}  // namespace dripfeed::app
