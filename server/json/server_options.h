// The options of dripfeed serve, as the command line and as a file have them. One function reads the file and describes
// it (see object_reader.h), so that its schema cannot differ from its reading.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"

namespace dripfeed::json {

struct ServerOptions {
  std::string data = "data";
  std::string store{};    // "": in the folder
  std::string node{};     // name of this server among those of its store; "": it is the only one
  std::string backups{};  // "": DATA/backups
  std::string listen = "127.0.0.1:8840";
  std::string web{};
  std::string log = "text";  // or "json"
  bool insecure = false;
  std::string tls_cert{};  // both or neither
  std::string tls_key{};
  std::vector<std::string> proxy{};         // IP addresses
  std::string modbus_listen{};              // "": no Modbus server
  std::vector<std::string> modbus_allow{};  // IP addresses
  std::string shdr_listen{};                // "": no adapter of MTConnect
  std::vector<std::string> shdr_allow{};    // IP addresses
  std::vector<std::string> modbus_unit{};   // MACHINE=UNIT
  std::string event_source{};               // "": by the computer's name
  std::string webhook_ca{};                 // PEM; "": whom the system believes
  std::vector<double> webhook_retry_s{};    // empty: the standard's
  std::string mqtt{};                       // URL of the broker; "": none
  std::string mqtt_user{};
  std::string mqtt_password_file{};
  std::string mqtt_client_id{};  // "": by the computer's name and `node`
  std::string mqtt_prefix = "dripfeed";
  std::string mqtt_ca{};                   // PEM; "": whom the system believes
  std::string sparkplug_group{};           // "": no Sparkplug
  std::string sparkplug_node{};            // "": the computer's name, and `node`
  std::vector<std::string> shift{};        // "06:00"; empty: 06:00, 14:00 and 22:00
  std::vector<std::string> stop_reason{};  // empty: the usual ones
  std::string arming_hook{};               // URL that is asked before an arming; "": none
  std::string arming_hook_secret_file{};
  std::string arming_hook_unanswered = "refuse";  // or "warn"
  bool arming_hook_local = false;
  std::uint32_t arming_hook_seconds = 5;
  std::string oidc{};                         // issuer of an OpenID Connect provider that signs people in; "": none
  std::string oidc_client_id{};               // of this server, as it is registered there
  std::string oidc_client_secret_file{};      // "": a public client
  std::string oidc_page{};                    // "https://dnc.shop": where browsers find the page
  std::string oidc_title = "OpenID Connect";  // on the button
  std::string oidc_scope = "profile";         // besides openid
  std::string oidc_name_claim = "preferred_username";
  std::string oidc_groups_claim = "groups";
  std::vector<std::string> oidc_group{};  // GROUP=ROLE[@MACHINES]; empty: an administrator gives the roles
  std::string oidc_ca{};                  // PEM; "": whom the system believes
  bool oidc_local = false;
  std::uint32_t oidc_seconds = 5;
  std::uint32_t check_seconds = 60;
  std::uint32_t check_memory = 2048;     // MB
  std::uint32_t program_mb = 64;         // of one text
  std::uint32_t attachment_mb = 64;      // of one attached file
  std::uint32_t store_mb = 0;            // of all texts and files; 0: no limit but the disk
  std::uint32_t delete_after_days = 30;  // after a program was archived
  friend bool operator==(const ServerOptions&, const ServerOptions&) = default;
};
inline constexpr double kMostRetry_s = 604'800.0;  // a week
inline constexpr std::size_t kMostRetries = 20;
inline constexpr std::uint32_t kMostHookSeconds = 15;
inline constexpr std::uint32_t kMostOidcSeconds = 15;
inline constexpr std::uint32_t kMostCheckSeconds = 86'400;
inline constexpr std::uint32_t kMostUpload_mb = 64;
inline constexpr std::uint32_t kMostStore_mb = 1'073'741'824;
inline constexpr std::uint32_t kMostDeleteAfter_days = 36'500;
inline constexpr std::uint32_t kLeastCheckMemory_mb = 64;
inline constexpr std::uint32_t kMostCheckMemory_mb = 1'048'576;

// Lays the file's text over `into`: what it does not name stays as it is. Errors: malformed, invalid; each fault with
// its line and column.
app::Result<void> read_server_options(std::string_view text, ServerOptions& into);
// As JSON Schema (2020-12).
std::string server_options_schema();

}  // namespace dripfeed::json
