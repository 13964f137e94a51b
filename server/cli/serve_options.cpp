// An option is one row: how the command line names it, and which member it is. The file's members have the same names.
#include "server/cli/serve_options.h"

#include <algorithm>
#include <charconv>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/app/jobs/stop_reasons.h"
#include "server/app/mqtt.h"
#include "server/app/out/sparkplug_node.h"
#include "server/app/shop/provider_people.h"
#include "server/cli/inputs.h"
#include "server/http/tls.h"
#include "server/io/mqtt_broker.h"
#include "server/oidc/provider_document.h"

namespace dripfeed::cli {

namespace {

using json::ServerOptions;

template <class Value>
struct Row {
  const char* name;
  Value ServerOptions::* member;
  const char* about;
  bool is_live = false;  // a running server takes it over
};

constexpr Row<std::string> kTexts[] = {
    {"--data", &ServerOptions::data, "folder of the store"},
    {"--store", &ServerOptions::store,
     "postgresql://USER@HOST/DATABASE: keep the store in this database of a PostgreSQL server, 14 or later; without "
     "it, "
     "in the folder"},
    {"--node", &ServerOptions::node,
     "name of this server, where several share the store of a PostgreSQL server: each has the lines of its machines"},
    {"--backups", &ServerOptions::backups,
     "folder of the backups that admins make on the page, best on another disk; DATA/backups by default"},
    {"--listen", &ServerOptions::listen, "ADDRESS:PORT, loopback by default"},
    {"--web", &ServerOptions::web, "folder of the built page"},
    {"--log", &ServerOptions::log, "form of the log: text, or json: a JSON object a line with time, level and text"},
    {"--modbus-listen", &ServerOptions::modbus_listen,
     "ADDRESS:PORT: PLCs may read there what the machines do, by Modbus TCP"},
    {"--shdr-listen", &ServerOptions::shdr_listen,
     "ADDRESS:PORT: agents of MTConnect may read there what the machines do, as from an adapter (SHDR)"},
    {"--tls-cert", &ServerOptions::tls_cert, "certificate with its chain, PEM: HTTPS; read again when it changes"},
    {"--tls-key", &ServerOptions::tls_key, "its key, PEM"},
    {"--event-source", &ServerOptions::event_source,
     "URI by which events say where they are from; dripfeed://HOSTNAME by default"},
    {"--webhook-ca", &ServerOptions::webhook_ca,
     "certificates that webhooks' receivers are believed by, PEM; the system's by default"},
    {"--arming-hook", &ServerOptions::arming_hook,
     "URL of a system that is asked before each arming, and may refuse it; signed as webhooks are"},
    {"--arming-hook-secret-file", &ServerOptions::arming_hook_secret_file,
     "file whose first line is the secret that questions are signed with (whsec_…)"},
    {"--arming-hook-unanswered", &ServerOptions::arming_hook_unanswered,
     "where no answer comes: refuse, or warn: arm all the same, with a row in the audit"},
    {"--mqtt", &ServerOptions::mqtt,
     "mqtt://HOST[:PORT] or mqtts://: a broker that gets states and events; nothing comes from it"},
    {"--mqtt-user", &ServerOptions::mqtt_user, "who the broker knows us as"},
    {"--mqtt-password-file", &ServerOptions::mqtt_password_file,
     "file whose first line is the password for the broker"},
    {"--mqtt-client-id", &ServerOptions::mqtt_client_id,
     "dripfeed-HOSTNAME by default; with --node dripfeed-HOSTNAME-NODE"},
    {"--mqtt-prefix", &ServerOptions::mqtt_prefix, "what all topics begin with, as enterprise/site/area"},
    {"--mqtt-ca", &ServerOptions::mqtt_ca, "certificates that the broker is believed by, PEM; the system's by default"},
    {"--sparkplug-group", &ServerOptions::sparkplug_group,
     "id of a group of Sparkplug B: the broker gets the states of machines as Sparkplug, too"},
    {"--sparkplug-node", &ServerOptions::sparkplug_node,
     "id of this server as its edge node; HOSTNAME by default, with --node HOSTNAME-NODE"},
    {"--oidc", &ServerOptions::oidc,
     "issuer of an OpenID Connect provider, https://…: people sign in there, by authorization code with PKCE"},
    {"--oidc-client-id", &ServerOptions::oidc_client_id, "what the provider knows this server as"},
    {"--oidc-client-secret-file", &ServerOptions::oidc_client_secret_file,
     "file whose first line is the secret for the provider; without it this is a public client"},
    {"--oidc-page", &ServerOptions::oidc_page,
     "where browsers find this server's page, as https://dnc.shop; register this with /sign-in at the provider"},
    {"--oidc-title", &ServerOptions::oidc_title, "name of the provider on the button"},
    {"--oidc-scope", &ServerOptions::oidc_scope, "scopes to ask for besides openid, with blanks between"},
    {"--oidc-name-claim", &ServerOptions::oidc_name_claim,
     "claim of the ID token with the name of a new user; best one that people cannot change"},
    {"--oidc-groups-claim", &ServerOptions::oidc_groups_claim, "claim of the ID token with the groups of a person"},
    {"--oidc-ca", &ServerOptions::oidc_ca,
     "certificates that the provider is believed by, PEM; the system's by default"},
};
constexpr Row<std::vector<std::string>> kLists[] = {
    {"--modbus-unit", &ServerOptions::modbus_unit, "MACHINE=UNIT: shown to PLCs as this unit, 1..247"},
    {"--modbus-allow", &ServerOptions::modbus_allow,
     "IP address that may read; must be given where --modbus-listen is not loopback", true},
    {"--shdr-allow", &ServerOptions::shdr_allow,
     "IP address of an agent; must be given where --shdr-listen is not loopback", true},
    {"--shift", &ServerOptions::shift,
     "HH:MM: a shift begins then, by this computer's clock; 06:00, 14:00 and 22:00 by default"},
    {"--stop-reason", &ServerOptions::stop_reason,
     "a reason that people choose from when a transfer has stopped, one for each; by default the usual ones"},
    {"--proxy", &ServerOptions::proxy,
     "IP address of a proxy whose X-Forwarded-Host and X-Forwarded-Proto are believed", true},
    {"--oidc-group", &ServerOptions::oidc_group,
     "GROUP=ROLE or GROUP=ROLE@MACHINES: the role of each person in this group at the provider, on all machines or on "
     "those "
     "of a group; without any an administrator gives the roles"},
};
constexpr Row<std::vector<double>> kDelays[] = {
    {"--webhook-retry-s", &ServerOptions::webhook_retry_s,
     "delay in seconds before a webhook is tried again, once for each further try; by default those of Standard "
     "Webhooks: 3 days in all"},
};
struct NumberRow {
  Row<std::uint32_t> row;
  std::uint32_t least;
  std::uint32_t most;
};
constexpr NumberRow kNumbers[] = {
    {{"--arming-hook-seconds", &ServerOptions::arming_hook_seconds, "how long its answer may take"},
     1,
     json::kMostHookSeconds},
    {{"--oidc-seconds", &ServerOptions::oidc_seconds, "how long the provider's answers to one sign-in may take"},
     1,
     json::kMostOidcSeconds},
    {{"--check-seconds", &ServerOptions::check_seconds, "budget of time of one check; a sweep has ten times it", true},
     1,
     json::kMostCheckSeconds},
    {{"--check-memory", &ServerOptions::check_memory, "budget of memory of one check, in MB", true},
     json::kLeastCheckMemory_mb,
     json::kMostCheckMemory_mb},
    {{"--program-mb", &ServerOptions::program_mb, "limit of one program's text, in MB"}, 1, json::kMostUpload_mb},
    {{"--attachment-mb", &ServerOptions::attachment_mb, "limit of one attached file, in MB"}, 1, json::kMostUpload_mb},
    {{"--store-mb", &ServerOptions::store_mb, "limit of all texts and files, in MB; 0: none but the disk"},
     0,
     json::kMostStore_mb},
    {{"--delete-after-days", &ServerOptions::delete_after_days,
      "how many days a program is archived before it may be deleted"},
     0,
     json::kMostDeleteAfter_days},
};
constexpr Row<bool> kFlags[] = {
    {"--insecure", &ServerOptions::insecure, "listen beyond loopback without TLS"},
    {"--arming-hook-local", &ServerOptions::arming_hook_local,
     "the hook may be this computer or in a private network, by HTTP too"},
    {"--oidc-local", &ServerOptions::oidc_local, "the provider may be this computer or in a private network"}};

template <class Visit>
void for_each_option(const Visit& visit) {
  for (const auto& row : kTexts) visit(row);
  for (const auto& row : kLists) visit(row);
  for (const auto& row : kDelays) visit(row);
  for (const auto& row : kNumbers) visit(row.row);
  for (const auto& row : kFlags) visit(row);
}

// What the command line names wins.
template <class Value>
void lay_over(const CLI::App& command, const Row<Value>& row, const ServerOptions& given, ServerOptions& into) {
  if (command.count(row.name) > 0) into.*row.member = given.*row.member;
}

template <class Value>
void note_change(const Row<Value>& row, const ServerOptions& before, const ServerOptions& after, ChangedOptions& into) {
  if (before.*row.member == after.*row.member) return;
  std::string name = row.name + 2;  // without its dashes
  std::ranges::replace(name, '-', '_');
  (row.is_live ? into.live : into.later).push_back(std::move(name));
}

template <class Value>
void take_live(const Row<Value>& row, const ServerOptions& from, ServerOptions& into) {
  if (row.is_live) into.*row.member = from.*row.member;
}

// MACHINE=UNIT, each unit and each machine once.
app::Result<std::map<std::uint8_t, std::string>> units_of(const std::vector<std::string>& given) {
  std::map<std::uint8_t, std::string> units;
  for (const std::string& one : given) {
    const std::size_t equals = one.rfind('=');
    int unit = 0;
    const char* const end = one.data() + one.size();
    const bool has_number = equals != std::string::npos && equals > 0 &&
                            std::from_chars(one.data() + equals + 1, end, unit).ptr == end && one.back() != '=';
    if (!has_number || unit < 1 || unit > 247)
      return app::fail(app::ErrorCode::invalid, fmt::format("--modbus-unit \"{}\": use MACHINE=1..247", one));
    const std::string machine = one.substr(0, equals);
    const bool named = std::ranges::any_of(units, [&](const auto& row) { return row.second == machine; });
    if (named || !units.emplace(static_cast<std::uint8_t>(unit), machine).second)
      return app::fail(app::ErrorCode::invalid, fmt::format("--modbus-unit \"{}\": named twice", one));
  }
  return units;
}

app::Result<void> check_tls(const ServerOptions& options, const http::ListenAddress& address) {
  if (options.tls_cert.empty() != options.tls_key.empty())
    return app::fail(app::ErrorCode::invalid, "--tls-cert and --tls-key go together: give both");
  if (!options.tls_cert.empty()) {
    const auto files = http::TlsFiles::open(options.tls_cert, options.tls_key);
    return files ? app::Result<void>() : app::fail(app::ErrorCode::invalid, files.error());
  }
  if (http::is_loopback(address) || options.insecure) return {};
  return app::fail(
      app::ErrorCode::invalid,
      fmt::format("{} is not loopback and there is no TLS: tokens would be readable on the network. Give --tls-cert "
                  "and --tls-key, put a TLS proxy before it, or pass --insecure",
                  options.listen));
}

app::Result<void> check_addresses(std::string_view option, const std::vector<std::string>& named) {
  for (const std::string& one : named)
    if (!http::is_ip_address(one))
      return app::fail(app::ErrorCode::invalid, fmt::format("{}: \"{}\" is not an IP address", option, one));
  return {};
}

// An address at which whoever reaches it reads: the protocols have no rights of their own.
struct OpenAddress {
  std::string_view option;  // "modbus": of --modbus-listen and --modbus-allow
  const std::string& listen;
  const std::vector<std::string>& allow;
};

// Nothing where it is not asked for.
app::Result<std::optional<http::ListenAddress>> open_address(const OpenAddress& one) {
  if (const auto readers = check_addresses(fmt::format("--{}-allow", one.option), one.allow); !readers)
    return std::unexpected(readers.error());
  if (one.listen.empty()) return std::nullopt;
  const auto address = http::parse_listen_address(one.listen);
  if (!address) return app::fail(app::ErrorCode::invalid, fmt::format("--{}-listen: {}", one.option, address.error()));
  if (one.allow.empty() && !http::is_loopback(*address))
    return app::fail(app::ErrorCode::invalid,
                     fmt::format("--{0}-listen {1} is not loopback: state by --{0}-allow which addresses may read",
                                 one.option, one.listen));
  return *address;
}

app::Result<void> check_node(const ServerOptions& options) {
  if (options.node.empty() || !options.store.empty()) return {};
  return app::fail(app::ErrorCode::invalid, "--node: only servers that share a store have names; give --store, too");
}

app::Result<void> check_sparkplug(const ServerOptions& options) {
  struct Id {
    const char* option;
    const std::string& given;
  };
  for (const Id& id :
       {Id{"--sparkplug-group", options.sparkplug_group}, Id{"--sparkplug-node", options.sparkplug_node}}) {
    const std::string why = id.given.empty() ? std::string() : app::why_no_sparkplug_id(id.given);
    if (!why.empty()) return app::fail(app::ErrorCode::invalid, fmt::format("{} {}", id.option, why));
  }
  if (options.sparkplug_group.empty() && !options.sparkplug_node.empty())
    return app::fail(app::ErrorCode::invalid, "--sparkplug-node: give --sparkplug-group, too");
  if (options.sparkplug_group.empty() || options.node.empty() || !options.sparkplug_node.empty()) return {};
  const std::string why = app::why_no_sparkplug_id(options.node);
  if (why.empty()) return {};
  return app::fail(
      app::ErrorCode::invalid,
      fmt::format("the name of --node is a part of the edge node's id, which {}: give --sparkplug-node", why));
}

app::Result<void> check_mqtt(const ServerOptions& options) {
  if (options.mqtt.empty()) {
    if (options.sparkplug_group.empty() && options.sparkplug_node.empty()) return {};
    return app::fail(app::ErrorCode::invalid, "--sparkplug-group: it needs a broker; give --mqtt, too");
  }
  if (const std::string why = io::why_no_mqtt_url(options.mqtt); !why.empty())
    return app::fail(app::ErrorCode::invalid, fmt::format("--mqtt {}", why));
  if (const std::string why = app::why_no_prefix(options.mqtt_prefix); !why.empty())
    return app::fail(app::ErrorCode::invalid, fmt::format("--mqtt-prefix {}", why));
  return check_sparkplug(options);
}

app::Result<void> check_log(const ServerOptions& options) {
  if (options.log == "text" || options.log == "json") return {};
  return app::fail(app::ErrorCode::invalid, "--log: use text or json");
}

// Whether the URL is one that is allowed is looked at with the sender.
app::Result<void> check_hook(const ServerOptions& options) {
  if (options.arming_hook_unanswered != "refuse" && options.arming_hook_unanswered != "warn")
    return app::fail(app::ErrorCode::invalid, "--arming-hook-unanswered: use refuse or warn");
  if (options.arming_hook.empty() == options.arming_hook_secret_file.empty()) return {};
  return app::fail(app::ErrorCode::invalid, "--arming-hook and --arming-hook-secret-file go together: give both");
}

app::Result<void> check_oidc(const ServerOptions& options) {
  const auto refuse = [](std::string why) { return app::fail(app::ErrorCode::invalid, std::move(why)); };
  for (const std::string& one : options.oidc_group)
    if (const auto row = app::read_group_role(one); !row) return refuse("--oidc-group " + row.error().text);
  if (options.oidc.empty()) {
    return options.oidc_client_id.empty() && options.oidc_page.empty()
               ? app::Result<void>()
               : refuse("--oidc-client-id and --oidc-page belong to a provider: give --oidc, too");
  }
  if (options.oidc_client_id.empty() || options.oidc_page.empty())
    return refuse("--oidc needs --oidc-client-id and --oidc-page");
  if (const std::string why = oidc::why_no_endpoint(options.oidc); !why.empty()) return refuse("--oidc " + why);
  if (const std::string why = oidc::why_no_page(options.oidc_page, options.insecure); !why.empty())
    return refuse("--oidc-page " + why);
  return {};
}

}  // namespace

void add_serve_options(CLI::App& command, GivenOptions& given) {
  ServerOptions& options = given.options;
  command.add_option(
      "--config", given.config,
      "JSON file with these options, as {\"data\": \"/srv/dripfeed\", \"check_seconds\": 30}; the command "
      "line wins over it");
  for (const auto& row : kTexts) {
    CLI::Option* const option = command.add_option(row.name, options.*row.member, row.about);
    if (!(options.*row.member).empty()) option->capture_default_str();
  }
  for (const auto& row : kLists) command.add_option(row.name, options.*row.member, row.about);
  for (const auto& row : kDelays)
    command.add_option(row.name, options.*row.member, row.about)->check(CLI::Range(0.05, json::kMostRetry_s));
  for (const auto& [row, least, most] : kNumbers) {
    command.add_option(row.name, options.*row.member, row.about)->check(CLI::Range(least, most))->capture_default_str();
  }
  for (const auto& row : kFlags) command.add_flag(row.name, options.*row.member, row.about);
  command.add_flag("--check", given.only_check, "look at the options, and start nothing");
  command.add_flag("--config-schema", given.only_schema, "print the JSON schema of the file, and start nothing");
}

app::Result<ServerOptions> options_of(const CLI::App& command, const GivenOptions& given) {
  if (given.config.empty()) return given.options;
  const auto file = read_source(given.config);
  if (!file) return std::unexpected(file.error());
  ServerOptions options;
  if (auto read = json::read_server_options(file->text(), options); !read) {
    app::Error error = std::move(read.error());
    error.text = fmt::format("{}: {}", given.config, error.text);
    return std::unexpected(std::move(error));
  }
  for_each_option([&](const auto& row) { lay_over(command, row, given.options, options); });
  return options;
}

ChangedOptions changed_options(const ServerOptions& before, const ServerOptions& after) {
  ChangedOptions changed;
  for_each_option([&](const auto& row) { note_change(row, before, after, changed); });
  return changed;
}

ServerOptions with_live(ServerOptions running, const ServerOptions& stated) {
  for_each_option([&](const auto& row) { take_live(row, stated, running); });
  return running;
}

app::Result<ServePlan> plan_of(const ServerOptions& options) {
  const auto address = http::parse_listen_address(options.listen);
  if (!address) return app::fail(app::ErrorCode::invalid, address.error());
  if (const auto tls = check_tls(options, *address); !tls) return std::unexpected(tls.error());
  if (const auto node = check_node(options); !node) return std::unexpected(node.error());
  if (const auto mqtt = check_mqtt(options); !mqtt) return std::unexpected(mqtt.error());
  if (const auto log = check_log(options); !log) return std::unexpected(log.error());
  if (const auto hook = check_hook(options); !hook) return std::unexpected(hook.error());
  if (const auto oidc = check_oidc(options); !oidc) return std::unexpected(oidc.error());
  if (const auto proxies = check_addresses("--proxy", options.proxy); !proxies) return std::unexpected(proxies.error());
  auto modbus = open_address({"modbus", options.modbus_listen, options.modbus_allow});
  if (!modbus) return std::unexpected(modbus.error());
  auto shdr = open_address({"shdr", options.shdr_listen, options.shdr_allow});
  if (!shdr) return std::unexpected(shdr.error());
  auto units = units_of(options.modbus_unit);
  if (!units) return std::unexpected(units.error());
  auto shifts = app::Shifts::of(options.shift);
  if (!shifts) return app::fail(app::ErrorCode::invalid, "--shift " + shifts.error());
  if (const std::string why = app::why_no_stop_reasons(options.stop_reason); !why.empty())
    return app::fail(app::ErrorCode::invalid, "--stop-reason: " + why);
  return ServePlan{.address = *address,
                   .modbus_units = std::move(*units),
                   .shifts = std::move(*shifts),
                   .modbus_address = std::move(*modbus),
                   .shdr_address = std::move(*shdr)};
}

}  // namespace dripfeed::cli
