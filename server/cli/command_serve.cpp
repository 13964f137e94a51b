// dripfeed serve: the server with its store, its links and the API.
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <thread>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

#include "server/app/application.h"
#include "server/app/shop/provider_people.h"
#include "server/cli/brokers.h"
#include "server/cli/cli.h"
#include "server/cli/data_folder.h"
#include "server/cli/host.h"
#include "server/cli/inputs.h"
#include "server/cli/logging.h"
#include "server/cli/open_store.h"
#include "server/cli/output.h"
#include "server/cli/readers.h"
#include "server/cli/rules_revision.h"
#include "server/cli/serve_options.h"
#include "server/cli/serve_reload.h"
#include "server/cli/signals.h"
#include "server/http/api.h"
#include "server/http/provider_sign_in.h"
#include "server/http/server.h"
#include "server/io/http_sender.h"
#include "server/io/io.h"
#include "server/io/line_claim.h"
#include "server/io/line_pulse.h"
#include "server/io/store_maintenance.h"
#include "server/io/thread_priority.h"
#include "server/io/worker_desk.h"
#include "server/json/cloud_events.h"
#include "server/json/documents.h"
#include "server/json/records.h"
#include "server/json/workers.h"
#include "store/hash/hash.h"
#include "store/sqlite/library.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

constexpr rlim_t kMostFiles = 8192;
// Of a request that computes when the server stops: a sweep looks every moment whether it is to end, a check does not.
constexpr std::chrono::seconds kRequestsEndWithin{5};

using json::ServerOptions;

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
  const auto added = app::lift(store.tokens().add(
      {.name = "admin", .role = store::Role::admin, .hash = hash::token_hash(token)}, {"dripfeed", clock.wall_ms()}));
  if (!added) return std::unexpected(added.error());
  return {};
}

// As many descriptors as the system lets us have: lines that reopen need some when clients have taken many.
void raise_file_limit() {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = std::min<rlim_t>(files.rlim_max, kMostFiles);
  ::setrlimit(RLIMIT_NOFILE, &files);  // where it is refused the limit stays, and HTTP takes half of it
}

std::string web_root(const ServerOptions& options) {
  if (!options.web.empty()) return options.web;
  return find_shared("../web/dist").value_or("");
}

std::uint64_t check_memory_bytes(const ServerOptions& options) { return std::uint64_t{options.check_memory} << 20U; }

// Each check runs in a process of this same program.
std::vector<std::string> worker_command(const ServerOptions& options) {
  const std::uint64_t computing_s = std::uint64_t{options.check_seconds} * json::DocumentWorkers::kSweepChecks;
  return {"/proc/self/exe", "worker",
          "--memory-bytes", fmt::format("{}", check_memory_bytes(options)),
          "--seconds",      fmt::format("{}", computing_s)};
}

io::WorkerDeskSettings desk_settings(const ServerOptions& options) {
  return {.command = worker_command(options),
          .at_once = std::max(2U, std::thread::hardware_concurrency() - 1U),
          .memory_bytes = check_memory_bytes(options),
          .memory_exit_code = kOverMemory};
}

app::LibraryLimits limits_of(const ServerOptions& options) {
  return {.program_bytes = std::uint64_t{options.program_mb} << 20U,
          .attachment_bytes = std::uint64_t{options.attachment_mb} << 20U,
          .store_bytes = std::uint64_t{options.store_mb} << 20U,
          .delete_after_days = options.delete_after_days};
}

// Who sends events: the computer, unless an option says what the shop calls this server.
std::string event_source(const ServerOptions& options) {
  return options.event_source.empty() ? fmt::format("dripfeed://{}", host_name()) : options.event_source;
}

io::HttpSenderSettings sender_settings(const ServerOptions& options) {
  return {.ca_file = options.webhook_ca, .user_agent = fmt::format("dripfeed/{}", std::string_view(kVersion))};
}

