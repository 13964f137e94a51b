// Releases and their steps in the database.
#pragma once

#include "store/releases.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class ReleaseTable final : public store::Releases {
 public:
  ReleaseTable(Database& database, store::Verdicts& verdicts) : database_(database), verdicts_(verdicts) {}
  store::Result<store::Release> add(const store::NewRelease& release, const store::Stamp& by) override;
  store::Result<store::Release> move(store::Id release, const store::ReleaseMove& move,
                                     const store::Stamp& by) override;
  store::Result<store::Release> sign_off(store::Id release, std::string_view note, const store::Stamp& by) override;
  store::Result<store::Release> get(store::Id release) override;
  store::Result<store::Page<store::Release>> list(const store::PageRequest& page,
                                                  const store::ReleaseFilter& filter) override;
  store::Result<std::vector<store::ReleaseStep>> history(store::Id release) override;
  store::Result<store::Clearance> released_for(std::string_view text_sha256, std::string_view machine,
                                               store::Delivery delivery, std::int64_t now_ms) override;

  // What released_for() answers for one release.
  store::Result<store::Clearance> clearance_of(const store::Release& release, std::int64_t now_ms);
  // A job of it begins to feed: one transfer less while it is proving. Within the caller's transaction.
  static void count_transfer(Session& session, store::Id release);

 private:
  store::Result<void> refuse_restart_of(Session& session, const store::NewRelease& release);
  store::Result<store::Verdict> clearing_verdict(const store::Release& release, std::int64_t now_ms);
  store::Result<void> check(const store::Release& release, const store::ReleaseMove& move, std::int64_t now_ms);

  Database& database_;
  store::Verdicts& verdicts_;
};

}  // namespace dripfeed::sql
