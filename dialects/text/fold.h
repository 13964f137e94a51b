// Diagnostics of one kind are shown a few times and then counted: a program that has the same fault in each of its
// blocks is described by the first of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dialects/text/diagnostic.h"

namespace dripfeed::text {

class DiagnosticFold {
 public:
  static constexpr std::uint64_t kShown = 20;  // of one id and severity

  // Whether this one is to be shown; counts it.
  bool shows(const Diagnostic& one) { return ++count(one.id, one.severity) <= kShown; }

  struct Row {
    DiagnosticId id;
    Severity severity;
    std::uint64_t more;  // that were not shown
  };
  // In the order of the ids.
  [[nodiscard]] std::vector<Row> folded() const {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (counts_[i] > kShown)
        rows.push_back(
            {static_cast<DiagnosticId>(i / kSeverities), static_cast<Severity>(i % kSeverities), counts_[i] - kShown});
    }
    return rows;
  }

 private:
  static constexpr std::size_t kSeverities = 3;

  std::uint64_t& count(DiagnosticId id, Severity severity) {
    return counts_[static_cast<std::size_t>(id) * kSeverities + static_cast<std::size_t>(severity)];
  }

  std::array<std::uint64_t, static_cast<std::size_t>(DiagnosticId::count_) * kSeverities> counts_{};
};

// "part.nc: warning[unknown-code]: 117 more, not shown"
std::string format_folded(const DiagnosticFold::Row& row, std::string_view name);

}  // namespace dripfeed::text
