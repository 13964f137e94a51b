// Upper case is refused because controls do not distinguish it from lower case.
#include "dialects/family/naming.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::family {

namespace {

bool is_well_formed(std::string_view name) {
  const bool known_letters =
      std::ranges::all_of(name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
  return known_letters && name.front() >= 'a' && name.front() <= 'z';
}

}  // namespace

std::optional<NewName> expect_new_name(Cursor& cursor, const Scope& scope) {
  if (cursor.peek().kind != LexemeKind::word) {
    cursor.expected("a name");
    return std::nullopt;
  }
  NewName out{std::string(cursor.word()), cursor.peek().span};
  if (is_keyword(out.name)) {
    text::Diagnostic fault = text::make_diagnostic(text::DiagnosticId::family_duplicate_name, out.span, {out.name});
    fault.notes.push_back({out.span, "it is a keyword"});
    cursor.report(std::move(fault));
    return std::nullopt;
  }
  if (!is_well_formed(out.name)) {
    cursor.syntax(out.span,
                  fmt::format("'{}' is not a name: lower case letters, digits and '_', a letter first", out.name));
    return std::nullopt;
  }
  if (const Scope::Name* earlier = scope.find(out.name)) {
    text::Diagnostic fault = text::make_diagnostic(text::DiagnosticId::family_duplicate_name, out.span, {out.name});
    fault.notes.push_back({earlier->span, "first here"});
    cursor.report(std::move(fault));
    return std::nullopt;
  }
  cursor.advance();
  return out;
}

}  // namespace dripfeed::family
