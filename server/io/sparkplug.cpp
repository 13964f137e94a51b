// The data types of metrics are those of Sparkplug 3.0, section 6.4.16.
#include "server/io/sparkplug.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <variant>

#include <sparkplug.pb.h>

namespace dripfeed::io {

namespace {

using sparkplug::Payload;

enum class DataType : std::uint32_t { int64 = 4, real = 10, boolean = 11, text = 12 };

DataType type_of(app::SparkplugType type) {
  switch (type) {
    case app::SparkplugType::boolean: return DataType::boolean;
    case app::SparkplugType::whole: return DataType::int64;
    case app::SparkplugType::real: return DataType::real;
    case app::SparkplugType::text: break;
  }
  return DataType::text;
}

void set_value(Payload::Metric& metric, const app::SparkplugValue& value) {
  const auto set = [&metric]<class T>(const T& known) {
    if constexpr (std::is_same_v<T, std::monostate>) {
      metric.set_is_null(true);
    } else if constexpr (std::is_same_v<T, bool>) {
      metric.set_boolean_value(known);
    } else if constexpr (std::is_same_v<T, std::int64_t>) {
      metric.set_long_value(static_cast<std::uint64_t>(known));  // two's complement, as the specification has it
    } else if constexpr (std::is_same_v<T, double>) {
      metric.set_double_value(known);
    } else {
      metric.set_string_value(known);
    }
  };
  std::visit(set, value);
}

}  // namespace

std::string write_sparkplug(const app::SparkplugPayload& payload) {
  Payload written;
  written.set_timestamp(static_cast<std::uint64_t>(payload.at_ms));
  if (payload.seq) written.set_seq(*payload.seq);
  for (const app::SparkplugMetric& metric : payload.metrics) {
    Payload::Metric& added = *written.add_metrics();
    added.set_name(metric.name);
    added.set_datatype(static_cast<std::uint32_t>(type_of(metric.type)));
    set_value(added, metric.value);
  }
  return written.SerializeAsString();
}

bool asks_for_rebirth(std::string_view payload) {
  if (payload.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return false;
  Payload read;
  if (!read.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) return false;
  return std::ranges::any_of(read.metrics(), [](const Payload::Metric& metric) {
    return metric.name() == "Node Control/Rebirth" && metric.boolean_value();
  });
}

}  // namespace dripfeed::io
