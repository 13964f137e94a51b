// What a line's report says of a job in words: the reason of its end, an alarm of its machine.
#pragma once

#include <string>

#include "server/app/lines/line.h"

namespace dripfeed::app {

// Why the job ended or was disarmed, with the interval of what may have reached the control; the stall while it runs.
std::string reason_of(const LineReport& report);

// The same as one name that does not change: of the cause of its end, or of the stall while it runs; "" for none.
std::string reason_id_of(const LineReport& report);

// An alarm of the machine that was not there at the last look; "" for none.
std::string new_alarm(const LineReport& report, const LineReport& last);

}  // namespace dripfeed::app
