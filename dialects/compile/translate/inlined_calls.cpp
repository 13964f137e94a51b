// The new text is read again, and each of its blocks compared with the block that it was: what the reader takes
// differently in its new place (a name that the caller defines) leaves the call as it is.
#include "dialects/compile/translate/inlined_calls.h"

#include <algorithm>
#include <expected>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "dialects/compile/translate/call_conditions.h"
#include "dialects/compile/translate/described_statement.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;
using ir::TokenKind;

constexpr std::size_t kMostNewLines = 20'000;

// Statements of one text that the new text has at some line, for one call of the main program.
struct Expected {
  const ir::Program* text = nullptr;
  std::uint32_t statement = 0;
  std::uint32_t site = ir::kNoIndex;  // the call; kNoIndex: none, a line of the main program
};

struct NewText {
  std::string text;
  std::vector<std::uint32_t> origin_lines;
  std::vector<Expected> expected;
};

// The comments within a part of the text.
std::string comments_in(const ir::Program& text, text::Span span) {
  std::string out;
  auto token = std::ranges::lower_bound(text.tokens, span.begin, {}, [](const ir::Token& t) { return t.span.begin; });
  for (; token != text.tokens.end() && token->span.begin < span.end; ++token)
    if (token->kind == TokenKind::comment) out.append(1, ' ').append(token->span.in(text.source.text()));
  return out;
}

class Inliner {
 public:
  Inliner(const ir::Program& text, const Dialect& dialect, const ir::Control& control, ProgramLibrary& library)
      : text_(text),
        dialect_(dialect),
        control_(control),
        main_(main_part(text)),
        conditions_(text, {&text, main_.index}, dialect, control, library) {}

  InlinedText run() {
    InlinedText out;
    const auto calls = [](const ir::Statement& s) { return s.kind == StatementKind::call; };
    if (std::ranges::none_of(text_.statements, calls)) return out;
    for (;;) {
      kept_.clear();
      inlined_.clear();
      NewText made = make();
      if (inlined_.empty()) break;
      const std::optional<std::uint32_t> wrong = first_difference(made);
      if (!wrong) {
        out.text = std::move(made.text);
        out.origin_lines = std::move(made.origin_lines);
        break;
      }
      refuse(*wrong);
    }
    out.inlined = std::move(inlined_);
    out.kept = std::move(kept_);
    return out;
  }

 private:
  // --- the text

  NewText make() {
    NewText out;
    std::uint32_t next = 0;  // statement
    const std::string_view whole = text_.source.text();
    for (std::uint32_t line = 1, at = 0; at < main_.bytes; ++line) {
      const std::string_view words = text_.source.line(line);
      const auto end = static_cast<std::uint32_t>(at + words.size());
      const std::uint32_t after = end + text::eob_length(whole, end);
      const std::uint32_t first = next;
      while (next < main_.range.last && text_.statements[next].line <= line) ++next;
      bool is_replaced = false;
      for (std::uint32_t i = first; i < next; ++i)
        if (text_.statements[i].kind == StatementKind::call) is_replaced = replace_main(i, out) || is_replaced;
      if (!is_replaced) {
        for (std::uint32_t i = first; i < next; ++i) out.expected.push_back({&text_, i});
        add_line(out, words, line, whole.substr(end, after - end));
      }
      at = after;
      if (after == end) break;  // the last one
    }
    return out;
  }

  static void add_line(NewText& out, std::string_view words, std::uint32_t origin, std::string_view eob) {
    out.text.append(words).append(eob);
    out.origin_lines.push_back(origin);
  }

  bool replace_main(std::uint32_t i, NewText& out) {
    Around around{.callers = {{&text_, main_.index}}, .site = i, .line = text_.statements[i].line};
    return replace({&text_, main_.index}, i, std::move(around), out);
  }