std::string backups_folder(const ServerOptions& options) {
  return options.backups.empty() ? (fs::path(options.data) / "backups").string() : options.backups;
}

std::vector<double> webhook_retries(const ServerOptions& options) {
  return options.webhook_retry_s.empty() ? app::kWebhookRetries_s : options.webhook_retry_s;
}

// Errors: invalid (the URL, the secret).
app::Result<app::HookSettings> arming_hook(const ServerOptions& options, const app::HttpSender& sender) {
  app::HookSettings hook;
  if (options.arming_hook.empty()) return hook;
  if (const std::string why = sender.why_no_target(options.arming_hook, options.arming_hook_local); !why.empty())
    return app::fail(app::ErrorCode::invalid, fmt::format("--arming-hook: the URL {}", why));
  auto secret = password_in(options.arming_hook_secret_file);
  if (!secret) return app::fail(app::ErrorCode::invalid, "--arming-hook-secret-file: " + secret.error().text);
  if (!hash::webhook_signature(*secret, {}))
    return app::fail(app::ErrorCode::invalid,
                     "--arming-hook-secret-file: its first line is not a secret: whsec_ and base64");
  hook.url = options.arming_hook;
  hook.secret = std::move(*secret);
  hook.local = options.arming_hook_local;
  hook.at_most = std::chrono::seconds(options.arming_hook_seconds);
  hook.arms_unanswered = options.arming_hook_unanswered == "warn";
  hook.make_sender = [settings = sender_settings(options)] {
    auto made = io::make_http_sender(settings);
    return made ? std::move(*made) : nullptr;
  };
  hook.write = json::arming_question;
  hook.read = json::read_hook_answer;
  return hook;
}

// Nothing where no provider is configured. Errors: invalid (the issuer's URL, the secret, the certificates).
app::Result<std::unique_ptr<http::ProviderSignIn>> provider_sign_in(const ServerOptions& options,
                                                                    const app::Clock& clock) {
  if (options.oidc.empty()) return nullptr;
  io::HttpSenderSettings sending = sender_settings(options);
  sending.ca_file = options.oidc_ca;
  const auto sender = io::make_http_sender(sending);
  if (!sender) return app::fail(app::ErrorCode::invalid, "--oidc-ca: " + sender.error());
  if (const std::string why = (*sender)->why_no_target(options.oidc, options.oidc_local); !why.empty())
    return app::fail(app::ErrorCode::invalid, fmt::format("--oidc: the URL {}", why));
  auto secret = password_in(options.oidc_client_secret_file);
  if (!secret) return app::fail(app::ErrorCode::invalid, "--oidc-client-secret-file: " + secret.error().text);
  if (secret->empty() && !options.oidc_client_secret_file.empty())
    return app::fail(app::ErrorCode::invalid, "--oidc-client-secret-file: its first line is empty");
  std::vector<app::GroupRole> mapping;
  for (const std::string& one : options.oidc_group) {
    auto row = app::read_group_role(one);
    if (!row) return std::unexpected(row.error());
    mapping.push_back(std::move(*row));
  }
  return std::make_unique<http::ProviderSignIn>(
      oidc::ProviderSettings{.issuer = options.oidc,
                             .client_id = options.oidc_client_id,
                             .client_secret = std::move(*secret),
                             .scope = options.oidc_scope,
                             .claims = {.name = options.oidc_name_claim, .groups = options.oidc_groups_claim},
                             .title = options.oidc_title,
                             .redirect_url = options.oidc_page + std::string(oidc::Provider::kPage),
                             .local = options.oidc_local,
                             .at_most = std::chrono::seconds(options.oidc_seconds),
                             .make_sender =
                                 [sending] {
                                   auto made = io::make_http_sender(sending);
                                   return made ? std::move(*made) : nullptr;
                                 },
                             .now_ms = [&clock] { return clock.wall_ms(); }},
      std::move(mapping));
}

