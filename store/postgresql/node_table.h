// Nodes and their leases in the database.
#pragma once

#include <string>

#include "store/nodes.h"
#include "store/postgresql/listener.h"
#include "store/sql/database.h"
#include "store/store.h"

namespace dripfeed::postgresql {

class NodeTable final : public store::Nodes {
 public:
  // What a machine that is taken over has.
  struct Others {
    store::Jobs& jobs;
    store::Answers& answers;
    store::Ledger& ledger;
  };
  NodeTable(sql::Database& database, Others others, std::string own, Listener listener)
      : database_(database), others_(others), own_(std::move(own)), listener_(std::move(listener)) {}

  [[nodiscard]] const std::string& own() const override { return own_; }
  store::Result<store::Beat> beat(std::string_view url, std::string_view version) override;
  void wait_for_news(std::chrono::milliseconds patience) override;
  store::Result<std::vector<store::NodeNews>> news(std::uint64_t after) override;
  store::Result<std::vector<store::LoggedEvent>> own_events(std::uint64_t after, std::uint32_t most) override;
  store::Result<std::vector<store::Node>> list() override;
  store::Result<std::vector<store::Lease>> leases() override;
  store::Result<store::Lease> claim(std::string_view machine, const store::Stamp& by) override;
  store::Result<void> claim_free(const store::Stamp& by) override;
  store::Result<store::Lease> hand_over(std::string_view machine, std::string_view to, std::string_view reason,
                                        const store::Stamp& by) override;
  store::Result<std::vector<store::Job>> take_over(std::string_view machine, std::string_view reason,
                                                   const store::Stamp& by) override;

 private:
  store::Result<void> doubt(std::string_view machine, std::string_view node, const store::Stamp& by);

  sql::Database& database_;
  Others others_;
  std::string own_;
  Listener listener_;
};

}  // namespace dripfeed::postgresql
