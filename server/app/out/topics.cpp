// The characters that have a meaning to a broker: MQTT 3.1.1, section 4.7.
#include "server/app/out/topics.h"

#include <fmt/format.h>

namespace dripfeed::app {

std::string topic_level(std::string_view name) {
  constexpr std::string_view kMeant = "%/+#$";
  std::string level;
  for (const char c : name) {
    if (kMeant.find(c) != std::string_view::npos || static_cast<unsigned char>(c) < 0x20) {
      level += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    } else {
      level += c;
    }
  }
  return level;
}

}  // namespace dripfeed::app
