// Jobs in the database.
#pragma once

#include "store/jobs.h"
#include "store/sql/answer_table.h"
#include "store/sql/database.h"
#include "store/sql/release_table.h"

namespace dripfeed::sql {

class JobTable final : public store::Jobs {
 public:
  JobTable(Database& database, ReleaseTable& releases, AnswerTable& answers)
      : database_(database), releases_(releases), answers_(answers) {}
  store::Result<store::Job> add(const store::NewJob& job, const store::Stamp& by) override;
  store::Result<store::Job> move(store::Id job, const store::JobMove& move, const store::Stamp& by) override;
  store::Result<store::Job> confirm_reset(std::string_view machine, std::string_view reason,
                                          const store::Stamp& by) override;
  store::Result<std::vector<store::Job>> move_before(store::Id job, store::Id before, const store::Stamp& by) override;
  store::Result<store::Job> schedule(store::Id job, std::int64_t not_before_ms, const store::Stamp& by) override;
  store::Result<store::Job> hold(store::Id job, std::string_view reason, const store::Stamp& by) override;
  store::Result<store::Job> end_hold(store::Id job, const store::Stamp& by) override;
  store::Result<store::Job> confirm_end(store::Id job, std::string_view note, const store::Stamp& by) override;
  store::Result<std::optional<store::Job>> end_waits_on(std::string_view machine) override;
  store::Result<void> each_ended(const store::EndedFilter& filter,
                                 const std::function<void(const store::EndedJob&)>& visit) override;
  store::Result<std::vector<store::JobUse>> used(std::string_view machine, std::int64_t from_ms,
                                                 std::int64_t to_ms) override;
  store::Result<store::Job> set_read_back(store::Id job, std::string_view result, const store::Stamp& by) override;
  store::Result<store::Job> get(store::Id job) override;
  store::Result<store::Page<store::Job>> list(const store::PageRequest& page, const store::JobFilter& filter) override;
  store::Result<std::optional<store::Job>> on_line(std::string_view machine) override;
  store::Result<std::optional<store::Job>> torn_on(std::string_view machine) override;
  store::Result<std::vector<store::Job>> interrupt_unfinished(const store::Stamp& by,
                                                              const store::OfMachines& of) override;

 private:
  store::Result<void> check_clearance(const store::Job& job, std::int64_t now_ms);
  store::Result<void> check_retry(const store::NewJob& job);
  store::Result<void> check_line(const store::Job& job);
  store::Result<std::optional<store::Job>> find(std::string_view sql, std::string_view machine);

  Database& database_;
  ReleaseTable& releases_;
  AnswerTable& answers_;
};

}  // namespace dripfeed::sql
