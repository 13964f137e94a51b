// Machines in the database.
#pragma once

#include "store/machines.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class MachineTable final : public store::Machines {
 public:
  explicit MachineTable(Database& database) : database_(database) {}
  store::Result<store::Machine> add(std::string_view name, std::string_view profile, const store::Stamp& by) override;
  store::Result<store::Machine> change(std::string_view name, store::Revision expected, std::string_view profile,
                                       const store::Stamp& by) override;
  store::Result<store::Machine> get(std::string_view name) override;
  store::Result<store::Machine> get(std::string_view name, store::Revision revision) override;
  store::Result<store::Page<store::Machine>> list(const store::PageRequest& page) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
