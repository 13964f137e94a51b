// Names of functions, for messages and the report of what was not interpreted.
#include "dialects/ir/function.h"

#include <array>

namespace dripfeed::ir {

namespace {

constexpr std::array kNames = {"none",
                               "rapid",
                               "linear",
                               "arc clockwise",
                               "arc counterclockwise",
                               "thread",
                               "arc by a point in between",
                               "tangential arc",
                               "spline",
                               "tapping",
                               "tapping retraction",
                               "dwell",
                               "exact stop once",
                               "exact stop mode",
                               "continuous path",
                               "plane XY",
                               "plane ZX",
                               "plane YZ",
                               "inch",
                               "metric",
                               "absolute",
                               "incremental",
                               "pole from the last position",
                               "pole from the zero point",
                               "pole from the last pole",
                               "feed per minute",
                               "feed per revolution",
                               "inverse time feed",
                               "diameter on",
                               "diameter off",
                               "diameter for absolute only",
                               "work offset",
                               "machine coordinates",
                               "local shift",
                               "additive local shift",
                               "rotation",
                               "scaling",
                               "mirroring",
                               "set coordinates",
                               "reference return",
                               "compensation off",
                               "compensation left",
                               "compensation right",
                               "tool length plus",
                               "tool length minus",
                               "tool length off",
                               "tool change",
                               "constant surface speed",
                               "constant spindle speed",
                               "spindle clockwise",
                               "spindle counterclockwise",
                               "spindle stop",
                               "spindle orientation",
                               "mist coolant",
                               "flood coolant",
                               "coolant off",
                               "program stop",
                               "optional stop",
                               "program end",
                               "program end with rewind",
                               "subprogram end",
                               "cycle off",
                               "return to initial level",
                               "return to R level",
                               "no effect",
                               "not modelled",
                               "machine function"};
static_assert(kNames.size() == static_cast<std::size_t>(Function::count_));

}  // namespace

std::string_view name_of(Function function) { return kNames[static_cast<std::size_t>(function)]; }

}  // namespace dripfeed::ir
