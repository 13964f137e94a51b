// "link" of a machine profile: the line, its protocol and how characters are sent.
#pragma once

#include <expected>
#include <string>

#include "server/json/object_reader.h"
#include "server/machine/profile.h"

namespace dripfeed::json {

void read_link(ObjectReader& object, machine::LineSettings& line);
// What the parts state together: whether the line can keep the machine's budget. The text says why not.
std::expected<void, std::string> line_is_possible(const machine::LineSettings& line);

}  // namespace dripfeed::json
