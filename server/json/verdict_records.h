// Verdicts as the API shows them, and what a verdict predicts for a job.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "checks/machine.h"
#include "server/app/application.h"

namespace dripfeed::json {

// How long a job's program takes by the newest verdict on it; `verdict`: nothing where there is none. `buffer`: of the
// machine, 0: not known.
std::string job_forecast(const store::Job& job, const std::optional<store::Verdict>& verdict,
                         const checks::BufferSize& buffer);
// How long the whole program takes by the report of a check; nothing where it does not say.
std::optional<double> cycle_s_of(std::string_view report);
// A stored verdict: the report's members with the verdict's own.
std::string verdict(const store::Verdict& verdict);
// Of a list: without the report.
// Of a check that was stored nowhere.
std::string preview_verdict(const app::CheckDone& done);

std::string verdict_summary(const store::Verdict& verdict);

}  // namespace dripfeed::json
