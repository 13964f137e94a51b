// A fault in a text: which one (a row of the table), how bad, where, with what arguments, and the alarm by which the
// control itself would name it. Emitting is apart from policy (raise, lower, waive) and from printing.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/text/diagnostic_id.h"
#include "dialects/text/source.h"
#include "dialects/text/span.h"

namespace dripfeed::text {

enum class Severity : std::uint8_t { note, warning, error };
std::string_view name_of(Severity severity);

// One row a diagnostic: `name` is what users see and waive, `text` has {} for the arguments in order, `help` explains
// the fault and its cure in a sentence or two.
struct DiagnosticRow {
  DiagnosticId id;
  std::string_view name;
  Severity severity;
  std::string_view text;
  std::string_view help;
};
const DiagnosticRow& row_of(DiagnosticId id);
// nullptr when no diagnostic has that name.
const DiagnosticRow* find_diagnostic(std::string_view name);

struct DiagnosticNote {
  Span span;
  std::string text;
};

struct Diagnostic {
  DiagnosticId id;
  Severity severity = Severity::error;
  Span span;
  std::vector<std::string> arguments;
  std::vector<DiagnosticNote> notes = {};
  std::optional<Edit> fix = std::nullopt;
  std::string alarm = {};  // the control's own number ("PS0124", "14080"); empty when it has none
  // The text that the spans are in, where it is not the one that is looked at: that of a called program.
  std::shared_ptr<const Source> elsewhere = nullptr;
  bool is_open = false;  // what exists next to the program decides it: until that is given, nothing passes
};

// A diagnostic with the severity of its row.
Diagnostic make_diagnostic(DiagnosticId id, Span span, std::vector<std::string> arguments = {});

// The sentence alone: the row's text with the arguments in place, each as far as excerpt.h shows it.
std::string message_of(const Diagnostic& diagnostic);

// `name:line:column: severity[id]: text (control alarm)` and an excerpt of the line with a caret, each ended by LF.
// A diagnostic of a called program is placed in that program. `control` is the control's name next to its alarm number;
// tabs before the caret are kept so that it stands right.
std::string format_diagnostic(const Diagnostic& diagnostic, const Source& source, std::string_view control);
// The same for a text that is not at hand as a whole: its place and line are given; notes are left out.
std::string format_diagnostic_at(const Diagnostic& diagnostic, std::string_view name, Position position,
                                 std::string_view line, std::string_view control);

bool has_error(const std::vector<Diagnostic>& diagnostics);

}  // namespace dripfeed::text
