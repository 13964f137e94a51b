// The names of the sender's states, inputs, stalls, reasons and events, in the order of the enums.
#include <array>

#include "protocol/modbus/sender_state.h"

namespace dripfeed::modbus {
namespace {

constexpr std::array<std::string_view, 14> kStateNames{"idle",      "looking",   "opening", "ready",   "delivering",
                                                       "closing",   "finishing", "done",    "holding", "held",
                                                       "releasing", "aborting",  "aborted", "stopped"};
constexpr std::array<std::string_view, 18> kInputNames{
    "vacant",    "acknowledged", "not_yet",   "refused", "ended",  "contradiction", "failed",  "gone",  "hold_due",
    "has_block", "has_end",      "text_lost", "start",   "resume", "hold",          "release", "abort", "proceed"};
constexpr std::array<std::string_view, 8> kStallNames{"none",
                                                      "waiting_for_credit",
                                                      "waiting_for_ledger",
                                                      "waiting_for_text",
                                                      "waiting_for_receiver",
                                                      "peer_gone",
                                                      "held_by_person",
                                                      "stopped"};
constexpr std::array<std::string_view, 12> kReasonNames{
    "none",        "foreign_registers", "session_over", "session_running", "other_session", "receiver_restarted",
    "out_of_step", "text_differs",      "refused",      "receiver_error",  "peer_gone",     "text_lost"};
constexpr std::array<std::string_view, 6> kEventNames{"state",     "stall",     "opened",
                                                      "confirmed", "rewritten", "command_refused"};

}  // namespace

std::string_view name(SenderState state) { return kStateNames[static_cast<std::size_t>(state)]; }
std::string_view name(SenderInput input) { return kInputNames[static_cast<std::size_t>(input)]; }
std::string_view name(SenderStall stall) { return kStallNames[static_cast<std::size_t>(stall)]; }
std::string_view name(StopReason reason) { return kReasonNames[static_cast<std::size_t>(reason)]; }
std::string_view name(SenderEventKind kind) { return kEventNames[static_cast<std::size_t>(kind)]; }

}  // namespace dripfeed::modbus
