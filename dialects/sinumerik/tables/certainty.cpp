// The table of open faults.
#include "dialects/sinumerik/tables/certainty.h"

namespace dripfeed::sinumerik {

namespace {

using enum text::DiagnosticId;

constexpr ir::OutsideRow kOpen[] = {
    {unknown_name,
     "a definition file (GUD or macros) that defines it decides this: put it into the program's folder or give "
     "its folder with --path"},
    {unknown_code,
     "a definition file (SMAC, MMAC, UMAC) that defines it as a macro decides this: put it into the folder of the "
     "program or give its folder with --path"},
    {call_target_missing,
     "the called program decides this: put it into the folder of this one or give its folder with --path"},
    {unknown_address, "a machine profile with its axes decides this", true},
};

}  // namespace

std::span<const ir::OutsideRow> open_faults() { return kOpen; }

}  // namespace dripfeed::sinumerik
