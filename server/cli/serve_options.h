// The options of dripfeed serve: from the command line, laid over a file where one is named, and looked at before
// anything is begun.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/jobs/shifts.h"
#include "server/http/server.h"
#include "server/json/server_options.h"

namespace CLI {
class App;  // included only where options are added: it takes seconds to compile
}

namespace dripfeed::cli {

// As the command line has them.
struct GivenOptions {
  json::ServerOptions options;
  std::string config;        // --config
  bool only_check = false;   // --check
  bool only_schema = false;  // --config-schema
};
void add_serve_options(CLI::App& command, GivenOptions& given);

// What the file says, with what the command line says laid over it. Errors: unavailable, malformed, invalid.
app::Result<json::ServerOptions> options_of(const CLI::App& command, const GivenOptions& given);

// What the options mean.
struct ServePlan {
  http::ListenAddress address;
  std::map<std::uint8_t, std::string> modbus_units;  // machines by unit
  app::Shifts shifts{};
  std::optional<http::ListenAddress> modbus_address{};  // nothing: no Modbus server
  std::optional<http::ListenAddress> shdr_address{};    // nothing: no adapter of MTConnect
};
// Errors: invalid, as one sentence. Nothing is begun; the certificate and its key are read.
app::Result<ServePlan> plan_of(const json::ServerOptions& options);

// The options that differ, as the file names them.
struct ChangedOptions {
  std::vector<std::string> live;   // a running server may take them over
  std::vector<std::string> later;  // they take effect at the next start
};
ChangedOptions changed_options(const json::ServerOptions& before, const json::ServerOptions& after);

// `running` with the live options of `stated`.
json::ServerOptions with_live(json::ServerOptions running, const json::ServerOptions& stated);

}  // namespace dripfeed::cli
