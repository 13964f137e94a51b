// The names of events, for whoever sends them and whoever chooses among them.
#include "store/event_log.h"

#include <fmt/format.h>

namespace dripfeed::store {

std::string type_of(const NewEvent& event) { return fmt::format("{}.{}", name_of(event.topic), event.word); }

std::string id_of(const LoggedEvent& event) { return fmt::format("{:x}-{}", event.by.at_ms, event.seq); }

}  // namespace dripfeed::store
