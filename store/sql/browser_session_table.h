// Sessions of browsers in the database.
#pragma once

#include "store/browser_sessions.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class BrowserSessionTable final : public store::BrowserSessions {
 public:
  explicit BrowserSessionTable(Database& database) : database_(database) {}
  store::Result<void> open(std::string_view session_hash, const store::SessionOwner& owner, std::size_t most,
                           std::int64_t at_ms) override;
  store::Result<store::BrowserSession> find(std::string_view session_hash) override;
  store::Result<void> note_use(std::string_view session_hash, std::int64_t at_ms) override;
  store::Result<void> close(std::string_view session_hash) override;
  store::Result<void> forget(std::int64_t opened_before_ms, std::int64_t used_before_ms) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
