// Comments come first in number: one with small letters would hide all else, and is one finding.
#include "server/app/checks/line_characters.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

// Characters of comments that a line or a control does not take: one finding for lower-case letters, one for all
// others.
struct CommentCharacters {
  std::size_t count = 0;
  std::optional<text::Diagnostic> first;
};

constexpr bool is_lower_case(std::uint8_t byte) { return byte >= 'a' && byte <= 'z'; }

text::Diagnostic refused_character(const machine::LineSettings& line, std::uint32_t at, std::uint8_t byte) {
  const bool printable = byte > ' ' && byte < 0x7F;
  return {
      .id = text::DiagnosticId::invalid_character,
      .severity = text::Severity::error,
      .span = {at, at + 1},
      .arguments = {printable ? std::string(1, static_cast<char>(byte)) : fmt::format("0x{:02X}", byte)},
      .notes = {{.span = {at, at + 1}, .text = machine::character_refusal(line, {.text_offset = at, .byte = byte})}}};
}

}  // namespace

void check_characters(const Examination& e, const ir::Program& program, std::vector<text::Diagnostic>& diagnostics) {
  if (e.profile == nullptr) return;
  const auto line = machine::effective_line(e.profile->line);
  if (!line) return;  // the profile's own fault, reported where the time is
  tape_code::CharacterSet taken = machine::characters_of(*line);
  taken.add('\r');  // a part of the text's EOBs, and not sent as such
  std::vector<text::Span> reported;
  for (text::Diagnostic& d : diagnostics) {
    if (d.id != text::DiagnosticId::invalid_character) continue;
    // Whether the control takes small letters may be open; a line that does not carry them settles it.
    const bool is_letter = d.span.size() == 1;
    if (is_letter && !taken.has(static_cast<std::uint8_t>(program.source.text()[d.span.begin])))
      d.severity = text::Severity::error;
    reported.push_back(d.span);
  }
  std::ranges::sort(reported, {}, &text::Span::begin);
  const auto is_reported = [&reported](std::uint32_t at) {
    const auto after = std::ranges::upper_bound(reported, at, {}, &text::Span::begin);
    return after != reported.begin() && at < std::prev(after)->end;
  };
  std::size_t in_program = 0;
  std::array<CommentCharacters, 2> in_comments;  // others, lower case
  for (const ir::Token& token : program.tokens) {
    for (std::uint32_t at = token.span.begin; at < token.span.end; ++at) {
      const auto byte = static_cast<std::uint8_t>(program.source.text()[at]);
      if (taken.has(byte)) continue;
      if (token.kind == ir::TokenKind::comment) {
        CommentCharacters& kind = in_comments[is_lower_case(byte) ? 1 : 0];
        if (kind.count++ == 0) kind.first = refused_character(*line, at, byte);
      } else if (in_program < tape_code::CharacterCheck::kMaxReported && !is_reported(at)) {
        ++in_program;
        diagnostics.push_back(refused_character(*line, at, byte));
      }
    }
  }
  for (CommentCharacters& kind : in_comments) {
    if (!kind.first) continue;
    kind.first->severity = text::Severity::warning;
    if (kind.count > 1)
      kind.first->notes.push_back(
          {.span = kind.first->span,
           .text = fmt::format("the first of {} {} in comments", kind.count,
                               &kind == &in_comments[1] ? "lower-case letters" : "such characters")});
    diagnostics.push_back(std::move(*kind.first));
  }
}

}  // namespace dripfeed::app
