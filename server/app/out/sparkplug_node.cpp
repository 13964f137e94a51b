// Rules and names are those of Sparkplug 3.0: topics in chapter 4, births, deaths and their numbers in chapters 5
// and 6.
#include "server/app/out/sparkplug_node.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "server/app/out/topics.h"

namespace dripfeed::app {

namespace {

SparkplugMetric session_number(std::uint8_t session) {
  return {.name = "bdSeq", .type = SparkplugType::whole, .value = std::int64_t{session}};
}

}  // namespace

SparkplugNode::SparkplugNode(std::string group, std::string node, std::uint8_t session, WriteSparkplug write)
    : group_(std::move(group)), node_(std::move(node)), write_(std::move(write)), session_(session) {}

BrokerMessage SparkplugNode::next_will(std::int64_t now_ms) {
  ++session_;
  return death(now_ms);
}

BrokerMessage SparkplugNode::death(std::int64_t now_ms) const {
  return {.topic = topic("NDEATH"),
          .payload = write_({.at_ms = now_ms, .seq = {}, .metrics = {session_number(session_)}})};
}

BrokerMessage SparkplugNode::birth(std::string_view software, std::int64_t now_ms) {
  seq_ = 0;
  Metrics metrics{
      session_number(session_),
      {.name = "Node Control/Rebirth", .type = SparkplugType::boolean, .value = false},
      {.name = "Properties/Software", .type = SparkplugType::text, .value = std::string(software)},
  };
  return {.topic = topic("NBIRTH"),
          .payload = write_({.at_ms = now_ms, .seq = seq_, .metrics = std::move(metrics)}),
          .qos = 0};
}

BrokerMessage SparkplugNode::of_device(std::string_view word, std::string_view machine, Metrics metrics,
                                       std::int64_t now_ms) const {
  return {.topic = fmt::format("{}/{}", topic(word), topic_level(machine)),
          .payload = write_({.at_ms = now_ms, .seq = seq_, .metrics = std::move(metrics)}),
          .qos = 0};
}

std::string SparkplugNode::topic(std::string_view word) const {
  return fmt::format("spBv1.0/{}/{}/{}", group_, word, node_);
}

std::string why_no_sparkplug_id(std::string_view id) {
  constexpr std::size_t kLongest = 100;
  if (id.empty() || id.size() > kLongest) return "has 1 to 100 bytes";
  if (topic_level(id) != id) return "has no /, +, #, $, % and no control characters: it is one level of a topic";
  return {};
}

}  // namespace dripfeed::app
