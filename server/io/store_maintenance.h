// Maintenance of the store by child processes, one at a time; see app::Maintenance.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "server/app/ports/maintenance.h"

namespace dripfeed::io {

struct StoreMaintenanceSettings {
  std::string program;   // that is started, as `program maintenance …`
  std::string data;      // the server's folder
  std::string database;  // its address; "": the store is the file
  std::string file;      // of the store in `data`
  std::string backups;   // folder
};

class StoreMaintenance final : public app::Maintenance {
 public:
  template <class T>
  using Result = std::expected<T, app::MaintenanceError>;

  explicit StoreMaintenance(StoreMaintenanceSettings settings) : settings_(std::move(settings)) {}
  [[nodiscard]] app::StoreRoom room() const override;
  Result<std::string> verify(const app::Waiter& waiter) override;
  Result<std::string> back_up(const std::string& name, const app::Waiter& waiter) override;
  Result<std::vector<app::BackupFile>> backups() override;
  Result<void> remove(const std::string& name) override;

 private:
  [[nodiscard]] bool is_database() const { return !settings_.database.empty(); }
  [[nodiscard]] std::uint64_t store_bytes() const;
  [[nodiscard]] Result<void> make_room() const;
  Result<std::string> run(const std::vector<std::string>& arguments, std::string_view input, const app::Waiter& waiter);

  StoreMaintenanceSettings settings_;
  std::mutex running_;
};

}  // namespace dripfeed::io
