// A backup gets its name only when it was read through; what a killed process left has another name and is removed.
#include "server/io/store_maintenance.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/io/spawned_worker.h"

namespace dripfeed::io {

namespace {

namespace fs = std::filesystem;
using app::MaintenanceFault;

std::unexpected<app::MaintenanceError> fail(MaintenanceFault fault, std::string text) {
  return std::unexpected(app::MaintenanceError{fault, std::move(text)});
}

constexpr int kHasFaults = 1;  // exit code of the process: the store, it says which
constexpr std::string_view kEnding = ".backup";
// What stays free on a disk that a backup goes to: it may be the store's own, whose ledger must find room.
constexpr std::uint64_t kStaysFree_bytes = std::uint64_t{256} << 20U;

std::uint64_t bytes_of(const fs::path& file) {
  std::error_code none;
  const std::uintmax_t bytes = fs::file_size(file, none);
  return none ? 0 : bytes;
}

// 0 where the disk does not report it. A folder that is not there yet is made on its parent's disk.
std::uint64_t free_bytes(fs::path folder) {
  std::error_code fault;
  while (!fs::exists(folder, fault) && folder.has_parent_path()) folder = folder.parent_path();
  const fs::space_info space = fs::space(folder.empty() ? fs::path(".") : folder, fault);
  return fault ? 0 : space.available;
}

std::int64_t changed_ms(const fs::path& file) {
  std::error_code none;
  const auto changed = fs::last_write_time(file, none);
  if (none) return 0;
  const auto at = std::chrono::file_clock::to_sys(changed);
  return std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch()).count();
}

// A name of ours stays in the folder.
bool is_backup(const std::string& name) {
  return name.ends_with(kEnding) && name.size() > kEnding.size() && name.find('/') == std::string::npos;
}

// Of a process that was killed while it copied.
void remove_unfinished(const fs::path& folder) {
  std::error_code fault;
  for (const auto& entry : fs::directory_iterator(folder, fault)) {
    const std::string name = entry.path().filename().string();
    const std::size_t ending = name.find(kEnding);
    if (ending == std::string::npos || ending + kEnding.size() == name.size()) continue;
    std::error_code none;
    fs::remove(entry.path(), none);
  }
}

}  // namespace

std::uint64_t StoreMaintenance::store_bytes() const {
  return is_database() ? 0 : bytes_of(settings_.file) + bytes_of(settings_.file + "-wal");
}

app::StoreRoom StoreMaintenance::room() const {
  app::StoreRoom room{.engine = is_database() ? "postgresql" : "sqlite",
                      .folder = settings_.data,
                      .bytes = store_bytes(),
                      .free_bytes = free_bytes(settings_.data),
                      .backups = {},
                      .backups_free_bytes = 0,
                      .why_no_backups = {}};
  if (is_database()) {
    room.why_no_backups = "the store is in a PostgreSQL database: back it up with that server's own tools";
  } else {
    room.backups = settings_.backups;
    room.backups_free_bytes = free_bytes(settings_.backups);
  }
  return room;
}

StoreMaintenance::Result<std::string> StoreMaintenance::run(const std::vector<std::string>& arguments,
                                                            std::string_view input, const app::Waiter& waiter) {
  const std::unique_lock running(running_, std::try_to_lock);
  if (!running.owns_lock())
    return fail(MaintenanceFault::runs, "a backup or a verification runs: ask again when it has ended");
  std::vector<std::string> command = {settings_.program, "maintenance"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  auto process = WorkerProcess::start(command);
  if (!process) return fail(MaintenanceFault::unavailable, "no process for the maintenance: " + process.error());
  WorkerProcess::Exchange done = process->exchange(
      input, waiter.peer, [&](bool peer_left) { return !peer_left && !waiter.stop.stop_requested(); });
  if (done.was_given_up) return fail(MaintenanceFault::unavailable, "it was given up: no one waits for it any more");
  if (done.end.is_good()) return std::move(done.reply);
  if (done.end.signal == 0 && !done.reply.empty())
    return fail(done.end.exit_code == kHasFaults ? MaintenanceFault::refused : MaintenanceFault::unavailable,
                done.reply);
  spdlog::error("maintenance of the store ended abnormally (exit code {}, signal {})", done.end.exit_code,
                done.end.signal);
  return fail(MaintenanceFault::ended, "the maintenance ended abnormally: see the server's log");
}

StoreMaintenance::Result<std::string> StoreMaintenance::verify(const app::Waiter& waiter) {
  if (is_database()) return run({"verify", "--database"}, settings_.database + "\n", waiter);
  return run({"verify", settings_.data}, "\n", waiter);
}

StoreMaintenance::Result<void> StoreMaintenance::make_room() const {
  if (const std::string why = room().why_no_backups; !why.empty()) return fail(MaintenanceFault::refused, why);
  std::error_code fault;
  const bool made = fs::create_directories(settings_.backups, fault);
  if (!fault && made) fs::permissions(settings_.backups, fs::perms::owner_all, fault);
  if (fault) return fail(MaintenanceFault::unavailable, fmt::format("{}: {}", settings_.backups, fault.message()));
  remove_unfinished(settings_.backups);
  const std::uint64_t needed = store_bytes() + kStaysFree_bytes;
  const std::uint64_t free = free_bytes(settings_.backups);
  if (free >= needed) return {};
  return fail(MaintenanceFault::unavailable,
              fmt::format("the disk of {} has {} MB free; a backup needs {} MB and leaves {} MB free",
                          settings_.backups, free >> 20U, (needed - kStaysFree_bytes) >> 20U, kStaysFree_bytes >> 20U));
}

StoreMaintenance::Result<std::string> StoreMaintenance::back_up(const std::string& name, const app::Waiter& waiter) {
  if (auto room = make_room(); !room) return std::unexpected(room.error());
  const fs::path file = fs::path(settings_.backups) / name;
  return run({"backup", settings_.data, file.string()}, "\n", {.stop = waiter.stop, .peer = -1, .work = waiter.work});
}

StoreMaintenance::Result<std::vector<app::BackupFile>> StoreMaintenance::backups() {
  std::vector<app::BackupFile> found;
  std::error_code fault;
  if (is_database() || !fs::exists(settings_.backups, fault)) return found;
  for (const auto& entry : fs::directory_iterator(settings_.backups, fault)) {
    const std::string name = entry.path().filename().string();
    if (is_backup(name))
      found.push_back({.name = name, .bytes = bytes_of(entry.path()), .made_at_ms = changed_ms(entry.path())});
  }
  if (fault) return fail(MaintenanceFault::unavailable, fmt::format("{}: {}", settings_.backups, fault.message()));
  std::ranges::sort(found, [](const app::BackupFile& a, const app::BackupFile& b) { return a.name > b.name; });
  return found;
}

StoreMaintenance::Result<void> StoreMaintenance::remove(const std::string& name) {
  const fs::path file = fs::path(settings_.backups) / name;
  std::error_code fault;
  if (!is_backup(name) || is_database() || !fs::exists(file, fault))
    return fail(MaintenanceFault::not_found, fmt::format("there is no backup {}", name));
  fs::remove(file, fault);
  if (fault) return fail(MaintenanceFault::unavailable, fmt::format("{}: {}", file.string(), fault.message()));
  return {};
}

}  // namespace dripfeed::io
