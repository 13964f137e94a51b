// What a server takes from the computer that it runs on: its name, and secrets from files.
#pragma once

#include <string>

#include "server/app/base/error.h"

namespace dripfeed::cli {

std::string host_name();

// The first line of a file that only the server reads; "" without a path. Errors: as read_source().
app::Result<std::string> password_in(const std::string& path);

}  // namespace dripfeed::cli
