// The comments of a source line go after its first printed line where they cannot be taken for anything else there,
// otherwise onto lines of their own before it; those of lines that print nothing go before the next line that does.
#include "dialects/compile/translate/carry_comments.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace dripfeed::compile {

namespace {

constexpr std::size_t kLongestComment = 120;  // characters of one line; longer ones are cut at a blank

// The comments of one source line, as one text for the other control.
struct Carried {
  std::uint32_t line = 0;
  std::string text;
  bool is_title = false;  // after the program's number
};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_framing(std::string_view comment) { return comment.starts_with(";$PATH="); }

// "O0012 …"
bool is_program_number(std::string_view line) {
  line = trimmed(line);
  return line.size() > 1 && (line[0] == 'O' || line[0] == ':') && line[1] >= '0' && line[1] <= '9';
}

class CommentText {
 public:
  explicit CommentText(CommentStyle style) : style_(style) {}

  // What the other control can show of it; lost() shows whether that is less than was written. A tape mark would end
  // the program on a line, and brackets end or open a comment.
  std::string translate(std::string_view text) {
    lost_ = false;
    std::string out;
    for (const char c : text) out += character(c);
    return std::string(trimmed(out));
  }
  [[nodiscard]] bool lost() const { return lost_; }

 private:
  char character(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || byte == 0x7F) return ' ';
    if (byte > 0x7F || c == '%') return lose();
    if (style_ == CommentStyle::semicolon) return c;
    if (c >= 'a' && c <= 'z') return static_cast<char>(c - 'a' + 'A');
    if (c == '(') return '[';
    if (c == ')') return ']';
    constexpr std::string_view kMore = " +-:/.,#*=[]&?@\"'<>!_$;";
    const bool known = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || kMore.contains(c);
    return !known ? lose() : c == ';' ? ',' : c;  // ; is an end of block there
  }
  char lose() {
    lost_ = true;
    return ' ';
  }

  CommentStyle style_;
  bool lost_ = false;
};

// Comments that are a statement's own: the text of #3000=1(TEXT) is printed with it. Statements are in the order of
// their lines.
bool belongs_to_statement(const ir::Program& program, std::string_view comment, std::uint32_t line) {
  const auto same_line = std::ranges::equal_range(program.statements, line, {}, &ir::Statement::line);
  return std::ranges::any_of(same_line, [&](const ir::Statement& s) {
    if (s.kind != ir::StatementKind::alarm && s.kind != ir::StatementKind::message) return false;
    const ir::ExpressionId text = program.messages[s.payload].text;
    return text != ir::ExpressionId::none && trimmed(program.strings.at(program.at(text).string)) == comment;
  });
}

std::vector<Carried> comments_of(const ir::Program& program, const ir::Control& to, CommentStyle style,
                                 std::vector<text::Diagnostic>& diagnostics) {
  std::vector<Carried> out;
  CommentText words(style);
  for (const ir::Token& token : program.tokens) {
    if (token.kind != ir::TokenKind::comment) continue;
    const std::string_view written = token.span.in(program.source.text());
    const std::uint32_t line = program.source.position(token.span.begin).line;
    if (is_framing(written) || belongs_to_statement(program, text_of_comment(written), line)) continue;
    const std::string text = words.translate(text_of_comment(written));
    if (words.lost()) {
      diagnostics.push_back(text::make_diagnostic(text::DiagnosticId::cannot_translate, token.span,
                                                  {"a character of the comment", to.title}));
      diagnostics.back().severity = text::Severity::note;
    }
    if (text.empty()) continue;
    if (out.empty() || out.back().line != line)
      out.push_back({line, text, is_program_number(program.source.line(line))});
    else
      out.back().text += " " + text;
  }
  return out;
}

class Weaver {
 public:
  Weaver(std::vector<Carried> comments, const ir::Control& to, CommentStyle style)
      : comments_(std::move(comments)), most_(to.limits.block_length_bytes), style_(style) {}

