// The transitions of jobs, as a table, and what follows from it.
#include "store/jobs.h"

#include <algorithm>
#include <array>

namespace dripfeed::store {
namespace {

using enum JobState;

// A disarmed job goes back to the queue: nothing of it was sent. A control may hold in the trailer, so draining and
// held follow each other in both directions.
constexpr std::array kTransitions{
    JobTransition{queued, armed, true},       JobTransition{queued, cancelled, true},
    JobTransition{armed, queued, true},       JobTransition{armed, feeding, true},
    JobTransition{armed, failed, true},       JobTransition{armed, cancelled, true},
    JobTransition{armed, interrupted, true},  JobTransition{feeding, held, false},
    JobTransition{feeding, draining, false},  JobTransition{feeding, failed, true},
    JobTransition{feeding, cancelled, true},  JobTransition{feeding, interrupted, true},
    JobTransition{held, feeding, false},      JobTransition{held, draining, false},
    JobTransition{held, failed, true},        JobTransition{held, cancelled, true},
    JobTransition{held, interrupted, true},   JobTransition{draining, held, false},
    JobTransition{draining, done, true},      JobTransition{draining, failed, true},
    JobTransition{draining, cancelled, true}, JobTransition{draining, interrupted, true},
};

}  // namespace

std::span<const JobTransition> job_transitions() { return kTransitions; }

bool allowed(JobState from, JobState to) {
  return std::ranges::any_of(kTransitions, [&](const JobTransition& t) { return t.from == from && t.to == to; });
}

bool has_line(JobState state) { return state == armed || state == feeding || state == held || state == draining; }

bool ended(JobState state) { return state == done || state == failed || state == cancelled || state == interrupted; }

}  // namespace dripfeed::store
