// The members have the names of the options, with _ for -. A unit is a number by its machine, as in {"lathe": 1}.
#include "server/json/server_options.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "server/json/object_reader.h"
#include "server/json/openapi.h"
#include "server/json/place_in_text.h"

namespace dripfeed::json {

namespace {

constexpr std::int64_t kMostUnit = 247;

void read_texts(ObjectReader& o, std::string_view name, std::string_view about, std::vector<std::string>& into) {
  const Document* const given = o.member(name, list_of(filled_text(std::string(about)), ""));
  if (given == nullptr) return;
  if (!given->is_array()) return o.fault(name, "must be a list of texts");
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < given->size(); ++i) {
    const Document& one = (*given)[i];
    if (!one.is_string() || one.get_ref<const std::string&>().empty()) {
      o.fault(name, fmt::format("entry {} must be a text that is not empty", i + 1));
    } else {
      texts.push_back(one.get<std::string>());
    }
  }
  into = std::move(texts);
}

void read_units(ObjectReader& o, std::vector<std::string>& into) {
  constexpr std::string_view kName = "modbus_unit";
  const Document* const given =
      o.member(kName, map_of(integer(1, kMostUnit, "the unit of this machine"), "machines that PLCs see"));
  if (given == nullptr) return;
  if (!given->is_object()) return o.fault(kName, "must be an object of units by machine, as {\"lathe\": 1}");
  std::vector<std::string> units;
  for (const auto& [machine, unit] : given->items()) {
    const bool fits =
        unit.is_number_integer() && unit.get<std::int64_t>() >= 1 && unit.get<std::int64_t>() <= kMostUnit;
    if (!fits) {
      o.fault(kName, fmt::format("of \"{}\" must be a whole number from 1 to 247", machine));
    } else {
      units.push_back(fmt::format("{}={}", machine, unit.get<std::int64_t>()));
    }
  }
  into = std::move(units);
}

void read_retries(ObjectReader& o, std::vector<double>& into) {
  constexpr std::string_view kName = "webhook_retry_s";
  const Document* const given = o.member(
      kName, list_of(number(0.05, kMostRetry_s, "delay in seconds"),
                     "delays between the tries of a delivery; not given: those of Standard Webhooks, 3 days in all"));
  if (given == nullptr) return;
  if (!given->is_array() || given->size() > kMostRetries) return o.fault(kName, "must be a list of 20 numbers at most");
  into.clear();
  for (const Document& one : *given) {
    const double delay_s = one.is_number() ? one.get<double>() : 0.0;
    if (delay_s < 0.05 || delay_s > kMostRetry_s) return o.fault(kName, "must have seconds from 0.05 to 604800");
    into.push_back(delay_s);
  }
}

void read_members(ObjectReader& o, ServerOptions& into) {
  o.text("data", into.data);
  o.text("store", into.store);
  o.text("node", into.node);
  o.text("backups", into.backups);
  o.text("listen", into.listen);
  o.text("web", into.web);
  o.text("log", into.log);
  o.flag("insecure", into.insecure);
  o.text("tls_cert", into.tls_cert);
  o.text("tls_key", into.tls_key);
  read_texts(o, "proxy", "IP address", into.proxy);
  o.text("modbus_listen", into.modbus_listen);
  read_texts(o, "modbus_allow", "IP address", into.modbus_allow);
  read_units(o, into.modbus_unit);
  o.text("shdr_listen", into.shdr_listen);
  read_texts(o, "shdr_allow", "IP address", into.shdr_allow);
  o.text("event_source", into.event_source);
  o.text("webhook_ca", into.webhook_ca);
  read_retries(o, into.webhook_retry_s);
  o.text("mqtt", into.mqtt);
  o.text("mqtt_user", into.mqtt_user);
  o.text("mqtt_password_file", into.mqtt_password_file);
  o.text("mqtt_client_id", into.mqtt_client_id);
  o.text("mqtt_prefix", into.mqtt_prefix);
  o.text("mqtt_ca", into.mqtt_ca);
  o.text("sparkplug_group", into.sparkplug_group);
  o.text("sparkplug_node", into.sparkplug_node);
  read_texts(o, "shift", "start of a shift as HH:MM, by the server's clock", into.shift);
  read_texts(o, "stop_reason", "reason that people choose from when a transfer has stopped", into.stop_reason);
  o.text("arming_hook", into.arming_hook);
  o.text("arming_hook_secret_file", into.arming_hook_secret_file);
  o.text("arming_hook_unanswered", into.arming_hook_unanswered);
  o.flag("arming_hook_local", into.arming_hook_local);
  o.integer("arming_hook_seconds", into.arming_hook_seconds, 1, kMostHookSeconds);
  o.text("oidc", into.oidc);
  o.text("oidc_client_id", into.oidc_client_id);
  o.text("oidc_client_secret_file", into.oidc_client_secret_file);
  o.text("oidc_page", into.oidc_page);
  o.text("oidc_title", into.oidc_title);
  o.text("oidc_scope", into.oidc_scope);
  o.text("oidc_name_claim", into.oidc_name_claim);
  o.text("oidc_groups_claim", into.oidc_groups_claim);
  read_texts(o, "oidc_group", "GROUP=ROLE or GROUP=ROLE@MACHINES", into.oidc_group);
  o.text("oidc_ca", into.oidc_ca);
  o.flag("oidc_local", into.oidc_local);
  o.integer("oidc_seconds", into.oidc_seconds, 1, kMostOidcSeconds);
  o.integer("check_seconds", into.check_seconds, 1, kMostCheckSeconds);
  o.integer("check_memory", into.check_memory, kLeastCheckMemory_mb, kMostCheckMemory_mb);
  o.integer("program_mb", into.program_mb, 1, kMostUpload_mb);
  o.integer("attachment_mb", into.attachment_mb, 1, kMostUpload_mb);
  o.integer("store_mb", into.store_mb, 0, kMostStore_mb);
  o.integer("delete_after_days", into.delete_after_days, 0, kMostDeleteAfter_days);
}

}  // namespace

app::Result<void> read_server_options(std::string_view text, ServerOptions& into) {
  ServerOptions read = into;
  auto done = read_object(text, "the options", [&](ObjectReader& o) { read_members(o, read); });
  if (done) {
    into = std::move(read);
    return {};
  }
  app::Error error = std::move(done.error());
  for (app::ErrorPlace& fault : error.places) {
    if (fault.line != 0) continue;  // the parser's own
    const TextPlace place = place_in_text(text, fault.pointer);
    fault = {.pointer = {},
             .line = place.line,
             .column = place.column,
             .text = fmt::format("{} {}", fault.pointer, fault.text)};
  }
  if (error.code == app::ErrorCode::invalid && !error.places.empty()) error.text = "these options are refused";
  std::ranges::sort(error.places, {}, [](const app::ErrorPlace& one) { return std::pair(one.line, one.column); });
  return std::unexpected(std::move(error));
}

std::string server_options_schema() {
  ServerOptions standard;
  return json_schema(describe("options of dripfeed serve; an option of the command line wins over its member here",
                              [&](ObjectReader& o) { read_members(o, standard); }));
}

}  // namespace dripfeed::json
