// What the checks report, as a verdict and as figures of their own have it.
#pragma once

#include "server/json/schemas.h"

namespace dripfeed::json {

Members envelope_members();
Members gouge_members();
Members accuracy_members();
Members timing_members();
Schema not_checked();
Schema control();  // as which a text was read
Schema folded();   // how many more faults of a kind there are

}  // namespace dripfeed::json
