// The whole store, read through or copied while the server runs. Both read every byte that a shop ever wrote, so they
// are done outside of this process: none of it can reach a line.
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <vector>

#include "server/app/ports/workplace.h"

namespace dripfeed::app {

// A backup in the server's folder for them.
struct BackupFile {
  std::string name;  // "dripfeed-2026-11-26T213300Z.backup"
  std::uint64_t bytes = 0;
  std::int64_t made_at_ms = 0;  // since 1970
};

// Where the store is, and what room it has.
struct StoreRoom {
  std::string engine;                    // "sqlite", "postgresql"
  std::string folder;                    // the server's own, on its computer
  std::uint64_t bytes = 0;               // of the store's file; 0: not known, it is a database
  std::uint64_t free_bytes = 0;          // of the disk of `folder`; 0: not known
  std::string backups;                   // folder of the backups; "": none are made here
  std::uint64_t backups_free_bytes = 0;  // of its disk; 0: not known
  std::string why_no_backups;            // a sentence; "" where they are made
};

enum class MaintenanceFault : std::uint8_t {
  runs,         // another backup or verification
  refused,      // none are made here, or the store has faults
  unavailable,  // the store cannot be read, or the disk has not the room
  not_found,    // no such backup
  ended,        // the process ended abnormally
};
struct MaintenanceError {
  MaintenanceFault fault = MaintenanceFault::ended;
  std::string text;  // a sentence
};

class Maintenance {
 public:
  Maintenance() = default;
  Maintenance(const Maintenance&) = delete;
  Maintenance& operator=(const Maintenance&) = delete;
  virtual ~Maintenance() = default;

  [[nodiscard]] virtual StoreRoom room() const = 0;
  // Reads the store through: the document of `dripfeed ledger verify --json`, also where it has faults.
  virtual std::expected<std::string, MaintenanceError> verify(const Waiter& waiter) = 0;
  // Makes a backup with this name in the folder: the document of `dripfeed backup --json`. It goes on when its waiter
  // leaves, but for the server's end.
  virtual std::expected<std::string, MaintenanceError> back_up(const std::string& name, const Waiter& waiter) = 0;
  // Newest first.
  virtual std::expected<std::vector<BackupFile>, MaintenanceError> backups() = 0;
  virtual std::expected<void, MaintenanceError> remove(const std::string& name) = 0;
};

}  // namespace dripfeed::app