struct Books {
  store::Store& store;
  store::Library* library;
};

// What a reload reaches.
struct Live {
  http::Server& server;
  Readers& readers;
  io::WorkerDesk& desk;
  json::DocumentWorkers& workers;
};

// Readers first: the address at which they are served may be another than the options state now.
app::Result<void> take_over(const Live& live, const ServerOptions& options) {
  if (auto readers = live.readers.set_allowed(options); !readers) return readers;
  if (const auto proxies = live.server.set_proxies(options.proxy); !proxies)
    return app::fail(app::ErrorCode::invalid, "--proxy: " + proxies.error());
  live.workers.set_seconds(options.check_seconds);
  live.desk.set_command(worker_command(options), check_memory_bytes(options));
  return {};
}

int run_server(const ServerOptions& options, const ServePlan& plan, const Books& books, Reload& reload,
               const std::stop_token& stop) {
  store::Store& store = books.store;
  const io::SteadyClock clock;
  const json::JsonDocuments documents;
  const io::ServiceNotices notices;
  const auto links = io::start_link_thread();
  const io::LinePulse pulse(*links, notices);
  links->run([] { spdlog::info("the lines are served {}", io::how_scheduled()); });
  app::DiskReserve disk_reserve(fs::path(options.data) / "disk-reserve");
  io::WorkerDesk desk(desk_settings(options));
  json::DocumentWorkers workers(desk, options.check_seconds, app::CalledPrograms(store, books.library));
  const auto sender = io::make_http_sender(sender_settings(options));
  if (!sender) {
    print_error(app::Error{app::ErrorCode::invalid, "--webhook-ca: " + sender.error(), {}});
    return kWrongUse;
  }
  auto hook = arming_hook(options, **sender);
  if (!hook) {
    print_error(hook.error());
    return kWrongUse;
  }
  const auto provider = provider_sign_in(options, clock);
  if (!provider) {
    print_error(provider.error());
    return kWrongUse;
  }
  io::StoreMaintenance maintenance({.program = "/proc/self/exe",
                                    .data = options.data,
                                    .database = options.store,
                                    .file = store_path(options.data),
                                    .backups = backups_folder(options)});
  const app::WriteEvent write_event = [source = event_source(options)](const store::LoggedEvent& event) {
    return json::cloud_event(event, source);
  };
  app::Application application({.store = store,
                                .links = *links,
                                .take_seat = io::take_modbus_seat,
                                .clock = clock,
                                .documents = documents,
                                .disk_reserve = &disk_reserve,
                                .claim = io::claim_line,
                                .workers = &workers,
                                .library = books.library,
                                .sender = sender->get(),
                                .webhooks = {.write = write_event, .retries_s = webhook_retries(options)},
                                .maintenance = &maintenance,
                                .event_source = event_source(options),
                                .version = std::string(kVersion),
                                .rules = std::string(rules_revision()),
                                .limits = limits_of(options),
                                .shifts = plan.shifts,
                                .stop_reasons = options.stop_reason,
                                .hook = std::move(*hook)});
  const auto token = ensure_first_token(store, options.data, clock);
  const auto started = token ? application.start() : token;
  if (!started) {
    print_error(started.error());
    return kWrongUse;
  }
  Readers readers;
  if (const auto listening = readers.start(application, options, plan); !listening) {
    print_error(listening.error());
    return kWrongUse;
  }
  Brokers brokers;
  if (const auto connected = brokers.start(application, options, write_event); !connected) {
    print_error(connected.error());
    return kWrongUse;
  }
  http::Api api(application, workers, web_root(options), kVersion, stop, provider->get());
  auto server = http::Server::start({.address = plan.address,
                                     .spool_folder = fs::path(options.data) / "uploads",
                                     .tls_certificate = options.tls_cert,
                                     .tls_key = options.tls_key,
                                     .heavy_threads = desk.threads(),
                                     .proxies = options.proxy,
                                     .traffic = api.traffic()},
                                    {.plan = http::Api::plan,
                                     .refuse_long = [&](const http::Request& r) { return api.refuse_long(r); },
                                     .answer = [&](const http::Request& r) { return api.answer(r); }});
  if (!server) {
    print_error(server.error());
    return kWrongUse;
  }
  const char* const scheme = options.tls_cert.empty() ? "http" : "https";
  if (app::NodeLines* const nodes = application.nodes())
    nodes->announce(fmt::format("{}://{}:{}", scheme, http::is_loopback(plan.address) ? plan.address.host : host_name(),
                                (*server)->port()));
  announce(fmt::format("dripfeed is at {}://{}:{}/  (token: {})", scheme, plan.address.host, (*server)->port(),
                       (fs::path(options.data) / "first-token").string()));
  notices.notify("READY=1");
  {
    const Live live{.server = **server, .readers = readers, .desk = desk, .workers = workers};
    const Reload::Running running(reload, [&](const ServerOptions& now) { return take_over(live, now); });
    for (io::PulseWatch watch(pulse); !stop.stop_requested(); watch.look(clock.now()))
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  notices.notify("STOPPING=1");
  spdlog::info("stopping: running feeds end at their block");
  (*server)->close();
  // The lines first: a request that is still at work must not keep a feed from ending at its block.
  application.end_lines();
  brokers.stop();
  if ((*server)->stop(kRequestsEndWithin)) return kDone;
  spdlog::warn("a request was still at work after {} s and was given up; the store and the lines have ended well",
               kRequestsEndWithin.count());
  spdlog::shutdown();
  std::_Exit(kDone);  // its thread uses what would be destroyed here
}

int serve(const ServerOptions& options, const Reload::Read& read_again) {
  const auto reload = std::make_shared<Reload>(options, read_again);  // the signals' thread outlives this call
  const std::stop_token stop = stop_by_signal_and_reload([reload] { reload->run(); });
  const Logging logging(options.log == "json" ? LogForm::json : LogForm::text);
  const auto plan = plan_of(options);
  if (!plan) {
    print_error(plan.error());
    return kWrongUse;
  }
  if (const auto made = make_data_folder(options.data); !made) {
    print_error(made.error());
    return kWrongUse;
  }
  raise_file_limit();
  auto store = open_to_serve({.data = options.data, .url = options.store, .node = options.node});
  if (!store) {
    print_error(store::message_of(store.error()));
    return kWrongUse;
  }
  // A shop goes on without it.
  auto library = sqlite::open_library(sqlite::library_path(store_path(options.data)));
  if (!library) spdlog::warn("programs cannot be searched: {}", store::message_of(library.error()));
  return run_server(options, *plan, {.store = **store, .library = library ? library->get() : nullptr}, *reload, stop);
}

// --check: what would keep the server from its start, as far as options say.
int check_options(const ServerOptions& options) {
  const auto plan = plan_of(options);
  if (!plan) {
    print_error(plan.error());
    return kWrongUse;
  }
  return write_output("-",
                      fmt::format("the options are valid: data in {}, listening at {}\n", options.data, options.listen))
             ? kDone
             : kWrongUse;
}

int serve_as_given(const CLI::App& command, const GivenOptions& given) {
  if (given.only_schema) return write_output("-", json::server_options_schema() + "\n") ? kDone : kWrongUse;
  const auto options = options_of(command, given);
  if (!options) {
    print_error(options.error());
    return kWrongUse;
  }
  return given.only_check ? check_options(*options) : serve(*options, [&] { return options_of(command, given); });
}

}  // namespace

void add_serve(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("serve", "the server: store, lines, REST API and page");
  const auto given = std::make_shared<GivenOptions>();
  add_serve_options(*command, *given);
  command->callback([command, given, &exit_code] { exit_code = serve_as_given(*command, *given); });
}

}  // namespace dripfeed::cli
