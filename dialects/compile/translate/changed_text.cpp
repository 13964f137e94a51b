// New statements are printed together, as a program of their own whose line numbers say which belongs where.
#include "dialects/compile/translate/changed_text.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "dialects/compile/dialect/printed_lines.h"
#include "dialects/compile/translate/carry_comments.h"
#include "dialects/facts/flow_graph.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;
using ir::TokenKind;

class Writer {
 public:
  Writer(const ir::Program& before, const ir::Program& after, const std::vector<optimize::MadeLine>& made_lines,
         const Dialect& dialect, const ir::Control& control, const KeptText& kept)
      : before_(before), after_(after), made_lines_(made_lines), dialect_(dialect), control_(control), kept_(kept) {
    const auto count = static_cast<std::uint32_t>(before_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) old_by_key_.try_emplace(key_of(before_.statements[i]), i);
    is_target_ = facts::jump_targets(after_);
    was_target_ = facts::jump_targets(before_);
    for (const ir::Statement& s : before_.statements) text_lines_ = std::max(text_lines_, s.line);
    find_heading();
  }

  ChangedText write() {
    plan();
    const std::map<std::uint32_t, std::string> printed = print();
    for (const Piece& piece : pieces_) {
      if (piece.group == 0) {
        old_line(piece.line);
      } else if (const auto text = printed.find(piece.group); text != printed.end()) {
        skip_to(piece.line);
        append(text->second, piece.line);
      }
    }
    bare_lines(before_.source.line_count() + 1);
    return {std::move(out_), std::move(origins_)};
  }

 private:
  // A line of the text as it was, or what is printed of a group of new statements.
  struct Piece {
    std::uint32_t line = 0;   // of the text; 0: of none
    std::uint32_t group = 0;  // 0: the line itself
    std::uint32_t made = 0;   // 1 is the first of made_lines_
  };
  using Key = std::tuple<StatementKind, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

  static Key key_of(const ir::Statement& s) { return {s.kind, s.payload, s.span.begin, s.span.end, s.line}; }

  [[nodiscard]] std::uint32_t old_of(std::uint32_t i) const {
    const auto found = old_by_key_.find(key_of(after_.statements[i]));
    return found == old_by_key_.end() ? ir::kNoIndex : found->second;
  }

  // How many statements from `i` on are a whole line of the text; 0 where they are not.
  [[nodiscard]] std::uint32_t whole_line_at(std::uint32_t i) const {
    const std::uint32_t old = old_of(i);
    if (old == ir::kNoIndex || (is_target_[i] && !was_target_[old])) return 0;
    const std::uint32_t line = before_.statements[old].line;
    if (old > 0 && before_.statements[old - 1].line == line) return 0;
    std::uint32_t n = 0;
    for (; old + n < before_.statements.size() && before_.statements[old + n].line == line; ++n)
      if (i + n >= after_.statements.size() || old_of(i + n) != old + n) return 0;
    return n;
  }

  void plan() {
    const auto count = static_cast<std::uint32_t>(after_.statements.size());
    for (std::uint32_t i = 0; i < count;) {
      const std::uint32_t whole = whole_line_at(i);
      if (whole > 0) {
        pieces_.push_back({after_.statements[i].line, 0});
        i += whole;
        continue;
      }
      const std::uint32_t line = after_.statements[i].line;
      const auto group = static_cast<std::uint32_t>(pieces_.size() + 1);
      // Blocks that were made have a line of their own, beyond those of the text.
      const bool is_made = line > text_lines_;
      pieces_.push_back({is_made ? 0 : line, group, is_made ? line - text_lines_ : 0});
      do {
        made_.emplace_back(i, group);
        ++i;
      } while (i < count && after_.statements[i].line == line && whole_line_at(i) == 0);
    }
  }

  [[nodiscard]] std::map<std::uint32_t, std::string> print() const {
    ir::Program made = after_;
    made.statements.clear();
    made.labels.clear();
    for (const auto& [i, group] : made_) {
      const auto at = static_cast<std::uint32_t>(made.statements.size());
      for (const ir::Label& label : std::ranges::equal_range(after_.labels, i, {}, &ir::Label::statement)) {
        if (!is_target_[i] && !kept_.numbers) continue;
        made.labels.push_back(label);
        made.labels.back().statement = at;
      }
      made.statements.push_back(after_.statements[i]);
      made.statements.back().line = group;
    }
    const ir::PrintResult printed = dialect_.print(made, control_);
    std::map<std::uint32_t, std::string> out;
    for_each_line(printed.text, [&](const PrintedLine& line) {
      const std::uint32_t group = printed.origin_lines[line.number - 1];
      if (group != 0) out[group].append(line.text).append(1, '\n');
    });
    for (auto& [group, text] : out) finish(group, text);
    return out;
  }

  // The comment of the line, which the first of its new blocks gets, and the text's own end of block.
  void finish(std::uint32_t group, std::string& text) const {
    const std::uint32_t line = pieces_[group - 1].line;
    const bool is_first = group == 1 || pieces_[group - 2].line != line || pieces_[group - 2].group == 0;
    const std::uint32_t made = pieces_[group - 1].made;
    std::string comment;
    if (kept_.comments && made != 0)
      comment = comments_of(made_lines_[made - 1].comments_of);
    else if (kept_.comments && is_first)
      comment = comment_of(line);
    std::string out;
    for_each_line(text, [&](const PrintedLine& one) {
      out += one.text;
      if (one.number == 1 && !comment.empty()) out.append(1, ' ').append(comment);
      out += eob();
    });
    text = std::move(out);
  }

