// Verdicts and their waivers in the database.
#pragma once

#include "store/sql/database.h"
#include "store/sql/session.h"
#include "store/verdicts.h"

namespace dripfeed::sql {

class VerdictTable final : public store::Verdicts {
 public:
  explicit VerdictTable(Database& database) : database_(database) {}
  void judge_by(std::string rules) override { rules_ = std::move(rules); }
  store::Result<store::Verdict> add(const store::NewVerdict& verdict, const store::Stamp& by) override;
  store::Result<store::Verdict> waive(store::Id verdict, const store::NewWaiver& waiver,
                                      const store::Stamp& by) override;
  store::Result<store::Verdict> get(store::Id verdict) override;
  store::Result<std::optional<store::Verdict>> newest(std::string_view text_sha256, std::string_view machine,
                                                      store::Delivery delivery) override;
  store::Result<store::Page<store::Verdict>> list(const store::PageRequest& page,
                                                  const store::VerdictFilter& filter) override;

 private:
  store::Verdict read(Query& query) const;

  Database& database_;
  std::string rules_{};
};

}  // namespace dripfeed::sql