  // Whether the lines of the call's program are in the text now.
  bool replace(const Callee& caller, std::uint32_t i, Around around, NewText& out) {
    const ir::Call& call = caller.text->calls[caller.text->statements[i].payload];
    if (call.cycle != nullptr || call.name == ir::StringId::none) return keep_unnamed(call, around);
    const std::string name(caller.text->strings.at(call.name));
    const Callee target = conditions_.find(name, *caller.text);
    if (target.text != nullptr && target.text->is_standard) return false;
    LoopsAround loops = loops_around(*caller.text, caller.range(), i);
    around.repeats = around.repeats || loops.repeats;
    const bool is_main = around.callers.size() == 1;
    if (is_main) around.loops = std::move(loops.numbers);
    auto taken = take(caller, i, target, around, out);
    if (!taken) {
      kept_.push_back({around.line, name, std::move(taken.error())});
      return false;
    }
    const CalledBody& body = taken->body;
    around.callers.push_back(target);
    if (is_main) inlined_.push_back({around.line, name, body.blocks});
    add_line(out, heading(*caller.text, i, name, is_main), around.line, eob());
    write(target, *taken, around, out);
    add_line(out, comment("end of " + name), around.line, eob());
    return true;
  }

  bool keep_unnamed(const ir::Call& call, const Around& around) {
    if (call.cycle == nullptr) kept_.push_back({around.line, {}, "which program it is, a value decides"});
    return false;
  }

  std::expected<TakenBody, std::string> take(const Callee& caller, std::uint32_t i, const Callee& target,
                                             const Around& around, const NewText& out) {
    if (const auto known = refused_.find(around.site); known != refused_.end()) return std::unexpected(known->second);
    if (!all_why_.empty()) return std::unexpected(all_why_);
    if (std::string why = conditions_.refusal(caller, i, target, around); !why.empty())
      return std::unexpected(std::move(why));
    if (out.origin_lines.size() > text_.source.line_count() + kMostNewLines)
      return std::unexpected("the text would become too long");
    return conditions_.body_of(target, around);
  }

  // --- its lines

  void write(const Callee& target, const TakenBody& taken, const Around& around, NewText& out) {
    const auto& [body, numbers] = taken;
    const ir::Program& text = *target.text;
    std::uint32_t next = body.first;
    for (std::uint32_t line = body.first_line; line <= body.last_line; ++line) {
      const std::uint32_t first = next;
      while (next < body.last && text.statements[next].line <= line) ++next;
      if (next == first + 1 && text.statements[first].kind == StatementKind::call &&
          replace(target, first, inner(around, numbers, body, first), out))
        continue;
      for (std::uint32_t n = first; n < next; ++n) out.expected.push_back({&text, n, around.site});
      add_line(out, body_line(body, line, first, next, numbers), around.line, eob());
    }
  }

  // The loops of the body are added by their new numbers.
  Around inner(const Around& around, const LoopNumbers& numbers, const CalledBody& body,
               std::uint32_t statement) const {
    Around out = around;
    for (std::uint32_t n = body.first; n < statement; ++n) {
      const auto found = numbers.find(n);
      if (found == numbers.end() || !passes::begins_loop(body.text->statements[n].kind)) continue;
      if (body.text->structures[body.text->statements[n].payload].partner > statement)
        out.loops.push_back(found->second);
    }
    return out;
  }

  // In place of the call, with its number and comments.
  [[nodiscard]] std::string heading(const ir::Program& text, std::uint32_t i, const std::string& name,
                                    bool keeps_number) const {
    const ir::Statement& s = text.statements[i];
    const std::string_view words = text.source.line(s.line);
    const auto begin = static_cast<std::uint32_t>(words.data() - text.source.text().data());
    std::string out(keeps_number ? words.substr(0, s.span.begin - begin) : std::string_view());
    out += comment("start of " + name) + comments_in(text, s.span);
    return out.append(words.substr(s.span.end - begin));
  }

  [[nodiscard]] std::string comment(const std::string& what) const {
    if (dialect_.comments == CommentStyle::brackets) return "(" + text::upper_case(what) + ")";
    return "; " + what;
  }

