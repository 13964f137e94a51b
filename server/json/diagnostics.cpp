// Positions are looked up here: a diagnostic knows only bytes.
#include "server/json/diagnostics.h"

#include "dialects/text/fold.h"
#include "server/json/object_reader.h"

namespace dripfeed::json {

std::string diagnostics(const std::vector<text::Diagnostic>& all, const text::Source& source) {
  Document list = Document::array();
  text::DiagnosticFold fold;
  for (const text::Diagnostic& one : all) {
    if (!fold.shows(one)) continue;
    const text::Source& in = one.elsewhere == nullptr ? source : *one.elsewhere;
    const text::Position at = in.position(one.span.begin);
    list.push_back({{"id", text::row_of(one.id).name},
                    {"severity", text::name_of(one.severity)},
                    {"file", one.elsewhere == nullptr ? Document(nullptr) : Document(in.name())},
                    {"line", at.line},
                    {"column", at.column},
                    {"column_chars", at.column_chars},
                    {"text", text::message_of(one)},
                    {"alarm", one.alarm.empty() ? Document(nullptr) : Document(one.alarm)}});
  }
  return dump(list);
}

std::string folded_diagnostics(const std::vector<text::Diagnostic>& all) {
  text::DiagnosticFold fold;
  for (const text::Diagnostic& one : all) (void)fold.shows(one);
  Document list = Document::array();
  for (const text::DiagnosticFold::Row& row : fold.folded())
    list.push_back({{"id", text::row_of(row.id).name}, {"severity", text::name_of(row.severity)}, {"more", row.more}});
  return dump(list);
}

}  // namespace dripfeed::json
