// Token by token, in the block that the reader found it in. A jump, and a cycle that names its shape, say which line
// they mean instead of its number:
//
//   N10 X1.         N100 X1.0 (start)        X 1.
//   GOTO 10         GOTO 100                 GOTO @0
#include "dialects/compile/translate/meant_lines.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;
using ir::TokenKind;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "N10" as the name of a label: a block number all the same.
bool names_block(std::string_view name) {
  return name.size() > 1 && (name.front() == 'N' || name.front() == 'n') &&
         std::ranges::all_of(name.substr(1), is_digit);
}

// The text in brackets is for people, and is shown to them: there it is what the block says.
bool shows_comment(StatementKind kind) {
  return kind == StatementKind::message || kind == StatementKind::alarm || kind == StatementKind::output ||
         kind == StatementKind::native || kind == StatementKind::execute_text;
}

class Reading {
 public:
  Reading(const ir::ReadResult& read, const ir::Control& control)
      : program_(read.program), text_(read.program.source.text()), control_(control) {
    // 10 is 10. for certain: a control that needs no look for it.
    points_matter_ = control.semantics.decimal_mode != ir::DecimalMode::calculator ||
                     (ir::has_numbered_variables(control) && !control.semantics.decimal_mode_confirmed);
    for (const ir::Label& label : program_.labels) {
      if (label.name != ir::StringId::none) continue;
      labels_.push_back(label);
      ++times_[label.number];
    }
    std::ranges::sort(labels_, {}, [](const ir::Label& label) { return label.span.begin; });
    find_gap(read.diagnostics);
    find_use_of_numbers();
  }

