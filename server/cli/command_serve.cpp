// dripfeed serve: the server with its store, its links and the API.
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "server/app/application.h"
#include "server/cli/cli.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/cli/signals.h"
#include "server/http/api.h"
#include "server/http/server.h"
#include "server/io/io.h"
#include "server/json/documents.h"
#include "store/hash/hash.h"
#include "store/sqlite/open.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kVersion = "0.1.0";

struct Options {
  std::string data = "data";
  std::string listen = "127.0.0.1:8840";
  std::string web;
  bool insecure = false;
};

// Only the owner may read it: it opens everything.
app::Result<void> write_secret(const fs::path& path, const std::string& secret) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const std::string line = secret + "\n";
  const bool written = descriptor >= 0 &&
                       ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size()) &&
                       ::fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (written) return {};
  return app::fail(app::ErrorCode::unavailable, fmt::format("{}: {}", path.string(), std::strerror(error)));
}

// A store without any token gets its first one, an admin's, in DATA/first-token.
app::Result<void> ensure_first_token(store::Store& store, const fs::path& data, const app::Clock& clock) {
  const auto tokens = app::lift(store.tokens().list({.limit = 1, .after = {}}));
  if (!tokens) return std::unexpected(tokens.error());
  if (!tokens->items.empty()) return {};
  const std::string token = hash::random_token();
  const auto written = write_secret(data / "first-token", token);
  if (!written) return written;
  const auto added = app::lift(
      store.tokens().add("admin", store::Role::admin, hash::token_hash(token), {"dripfeed", clock.wall_ms()}));
  if (!added) return std::unexpected(added.error());
  return {};
}

std::string web_root(const Options& options) {
  if (!options.web.empty()) return options.web;
  return find_shared("../web/dist").value_or("");
}

int run_server(const Options& options, const http::ListenAddress& address, store::Store& store,
               const std::stop_token& stop) {
  const io::SteadyClock clock;
  const json::JsonDocuments documents;
  const auto links = io::start_link_thread();
  app::Ballast ballast(fs::path(options.data) / "ballast");
  app::Application application({.store = store,
                                .links = *links,
                                .make_bus = io::make_modbus_bus,
                                .clock = clock,
                                .documents = documents,
                                .ballast = &ballast});
  const auto token = ensure_first_token(store, options.data, clock);
  const auto started = token ? application.start() : token;
  if (!started) {
    print_error(started.error());
    return kWrongUse;
  }
  http::Api api(application, web_root(options), kVersion);
  auto server = http::Server::start(address, {.refuse_long = [&](const http::Request& r) { return api.refuse_long(r); },
                                              .is_heavy = [&](const http::Request& r) { return api.is_heavy(r); },
                                              .answer = [&](const http::Request& r) { return api.answer(r); }});
  if (!server) {
    print_error(server.error());
    return kWrongUse;
  }
  fmt::print("dripfeed is at http://{}:{}/  (token: {})\n", address.host, (*server)->port(),
             (fs::path(options.data) / "first-token").string());
  std::fflush(stdout);
  while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  spdlog::info("stopping: running feeds end at their block");
  server->reset();
  return kDone;
}

int serve(const Options& options) {
  const std::stop_token stop = stop_by_signal();
  const auto address = http::parse_listen_address(options.listen);
  if (!address) {
    print_error(address.error());
    return kWrongUse;
  }
  if (!http::is_loopback(*address) && !options.insecure) {
    print_error(
        fmt::format("{} is not loopback and there is no TLS: tokens would be readable on the network. Put a TLS proxy "
                    "before it, or say --insecure",
                    options.listen));
    return kWrongUse;
  }
  std::error_code error;
  fs::create_directories(options.data, error);
  if (error) {
    print_error(fmt::format("{}: {}", options.data, error.message()));
    return kWrongUse;
  }
  auto store = sqlite::open((fs::path(options.data) / "dripfeed.db").string(), {.own = true});
  if (!store) {
    print_error(store::message_of(store.error()));
    return kWrongUse;
  }
  return run_server(options, *address, **store, stop);
}

}  // namespace

void add_serve(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("serve", "the server: store, lines, REST API and page");
  const auto options = std::make_shared<Options>();
  command->set_config("--config", "", "read options from this file");
  command->add_option("--data", options->data, "folder of the store")->capture_default_str();
  command->add_option("--listen", options->listen, "ADDRESS:PORT, loopback by default")->capture_default_str();
  command->add_option("--web", options->web, "folder of the built page");
  command->add_flag("--insecure", options->insecure, "listen beyond loopback without TLS");
  command->callback([options, &exit_code] { exit_code = serve(*options); });
}

}  // namespace dripfeed::cli
