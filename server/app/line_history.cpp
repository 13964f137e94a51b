// Jobs first: their reason says more.
#include "server/app/line_history.h"

#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

Result<std::string> torn_in_store(store::Store& store, const std::string& machine) {
  const auto job = lift(store.jobs().torn_on(machine));
  if (!job) return std::unexpected(job.error());
  if (*job) return fmt::format("job {} broke off inside a block ({})", (*job)->id, (*job)->reason);
  const auto answer = lift(store.answers().torn_on(machine));
  if (!answer) return std::unexpected(answer.error());
  if (*answer) return fmt::format("an answer to its operator broke off inside a block ({})", (*answer)->reason);
  return std::string();
}

LineHistory history_of(store::Store& store, ClaimLine claim) {
  return {.torn = [&store](const std::string& machine) { return torn_in_store(store, machine); },
          .claim = std::move(claim)};
}

}  // namespace dripfeed::app
