// Names as levels of a broker's topics.
#pragma once

#include <string>
#include <string_view>

namespace dripfeed::app {

// A name as one level of a topic: what has a meaning there is escaped by %.
std::string topic_level(std::string_view name);

}  // namespace dripfeed::app
