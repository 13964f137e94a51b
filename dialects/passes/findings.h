// What a pass reports: why the statement that it is at has no counterpart on the target, and what is not known there.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/passes/refusal.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

class Findings {
 public:
  // Must outlive it.
  explicit Findings(const ir::Control& target) : target_(target) {}

  void at(text::Span span) { span_ = span; }
  void cannot(Refusal what) { diagnostics_.push_back(diagnose(std::move(what), span_, target_.title)); }
  // It is written all the same, with a warning.
  void warn(Refusal what) {
    cannot(std::move(what));
    diagnostics_.back().severity = text::Severity::warning;
  }
  void unknown(std::string what, std::string why) {
    diagnostics_.push_back(
        text::make_diagnostic(text::DiagnosticId::unknown_modal_state, span_, {std::move(what), std::move(why)}));
  }
  std::vector<text::Diagnostic> take() { return std::move(diagnostics_); }

 private:
  const ir::Control& target_;
  text::Span span_;
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace dripfeed::passes