  // All in one, where their style lets them stand next to each other.
  [[nodiscard]] std::string comments_of(const std::vector<std::uint32_t>& lines) const {
    std::string out;
    for (const std::uint32_t line : lines) {
      const std::string_view comment = comment_of(line);
      if (comment.empty()) continue;
      if (out.empty())
        out = comment;
      else
        out.append(", ").append(text_of_comment(comment));
    }
    return out;
  }

  [[nodiscard]] std::string_view comment_of(std::uint32_t line) const {
    if (line == 0) return {};
    const text::Span span = span_of(line);
    auto token = first_token_at(span.begin);
    for (; token != before_.tokens.end() && token->span.begin < span.end; ++token)
      if (token->kind == TokenKind::comment) return token->span.in(before_.source.text());
    return {};
  }

  [[nodiscard]] std::vector<ir::Token>::const_iterator first_token_at(std::uint32_t offset) const {
    return std::ranges::lower_bound(before_.tokens, offset, {}, [](const ir::Token& t) { return t.span.begin; });
  }

  [[nodiscard]] text::Span span_of(std::uint32_t line) const {
    const std::string_view whole = before_.source.text();
    const std::string_view found = before_.source.line(line);
    const auto begin = static_cast<std::uint32_t>(found.data() - whole.data());
    return {begin, begin + static_cast<std::uint32_t>(found.size())};
  }

  [[nodiscard]] std::string_view eob() const {
    const std::string_view whole = before_.source.text();
    const auto end = static_cast<std::size_t>(span_of(1).end);
    const std::uint32_t length = text::eob_length(whole, end);
    return length == 0 ? "\n" : whole.substr(end, length);
  }

  // Comments before the first block say what the program is.
  void find_heading() {
    for (const ir::Statement& s : before_.statements) {
      if (s.kind != StatementKind::empty) break;
      heading_ = s.line;
    }
  }

  // Lines of the text that no statement has.
  void bare_lines(std::uint32_t until) {
    for (; next_line_ < until; ++next_line_)
      if (!std::ranges::binary_search(lines_with_statements(), next_line_)) append_line(next_line_);
  }
  const std::vector<std::uint32_t>& lines_with_statements() {
    if (lines_.empty())
      for (const ir::Statement& s : before_.statements)
        if (lines_.empty() || lines_.back() < s.line) lines_.push_back(s.line);
    return lines_;
  }
  void skip_to(std::uint32_t line) {
    if (line > next_line_) bare_lines(line);
  }

  void old_line(std::uint32_t line) {
    skip_to(line);
    append_line(line);
    next_line_ = std::max(next_line_, line + 1);
  }

  void append_line(std::uint32_t line) {
    const text::Span span = span_of(line);
    const std::string_view whole = before_.source.text();
    const std::string_view rest = whole.substr(span.end, text::eob_length(whole, span.end));
    if ((kept_.comments || line <= heading_) && kept_.numbers) {
      append(span.in(whole), line);
      out_ += rest;
      return;
    }
    const std::string words = stripped(line, span);
    const bool had_words = span.begin != span.end;
    if (words.empty() && had_words) return;
    append(words, line);
    out_ += rest;
  }

  // Whole lines; the last one's end of block may follow.
  void append(std::string_view lines, std::uint32_t origin) {
    out_ += lines;
    const auto ends = static_cast<std::size_t>(std::ranges::count(lines, '\n'));
    origins_.insert(origins_.end(), std::max<std::size_t>(ends, 1), origin);
  }

  // Without what is to be left out.
  [[nodiscard]] std::string stripped(std::uint32_t line, text::Span span) const {
    const std::string_view whole = before_.source.text();
    std::string out;
    auto token = first_token_at(span.begin);
    const text::Span number = kept_.numbers ? text::Span{} : number_of(line);
    for (; token != before_.tokens.end() && token->span.begin < span.end; ++token) {
      if (token->kind == TokenKind::comment && !kept_.comments && line > heading_) continue;
      if (!number.empty() && token->span.begin >= number.begin && token->span.end <= number.end) continue;
      if (out.empty() && token->kind == TokenKind::white) continue;
      out += token->span.in(whole);
    }
    while (!out.empty() && (out.back() == ' ' || out.back() == '\t')) out.pop_back();
    return out;
  }

  // Of the block number where nothing jumps to it.
  [[nodiscard]] text::Span number_of(std::uint32_t line) const {
    const auto line_of = [this](const ir::Label& label) { return before_.statements[label.statement].line; };
    for (const ir::Label& label : std::ranges::equal_range(before_.labels, line, {}, line_of))
      if (label.name == ir::StringId::none && !was_target_[label.statement]) return label.span;
    return {};
  }

  const ir::Program& before_;
  const ir::Program& after_;
  const std::vector<optimize::MadeLine>& made_lines_;
  const Dialect& dialect_;
  const ir::Control& control_;
  KeptText kept_;
  std::map<Key, std::uint32_t> old_by_key_;
  std::vector<bool> is_target_;   // of `after_`
  std::vector<bool> was_target_;  // of `before_`
  std::vector<Piece> pieces_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> made_;  // new statements and their groups
  std::vector<std::uint32_t> lines_;
  std::uint32_t heading_ = 0;
  std::uint32_t text_lines_ = 0;
  std::uint32_t next_line_ = 1;
  std::string out_;
  std::vector<std::uint32_t> origins_;  // by line of out_
};

}  // namespace

ChangedText changed_text(const ir::Program& before, const ir::Program& after,
                         const std::vector<optimize::MadeLine>& made, const Dialect& dialect,
                         const ir::Control& control, const KeptText& kept) {
  return Writer(before, after, made, dialect, control, kept).write();
}

}  // namespace dripfeed::compile
