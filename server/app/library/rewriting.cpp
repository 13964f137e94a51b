// Each text that comes out is read again and compared with the one before.
#include "server/app/library/rewriting.h"

#include <algorithm>
#include <utility>

#include "server/app/library/letters_and_blanks.h"
#include "server/app/library/same_program.h"

namespace dripfeed::app {

namespace {

// What a text is read by.
struct Reader {
  const compile::Dialect& dialect;
  const ir::Control& control;
  [[nodiscard]] ir::ReadResult read(const text::Source& source) const { return dialect.read(source, control); }
};

Rewritten refused(std::uint32_t line, std::string why) {
  Rewritten out;
  out.refused.push_back({line, std::move(why)});
  return out;
}

constexpr std::string_view kOther = "the text that would come out is another program";

struct LineError {
  std::uint32_t line = 0;
  const text::Diagnostic* of = nullptr;
};

std::vector<LineError> errors_of(const ir::ReadResult& read) {
  std::vector<LineError> errors;
  for (const text::Diagnostic& one : read.diagnostics)
    if (one.severity == text::Severity::error || one.id == text::DiagnosticId::invalid_character)
      errors.push_back({read.program.source.position(one.span.begin).line, &one});
  return errors;
}

// Blocks that the reader would take for others keep their blanks.
Rewritten respaced(Blanks blanks, const text::Source& source, const Reader& reader) {
  const ir::ReadResult before = reader.read(source);
  if (const auto errors = errors_of(before); !errors.empty())
    return refused(errors.front().line, "the line has an error: " + text::message_of(*errors.front().of));
  BlankOrder order{.blanks = blanks, .words_may_touch = reader.dialect.comments == compile::CommentStyle::brackets};
  const auto make = [&] { return text::Source(source.name(), with_blanks(before.program, order)); };
  text::Source made = make();
  ir::ReadResult after = reader.read(made);
  const auto changed = changed_blocks(before.program, after.program);
  if (!changed) return refused(0, std::string(kOther));
  if (!changed->empty()) {
    order.left_blocks = *changed;
    made = make();
    after = reader.read(made);
  }
  if (!errors_of(after).empty() || !is_same_program(before.program, after.program))
    return refused(0, std::string(kOther));
  return {.text = std::string(made.text()), .assumptions = {}, .refused = {}};
}

// Capitals may mend small letters that the control does not take: errors may go, and none may come.
Rewritten recased(LetterCase wanted, const text::Source& source, const Reader& reader) {
  const ir::ReadResult before = reader.read(source);
  const text::Source made(source.name(), with_case(before.program, wanted));
  const ir::ReadResult after = reader.read(made);
  const auto known = errors_of(before);
  for (const LineError& one : errors_of(after)) {
    const auto is_it = [&](const LineError& old) { return old.line == one.line && old.of->id == one.of->id; };
    if (std::ranges::none_of(known, is_it))
      return refused(one.line, "the line would have an error: " + text::message_of(*one.of));
  }
  if (known.empty() && !is_same_program(before.program, after.program)) return refused(0, std::string(kOther));
  return {.text = std::string(made.text()), .assumptions = {}, .refused = {}};
}

}  // namespace

Rewritten renumber_text(const compile::RenumberRequest& request) {
  compile::Renumbered made = compile::renumber(request);
  return {.text = std::move(made.text),
          .numbers = made.numbers,
          .references = made.references,
          .assumptions = std::move(made.assumptions),
          .refused = std::move(made.refused)};
}

Result<Rewritten> rewrite_text(const RewriteOrder& order, const Documents& documents) {
  const auto opened = open_text(order.of, documents);
  if (!opened) return std::unexpected(opened.error());
  const Examination& e = (*opened)->examination;
  const Reader reader{*e.dialect, e.control};
  switch (order.how) {
    case Rewriting::renumber:
      return renumber_text({.source = e.source,
                            .control = e.control,
                            .numbering = order.numbering,
                            .first = order.first,
                            .step = order.step});
    case Rewriting::add_blanks: return respaced(Blanks::add, e.source, reader);
    case Rewriting::remove_blanks: return respaced(Blanks::remove, e.source, reader);
    case Rewriting::upper_case: return recased(LetterCase::upper, e.source, reader);
    case Rewriting::lower_case: return recased(LetterCase::lower, e.source, reader);
  }
  return fail(ErrorCode::internal, "no such rewriting");
}

}  // namespace dripfeed::app
