// The transition table of a reception, row by row, and the names in it.
#include "protocol/receive/state.h"

#include <array>

namespace dripfeed::receive {
namespace {

using S = State;
using I = Input;
using G = Guard;
using A = Action;
using C = Condition;

// clang-format off
constexpr std::array<Reaction, 61> kReactions{{
    // At rest only DC2, a '%' or the first character of a text begins something; the rest is the feed's to judge.
    {S::idle, I::punch_on, G::always, A::open, S::opened},
    {S::idle, I::punch_off, G::always, A::none, S::idle},
    {S::idle, I::percent, G::always, A::begin, S::receiving},
    {S::idle, I::text, G::always, A::begin, S::receiving},
    {S::idle, I::eob, G::always, A::none, S::idle},
    {S::idle, I::filler, G::always, A::none, S::idle},
    {S::idle, I::end_code, G::always, A::none, S::idle},
    {S::idle, I::reader_on, G::always, A::none, S::idle},
    {S::idle, I::reader_off, G::always, A::none, S::idle},
    {S::idle, I::reset, G::always, A::none, S::idle},
    {S::idle, I::other, G::always, A::none, S::idle},
    {S::idle, I::link_lost, G::always, A::none, S::idle},

    // A leader is not a text yet.
    {S::opened, I::punch_on, G::always, A::skip, S::opened},
    {S::opened, I::punch_off, G::always, A::end, S::idle},
    {S::opened, I::percent, G::always, A::keep, S::receiving},
    {S::opened, I::text, G::always, A::keep, S::receiving},
    {S::opened, I::eob, G::always, A::skip, S::opened},
    {S::opened, I::filler, G::always, A::skip, S::opened},
    {S::opened, I::end_code, G::always, A::end, S::idle},
    {S::opened, I::reader_on, G::always, A::end, S::idle},
    {S::opened, I::reader_off, G::always, A::skip, S::opened},
    {S::opened, I::reset, G::always, A::end, S::idle},
    {S::opened, I::other, G::always, A::keep, S::receiving},
    {S::opened, I::link_lost, G::always, A::end, S::idle},

    // The first '%' begins a program, a later one may end it. A DC3 is no sign of a control that sends, but one flipped
    // bit makes it of a 3: it is kept, so that the judgement sees it.
    {S::receiving, I::punch_on, G::always, A::renew, S::opened},
    {S::receiving, I::punch_off, G::always, A::end, S::idle},
    {S::receiving, I::percent, G::first_percent, A::keep, S::receiving},
    {S::receiving, I::percent, G::later_percent, A::keep, S::closing},
    {S::receiving, I::text, G::always, A::keep, S::receiving},
    {S::receiving, I::eob, G::always, A::keep, S::receiving},
    {S::receiving, I::filler, G::always, A::keep, S::receiving},
    {S::receiving, I::end_code, G::always, A::end, S::idle},
    {S::receiving, I::reader_on, G::always, A::end, S::idle},
    {S::receiving, I::reader_off, G::always, A::keep, S::receiving},
    {S::receiving, I::reset, G::always, A::end, S::idle},
    {S::receiving, I::other, G::always, A::keep, S::receiving},
    {S::receiving, I::link_lost, G::always, A::end, S::idle},

    // What follows a final '%' is trailer, or the next program of the same punch.
    {S::closing, I::punch_on, G::always, A::renew, S::opened},
    {S::closing, I::punch_off, G::always, A::end, S::idle},
    {S::closing, I::percent, G::always, A::keep, S::closing},
    {S::closing, I::text, G::always, A::keep, S::receiving},
    {S::closing, I::eob, G::always, A::keep, S::closing},
    {S::closing, I::filler, G::always, A::keep, S::closing},
    {S::closing, I::end_code, G::always, A::end, S::idle},
    {S::closing, I::reader_on, G::always, A::end, S::idle},
    {S::closing, I::reader_off, G::always, A::keep, S::receiving},
    {S::closing, I::reset, G::always, A::end, S::idle},
    {S::closing, I::other, G::always, A::keep, S::receiving},
    {S::closing, I::link_lost, G::always, A::end, S::idle},

    // Over the limit: nothing is kept. A new DC2 is a new reception.
    {S::spilling, I::punch_on, G::always, A::open, S::opened},
    {S::spilling, I::punch_off, G::always, A::skip, S::idle},
    {S::spilling, I::percent, G::always, A::skip, S::spilling},
    {S::spilling, I::text, G::always, A::skip, S::spilling},
    {S::spilling, I::eob, G::always, A::skip, S::spilling},
    {S::spilling, I::filler, G::always, A::skip, S::spilling},
    {S::spilling, I::end_code, G::always, A::skip, S::spilling},
    {S::spilling, I::reader_on, G::always, A::skip, S::idle},
    {S::spilling, I::reader_off, G::always, A::skip, S::spilling},
    {S::spilling, I::reset, G::always, A::skip, S::idle},
    {S::spilling, I::other, G::always, A::skip, S::spilling},
    {S::spilling, I::link_lost, G::always, A::skip, S::idle},
}};

constexpr std::array<Progress, 6> kProgress{{
    {S::opened, C::quiet, A::end, S::idle},
    {S::receiving, C::quiet, A::end, S::idle},
    {S::closing, C::short_quiet, A::end, S::idle},
    {S::spilling, C::quiet, A::none, S::idle},
    {S::receiving, C::too_long, A::spoil, S::spilling},
    {S::closing, C::too_long, A::spoil, S::spilling},
}};
// clang-format on

constexpr std::array<std::string_view, kStates> kStateNames{"idle", "opened", "receiving", "closing", "spilling"};
constexpr std::array<std::string_view, kInputs> kInputNames{"punch_on",   "punch_off", "percent",  "text",
                                                            "eob",        "filler",    "end_code", "reader_on",
                                                            "reader_off", "reset",     "other",    "link_lost"};
constexpr std::array<std::string_view, 3> kGuardNames{"always", "first_percent", "later_percent"};
constexpr std::array<std::string_view, 2> kConditionNames{"quiet", "short_quiet"};

}  // namespace

std::span<const Reaction> reactions() { return kReactions; }
std::span<const Progress> progress() { return kProgress; }

std::string_view name(State state) { return kStateNames[static_cast<std::size_t>(state)]; }
std::string_view name(Input input) { return kInputNames[static_cast<std::size_t>(input)]; }
std::string_view name(Guard guard) { return kGuardNames[static_cast<std::size_t>(guard)]; }
std::string_view name(Condition condition) { return kConditionNames[static_cast<std::size_t>(condition)]; }

}  // namespace dripfeed::receive
