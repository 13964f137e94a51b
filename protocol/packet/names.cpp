// The names of stalls, causes and events, in the order of their enums.
#include <array>

#include "protocol/packet/event.h"
#include "protocol/packet/receive_state.h"

namespace dripfeed::packet {
namespace {

constexpr std::array<std::string_view, kStalls> kStallNames = {
    "",
    "waiting for the receiver's start",
    "waiting for the receiver",
    "waiting for ACK",
    "waiting for ledger",
    "waiting for text",
    "waiting for the end's ACK",
    "stopped",
    "the partner sends",
};
constexpr std::array<std::string_view, kCauses> kCauseNames = {
    "none",           "start",          "person",     "expired",       "link lost",        "cancelled by the peer",
    "peer restarted", "peer was reset", "peer alarm", "no answer",     "too many repeats", "out of step",
    "text lost",      "bad character",  "broken off", "a second file",
};
constexpr std::array<std::string_view, 7> kEventNames = {"state",   "stall",           "start_unarmed", "repeated",
                                                         "noticed", "command_refused", "telegram"};
constexpr std::array<std::string_view, kReceiveEvents> kReceiveEventNames = {"state", "frame", "repeated_frame",
                                                                             "bad_frame", "command_refused"};

}  // namespace

std::string_view name(Stall stall) { return kStallNames[static_cast<std::size_t>(stall)]; }
std::string_view name(Cause cause) { return kCauseNames[static_cast<std::size_t>(cause)]; }
std::string_view name(EventKind kind) { return kEventNames[static_cast<std::size_t>(kind)]; }
std::string_view name(ReceiveEventKind kind) { return kReceiveEventNames[static_cast<std::size_t>(kind)]; }

}  // namespace dripfeed::packet
