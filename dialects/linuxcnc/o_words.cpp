// O-words: a number or a name, then what the line does.
//
//   o1 while [c]           WHILE c                    o1 repeat [n]     left = ROUND[n]
//     …                      …                                          WHILE left > 0
//   o1 continue            -> next                      …                 …
//   o1 break               -> after                  o1 endrepeat        left = left - 1
//   o1 endwhile            next: END                                    END
//                          after:
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/linuxcnc/parse.h"
#include "dialects/text/number.h"

namespace dripfeed::linuxcnc {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;
using enum text::DiagnosticId;

namespace {

constexpr std::string_view kNext = "next";
constexpr std::string_view kAfter = "after";
constexpr std::size_t kMostArguments = 30;

// The letters whose arguments a macro call puts into #1, #2, #3 …: A B C, then I J K over and over.
char letter_of_argument(std::size_t index) { return index < 3 ? "ABC"[index] : "IJK"[index % 3]; }

}  // namespace

// A longer spelling before one that it begins with.
const Parser::Keyword Parser::kKeywords[] = {
    {"sub", &Parser::begin_sub},
    {"endsub", &Parser::end_sub},
    {"return", &Parser::return_word},
    {"call", &Parser::call},
    {"if", &Parser::begin_if},
    {"elseif", &Parser::else_if},
    {"else", &Parser::else_word},
    {"endif", &Parser::end_if},
    {"while", &Parser::begin_while},
    {"endwhile", &Parser::end_while},
    {"do", &Parser::begin_do},
    {"repeat", &Parser::begin_repeat},
    {"endrepeat", &Parser::end_repeat},
    {"break", &Parser::break_loop},
    {"continue", &Parser::continue_loop},
};

void Parser::o_word() {
  OWord word;
  expressions_.skip(1);
  if (!read_name(word)) return;
  const std::string_view rest = line_.rest(expressions_.at());
  if (rest.empty()) return program_number(word);
  const auto* const row =
      std::ranges::find_if(kKeywords, [&](const Keyword& k) { return rest.starts_with(k.spelling); });
  if (row == std::end(kKeywords)) {
    faults_.fail(syntax_error, place().span, {fmt::format("{} is not a word after an O-word", rest)});
    return;
  }
  expressions_.skip(row->spelling.size());
  (this->*row->read)(word);
  if (!faults_.failed() && expressions_.at() != line_.text.size())
    faults_.fail(statement_not_alone, place().span, {"the O-word"});
}

bool Parser::read_name(OWord& word) {
  if (line_.at(expressions_.at()) == '<') {
    const std::size_t end = line_.text.find('>', expressions_.at());
    if (end == std::string::npos) {
      faults_.fail(syntax_error, place().span, {"a name needs <…>"});
      return false;
    }
    word.name = line_.rest(expressions_.at() + 1).substr(0, end - expressions_.at() - 1);
    expressions_.skip(end + 1 - expressions_.at());
    return true;
  }
  const ExpressionId number = expressions_.value();
  if (faults_.failed()) return false;
  const ir::Expression& value = program_.at(number);
  if (value.op == Operator::constant)
    word.name = macro_b::program_name(value.value);
  else
    word.computed = number;
  return true;
}

// A number alone begins a program: the first one of a text the main program.
void Parser::program_number(const OWord& word) {
  bool is_main = section_ == 0 && sections_[0].empty();
  for (std::size_t i = 0; i < section_of_.size(); ++i)
    is_main = is_main && (section_of_[i] != 0 || program_.statements[i].kind == StatementKind::empty);
  if (section_ != 0 && !by_number_) {
    faults_.fail(wrong_nesting, place().span, {word.name, sections_[section_]});
    return;
  }
  if (is_main) {
    program_.name = sections_[0] = word.name;
    return;
  }
  sections_.push_back(word.name);
  section_ = static_cast<std::uint32_t>(sections_.size() - 1);
  by_number_ = true;
  numbered_.push_back(word.name);
}

void Parser::begin_sub(const OWord& word) {
  if ((section_ != 0 && !by_number_) || !open_.empty()) {
    faults_.fail(wrong_nesting, place().span, {word.name, sections_[section_]});
    return;
  }
  sections_.push_back(word.name);
  section_ = static_cast<std::uint32_t>(sections_.size() - 1);
  by_number_ = false;
}

// Programs that an O number begins are called by M98 and return by M99; those of sub by call, and by endsub.
void Parser::check_styles() {
  for (const ir::Statement& statement : program_.statements) {
    if (statement.kind != StatementKind::call) continue;
    const ir::Call& made = program_.calls[statement.payload];
    const std::string_view name = program_.strings.at(made.name);
    const bool is_here = std::ranges::find(sections_, name) != sections_.end();
    const bool is_numbered = std::ranges::find(numbered_, name) != numbered_.end();
    if (is_here && !name.empty() && is_numbered == (made.kind == ir::CallKind::macro))
      faults_.report(call_target_missing, statement.span,
                     {fmt::format("{} as {} calls it", name, is_numbered ? "O-word call" : "M98")});
  }
}

void Parser::end_sub(const OWord& word) {
  if (section_ == 0 || by_number_ || sections_[section_] != word.name || !open_.empty()) {
    faults_.fail(end_without_begin, place().span, {"endsub of " + word.name, "sub"});
    return;
  }
  give_back();
  section_of_.resize(program_.statements.size(), section_);
  section_ = 0;
}

// #<_value> is what a subprogram gives back, and #<_value_returned> whether it gave anything.
void Parser::give_back() {
  const bool has_value = line_.at(expressions_.at()) == '[';
  const ExpressionId value = has_value ? expressions_.bracketed() : program_.add_constant(0.0);
  if (faults_.failed()) return;
  assign(expressions_.named("_value", {}), value);
  assign(expressions_.named("_value_returned", {}), program_.add_constant(has_value ? 1.0 : 0.0));
  lowering_.emit(StatementKind::subprogram_return, ir::kNoIndex, place());
}

// The control does not look at its name.
void Parser::return_word(const OWord& word) {
  if (section_ == 0 || by_number_) {
    faults_.fail(end_without_begin, place().span, {"return of " + word.name, "sub"});
    return;
  }
  give_back();
}

void Parser::call(const OWord& word) {
  ir::Call call;
  call.kind = ir::CallKind::macro;
  if (word.computed != ExpressionId::none)
    call.number = word.computed;
  else
    call.name = program_.strings.add(word.name);
  std::vector<ir::Argument> arguments;
  while (!faults_.failed() && line_.at(expressions_.at()) == '[' && arguments.size() < kMostArguments) {
    const char letter = letter_of_argument(arguments.size());
    arguments.push_back({letter, expressions_.bracketed()});
  }
  if (faults_.failed()) return;
  call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
  call.argument_count = static_cast<std::uint32_t>(arguments.size());
  program_.arguments.insert(program_.arguments.end(), arguments.begin(), arguments.end());
  program_.calls.push_back(call);
  lowering_.emit(StatementKind::call, static_cast<std::uint32_t>(program_.calls.size() - 1), place());
}

// --- structures

void Parser::structure(StatementKind kind, ExpressionId condition) {
  ir::Structure structure;
  structure.condition = condition;
  program_.structures.push_back(structure);
  lowering_.emit(kind, static_cast<std::uint32_t>(program_.structures.size() - 1), place());
}

// A fault in it leaves the structure in place.
ExpressionId Parser::condition() {
  const ExpressionId value = expressions_.bracketed();
  return value == ExpressionId::none ? program_.add_constant(0.0) : value;
}

void Parser::label(const Open& open, std::string_view where) {
  lowering_.emit(StatementKind::empty, ir::kNoIndex, place()).is_label = true;
  program_.labels.push_back({program_.strings.add(fmt::format("{} of {}", where, open.number)), ir::kNoIndex,
                             static_cast<std::uint32_t>(program_.statements.size() - 1), place().span});
}

void Parser::jump(const Open& open, std::string_view where) {
  ir::Jump jump;
  jump.label = program_.strings.add(fmt::format("{} of {}", where, open.number));
  program_.jumps.push_back(jump);
  lowering_.emit(StatementKind::go_to, static_cast<std::uint32_t>(program_.jumps.size() - 1), place());
}

Parser::Open* Parser::innermost(const OWord& word, Form form, std::string_view closer) {
  if (!open_.empty() && open_.back().name == word.name && open_.back().form == form) return &open_.back();
  faults_.fail(end_without_begin, place().span, {fmt::format("{} of {}", closer, word.name), "begin"});
  return nullptr;
}

Parser::Open* Parser::loop_named(const OWord& word) {
  const auto found = std::ranges::find_if(open_.rbegin(), open_.rend(), [&](const Open& open) {
    return open.name == word.name && (open.form == Form::while_loop || open.form == Form::do_loop);
  });
  if (found != open_.rend()) return &*found;
  faults_.fail(end_without_begin, place().span, {"the jump of " + word.name, "while or do"});
  return nullptr;
}

void Parser::begin_if(const OWord& word) {
  structure(StatementKind::if_begin, condition());
  open_.push_back({.name = word.name, .form = Form::condition, .number = ++structures_, .count = {}});
}

void Parser::else_if(const OWord& word) {
  Open* const open = innermost(word, Form::condition, "elseif");
  if (open == nullptr) return;
  structure(StatementKind::else_begin);
  structure(StatementKind::if_begin, condition());
  ++open->conditions;
}

void Parser::else_word(const OWord& word) {
  if (innermost(word, Form::condition, "else") != nullptr) structure(StatementKind::else_begin);
}

void Parser::end_if(const OWord& word) {
  const Open* const open = innermost(word, Form::condition, "endif");
  if (open == nullptr) return;
  for (std::uint32_t i = 0; i < open->conditions; ++i) structure(StatementKind::if_end);
  open_.pop_back();
}

// Of a loop that began with DO it is the end.
void Parser::begin_while(const OWord& word) {
  const bool ends = !open_.empty() && open_.back().name == word.name && open_.back().form == Form::do_loop;
  if (!ends) {
    structure(StatementKind::while_begin, condition());
    open_.push_back({.name = word.name, .form = Form::while_loop, .number = ++structures_, .count = {}});
    return;
  }
  label(open_.back(), kNext);
  structure(StatementKind::repeat_end, expressions_.combine(Operator::logic_not, condition()));
  label(open_.back(), kAfter);
  open_.pop_back();
}

void Parser::end_while(const OWord& word) {
  const Open* const open = innermost(word, Form::while_loop, "endwhile");
  if (open == nullptr) return;
  label(*open, kNext);
  structure(StatementKind::while_end);
  label(*open, kAfter);
  open_.pop_back();
}

void Parser::begin_do(const OWord& word) {
  structure(StatementKind::repeat_begin);
  open_.push_back({.name = word.name, .form = Form::do_loop, .number = ++structures_, .count = {}});
}

void Parser::begin_repeat(const OWord& word) {
  const ExpressionId times = expressions_.combine(Operator::round, condition());
  if (faults_.failed()) return;
  Open open{.name = word.name, .form = Form::repeat, .number = ++structures_, .count = {}};
  open.count = expressions_.own(fmt::format("left {}", open.number));
  assign(open.count, times);
  structure(StatementKind::while_begin,
            expressions_.combine(Operator::greater, program_.add_variable(open.count), program_.add_constant(0.0)));
  open_.push_back(std::move(open));
}

void Parser::end_repeat(const OWord& word) {
  const Open* const open = innermost(word, Form::repeat, "endrepeat");
  if (open == nullptr) return;
  assign(open->count,
         expressions_.combine(Operator::subtract, program_.add_variable(open->count), program_.add_constant(1.0)));
  structure(StatementKind::while_end);
  open_.pop_back();
}

// What stands in a repeat cannot leave it.
void Parser::break_loop(const OWord& word) {
  if (const Open* const open = loop_named(word)) jump(*open, kAfter);
}
void Parser::continue_loop(const OWord& word) {
  if (const Open* const open = loop_named(word)) jump(*open, kNext);
}

}  // namespace dripfeed::linuxcnc
