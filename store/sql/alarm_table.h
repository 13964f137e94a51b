// Alarms in the database.
#pragma once

#include "store/alarms.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class AlarmTable final : public store::Alarms {
 public:
  explicit AlarmTable(Database& database) : database_(database) {}
  store::Result<store::Alarm> raise(const store::NewAlarm& alarm, std::int64_t at_ms) override;
  store::Result<std::vector<store::Alarm>> clear(std::string_view machine, std::string_view kind,
                                                 std::int64_t at_ms) override;
  store::Result<std::vector<store::Alarm>> lasting() override;
  store::Result<store::Alarm> acknowledge(store::Id alarm, const store::Stamp& by) override;
  store::Result<store::Alarm> shelve(store::Id alarm, std::int64_t until_ms, std::string_view reason,
                                     const store::Stamp& by) override;
  store::Result<store::Alarm> unshelve(store::Id alarm, const store::Stamp& by) override;
  store::Result<std::vector<store::Alarm>> end_shelves(std::int64_t now_ms) override;
  store::Result<store::Alarm> get(store::Id alarm) override;
  store::Result<store::Page<store::Alarm>> list(const store::PageRequest& page,
                                                const store::AlarmFilter& filter) override;
  store::Result<std::vector<store::OpenAlarms>> count_open() override;
  store::Result<std::uint64_t> forget(std::int64_t before_ms, std::uint64_t most, std::uint32_t at_once) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