  void weave(ir::PrintResult& printed) {
    std::vector<std::string_view> lines;
    const std::string_view text = printed.text;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
    // Frame lines (%, O0001) come from no line: comments stand inside the frame.
    std::size_t last = lines.size();
    while (last > 0 && origin_of(printed, last - 1) == 0) --last;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i == last) all_before(0);
      const std::uint32_t origin = origin_of(printed, i);
      if (origin != 0) all_before(origin);
      put(lines[i], origin);
    }
    if (last == lines.size()) all_before(0);
    printed.text = std::move(text_);
    printed.origin_lines = std::move(origins_);
  }

 private:
  static std::uint32_t origin_of(const ir::PrintResult& printed, std::size_t line) {
    return line < printed.origin_lines.size() ? printed.origin_lines[line] : 0;
  }

  void add(std::string_view line, std::uint32_t origin) {
    text_ += line;
    text_ += '\n';
    origins_.push_back(origin);
  }

  // Those of lines before `line`; 0: all that are left.
  void all_before(std::uint32_t line) {
    while (next_ < comments_.size() && (line == 0 || comments_[next_].line < line)) alone(comments_[next_++]);
  }

  [[nodiscard]] std::string comment(std::string_view text) const {
    return style_ == CommentStyle::brackets ? "(" + std::string(text) + ")" : "; " + std::string(text);
  }

  void alone(const Carried& carried) {
    std::string_view rest = carried.text;
    while (!rest.empty()) {
      std::size_t take = rest.size();
      if (take > kLongestComment) {
        const std::size_t blank = rest.rfind(' ', kLongestComment);
        take = blank == std::string_view::npos || blank == 0 ? kLongestComment : blank;
      }
      add(comment(trimmed(rest.substr(0, take))), carried.line);
      rest = trimmed(rest.substr(take));
    }
  }

  // A line that would take the comment for its own text: #3000=1(TEXT), #3006=1(TEXT), and messages, which are comments
  // there; also one that has a comment already.
  [[nodiscard]] bool takes_comment(std::string_view line) const {
    if (style_ == CommentStyle::semicolon) return !line.contains(';') && !line.starts_with('%');
    return !line.contains('(') && !line.contains("#3000=") && !line.contains("#3006=") && line != "%";
  }

  void put(std::string_view line, std::uint32_t origin) {
    if (origin == 0 && next_ < comments_.size() && comments_[next_].is_title && is_program_number(line) &&
        takes_comment(line))
      return add(std::string(line) + " " + comment(comments_[next_++].text), origin);
    const bool has_own = next_ < comments_.size() && comments_[next_].line == origin && origin != 0;
    if (!has_own) return add(line, origin);
    const Carried& carried = comments_[next_++];
    const std::string commented = std::string(line) + " " + comment(carried.text);
    const bool fits = carried.text.size() <= kLongestComment && (most_ == 0 || commented.size() <= most_);
    if (takes_comment(line) && fits) return add(commented, origin);
    alone(carried);
    add(line, origin);
  }

  std::vector<Carried> comments_;
  std::size_t most_;
  CommentStyle style_;
  std::size_t next_ = 0;
  std::string text_;
  std::vector<std::uint32_t> origins_;
};

}  // namespace

void carry_comments(const ir::Program& program, const ir::Control& to, CommentStyle style, ir::PrintResult& printed,
                    std::vector<text::Diagnostic>& diagnostics) {
  std::vector<Carried> comments = comments_of(program, to, style, diagnostics);
  if (!comments.empty()) Weaver(std::move(comments), to, style).weave(printed);
}

std::string_view text_of_comment(std::string_view comment) {
  if (comment.starts_with('(')) {
    comment.remove_prefix(1);
    if (comment.ends_with(')')) comment.remove_suffix(1);
  } else {
    const std::size_t begin = comment.find_first_not_of(';');
    comment.remove_prefix(std::min(begin, comment.size()));
  }
  return trimmed(comment);
}

}  // namespace dripfeed::compile
