// The table of all events that go out to other systems: their names, when they come, and which document they carry.
// Documents, OpenAPI and the reference are written from it.
#pragma once

#include <span>
#include <string_view>

namespace dripfeed::app {

struct EventType {
  std::string_view name;    // "job.done"
  std::string_view when;    // for people: "the end of a job's text was seen"
  std::string_view schema;  // of `data`, see server/json
};
std::span<const EventType> event_types();

// Whether this names a type, a group of types ("job.*") or all ("*").
bool covers_a_type(std::string_view pattern);

}  // namespace dripfeed::app