  Meaning run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    ordinals_.resize(count);
    for (std::uint32_t i = 0; i < count;) {
      std::uint32_t last = i + 1;
      while (last < count && program_.statements[last].tokens.first == program_.statements[last].tokens.last) ++last;
      std::fill(ordinals_.begin() + i, ordinals_.begin() + last, static_cast<std::uint32_t>(out_.lines.size()));
      add_block(i, last);
      i = last;
    }
    put_targets();
    return std::move(out_);
  }

 private:
  // A word of a line that stands for another line.
  struct Target {
    std::size_t line = 0;  // of out_.lines
    std::size_t at = 0;    // of its words
    std::uint32_t number = 0;
  };

  void find_gap(const std::vector<text::Diagnostic>& diagnostics) {
    const auto gap = [&](std::uint32_t offset, std::string what) {
      if (out_.not_understood.empty())
        out_.not_understood = fmt::format("line {}: {}", program_.source.position(offset).line, what);
    };
    for (const text::Diagnostic& d : diagnostics)
      if (d.severity == text::Severity::error) return gap(d.span.begin, text::message_of(d));
    for (const ir::Token& token : program_.tokens)
      if (token.kind == TokenKind::invalid) return gap(token.span.begin, "it has a character that no control reads");
    for (const ir::Statement& s : program_.statements)
      if (s.kind == StatementKind::native && !program_.natives[s.payload].effects_known)
        return gap(s.span.begin,
                   fmt::format("{} is not understood", program_.strings.at(program_.natives[s.payload].name)));
    if (!program_.foreign_parts.empty())
      gap(program_.foreign_parts.front().text.begin, "it is in the control's other language");
  }

  // Numbers of blocks that are named by what is not looked at here.
  void find_use_of_numbers() {
    for (const ir::Statement& s : program_.statements)
      if (uses_numbers(s)) {
        out_.numbers_matter = fmt::format("line {}", s.line);
        return;
      }
    for (const ir::Variable& v : program_.variables) {
      const bool in_table = v.bank == ir::Bank::system && v.number < control_.system_variables.size();
      if (in_table && control_.system_variables[v.number].kind == ir::SystemValue::block_number)
        out_.numbers_matter = fmt::format("line {}", program_.source.position(v.span.begin).line);
    }
  }

  [[nodiscard]] bool uses_numbers(const ir::Statement& s) const {
    using enum StatementKind;
    if (s.kind == execute_text) return true;
    if (s.kind == go_to) {
      const ir::Jump& jump = program_.jumps[s.payload];
      if (jump.label != ir::StringId::none) return names_block(program_.strings.at(jump.label));
      return !jump.restart && !is_unique(jump.number);
    }
    if (s.kind == repeat_section) {
      const ir::Repeat& repeat = program_.repeats[s.payload];
      return repeat.first == ir::StringId::none || repeat.last_number != ir::kNoIndex ||
             names_block(program_.strings.at(repeat.first)) || names_block(program_.strings.at(repeat.last));
    }
    if (s.kind == call || s.kind == modal_call) {
      const ir::Call& one = program_.calls[s.payload];
      const auto is_text = [&](const ir::Argument& a) {
        return a.value != ir::ExpressionId::none && program_.at(a.value).op == ir::Operator::string;
      };
      return one.start != ir::ExpressionId::none || one.first_label != ir::ExpressionId::none ||
             std::ranges::any_of(program_.arguments_of(one), is_text);
    }
    if (s.kind != block || !is_repetitive(s)) return false;
    return std::ranges::any_of(program_.words_of(program_.blocks[s.payload]),
                               [&](const ir::Word& w) { return names_shape(w) && !is_unique(number_of(w)); });
  }

  [[nodiscard]] bool is_unique(std::uint32_t number) const {
    const auto found = times_.find(number);
    return found != times_.end() && found->second == 1 && program_.sections.size() < 2;
  }
  [[nodiscard]] bool is_repetitive(const ir::Statement& s) const {
    const auto codes = program_.codes_of(program_.blocks[s.payload]);
    return std::ranges::find(codes, ir::Function::repetitive_cycle, &ir::Code::function) != codes.end();
  }
  static bool names_shape(const ir::Word& word) {
    return (word.address == ir::Address::p || word.address == ir::Address::q) && word.value != ir::ExpressionId::none;
  }
  [[nodiscard]] std::uint32_t number_of(const ir::Word& word) const {
    const ir::Expression& e = program_.at(word.value);
    const bool is_number = e.op == ir::Operator::constant && e.value >= 0.0 && e.value < 1e9;
    return is_number ? static_cast<std::uint32_t>(e.value) : ir::kNoIndex;
  }

  // Tokens of statements [first, last), which are one block, that stand for another line.
  [[nodiscard]] std::map<std::uint32_t, std::uint32_t> targets_of(std::uint32_t first, std::uint32_t last) const {
    std::map<std::uint32_t, std::uint32_t> out;  // offset of the number's token: block number
    for (std::uint32_t i = first; i < last; ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind == StatementKind::go_to) {
        const ir::Jump& jump = program_.jumps[s.payload];
        if (jump.label == ir::StringId::none && is_unique(jump.number))
          if (const auto at = last_number(s.span)) out[*at] = jump.number;
      }
      if (s.kind != StatementKind::block || !is_repetitive(s)) continue;
      for (const ir::Word& word : program_.words_of(program_.blocks[s.payload]))
        if (names_shape(word) && is_unique(number_of(word)))
          if (const auto at = last_number(word.span)) out[*at] = number_of(word);
    }
    return out;
  }
  [[nodiscard]] std::optional<std::uint32_t> last_number(text::Span span) const {
    auto token =
        std::ranges::lower_bound(program_.tokens, span.end, {}, [](const ir::Token& t) { return t.span.begin; });
    while (token != program_.tokens.begin()) {
      --token;
      if (token->span.begin < span.begin) break;
      if (token->kind == TokenKind::number) return token->span.begin;
    }
    return std::nullopt;
  }

  [[nodiscard]] const ir::Label* label_at(text::Span span) const {
    auto after = std::ranges::upper_bound(labels_, span.begin, {}, [](const ir::Label& l) { return l.span.begin; });
    if (after == labels_.begin()) return nullptr;
    const ir::Label& label = *std::prev(after);
    return span.end <= label.span.end ? &label : nullptr;
  }

  void add_block(std::uint32_t first, std::uint32_t last) {
    const ir::Statement& head = program_.statements[first];
    const auto statements = std::span(program_.statements).subspan(first, last - first);
    const bool with_comments =
        std::ranges::any_of(statements, [](const ir::Statement& s) { return shows_comment(s.kind); });
    const bool is_empty = last == first + 1 && head.kind == StatementKind::empty;
    const auto targets = targets_of(first, last);
    MeantLine line{.line = head.line};
    before_ = nullptr;
    before_sign_ = nullptr;
    for (std::uint32_t i = head.tokens.first; i < head.tokens.last; ++i) {
      const ir::Token& token = program_.tokens[i];
      if (is_left_out(token.kind) || (token.kind == TokenKind::comment && !with_comments)) continue;
      if (const ir::Label* label = label_at(token.span)) {
        line.number = label->number;
        continue;
      }
      if (!line.words.empty()) line.words += ' ';
      if (const auto target = targets.find(token.span.begin); target != targets.end())
        targets_.push_back({out_.lines.size(), line.words.size(), target->second});
      else
        line.words += words_of(token);
      before_sign_ = before_;
      before_ = &token;
    }
    for (const ir::Statement& s : statements)
      if (s.kind == StatementKind::call && program_.calls[s.payload].name != ir::StringId::none)
        line.words += fmt::format(" ({})", program_.strings.at(program_.calls[s.payload].name));
    if (line.words.empty() || (is_empty && is_head(line.words))) return;
    out_.lines.push_back(std::move(line));
  }

  static bool is_left_out(TokenKind kind) {
    return kind == TokenKind::white || kind == TokenKind::eob || kind == TokenKind::tape_mark;
  }
  // The name of the only program of a text: what it is called changes nothing of what it does.
  [[nodiscard]] bool is_head(std::string_view words) const {
    return program_.sections.size() < 2 && (words.front() == 'O' || words.front() == ':' || words.front() == '<');
  }

  [[nodiscard]] std::string words_of(const ir::Token& token) const {
    const std::string_view written = token.span.in(text_);
    switch (token.kind) {
      case TokenKind::number: return number_words(written);
      case TokenKind::skip: return written == "/1" ? "/" : std::string(written);
      case TokenKind::address:
      case TokenKind::variable:
      case TokenKind::name: return text::upper_case(written);
      case TokenKind::comment:
      case TokenKind::string:
      case TokenKind::symbol:
      case TokenKind::white:
      case TokenKind::eob:
      case TokenKind::tape_mark:
      case TokenKind::invalid: return std::string(written);
    }
    return std::string(written);
  }

  [[nodiscard]] std::string number_words(std::string_view written) const {
    const auto decimal = text::read_decimal(written);
    if (!decimal || decimal->length != written.size()) return text::upper_case(written);
    const bool shows_point = points_matter_ && decimal->has_point && decimal->value != 0.0 && is_of_address();
    return text::format_shortest(decimal->value) + (shows_point ? "." : "");
  }
  // In an expression 1 is 1. everywhere; after a letter one counts increments, and the other millimetres.
  [[nodiscard]] bool is_of_address() const {
    const ir::Token* at = before_;
    if (at != nullptr && at->kind == TokenKind::symbol) {
      const std::string_view sign = at->span.in(text_);
      if (sign == "-" || sign == "+") at = before_sign_;
    }
    return at != nullptr && at->kind == TokenKind::address;
  }

  // The line that a number stands for is the first one from it on that says something.
  void put_targets() {
    for (auto target = targets_.rbegin(); target != targets_.rend(); ++target) {
      if (target->line >= out_.lines.size()) continue;
      const auto label = std::ranges::find(labels_, target->number, &ir::Label::number);
      out_.lines[target->line].words.insert(target->at, fmt::format("@{}", ordinals_[label->statement]));
    }
  }

  const ir::Program& program_;
  std::string_view text_;
  const ir::Control& control_;
  bool points_matter_ = true;
  std::vector<ir::Label> labels_;  // block numbers, by their place
  std::map<std::uint32_t, std::size_t> times_;
  std::vector<std::uint32_t> ordinals_;  // by statement: of the line that it is a part of, or the next one
  std::vector<Target> targets_;
  const ir::Token* before_ = nullptr;       // the word before, in this block
  const ir::Token* before_sign_ = nullptr;  // … and the one before that
  Meaning out_;
};

}  // namespace

Meaning meaning_of(const ir::ReadResult& read, const ir::Control& control) { return Reading(read, control).run(); }

std::string words_of_line(const Meaning& meaning, std::uint32_t line) {
  const auto found = std::ranges::lower_bound(meaning.lines, line, {}, &MeantLine::line);
  return found == meaning.lines.end() || found->line != line ? std::string() : found->words;
}

}  // namespace dripfeed::compile
