// Alarms of the Haas list whose fault is one that is found here; from the operator's manual and alarm lists. Faults
// without a row have no number of their own that is known for certain.
#include <array>

#include "dialects/haas/tables.h"

namespace dripfeed::haas {

namespace {

using ir::AlarmRow;
using enum text::DiagnosticId;
using enum ir::AlarmDetail;

constexpr auto kAlarms = std::to_array<AlarmRow>({
    {unknown_code, "310"},
    {call_target_missing, "314"},
    {call_nesting_too_deep, "307"},
    {arc_radius_mismatch, "303"},
    {comp_started_by_arc, "340"},
    {address_without_value, "313", macro_program},
});

}  // namespace

std::span<const AlarmRow> alarms() { return kAlarms; }

}  // namespace dripfeed::haas
