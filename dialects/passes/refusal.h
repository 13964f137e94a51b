// Why something has no counterpart on another control: the kind, which decides what a person can do about it (each is a
// diagnostic with a help of its own), and the words for it. A text alone is a function that the other control lacks.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>

#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

struct Refusal {
  text::DiagnosticId id = text::DiagnosticId::cannot_translate;
  std::string what;  // "a tap whose feed is not known here": no full stop, no "cannot"

  Refusal(text::DiagnosticId kind, std::string words) : id(kind), what(std::move(words)) {}
  template <std::convertible_to<std::string_view> Text>
  Refusal(const Text& words) : what(std::string_view(words)) {}  // NOLINT(google-explicit-constructor)
};

constexpr bool is_refusal(text::DiagnosticId id) {
  return id >= text::DiagnosticId::cannot_translate && id <= text::DiagnosticId::translation_differs;
}

// `target` is the control's title, or what stands for it.
inline text::Diagnostic diagnose(Refusal refusal, text::Span span, std::string_view target) {
  return text::make_diagnostic(refusal.id, span, {std::move(refusal.what), std::string(target)});
}

// It depends on a state that the text does not fix on all control-flow paths.
inline Refusal not_known(std::string what) { return {text::DiagnosticId::translation_not_known, std::move(what)}; }
// A number is needed where the text computes one.
inline Refusal computed(std::string what) { return {text::DiagnosticId::translation_computed, std::move(what)}; }
// A parameter of the control decides.
inline Refusal by_parameter(std::string what) {
  return {text::DiagnosticId::translation_by_parameter, std::move(what)};
}
// Two things that exclude each other there.
inline Refusal together(std::string what) { return {text::DiagnosticId::translation_together, std::move(what)}; }
// The operator's block skip would cover something else.
inline Refusal at_switch(std::string what) { return {text::DiagnosticId::translation_switch, std::move(what)}; }
// A value that others may read.
inline Refusal kept_value(std::string what) { return {text::DiagnosticId::translation_kept_value, std::move(what)}; }
// An expression, or a kind of value.
inline Refusal of_value(std::string what) { return {text::DiagnosticId::translation_value, std::move(what)}; }
inline Refusal of_tool(std::string what) { return {text::DiagnosticId::translation_tool, std::move(what)}; }
inline Refusal of_call(std::string what) { return {text::DiagnosticId::translation_call, std::move(what)}; }
inline Refusal of_axis(std::string what) { return {text::DiagnosticId::translation_axis, std::move(what)}; }
// A contour that cannot be cut as it is written.
inline Refusal of_shape(std::string what) { return {text::DiagnosticId::translation_shape, std::move(what)}; }
// The run of the translation is not that of the source.
inline Refusal differs(std::string what) { return {text::DiagnosticId::translation_differs, std::move(what)}; }

}  // namespace dripfeed::passes
