// Words, assignments and comments of one line. All values of a line are read before anything is set, and what is set
// counts from the next line on for the words, too.
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "dialects/linuxcnc/parse.h"
#include "dialects/linuxcnc/tables.h"
#include "dialects/text/number.h"

namespace dripfeed::linuxcnc {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::ModalGroup;
using ir::Operator;
using ir::StatementKind;
using enum text::DiagnosticId;

namespace {

constexpr double kMillisecondsPerSecond = 1000.0;
constexpr double kDwell = 4.0;  // G4
// Where probed positions, offsets and stored points lie. What a program writes there counts when the control reads it
// next.
constexpr std::uint32_t kFirstStored = 5061;
constexpr std::uint32_t kLastStored = 5428;

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
char capital(char c) { return is_small(c) ? static_cast<char>(c - 'a' + 'A') : c; }

// "MSG" of "( Msg , text".
std::string command_of(std::string_view inner) {
  std::string command;
  for (const char c : inner.substr(0, inner.find(','))) {
    if (c == ' ' || c == '\t') continue;
    if (command.size() > std::string_view("PROBECLOSE").size()) return {};
    command += capital(c);
  }
  return command;
}

// The length of "%d", "%f", "%lf" or "%.4f" at the start; 0: it is text.
std::size_t format_length(std::string_view text) {
  if (text.starts_with("%d") || text.starts_with("%f")) return 2;
  if (text.starts_with("%lf")) return 3;
  const bool digits = text.size() > 3 && text.starts_with("%.") && text[2] >= '0' && text[2] <= '9' && text[3] == 'f';
  return digits ? 4 : 0;
}

}  // namespace

void Parser::words() {
  raw_.clear();
  assigns_.clear();
  assigned_names_.clear();
  while (!faults_.failed() && expressions_.at() < line_.text.size()) {
    const std::size_t begin = expressions_.at();
    const char c = line_.at(begin);
    if (c == '#') {
      assignment();
    } else if (is_small(c)) {
      expressions_.skip(1);
      const ExpressionId value = expressions_.value();
      raw_.push_back({capital(c), false, value, line_.span(begin, expressions_.at())});
    } else if (c == '@' || c == '^' || c == '$') {
      return faults_.make_native(std::string_view(c == '$' ? "words of a spindle by its number" : "polar coordinates"));
    } else {
      faults_.fail(value_without_address, line_.span(begin, begin + 1), {std::string(1, c)});
    }
  }
  if (faults_.failed()) return;
  const bool stored = std::ranges::any_of(assigns_, [&](const ir::Assign& a) {
    const ir::Variable& v = program_.at(a.target);
    return v.bank == ir::Bank::hash && v.number >= kFirstStored && v.number <= kLastStored;
  });
  if (stored) return faults_.make_native("a parameter of the control that the program writes");
  emit_assignments();
}

void Parser::assignment() {
  const std::size_t begin = expressions_.at();
  const auto target = expressions_.parameter();
  if (!target) return;
  const std::size_t end = expressions_.at();
  if (line_.at(end) != '=') {
    faults_.fail(missing_equals, line_.span(begin, end), {std::string(line_.rest(begin).substr(0, end - begin))});
    return;
  }
  expressions_.skip(1);
  const ExpressionId value = expressions_.value();
  if (faults_.failed()) return;
  assigns_.push_back({program_.add(*target), value});
  const bool named = target->bank == ir::Bank::named;
  assigned_names_.emplace_back(named ? line_.rest(begin + 2).substr(0, end - begin - 3) : std::string_view());
}

// With words, or with others, the values wait.
void Parser::emit_assignments() {
  const bool wait = assigns_.size() > 1 || (!assigns_.empty() && !raw_.empty());
  for (std::size_t i = 0; wait && i < assigns_.size(); ++i) {
    const ir::Variable held = expressions_.own(fmt::format("value {}", i + 1));
    assign(held, assigns_[i].value);
    assigns_[i].value = program_.add_variable(held);
  }
  if (!raw_.empty()) emit_words();
  for (std::size_t i = 0; i < assigns_.size(); ++i) {
    program_.assigns.push_back(assigns_[i]);
    lowering_.emit(StatementKind::assign, static_cast<std::uint32_t>(program_.assigns.size() - 1), place());
    if (asks_existence_ && !assigned_names_[i].empty())
      assign(expressions_.existence(assigned_names_[i]), program_.add_constant(1.0));
  }
}

double Parser::number_of(ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  return e.op == Operator::constant ? e.value : std::nan("");
}

bool Parser::has_code(char letter, double number) const {
  return std::ranges::any_of(
      raw_, [&](const macro_b::RawWord& w) { return w.letter == letter && number_of(w.value) == number; });
}

void Parser::emit_words() {
  constexpr double kSaveAndRestore = 73.0;
  constexpr double kRestore = 72.0;
  constexpr double kReturn = 99.0;
  if (has_code('M', kReturn) && section_ != 0 && !by_number_) {
    faults_.fail(wrong_nesting, place().span, {"M99", sections_[section_]});
    return;
  }
  if (has_code('M', kRestore) || has_code('M', kSaveAndRestore))
    return lowering_.emit_native("M72 and M73, which take modes back", false, place(), true);
  if (emit_data_setting()) return;
  if (has_code('G', kDwell) && raw_.size() > 2) return emit_around_dwell();
  const auto first_code = program_.codes.size();
  const auto first_word = static_cast<std::uint32_t>(program_.words.size());
  for (const double number : {90.1, 91.1})
    if (has_code('G', number)) centers_absolute_ = number < 91.0;
  lowering_.lower(raw_, place());
  const auto codes = std::span(program_.codes).subspan(first_code);
  const auto moves = [](const ir::Code& c) {
    return c.group == ModalGroup::motion || c.group == ModalGroup::cycle || c.group == ModalGroup::non_modal;
  };
  const bool has_own = std::ranges::any_of(codes, moves);
  const auto words = std::span(program_.words).subspan(first_word);
  const bool names_axis = std::ranges::any_of(words, ir::is_axis, &ir::Word::address);
  // Those go on until the touch, which no one here knows.
  if (probes_ && !has_own && names_axis) lowering_.emit_native("a move in the mode of G38", false, place(), true);
  for (const ir::Code& code : codes) {
    if (code.group == ModalGroup::motion || code.group == ModalGroup::cycle) motion_ = code.function;
    if (code.function == Function::skip_move) motion_ = Function::skip_move;
    if (code.function != Function::skip_move && moves(code)) probes_ = false;
    if (code.function == Function::skip_move) probes_ = true;
  }
  interpret_words(first_code, first_word);
}

// A dwell in the block of other words: what switches acts before it, what moves after it.
void Parser::emit_around_dwell() {
  const std::vector<macro_b::RawWord> all = raw_;
  const auto emit = [&](auto belongs) {
    raw_.clear();
    std::ranges::copy_if(all, std::back_inserter(raw_), belongs);
    if (!raw_.empty()) emit_words();
  };
  const auto is_dwell = [&](const macro_b::RawWord& w) {
    return w.letter == 'P' || (w.letter == 'G' && number_of(w.value) == kDwell);
  };
  const auto switches = [&](const macro_b::RawWord& w) {
    constexpr double kFirstSwitch = 3.0;  // of the spindle; M9 of the coolant is the last
    constexpr double kLastSwitch = 9.0;
    const double number = number_of(w.value);
    return w.letter == 'S' || w.letter == 'T' || w.letter == 'F' ||
           (w.letter == 'M' && number >= kFirstSwitch && number <= kLastSwitch);
  };
  emit(switches);
  emit(is_dwell);
  emit([&](const macro_b::RawWord& w) { return !is_dwell(w) && !switches(w); });
}

// G10: offsets of G54 to G59 are set as elsewhere, whatever G91 says. What counts from the present position, turns, or
// belongs to the tool table is the control's.
bool Parser::emit_data_setting() {
  constexpr double kSetData = 10.0;
  if (!has_code('G', kSetData)) return false;
  const auto value = [&](char letter) {
    const auto word = std::ranges::find(raw_, letter, &macro_b::RawWord::letter);
    return word == raw_.end() ? std::nan("") : number_of(word->value);
  };
  const double l = value('L');
  const double p = value('P');
  const bool turns = std::ranges::find(raw_, 'R', &macro_b::RawWord::letter) != raw_.end();
  if (l == 2.0 && p >= 1.0 && p <= 6.0 && !turns) return false;
  const bool of_tool = l == 1.0 || l == 10.0 || l == 11.0;
  lowering_.emit_native(fmt::format("G10 L{}", l), false, place(), !of_tool);
  return true;
}

// Words that mean something else with the codes of their block, or in the motion in effect.
void Parser::interpret_words(std::size_t first_code, std::uint32_t first_word) {
  const auto codes = std::span(program_.codes).subspan(first_code);
  const auto has = [&](Function function) {
    return std::ranges::find(codes, function, &ir::Code::function) != codes.end();
  };
  const bool is_bare = std::ranges::none_of(codes, [](const ir::Code& c) { return c.group == ModalGroup::non_modal; });
  const bool drills = has(Function::drill) || (is_bare && motion_ == Function::drill);
  const bool arc = is_bare && (motion_ == Function::arc_cw || motion_ == Function::arc_ccw);
  for (std::size_t i = first_word; i < program_.words.size(); ++i) {
    ir::Word& word = program_.words[i];
    const bool is_center = word.address == Address::i || word.address == Address::j || word.address == Address::k;
    if (word.address == Address::p && (drills || has(Function::dwell))) {
      word.value = scaled(word.value, kMillisecondsPerSecond, 0.0);
    } else if (word.address == Address::p && arc && !has(Function::continuous_path)) {
      word.address = Address::turns;  // further ones
      program_.words[i].value = scaled(word.value, 1.0, -1.0);
    } else if (word.address == Address::d && has(Function::surface_speed_on)) {
      word.address = Address::spindle_limit;
    } else if ((is_center && arc && centers_absolute_) || (ir::is_axis(word.address) && has(Function::data_input))) {
      word.mode = ir::WordMode::absolute;
    }
  }
}

ExpressionId Parser::scaled(ExpressionId id, double factor, double added) {
  const ir::Expression e = program_.at(id);
  if (e.op == Operator::constant) return program_.add_constant(e.value * factor + added, e.span);
  const ExpressionId product = program_.add_operator(Operator::multiply, id, program_.add_constant(factor), e.span);
  return program_.add_operator(Operator::add, product, program_.add_constant(added), e.span);
}

// --- comments

void Parser::comments() {
  for (const text::Span span : line_.comments) {
    std::string_view inner = span.in(program_.source.text());
    if (!inner.starts_with('(')) continue;
    if (!inner.ends_with(')')) {
      faults_.fail(unterminated_comment, span);
      return;
    }
    inner = inner.substr(1, inner.size() - 2);
    const std::size_t comma = inner.find(',');
    if (comma == std::string_view::npos) continue;
    const std::string command = command_of(inner);
    const std::string_view text = inner.substr(comma + 1);
    if (command == "MSG" || command == "DEBUG" || command == "PRINT" || command == "ABORT")
      message(text, command != "MSG", command == "ABORT");
    else if (command == "LOG" || command == "LOGOPEN" || command == "LOGAPPEND" || command == "PROBEOPEN")
      lowering_.emit_native(command == "LOG" ? "LOG" : "a file that the control writes", true, place());
    else if (command == "PY")
      lowering_.emit_native("a comment in Python", false, place(), true);
  }
}

void Parser::message(std::string_view text, bool has_values, bool stops) {
  ir::Message message;
  message.text = has_values ? text_with_values(text) : text_constant(text);
  if (faults_.failed()) return;
  program_.messages.push_back(message);
  lowering_.emit(stops ? StatementKind::alarm : StatementKind::message,
                 static_cast<std::uint32_t>(program_.messages.size() - 1), place());
}

ExpressionId Parser::text_constant(std::string_view text) {
  ir::Expression string;
  string.op = Operator::string;
  string.string = program_.strings.add(text);
  return program_.add(string);
}

// #5 and #<name> in a text stand for their values; how many digits these have is left to whoever shows them.
ExpressionId Parser::text_with_values(std::string_view text) {
  ExpressionId whole = text_constant("");
  const auto append = [&](ExpressionId part) {
    whole = program_.add_operator(Operator::concatenate, whole, part, place().span);
  };
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t format = format_length(text.substr(i)); format > 0) {
      i += format;
      continue;
    }
    const bool named = text.substr(i).starts_with("#<");
    const std::size_t end = named ? text.find('>', i) : text.find_first_not_of("0123456789", i + 1);
    const bool is_value = text[i] == '#' && (named ? end != std::string_view::npos : end != i + 1);
    if (!is_value) {
      plain += text[i++];
      continue;
    }
    const std::string_view written = text.substr(i, std::min(end, text.size()) - i + (named ? 1 : 0));
    append(text_constant(plain));
    plain.clear();
    append(value_in_text(written));
    i += written.size();
  }
  append(text_constant(plain));
  return whole;
}

ExpressionId Parser::value_in_text(std::string_view written) {
  Line line;
  for (const char c : written)
    if (c != ' ') line.text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  line.offsets.assign(line.text.size() + 1, place().span.begin);
  if (line.text == "#<_line>") return text_constant(std::to_string(number_));
  const std::size_t at = expressions_.at();
  expressions_.begin(line, 0);
  const ExpressionId value = expressions_.value();
  expressions_.begin(line_, at);
  return value;
}

}  // namespace dripfeed::linuxcnc
