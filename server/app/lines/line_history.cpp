// Jobs first: their reason says more.
#include "server/app/lines/line_history.h"

#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

Result<std::optional<TornBlock>> torn_in_store(store::Store& store, const std::string& machine) {
  const auto job = lift(store.jobs().torn_on(machine));
  if (!job) return std::unexpected(job.error());
  if (*job) return TornBlock{.job = (*job)->id, .text = (*job)->reason, .reason_id = (*job)->reason_id};
  const auto answer = lift(store.answers().torn_on(machine));
  if (!answer) return std::unexpected(answer.error());
  if (!*answer) return std::nullopt;
  return TornBlock{.text = fmt::format("an answer to its operator broke off inside a block ({})", (*answer)->reason),
                   .reason_id = "answer_torn"};
}

LineHistory history_of(store::Store& store, ClaimLine claim) {
  return {.torn = [&store](const std::string& machine) { return torn_in_store(store, machine); },
          .claim = std::move(claim)};
}

}  // namespace dripfeed::app
