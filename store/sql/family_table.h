// Part families in the database.
#pragma once

#include "store/families.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class FamilyTable final : public store::Families {
 public:
  explicit FamilyTable(Database& database) : database_(database) {}
  store::Result<store::Family> add(std::string_view name, std::string_view text, const store::Stamp& by) override;
  store::Result<store::Family> change(std::string_view name, store::Revision expected, std::string_view text,
                                      const store::Stamp& by) override;
  store::Result<store::Family> get(std::string_view name) override;
  store::Result<store::Family> get(std::string_view name, store::Revision revision) override;
  store::Result<store::Page<store::Family>> list(const store::PageRequest& page) override;
  store::Result<store::Page<store::Family>> revisions(std::string_view name, const store::PageRequest& page) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
