// A word's line of the tables, with the state that `dripfeed words` gives it.
#include <fmt/format.h>

#include "server/lsp/features.h"

namespace dripfeed::lsp {

namespace {

std::string_view sentence_of(ir::WordState state) {
  switch (state) {
    case ir::WordState::interpreted: return "";
    case ir::WordState::without_effect: return "It neither moves nor changes what is checked.";
    case ir::WordState::reported: return "What it does is not followed: the verdict is `unknown`.";
  }
  return "";
}

std::string text_of(const compile::DialectWord& word) {
  std::string text = fmt::format("**{}** {}", word.spelling, word.about);
  if (word.last != 0) text = fmt::format("**{}** to **#{}** {}", word.spelling, word.last, word.about);
  if (const std::string_view state = sentence_of(word.state); !state.empty()) text += fmt::format("\n\n{}", state);
  if (!word.reference.empty()) text += fmt::format("\n\n*{}*", word.reference);
  return text;
}

}  // namespace

std::optional<Hover> hover_at(const Subject& of, Position at) {
  Hover hover{.range = {at, at}, .text = {}};
  const std::uint32_t offset = of.offset_of(at);
  if (const auto written = compile::written_word_at(of.reading.read.program, offset)) {
    const std::string_view text = written->in(of.text.source().text());
    if (const compile::DialectWord* word = of.reading.words.find(text)) hover = {of.range_of(*written), text_of(*word)};
  }
  for (const text::Diagnostic& one : of.reading.report.checks.diagnostics) {
    if (one.elsewhere != nullptr || offset < one.span.begin || offset > one.span.end) continue;
    if (hover.text.empty()) hover.range = of.range_of(one.span);
    const text::DiagnosticRow& row = text::row_of(one.id);
    hover.text += fmt::format("{}`{}`: {}", hover.text.empty() ? "" : "\n\n", row.name, row.help);
  }
  if (hover.text.empty()) return std::nullopt;
  return hover;
}

}  // namespace dripfeed::lsp
