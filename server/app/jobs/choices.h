// One program for a group of machines: a job for each of its machines that has a valid release of this very text. They
// are a choice: a person arms one of them, and the others leave the queue with it. Nothing is armed here.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/jobs/jobs.h"

namespace dripfeed::app {

struct ChoiceOrder {
  std::string group;
  store::Id program = 0;
  store::Revision revision = 0;  // 0: the newest
  store::Delivery delivery = store::Delivery::drip;
  JobPlan plan{};
};

// A machine of the group without a job, and why.
struct LeftOut {
  std::string machine;
  std::string why;
};

struct ChoiceParts {
  std::vector<store::Id> releases;  // one a machine
  std::vector<LeftOut> left_out;
};

struct Choice {
  store::Id id = 0;
  std::vector<store::Job> jobs;
  std::vector<LeftOut> left_out;
};

// What can be queued, and its texts read: too long for a transaction. `may`: whether the caller may queue on a machine.
// Errors: not_found (the group, the program, the revision), refused (no machine is left).
Result<ChoiceParts> prepare_choice(store::Store& store, Jobs& jobs, const ChoiceOrder& order, std::int64_t now_ms,
                                   const std::function<bool(const std::string& machine)>& may);
// All of them or none, inside a transaction. Errors: those of Jobs::add; unavailable (a machine changed meanwhile).
Result<Choice> add_choice(store::Store& store, Jobs& jobs, const ChoiceParts& parts, const JobPlan& plan,
                          std::string_view actor);

}  // namespace dripfeed::app
