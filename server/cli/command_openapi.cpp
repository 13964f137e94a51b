// dripfeed openapi: the API's own description, as a server gives it at /api/openapi.json.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/http/describe.h"

namespace dripfeed::cli {

void add_openapi(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("openapi", "Print the description of the API (OpenAPI 3.1, JSON)");
  command->callback([&exit_code] {
    fmt::print("{}\n", http::describe_api(kVersion));
    exit_code = kDone;
  });
}

}  // namespace dripfeed::cli
