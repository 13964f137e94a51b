// What a message of Sparkplug B carries, before it is written as bytes (Sparkplug 3.0, chapter 6).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace dripfeed::app {

enum class SparkplugType : std::uint8_t { boolean, whole, real, text };

// Nothing: it is not known, or there is none.
using SparkplugValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct SparkplugMetric {
  std::string name;
  SparkplugType type = SparkplugType::text;
  SparkplugValue value;
  friend bool operator==(const SparkplugMetric&, const SparkplugMetric&) = default;
};

struct SparkplugPayload {
  std::int64_t at_ms = 0;
  std::optional<std::uint8_t> seq;  // a death has none
  std::vector<SparkplugMetric> metrics;
};

}  // namespace dripfeed::app
