// Tokens, statements and places of a program that was read.
#include "tests/fuzz/program_checks.h"

namespace dripfeed::fuzz {

namespace {

bool lies_in(text::Span span, std::string_view text) { return span.begin <= span.end && span.end <= text.size(); }

// How many {} a row's sentence has.
std::size_t places_in(std::string_view sentence) {
  std::size_t count = 0;
  for (std::size_t at = sentence.find("{}"); at != std::string_view::npos; at = sentence.find("{}", at + 2)) ++count;
  return count;
}

// How many entries the arena of a statement's payload has; nothing for kinds without one.
std::size_t arena_size(const ir::Program& program, ir::StatementKind kind) {
  switch (kind) {
    case ir::StatementKind::empty:
    case ir::StatementKind::modal_call_end:
    case ir::StatementKind::subprogram_return:
    case ir::StatementKind::declaration: return 0;
    case ir::StatementKind::program_end:
    case ir::StatementKind::block: return program.blocks.size();
    case ir::StatementKind::assign: return program.assigns.size();
    case ir::StatementKind::return_to:
    case ir::StatementKind::go_to: return program.jumps.size();
    case ir::StatementKind::if_begin:
    case ir::StatementKind::else_begin:
    case ir::StatementKind::if_end:
    case ir::StatementKind::while_begin:
    case ir::StatementKind::while_end:
    case ir::StatementKind::repeat_begin:
    case ir::StatementKind::repeat_end:
    case ir::StatementKind::for_begin:
    case ir::StatementKind::for_end:
    case ir::StatementKind::loop_begin:
    case ir::StatementKind::loop_end:
    case ir::StatementKind::define:
    case ir::StatementKind::procedure: return program.structures.size();
    case ir::StatementKind::call:
    case ir::StatementKind::modal_call: return program.calls.size();
    case ir::StatementKind::output: return program.outputs.size();
    case ir::StatementKind::repeat_section: return program.repeats.size();
    case ir::StatementKind::execute_text:
    case ir::StatementKind::message:
    case ir::StatementKind::alarm: return program.messages.size();
    case ir::StatementKind::native: return program.natives.size();
  }
  return 0;
}

void require_statements(const ir::Program& program, const text::Source& source) {
  std::uint32_t token = 0;
  std::uint32_t line = 0;
  for (const ir::Statement& statement : program.statements) {
    require(lies_in(statement.span, source.text()), "a statement lies in the text");
    require(statement.line >= line && statement.line <= source.line_count() + 1,
            "statements are in the order of lines");
    line = statement.line;
    const std::size_t arena = arena_size(program, statement.kind);
    const bool points = statement.payload != ir::kNoIndex;
    require(!points || statement.payload < arena, "a statement points into its arena");
    require(points || statement.kind != ir::StatementKind::assign, "an assignment has its target and value");
    if (statement.tokens.first == statement.tokens.last) continue;
    require(statement.tokens.first >= token && statement.tokens.last <= program.tokens.size() &&
                statement.tokens.first < statement.tokens.last,
            "statements hold their tokens in order");
    token = statement.tokens.last;
  }
  for (const ir::Label& label : program.labels) {
    require(label.statement < program.statements.size(), "a label stands at a statement");
    require(program.statements[label.statement].is_label, "the statement of a label knows it");
  }
}

}  // namespace

void require_places(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source) {
  for (const text::Diagnostic& diagnostic : diagnostics) {
    require(lies_in(diagnostic.span, source.text()), "a diagnostic lies in the text");
    for (const text::DiagnosticNote& note : diagnostic.notes) {
      require(lies_in(note.span, source.text()), "a diagnostic's note lies in the text");
    }
    if (diagnostic.fix) require(lies_in(diagnostic.fix->replaced, source.text()), "a fix replaces a part of the text");
    const text::Position at = source.position(diagnostic.span.begin);
    // After the last EOB begins a line that nothing is in.
    require(at.line >= 1 && at.line <= source.line_count() + 1, "a diagnostic's line is there");
    require(!text::format_diagnostic(diagnostic, source, "control").empty(), "a diagnostic can be shown");
    require(diagnostic.arguments.size() == places_in(text::row_of(diagnostic.id).text),
            "a diagnostic has the arguments of its row");
  }
}

void require_whole(const ir::Program& program, const text::Source& source) {
  std::uint32_t end = 0;
  for (const ir::Token& token : program.tokens) {
    require(token.span.begin == end && token.span.end >= end, "tokens tile the text");
    end = token.span.end;
  }
  require(end == source.text().size(), "tokens reach to the end of the text");
  require(ir::print_same(program) == source.text(), "a program prints back byte for byte");
  require_statements(program, source);
}

}  // namespace dripfeed::fuzz
