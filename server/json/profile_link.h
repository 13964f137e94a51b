// "link" and "receive" of a machine profile: the line, its protocol, how characters are sent and taken.
#pragma once

#include <expected>
#include <string>

#include "server/json/object_reader.h"
#include "server/machine/profile.h"
#include "server/machine/receive_settings.h"

namespace dripfeed::json {

void read_link(ObjectReader& object, machine::LineSettings& line);
void read_receive(ObjectReader& object, machine::ReceiveSettings& receive);
// What the parts state together: whether the line can keep the machine's budget. The text says why not.
std::expected<void, std::string> line_is_possible(const machine::LineSettings& line);

}  // namespace dripfeed::json