  // Without its number, and with the loops' own where they stand now.
  [[nodiscard]] std::string body_line(const CalledBody& body, std::uint32_t line, std::uint32_t first,
                                      std::uint32_t last, const LoopNumbers& numbers) const {
    const ir::Program& text = *body.text;
    const std::string_view whole = text.source.text();
    const std::string_view words = text.source.line(line);
    const auto begin = static_cast<std::uint32_t>(words.data() - whole.data());
    std::vector<text::Edit> edits;
    for (std::uint32_t n = first; n < last; ++n) {
      if (const auto number = numbers.find(n); number != numbers.end())
        edits.push_back(loop_edit(text, n, number->second));
      for (const ir::Label& label : std::ranges::equal_range(text.labels, n, {}, &ir::Label::statement)) {
        text::Span span = label.span;
        while (span.end < whole.size() && whole[span.end] == ' ') ++span.end;
        edits.push_back({span, {}});
      }
    }
    if (line == body.last_line && !body.return_words.empty()) edits.push_back({body.return_words, {}});
    std::ranges::sort(edits, {}, [](const text::Edit& one) { return one.replaced.begin; });
    std::string out;
    std::uint32_t at = begin;
    for (const text::Edit& one : edits) {
      out.append(whole.substr(at, one.replaced.begin - at)).append(one.text);
      at = one.replaced.end;
    }
    out += words.substr(at - begin);
    while (!edits.empty() && !out.empty() && out.back() == ' ') out.pop_back();
    return out;
  }

  // The last number of its block: DO1, WHILE[...]DO1, END1.
  static text::Edit loop_edit(const ir::Program& text, std::uint32_t statement, std::uint8_t number) {
    text::Edit out;
    const ir::TokenRange tokens = text.statements[statement].tokens;
    for (std::uint32_t t = tokens.first; t < tokens.last; ++t)
      if (text.tokens[t].kind == TokenKind::number) out = {text.tokens[t].span, std::to_string(number)};
    return out;
  }

  [[nodiscard]] std::string_view eob() const {
    const std::string_view whole = text_.source.text();
    const std::size_t end = text_.source.line(1).size();
    const std::uint32_t length = text::eob_length(whole, end);
    return length == 0 ? "\n" : whole.substr(end, length);
  }

  // --- read again

  // The site of the first block that is another one; kNoIndex where it is of none.
  [[nodiscard]] std::optional<std::uint32_t> first_difference(const NewText& made) const {
    const ir::ReadResult read = dialect_.read(text::Source(text_.source.name(), made.text), control_);
    std::uint32_t at = 0;
    const auto& statements = read.program.statements;
    const auto skip_empty = [&] {
      while (at < statements.size() && statements[at].kind == StatementKind::empty) ++at;
    };
    std::uint32_t site = ir::kNoIndex;
    for (const Expected& one : made.expected) {
      if (one.text->statements[one.statement].kind == StatementKind::empty) continue;
      skip_empty();
      if (one.site != ir::kNoIndex) site = one.site;
      if (at == statements.size() ||
          described_statement(*one.text, one.statement) != described_statement(read.program, at))
        return one.site == ir::kNoIndex ? site : one.site;
      ++at;
    }
    skip_empty();
    const bool same_programs = read.program.sections.size() <= main_.index + std::size_t{1};
    if (at == statements.size() && same_programs) return {};
    return site;
  }

  void refuse(std::uint32_t site) {
    if (site == ir::kNoIndex)
      all_why_ = "the text would be read differently";
    else
      refused_[site] = "its blocks would be read differently in its caller's text";
  }

  const ir::Program& text_;
  const Dialect& dialect_;
  const ir::Control& control_;
  MainPart main_;
  CallConditions conditions_;
  std::string all_why_;                           // of every call
  std::map<std::uint32_t, std::string> refused_;  // by site
  std::vector<InlinedCall> inlined_;
  std::vector<KeptCall> kept_;
};

}  // namespace

MainPart main_part(const ir::Program& text) {
  MainPart out;
  out.bytes = static_cast<std::uint32_t>(text.source.text().size());
  out.range = {.first = 0, .last = static_cast<std::uint32_t>(text.statements.size())};
  if (text.sections.size() < 2) return out;
  out.index = ir::section_named(text, text.name).value_or(0);
  out.range.last = text.sections[out.index].last;
  if (out.range.last < text.statements.size())
    out.bytes = static_cast<std::uint32_t>(text.source.line(text.statements[out.range.last].line).data() -
                                           text.source.text().data());
  return out;
}

InlinedText inline_calls(const ir::Program& text, const Dialect& dialect, const ir::Control& control,
                         ProgramLibrary& library) {
  return Inliner(text, dialect, control, library).run();
}

}  // namespace dripfeed::compile
