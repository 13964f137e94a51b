// checks/verdict.h: what all checks of one text say together, and how their words become one. Waivers are others'.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "checks/accuracy/accuracy.h"
#include "checks/envelope/envelope.h"
#include "checks/finding.h"
#include "checks/gouge/gouge.h"
#include "checks/timing/timing.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::checks {

// From best to worst. unknown: something may be wrong that nothing looked at; it outranks a warning, and a failure
// outranks it.
enum class Verdict : std::uint8_t { pass, warn, unknown, fail };

constexpr std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::warn: return "warn";
    case Verdict::unknown: return "unknown";
    case Verdict::fail: return "fail";
  }
  return {};
}

constexpr Verdict combine(std::initializer_list<Verdict> verdicts) {
  Verdict worst = Verdict::pass;
  for (const Verdict verdict : verdicts) worst = std::max(worst, verdict);
  return worst;
}

constexpr Verdict verdict_of(text::Severity severity) {
  switch (severity) {
    case text::Severity::note: return Verdict::pass;
    case text::Severity::warning: return Verdict::warn;
    case text::Severity::error: return Verdict::fail;
  }
  return Verdict::unknown;
}

inline Verdict verdict_of(const std::vector<text::Diagnostic>& diagnostics) {
  Verdict worst = Verdict::pass;
  for (const text::Diagnostic& one : diagnostics)
    worst = std::max({worst, verdict_of(one.severity), one.is_open ? Verdict::unknown : Verdict::pass});
  return worst;
}

inline Verdict verdict_of(const FindingList& findings) {
  Verdict worst = Verdict::pass;
  for (const FindingList::Kind& one : findings.kinds()) worst = std::max(worst, verdict_of(one.worst.severity));
  return worst;
}

// All that was found in one text. A check that did not run is empty and has its reason in `not_checked`.
struct CheckReport {
  std::vector<text::Diagnostic> diagnostics;  // of reading, validating and running
  std::optional<envelope::Report> envelope;
  std::optional<gouge::Report> gouge;
  std::optional<accuracy::Report> accuracy;
  std::optional<timing::Report> timing;
  // The program has words or calls whose effect is not known: then the verdict is at best unknown.
  bool has_unknown_effects = false;
  NotCheckedList not_checked;  // of no single check
};

// Calls visit(one) for the report of each check that ran, in the order in which they are printed. Whatever concerns all
// checks uses it: a new check is a member above and a line here.
template <class Report, class Visit>
void for_each_check(Report& report, Visit&& visit) {
  if (report.envelope) visit(*report.envelope);
  if (report.gouge) visit(*report.gouge);
  if (report.accuracy) visit(*report.accuracy);
  if (report.timing) visit(*report.timing);
}

inline Verdict verdict_of(const CheckReport& report) {
  Verdict worst = verdict_of(report.diagnostics);
  for_each_check(report, [&](const auto& one) { worst = std::max(worst, verdict_of(one.findings)); });
  const bool unjudged =
      (report.gouge && report.gouge->has_unjudged_cuts) || (report.accuracy && report.accuracy->has_unmeasured_cuts);
  return report.has_unknown_effects || unjudged ? std::max(worst, Verdict::unknown) : worst;
}

// Every sentence about what was not checked, those of the single checks first.
inline std::vector<NotChecked> not_checked_of(const CheckReport& report) {
  std::vector<NotChecked> all;
  const auto append = [&all](const NotCheckedList& list) {
    all.insert(all.end(), list.list().begin(), list.list().end());
  };
  for_each_check(report, [&](const auto& one) { append(one.not_checked); });
  append(report.not_checked);
  return all;
}

}  // namespace dripfeed::checks
