// Canonical text: one statement a line; assignments of one source line stay on one line while it is short.
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "dialects/ir/readable_line.h"
#include "dialects/sinumerik/reader/lower.h"
#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/writer/print_block.h"
#include "dialects/sinumerik/writer/print_expression.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;

std::string_view name_of(ir::ValueType type) {
  switch (type) {
    case ir::ValueType::integer: return "INT";
    case ir::ValueType::real: return "REAL";
    case ir::ValueType::boolean: return "BOOL";
    case ir::ValueType::character: return "CHAR";
    case ir::ValueType::string: return "STRING";
    case ir::ValueType::axis: return "AXIS";
    case ir::ValueType::frame: return "FRAME";
  }
  return {};
}

class Printer {
 public:
  Printer(const ir::Program& program, const ir::Control& control)
      : program_(program), expressions_(program, control), blocks_(program, control) {}

  ir::PrintResult print() {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) statement(i);
    end_line();
    result_.variables = count_variables();
    return std::move(result_);
  }

 private:
  void statement(std::uint32_t i) {
    const ir::Statement& s = program_.statements[i];
    const bool labelled = has_printed_label(i);
    std::string words;
    words_of(i, s, words);
    if (words.empty() && !labelled) return;
    if (s.kind == StatementKind::assign && !labelled && joins(s, words)) {
      line_ += ' ';
      line_ += words;
      return;
    }
    end_line();
    open_line_ = true;
    origin_ = s.line;
    open_skip_ = s.skip_level;
    joinable_ = s.kind == StatementKind::assign && comment_.empty();
    if (s.skip_level > 0) line_ += s.skip_level == 1 ? "/ " : "/" + std::to_string(s.skip_level - 1) + " ";
    if (labelled) labels(i, s);
    line_ += words;
    if (!comment_.empty()) line_ += " ; " + std::exchange(comment_, {});
  }

  [[nodiscard]] bool joins(const ir::Statement& s, const std::string& words) const {
    return open_line_ && joinable_ && comment_.empty() && s.line != 0 && s.line == origin_ &&
           s.skip_level == open_skip_ && line_.size() + words.size() < ir::kReadableLine;
  }

  void end_line() {
    if (!open_line_) return;
    while (!line_.empty() && line_.back() == ' ') line_.pop_back();
    result_.text += line_;
    result_.text += '\n';
    result_.origin_lines.push_back(origin_);
    line_.clear();
    open_line_ = false;
  }

  [[nodiscard]] std::pair<std::size_t, std::size_t> labels_at(std::uint32_t statement) const {
    const auto range = std::ranges::equal_range(program_.labels, statement, {}, &ir::Label::statement);
    const auto first = static_cast<std::size_t>(range.begin() - program_.labels.begin());
    return {first, first + range.size()};
  }

  [[nodiscard]] bool has_printed_label(std::uint32_t statement) const {
    const auto [first, last] = labels_at(statement);
    return first != last;
  }

  // Of several block numbers of one place each but the last has a line of its own.
  void labels(std::uint32_t statement, const ir::Statement& s) {
    const auto [first, last] = labels_at(statement);
    const auto is_number = [](const ir::Label& label) { return label.name == ir::StringId::none; };
    bool numbered = false;
    for (std::size_t i = first; i < last; ++i) {
      if (!is_number(program_.labels[i])) continue;
      if (std::exchange(numbered, true)) {
        end_line();
        open_line_ = true;
        origin_ = s.line;
      }
      line_ += "N" + std::to_string(program_.labels[i].number) + " ";
    }
    for (std::size_t i = first; i < last; ++i)
      if (!is_number(program_.labels[i])) line_ += std::string(program_.strings.at(program_.labels[i].name)) + ": ";
  }

  void value(std::string& out, ir::ExpressionId id) const { expressions_.append(out, id); }

  void words_of(std::uint32_t i, const ir::Statement& s, std::string& out) {
    switch (s.kind) {
      case StatementKind::empty:
      case StatementKind::output: return;  // of other controls: raising refuses them
      case StatementKind::block:
        // The word that it carries out stands in the block before it.
        if (is_aside(program_, program_.blocks[s.payload])) return;
        return blocks_.append(out, program_.blocks[s.payload]);
      case StatementKind::assign: return assign(program_.assigns[s.payload], out);
      case StatementKind::go_to: return jump(program_.jumps[s.payload], out);
      case StatementKind::if_begin: return opener("IF ", s, out);
      case StatementKind::else_begin: out += "ELSE"; return;
      case StatementKind::if_end: out += "ENDIF"; return;
      case StatementKind::while_begin: return opener("WHILE ", s, out);
      case StatementKind::while_end: out += "ENDWHILE"; return;
      case StatementKind::repeat_begin: out += "REPEAT"; return;
      case StatementKind::repeat_end: return opener("UNTIL ", s, out);
      case StatementKind::for_begin: return for_loop(program_.structures[s.payload], out);
      case StatementKind::for_end: out += "ENDFOR"; return;
      case StatementKind::loop_begin: out += "LOOP"; return;
      case StatementKind::loop_end: out += "ENDLOOP"; return;
      case StatementKind::define: return definition(program_.structures[s.payload], out);
      case StatementKind::call:
        if (is_written_call(s)) {
          out += written(s.span);
          return;
        }
        return call(program_.calls[s.payload], out);
      case StatementKind::return_to:
        out += "RET(";
        if (program_.jumps[s.payload].computed != ir::ExpressionId::none)
          value(out, program_.jumps[s.payload].computed);
        if (program_.jumps[s.payload].levels != 1) out += ",," + std::to_string(program_.jumps[s.payload].levels);
        out += ')';
        return;
      case StatementKind::modal_call: out += "MCALL "; return call(program_.calls[s.payload], out);
      case StatementKind::modal_call_end:
        // A cycle that is not read stands on the same line.
        if (s.span.empty() || same_name(written(s.span), "MCALL")) out += "MCALL";
        return;
      case StatementKind::procedure: return procedure(program_.structures[s.payload], out);
      case StatementKind::declaration: out += written_line(i); return;
      case StatementKind::subprogram_return: out += same_name(written(s.span), "RET") ? "RET" : "M17"; return;
      case StatementKind::program_end: return program_end(s, out);
      case StatementKind::message: return message("MSG", program_.messages[s.payload], out);
      case StatementKind::alarm: return message("SETAL", program_.messages[s.payload], out);
      case StatementKind::repeat_section:
      case StatementKind::execute_text:
      case StatementKind::native:
        // A fault after IF or WHILE is a second statement of its line, which is printed already.
        if (s.tokens.first < s.tokens.last) out += written_line(i);
        return;
    }
  }

  // CALL, PCALL and EXTCALL look for their program by methods of their own: they stay as they are written.
  [[nodiscard]] bool is_written_call(const ir::Statement& s) const {
    const std::string_view text = written(s.span);
    return std::ranges::any_of(std::array{"CALL", "PCALL", "EXTCALL"}, [text](std::string_view word) {
      return text.size() > word.size() && same_name(text.substr(0, word.size()), word) &&
             !is_name_character(text[word.size()]);
    });
  }

  [[nodiscard]] std::string_view written(text::Span span) const {
    return span.end <= program_.source.text().size() ? span.in(program_.source.text()) : std::string_view();
  }

  // The line's own words, without its number, labels and comment.
  [[nodiscard]] std::string written_line(std::uint32_t i) const {
    const ir::Statement& s = program_.statements[i];
    const auto tokens = std::span(program_.tokens);
    if (tokens.empty()) return {};
    const auto after =
        std::ranges::upper_bound(tokens, s.span.begin, {}, [](const ir::Token& t) { return t.span.begin; });
    std::size_t first = static_cast<std::size_t>(after - tokens.begin());
    while (first > 0 && tokens[first - 1].kind != ir::TokenKind::eob) --first;
    std::string out;
    bool head = true;
    for (std::size_t t = first; t < tokens.size() && tokens[t].kind != ir::TokenKind::eob; ++t) {
      if (tokens[t].kind == ir::TokenKind::comment) break;
      head = head && tokens[t].span.begin < label_end(i);
      if (head || (out.empty() && tokens[t].kind == ir::TokenKind::white)) continue;
      if (tokens[t].kind != ir::TokenKind::skip && tokens[t].kind != ir::TokenKind::tape_mark)
        out += tokens[t].span.in(program_.source.text());
    }
    return out;
  }

  // Where the line's number and labels end, the colon of a label with them.
  [[nodiscard]] std::uint32_t label_end(std::uint32_t statement) const {
    std::uint32_t end = 0;
    const auto [first, last] = labels_at(statement);
    for (std::size_t i = first; i < last; ++i) {
      const ir::Label& label = program_.labels[i];
      end = std::max(end, label.span.end);
      const std::size_t colon = program_.source.text().find(':', label.span.end);
      if (label.name != ir::StringId::none && colon != std::string_view::npos)
        end = std::max(end, static_cast<std::uint32_t>(colon + 1));
    }
    return end;
  }

  void assign(const ir::Assign& a, std::string& out) {
    const ir::Variable& target = program_.at(a.target);
    expressions_.append_variable(out, target);
    out += '=';
    value(out, a.value);
    // A name that became a number is reported where the number is set first.
    if (target.bank == ir::Bank::r && target.symbol != ir::SymbolId::none && named_.insert(target.number).second)
      comment_ = program_.strings.at(program_.at(target.symbol).name);
  }

  void jump(const ir::Jump& j, std::string& out) const {
    if (j.restart && j.condition == ir::ExpressionId::none) {
      out += "GOTOS";
      return;
    }
    if (j.condition != ir::ExpressionId::none) {
      out += "IF ";
      value(out, j.condition);
      out += ' ';
    }
    if (j.restart) {
      out += "GOTOS";
      return;
    }
    out += j.tolerant                             ? "GOTOC "
           : j.search == ir::JumpSearch::forward  ? "GOTOF "
           : j.search == ir::JumpSearch::backward ? "GOTOB "
                                                  : "GOTO ";
    if (j.computed != ir::ExpressionId::none) {
      value(out, j.computed);
    } else if (j.label != ir::StringId::none) {
      out += program_.strings.at(j.label);
    } else {
      out += "N" + std::to_string(j.number);
    }
  }

  void opener(std::string_view word, const ir::Statement& s, std::string& out) const {
    out += word;
    value(out, program_.structures[s.payload].condition);
  }

  void for_loop(const ir::Structure& s, std::string& out) const {
    out += "FOR ";
    expressions_.append_variable(out, program_.at(s.counter));
    out += '=';
    value(out, s.first);
    out += " TO ";
    value(out, s.last);
  }

  void symbol(const ir::Symbol& s, std::string& out) const {
    out += program_.strings.at(s.name);
    if (s.dimension1 > 0) {
      out += "[" + std::to_string(s.dimension1);
      if (s.dimension2 > 0) out += "," + std::to_string(s.dimension2);
      if (s.dimension3 > 0) out += "," + std::to_string(s.dimension3);
      out += "]";
    }
    if (s.initial != ir::ExpressionId::none) {
      out += '=';
      value(out, s.initial);
    }
  }

  static std::string type_of(const ir::Symbol& s) {
    std::string type(name_of(s.type));
    if (s.string_length > 0) type += "[" + std::to_string(s.string_length) + "]";
    return type;
  }

  void definition(const ir::Structure& s, std::string& out) const {
    if (s.symbol_count == 0) return;
    out += "DEF " + type_of(program_.symbols[s.first_symbol]) + " ";
    for (std::uint32_t i = 0; i < s.symbol_count; ++i) {
      if (i > 0) out += ", ";
      symbol(program_.symbols[s.first_symbol + i], out);
    }
  }

  void procedure(const ir::Structure& s, std::string& out) const {
    out += "PROC " + program_.name + "(";
    for (std::uint32_t i = 0; i < s.symbol_count; ++i) {
      const ir::Symbol& parameter = program_.symbols[s.first_symbol + i];
      if (i > 0) out += ", ";
      if (parameter.by_reference) out += "VAR ";
      out += type_of(parameter) + " ";
      symbol(parameter, out);
    }
    out += s.saves_modal ? ") SAVE" : ")";
  }

  // CALL "NAME" BLOCK "A" TO "B".
  void part_call(const ir::Call& c, std::string& out) const {
    out += "CALL ";
    quoted_name(c, out);
    out += " BLOCK ";
    value(out, c.first_label);
    out += " TO ";
    value(out, c.last_label);
  }

  void quoted_name(const ir::Call& c, std::string& out) const {
    if (c.computed != ir::ExpressionId::none)
      value(out, c.computed);
    else
      out += '"' + std::string(program_.strings.at(c.name)) + '"';
  }
  void call(const ir::Call& c, std::string& out) const {
    c.first_label != ir::ExpressionId::none ? part_call(c, out) : whole_call(c, out);
    if (c.repeats == ir::ExpressionId::none) return;
    out += " P=";
    value(out, c.repeats);
  }
  void whole_call(const ir::Call& c, std::string& out) const {
    if (c.in_other_language) {
      out += "ISOCALL ";
      return quoted_name(c, out);
    }
    if (c.computed != ir::ExpressionId::none) {
      out += "CALL(";
      value(out, c.computed);
      out += ')';
    }
    out += program_.strings.at(c.name);
    if (c.argument_count > 0) {
      out += '(';
      for (std::uint32_t i = 0; i < c.argument_count; ++i) {
        if (i > 0) out += ',';
        const ir::Argument& argument = program_.arguments[c.first_argument + i];
        if (argument.value != ir::ExpressionId::none) value(out, argument.value);
      }
      out += ')';
    }
  }

  void program_end(const ir::Statement& s, std::string& out) const {
    const bool m2 = same_name(written(s.span), "M2") || same_name(written(s.span), "M02");
    out += m2 ? "M2" : "M30";
  }

  void message(std::string_view word, const ir::Message& m, std::string& out) const {
    out += word;
    out += '(';
    if (m.number != ir::ExpressionId::none) value(out, m.number);
    if (m.number != ir::ExpressionId::none && m.text != ir::ExpressionId::none) out += ',';
    if (m.text != ir::ExpressionId::none) value(out, m.text);
    out += ')';
  }

  // Of the statements that are left, not of the arena: raising leaves copies there.
  [[nodiscard]] std::uint32_t count_variables() const {
    std::set<std::pair<int, std::uint32_t>> seen;
    for (const ir::Variable& v : program_.variables) {
      if (v.bank == ir::Bank::system || v.bank == ir::Bank::hash) continue;
      if (v.bank == ir::Bank::r && v.index != ir::ExpressionId::none) continue;
      seen.emplace(static_cast<int>(v.bank),
                   v.bank == ir::Bank::named ? static_cast<std::uint32_t>(v.symbol) : v.number);
    }
    return static_cast<std::uint32_t>(seen.size());
  }

  const ir::Program& program_;
  ExpressionPrinter expressions_;
  BlockPrinter blocks_;
  std::set<std::uint32_t> named_;
  ir::PrintResult result_;
  std::string line_;
  std::string comment_;
  std::uint32_t origin_ = 0;
  std::uint8_t open_skip_ = 0;
  bool open_line_ = false;
  bool joinable_ = false;
};

}  // namespace

ir::PrintResult print(const ir::Program& program, const ir::Control& control) {
  return Printer(program, control).print();
}

}  // namespace dripfeed::sinumerik
