// The names of states, inputs, stalls, causes and events, as reports and dialogs spell them. In the order of the enums.
#include <array>

#include "protocol/feed/event.h"
#include "protocol/feed/state.h"

namespace dripfeed::feed {
namespace {

constexpr std::array<std::string_view, 22> kStateNames{
    "idle",         "armed",        "sending",         "held",       "stopping",        "stopping_held",
    "stopped",      "stopped_held", "reset_suspected", "cancelling", "cancelling_held", "trailer",
    "trailer_held", "draining",     "wait_end",        "ending",     "next_round",      "done",
    "failed",       "torn",         "cancelled",       "disarmed"};
constexpr std::array<std::string_view, 14> kInputNames{"dc1",      "dc3",   "punch_code",    "eot",          "broken",
                                                       "line_off", "arm",   "disarm",        "stop",         "resume",
                                                       "cancel",   "abort", "resume_as_dc1", "confirm_reset"};
constexpr std::array<std::string_view, 7> kGuardNames{"always",    "in_block",   "between_blocks", "dc3_ends",
                                                      "dc3_holds", "dc1_starts", "dc1_is_no_start"};
constexpr std::array<std::string_view, 10> kConditionNames{
    "starts_open",   "starts_held",  "expired", "program_handed", "all_handed",
    "block_clocked", "line_drained", "quiet",   "shut",           "round_left"};

static_assert(kStateNames.size() == kStates && kInputNames.size() == kInputs);

constexpr std::array<std::string_view, 13> kStallNames{"none",
                                                       "waiting_for_dc1",
                                                       "held_by_dc3",
                                                       "cts_off",
                                                       "peer_gone",
                                                       "waiting_for_ledger",
                                                       "waiting_for_text",
                                                       "waiting_for_end",
                                                       "stopped_by_person",
                                                       "dsr_off",
                                                       "held_below",
                                                       "waiting_for_trigger",
                                                       "reset_suspected"};
constexpr std::array<std::string_view, 16> kCauseNames{
    "none",      "dc1",     "dc3",     "eot",     "quiet",  "syn",       "nak",           "unexpected_input",
    "link_lost", "dsr_off", "cts_off", "expired", "person", "text_lost", "bad_character", "trigger"};
constexpr std::array<std::string_view, 11> kEventNames{
    "state", "stall", "dc1_unarmed", "dc3_seen", "punch_code", "noticed", "command_refused", "resumed_by_person",
    "cts",   "dsr",   "link"};

}  // namespace

std::string_view name(State state) { return kStateNames[static_cast<std::size_t>(state)]; }
std::string_view name(Input input) { return kInputNames[static_cast<std::size_t>(input)]; }
std::string_view name(Guard guard) { return kGuardNames[static_cast<std::size_t>(guard)]; }
std::string_view name(Condition condition) { return kConditionNames[static_cast<std::size_t>(condition)]; }

std::string_view name(Stall stall) { return kStallNames[static_cast<std::size_t>(stall)]; }
std::string_view name(Cause cause) { return kCauseNames[static_cast<std::size_t>(cause)]; }
std::string_view name(EventKind kind) { return kEventNames[static_cast<std::size_t>(kind)]; }

}  // namespace dripfeed::feed
