// Parts in the database.
#pragma once

#include "store/parts.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class PartTable final : public store::Parts {
 public:
  explicit PartTable(Database& database) : database_(database) {}
  store::Result<store::Part> add(std::string_view number, const store::PartValues& values,
                                 const store::Stamp& by) override;
  store::Result<store::Part> change(std::string_view number, store::Revision expected, const store::PartValues& values,
                                    const store::Stamp& by) override;
  store::Result<store::Part> get(std::string_view number) override;
  store::Result<store::Part> get(std::string_view number, store::Revision revision) override;
  store::Result<store::Page<store::Part>> list(const store::PageRequest& page, std::string_view family) override;
  store::Result<store::Page<store::Part>> revisions(std::string_view number, const store::PageRequest& page) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
