// One look at the index for each form of the name.
#include "server/app/library/stored_program.h"

#include <utility>

#include "server/machine/program_names.h"

namespace dripfeed::app {

Result<std::optional<store::Program>> stored_program(store::Store& store, std::string_view name) {
  for (const std::string& form : machine::forms_of_program_name(name)) {
    auto known = lift(store.programs().list({.limit = 1, .after = {}}, {.name = form, .part = {}}));
    if (!known) return std::unexpected(known.error());
    if (!known->items.empty()) return std::move(known->items.front());
  }
  return std::nullopt;
}

}  // namespace dripfeed::app
