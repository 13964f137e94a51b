// Answers to operators in the database.
#pragma once

#include "store/answers.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class AnswerTable final : public store::Answers {
 public:
  explicit AnswerTable(Database& database) : database_(database) {}
  store::Result<store::Answer> begin(std::string_view machine, std::uint64_t bytes_total,
                                     const store::Stamp& by) override;
  store::Result<store::Answer> end(store::Id answer, store::AnswerState to, std::string_view reason,
                                   const store::Stamp& by) override;
  store::Result<std::optional<store::Answer>> torn_on(std::string_view machine) override;
  store::Result<store::Answer> confirm_reset(std::string_view machine, std::string_view reason,
                                             const store::Stamp& by) override;
  store::Result<std::vector<store::Answer>> tear_unfinished(const store::Stamp& by,
                                                            const store::OfMachines& of) override;
  store::Result<store::Page<store::Answer>> list(const store::PageRequest& page, std::string_view machine) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
