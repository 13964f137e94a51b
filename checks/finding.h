// checks/finding.h: what a check has to say: findings, each with the row of the table of diagnostics, the place, the
// value and its limit; and sentences about what was not checked and why. Lists are bounded: programs are long.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dialects/ir/motion.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::checks {

struct Finding {
  text::DiagnosticId id = text::DiagnosticId::count_;
  text::Severity severity = text::Severity::error;
  ir::Place place;
  double value = 0.0;  // units as the sentence says
  double limit = 0.0;
  std::string text;   // the sentence
  std::string alarm;  // what the control calls it, set by whoever knows the control; "" where it has no alarm
};

// Keeps the first findings of each kind, counts all and remembers the worst. A finding that is neither costs no memory,
// and one that says the same of the same program as another is kept once.
class FindingList {
 public:
  static constexpr std::size_t kKept = 20;
  static constexpr std::uint64_t kCompared = 2000;  // with those that are kept

  struct Kind {
    text::DiagnosticId id = text::DiagnosticId::count_;
    std::uint64_t count = 0;
    std::size_t kept = 0;
    Finding worst;  // the one farthest from its limit
  };

  // `arguments` is called for those that are kept or the worst so far: it gives the std::vector of the row's arguments.
  template <class Arguments>
  void add(text::DiagnosticId id, const ir::Place& place, double value, double limit, Arguments&& arguments) {
    auto kind = std::ranges::find(kinds_, id, &Kind::id);
    if (kind == kinds_.end()) kind = kinds_.insert(kinds_.end(), Kind{id, 0, 0, {}});
    const bool may_keep = kind->count++ < kCompared && kind->kept < kKept;
    const bool is_worst =
        kind->count == 1 || std::fabs(value - limit) > std::fabs(kind->worst.value - kind->worst.limit);
    if (!may_keep && !is_worst) return;
    const text::Diagnostic diagnostic = text::make_diagnostic(id, {}, std::forward<Arguments>(arguments)());
    Finding finding{id, diagnostic.severity, place, value, limit, text::message_of(diagnostic), {}};
    if (is_worst) kind->worst = finding;
    const bool is_reported = std::ranges::any_of(findings_, [&](const Finding& one) {
      return one.id == id && one.place.program == place.program && one.text == finding.text;
    });
    if (!may_keep || is_reported) return;
    ++kind->kept;
    findings_.push_back(std::move(finding));
  }

  // `alarm_of` is asked for each kept finding and each kind's worst.
  template <class AlarmOf>
  void name_alarms(AlarmOf&& alarm_of) {
    for (Finding& one : findings_) one.alarm = alarm_of(std::as_const(one));
    for (Kind& kind : kinds_) kind.worst.alarm = alarm_of(std::as_const(kind.worst));
  }

  // The kept ones, in the order of the program.
  [[nodiscard]] const std::vector<Finding>& kept() const { return findings_; }
  [[nodiscard]] const std::vector<Kind>& kinds() const { return kinds_; }
  // nullptr when there is none of that kind.
  [[nodiscard]] const Kind* kind(text::DiagnosticId id) const {
    const auto found = std::ranges::find(kinds_, id, &Kind::id);
    return found == kinds_.end() ? nullptr : &*found;
  }
  [[nodiscard]] std::uint64_t count(text::DiagnosticId id) const {
    const Kind* found = kind(id);
    return found == nullptr ? 0 : found->count;
  }
  [[nodiscard]] bool empty() const { return kinds_.empty(); }
  [[nodiscard]] bool has(text::Severity severity) const {
    return std::ranges::any_of(kinds_, [&](const Kind& one) { return one.worst.severity == severity; });
  }

 private:
  std::vector<Finding> findings_;
  std::vector<Kind> kinds_;
};

// Sentences, each once, with the first line that it is about (0: none).
struct NotChecked {
  std::string text;
  std::uint32_t line = 0;
};

class NotCheckedList {
 public:
  void add(std::string_view text, std::uint32_t line = 0) {
    if (list_.size() > kListed || std::ranges::find(list_, text, &NotChecked::text) != list_.end()) return;
    list_.push_back(list_.size() < kListed ? NotChecked{std::string(text), line}
                                           : NotChecked{"and more like these", line});
  }
  [[nodiscard]] const std::vector<NotChecked>& list() const { return list_; }
  [[nodiscard]] bool empty() const { return list_.empty(); }

 private:
  static constexpr std::size_t kListed = 1000;

  std::vector<NotChecked> list_;
};

}  // namespace dripfeed::checks
