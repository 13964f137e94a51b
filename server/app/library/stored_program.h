// The stored program that a control's name means.
#pragma once

#include <optional>
#include <string_view>

#include "server/app/base/error.h"
#include "store/store.h"

namespace dripfeed::app {

// By the likeliest form of the name that one is stored under (server/machine/program_names.h); nothing where none is.
// Errors: those of the store.
Result<std::optional<store::Program>> stored_program(store::Store& store, std::string_view name);

}  // namespace dripfeed::app
