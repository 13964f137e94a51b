// Reporting of faults, and the look ahead.
#include "dialects/macro_b/reader/cursor.h"

#include <utility>

namespace dripfeed::macro_b {

text::Diagnostic* Faults::report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments,
                                 ir::AlarmDetail detail) {
  if (diagnostics_.size() >= kMostFaults) return nullptr;
  diagnostics_.push_back(ir::diagnose(control_, id, span, std::move(arguments), detail));
  return &diagnostics_.back();
}

text::Diagnostic* Faults::fail(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments,
                               ir::AlarmDetail detail) {
  if (std::exchange(failed_, true)) return nullptr;
  return report(id, span, std::move(arguments), detail);
}

const ir::Token& Cursor::peek() const {
  std::uint32_t i = index_;
  if (tokens_[i].kind == ir::TokenKind::eob) return tokens_[i];  // the last token of all is one
  do {
    ++i;
  } while (tokens_[i].kind == ir::TokenKind::white || tokens_[i].kind == ir::TokenKind::comment);
  return tokens_[i];
}

}  // namespace dripfeed::macro_b
