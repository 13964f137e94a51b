// The causes are those that checks::verdict_of goes by; what was not checked without being one of them is none.
#include "server/app/checks/verdict_points.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

class Points {
 public:
  explicit Points(const CheckReport& report) : report_(report) {}

  std::vector<std::string> run() {
    for (const text::Diagnostic& one : report_.checks.diagnostics) take(one);
    checks::for_each_check(report_.checks, [this](const auto& one) { take(one.findings); });
    if (report_.checks.has_unknown_effects) add("it has effects that are not known: see what was not checked");
    if (report_.checks.gouge && report_.checks.gouge->has_unjudged_cuts)
      add("some cuts were not compared with stock and part");
    if (report_.checks.accuracy && report_.checks.accuracy->has_unmeasured_cuts)
      add("some cuts were not compared with the nominal");
    if (points_.size() > kMostPoints) points_.clear();
    return std::move(points_);
  }

 private:
  void add(std::string text) {
    if (points_.size() <= kMostPoints && std::ranges::find(points_, text) == points_.end())
      points_.push_back(std::move(text));
  }

  void take(const text::Diagnostic& one) {
    if (one.severity != text::Severity::warning && !one.is_open) return;
    const text::Source& in = one.elsewhere ? *one.elsewhere : report_.source;
    const std::string where = one.elsewhere ? fmt::format("{}, ", in.name()) : std::string();
    add(fmt::format("{}line {}: {}", where, in.position(one.span.begin).line, text::message_of(one)));
  }

  void take(const checks::FindingList& findings) {
    for (const checks::Finding& one : findings.kept())
      if (one.severity == text::Severity::warning) add(fmt::format("{}: {}", place_of(one.place), one.text));
    for (const checks::FindingList::Kind& kind : findings.kinds())
      if (kind.worst.severity == text::Severity::warning && kind.count > kind.kept)
        add(fmt::format("{} more like it: {}", kind.count - kind.kept, kind.worst.text));
  }

  [[nodiscard]] std::string place_of(const ir::Place& place) const {
    const bool is_called = place.program != 0 && place.program < report_.programs.size();
    return fmt::format("{}line {}", is_called ? report_.programs[place.program] + ", " : "", place.line);
  }

  const CheckReport& report_;
  std::vector<std::string> points_;
};

}  // namespace

std::vector<std::string> points_of(const CheckReport& report) {
  const bool is_between = report.verdict == checks::Verdict::warn || report.verdict == checks::Verdict::unknown;
  return is_between ? Points(report).run() : std::vector<std::string>();
}

}  // namespace dripfeed::app
