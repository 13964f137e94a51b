// What a client may ask of an open text: each answer is plain data in the client's positions, made from what was read.
// How they are written for the client is `answers`'s.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/lsp/texts.h"

namespace dripfeed::lsp {

// A text with what was read of it and how the client counts.
struct Subject {
  const OpenText& text;
  const Reading& reading;
  PositionUnit unit;

  [[nodiscard]] Range range_of(text::Span span) const { return text.lines().range_of(span, unit); }
  [[nodiscard]] std::uint32_t offset_of(Position at) const { return text.lines().offset_of(at, unit); }
  // Of a line as dripfeed counts them: from 1, ended by an EOB.
  [[nodiscard]] text::Span span_of_line(std::uint32_t line) const;
};

struct Location {
  std::string uri;
  Range range;
};

struct TextEdit {
  Range range;
  std::string text;
};

struct Related {
  Location at;
  std::string text;
};

struct Fault {
  Range range;
  text::Severity severity = text::Severity::error;
  std::string name;  // of the table of diagnostics
  std::string text;  // the sentence and the control's alarm
  std::vector<Related> related;
};
// Of one report on the subject's text.
std::vector<Fault> faults_of(const Subject& of, const app::CheckReport& report);

struct Hover {
  Range range;
  std::string text;  // Markdown
};
// What the tables say of the word there, and the help of a diagnostic that is reported there.
std::optional<Hover> hover_at(const Subject& of, Position at);

struct Symbol {
  compile::OutlineSort sort = compile::OutlineSort::program;
  std::string name;
  Range line;                    // where it stands
  Range whole;                   // of a program: up to the next one
  std::vector<Symbol> children;  // of a program
};
std::vector<Symbol> symbols_of(const Subject& of);

// Of the block number, label or program that the statement there names.
std::vector<Location> definition_at(const Subject& of, Position at, const compile::FindText& find_called);

struct Proposal {
  const compile::DialectWord* word = nullptr;
  Range replaced;
};
std::vector<Proposal> proposals_at(const Subject& of, Position at);

// A line each that changes. Errors: refused, with the lines that stand against it.
app::Result<std::vector<TextEdit>> renumbered(const Subject& of, const Settings& settings);

struct Action {
  std::string title;
  std::vector<TextEdit> edits;
  std::optional<Fault> mends;  // nothing: it mends all that can be
};
// The edits that diagnostics in the range propose, and all of the text at once.
std::vector<Action> actions_in(const Subject& of, const Range& range);

}  // namespace dripfeed::lsp
