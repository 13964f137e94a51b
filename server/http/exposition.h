// Writer of the Prometheus text format, version 0.0.4: families with their help and type, and the samples of each.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace dripfeed::http {

inline constexpr const char* kExpositionType = "text/plain; version=0.0.4; charset=utf-8";

enum class MetricType : std::uint8_t { counter, gauge, histogram, summary };

using Label = std::pair<std::string_view, std::string_view>;
using Labels = std::initializer_list<Label>;

class Exposition {
 public:
  // Its samples follow, and no others: a family is written once. A family without samples is left out.
  void family(std::string_view name, MetricType type, std::string_view help);
  void sample(Labels labels, std::uint64_t value);
  void sample(Labels labels, double value);
  // Of a histogram or summary: "bucket", "sum", "count".
  void part(std::string_view suffix, Labels labels, std::uint64_t value);
  void part(std::string_view suffix, Labels labels, double value);
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  void begin_line(std::string_view suffix, Labels labels);
  void end_line(std::string_view value);

  std::string text_;
  std::string name_;
  std::string head_;  // of a family that has no sample yet
};

// A duration's bound or value as the format has it: "+Inf" where it has no end.
std::string exposition_number(double value);

}  // namespace dripfeed::http
