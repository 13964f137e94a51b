// Keeping prepared statements.
#include "store/sql/connection.h"

#include <utility>

namespace dripfeed::sql {

store::Result<void> Connection::transact(std::string_view sql) {
  std::unique_ptr<Statement> statement = take(sql);
  if (!statement || statement->step() == Statement::Step::fault) {
    auto refused = std::unexpected(fault({}));
    give_back(sql, std::move(statement));
    return refused;
  }
  give_back(sql, std::move(statement));
  return {};
}

std::unique_ptr<Statement> Connection::take(std::string_view sql) {
  const auto found = idle_.find(sql);
  if (found == idle_.end() || found->second.empty()) return prepare(sql);
  std::unique_ptr<Statement> statement = std::move(found->second.back());
  found->second.pop_back();
  return statement;
}

void Connection::give_back(std::string_view sql, std::unique_ptr<Statement> statement) {
  if (!statement) return;
  statement->reset();
  auto found = idle_.find(sql);
  if (found == idle_.end()) found = idle_.try_emplace(std::string(sql)).first;
  found->second.push_back(std::move(statement));
}

}  // namespace dripfeed::sql
