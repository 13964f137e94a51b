// The whole store: its room, a verification, backups. The work itself is done outside of the server's process.
#include <chrono>
#include <string>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "server/app/ports/maintenance.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/records.h"

namespace dripfeed::http {

namespace {

Response no_maintenance() { return problem_response(409, "this server does not look after its store"); }

Response refuse(const app::MaintenanceError& error) {
  using enum app::MaintenanceFault;
  switch (error.fault) {
    case runs:
    case refused: return problem_response(409, error.text);
    case not_found: return problem_response(404, error.text);
    case unavailable: return problem_response(503, error.text);
    case ended: break;
  }
  return problem_response(500, error.text);
}

// What was done to the whole store is in the audit, as each other change.
std::optional<Response> note(const Call& call, std::string action, std::string subject, std::string detail) {
  const auto noted = call.api.application().store().audit().append(
      {.action = std::move(action), .subject = std::move(subject), .detail = std::move(detail)}, stamp_of(call));
  if (noted) return std::nullopt;
  return problem_response(app::from_store(noted.error()));
}

// In the order of time by their names; two in one second are refused.
std::string backup_name(std::int64_t wall_ms) {
  const std::chrono::sys_seconds at{std::chrono::seconds(wall_ms / 1000)};
  return fmt::format("dripfeed-{:%Y-%m-%dT%H%M%SZ}.backup", at);
}

}  // namespace

Response get_store(const Call& call) {
  app::Maintenance* const maintenance = call.api.application().maintenance();
  if (maintenance == nullptr) return no_maintenance();
  return json_response(200, json::store_room(maintenance->room()));
}

Response verify_store(const Call& call) {
  app::Maintenance* const maintenance = call.api.application().maintenance();
  if (maintenance == nullptr) return no_maintenance();
  auto found = maintenance->verify(waiter_of(call, "verify", "store", ""));
  if (!found) return refuse(found.error());
  if (const auto fault = note(call, "store.verify", "store", *found)) return *fault;
  return json_response(200, std::move(*found));
}

Response list_backups(const Call& call) {
  app::Maintenance* const maintenance = call.api.application().maintenance();
  if (maintenance == nullptr) return no_maintenance();
  const auto found = maintenance->backups();
  if (!found) return refuse(found.error());
  std::vector<std::string> items;
  items.reserve(found->size());
  for (const app::BackupFile& file : *found) items.push_back(json::backup(file));
  return json_response(200, json::list(items, {}));
}

Response add_backup(const Call& call) {
  app::Maintenance* const maintenance = call.api.application().maintenance();
  if (maintenance == nullptr) return no_maintenance();
  const std::string name = backup_name(call.api.application().clock().wall_ms());
  auto made = maintenance->back_up(name, waiter_of(call, "backup", "store", ""));
  if (!made) return refuse(made.error());
  if (const auto fault = note(call, "backup.add", "backup/" + name, *made)) return *fault;
  return created("/api/v1/backups/" + name, std::move(*made));
}

Response remove_backup(const Call& call) {
  app::Maintenance* const maintenance = call.api.application().maintenance();
  if (maintenance == nullptr) return no_maintenance();
  const auto removed = maintenance->remove(call.parameters[0]);
  if (!removed) return refuse(removed.error());
  if (const auto fault = note(call, "backup.remove", "backup/" + call.parameters[0], "")) return *fault;
  return no_content();
}

}  // namespace dripfeed::http
