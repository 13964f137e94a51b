// By the statements of the program as it was read. What a statement does not keep, the digits of a jump, is found among
// its tokens.
#include "dialects/compile/renumber/block_references.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

using ir::ExpressionId;
using ir::Function;
using ir::StatementKind;
using ir::TokenKind;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// "N10", as a text names a block.
bool names_block(std::string_view text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const bool is_word =
        at == 0 || !(std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0 || text[at - 1] == '_');
    if (is_word && (text[at] == 'N' || text[at] == 'n') && is_digit(text[at + 1])) return true;
  }
  return false;
}

class Finder {
 public:
  explicit Finder(const ir::Program& program) : program_(program), text_(program.source.text()) {
    for (const ir::Label& label : program.labels)
      if (label.name == ir::StringId::none) numbers_.push_back(label.number);
    std::ranges::sort(numbers_);
  }

  BlockReferences find() {
    for (index_ = 0; index_ < program_.statements.size(); ++index_) statement();
    return std::move(found_);
  }

 private:
  void statement() {
    const ir::Statement& s = program_.statements[index_];
    switch (s.kind) {
      case StatementKind::go_to: return jump(program_.jumps[s.payload]);
      case StatementKind::return_to: return unclear("its block is the calling program's");
      case StatementKind::repeat_section: return repeat(program_.repeats[s.payload]);
      case StatementKind::call:
      case StatementKind::modal_call: return call(program_.calls[s.payload]);
      case StatementKind::block: return block(program_.blocks[s.payload]);
      case StatementKind::execute_text: return unclear("a text is executed as a block");
      case StatementKind::native: return native();
      default: return;
    }
  }

  void jump(const ir::Jump& jump) {
    if (jump.restart) return;
    if (jump.number == ir::kNoIndex && jump.label == ir::StringId::none) return unclear("its target is calculated");
    if (jump.label != ir::StringId::none) {
      if (names_block(program_.strings.at(jump.label))) unclear("a text names its target");
      return;
    }
    digits({jump.number});
  }

  void repeat(const ir::Repeat& repeat) {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t number : {repeat.first_number, repeat.last_number})
      if (number != ir::kNoIndex) numbers.push_back(number);
    digits(numbers);
  }

  // M97 P100 names a block of this text, as does M98 H100 without a program.
  void call(const ir::Call& call) {
    const bool is_own = call.name == ir::StringId::none && call.number == ExpressionId::none;
    const bool is_here =
        std::ranges::any_of(program_.sections, [&](const ir::Section& section) { return section.name == call.name; });
    found_.calls_others = found_.calls_others || (!is_own && !is_here);
    for (const ExpressionId label : {call.first_label, call.last_label})
      if (label != ExpressionId::none) return unclear("it calls a part of a program");
    if (call.start == ExpressionId::none) return;
    if (!is_own) return unclear("it begins in the middle of a program");
    value(call.start);
  }

  // The contour of a turning cycle.
  void block(const ir::Block& block) {
    const auto codes = program_.codes_of(block);
    const auto has = [&](Function function) {
      return std::ranges::find(codes, function, &ir::Code::function) != codes.end();
    };
    const bool is_cycle = has(Function::repetitive_cycle);
    const bool is_unknown = has(Function::not_modelled) || has(Function::no_effect);
    if (!is_cycle && !is_unknown) return;
    for (const ir::Word& word : program_.words_of(block)) {
      const std::string_view written = word.span.in(text_);
      if (written.empty() || (written.front() != 'P' && written.front() != 'Q')) continue;
      const ir::Expression& e = program_.at(word.value);
      const bool is_number = e.op == ir::Operator::constant && e.value >= 1.0 && e.value == std::floor(e.value);
      if (is_cycle && !is_number) return unclear("the block of its contour is calculated");
      if (is_cycle)
        value(word.value);
      else if (is_number && has_number(static_cast<std::uint32_t>(e.value)))
        return unclear(fmt::format("{} may be a block's number", written));
    }
  }

  void native() {
    const ir::Statement& s = program_.statements[index_];
    if (names_block(s.span.in(text_))) unclear("what is not understood may name a block");
  }

  void value(ExpressionId id) {
    const ir::Expression& e = program_.at(id);
    if (e.op != ir::Operator::constant || e.span.empty()) return unclear("the block that it names is calculated");
    const std::string_view written = e.span.in(text_);
    const text::Span digits = digits_of(text_, e.span);
    if (!text::parse_integer(digits.in(text_))) return unclear(fmt::format("{} is not a plain block number", written));
    add(static_cast<std::uint32_t>(e.value), digits);
  }

  // The last numbers of the statement with these values, in their order: what comes before is a condition.
  void digits(const std::vector<std::uint32_t>& numbers) {
    const text::Span span = program_.statements[index_].span;
    std::vector<text::Span> tokens;
    auto token =
        std::ranges::lower_bound(program_.tokens, span.begin, {}, [](const ir::Token& one) { return one.span.begin; });
    for (; token != program_.tokens.end() && token->span.begin < span.end; ++token)
      if (token->kind == TokenKind::number) tokens.push_back(token->span);
    for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
      const auto found = std::find_if(tokens.rbegin(), tokens.rend(),
                                      [&](text::Span one) { return text::parse_integer(one.in(text_)) == *number; });
      if (found == tokens.rend()) return unclear("its target is written in a form that is not known");
      add(*number, *found);
      tokens.erase(std::next(found).base(), tokens.end());
    }
  }

  void add(std::uint32_t number, text::Span span) {
    found_.known.push_back({.number = number, .statement = index_, .span = span});
  }
  void unclear(std::string why) { found_.unclear.push_back({.statement = index_, .why = std::move(why)}); }
  [[nodiscard]] bool has_number(std::uint32_t number) const { return std::ranges::binary_search(numbers_, number); }

  const ir::Program& program_;
  std::string_view text_;
  std::vector<std::uint32_t> numbers_;  // of all blocks, sorted
  std::uint32_t index_ = 0;
  BlockReferences found_;
};

// CYCLE95("N10:N50"), GOTO "N"<<R1: texts are made and read in many forms.
void find_texts(const ir::Program& program, BlockReferences& found) {
  const std::string_view text = program.source.text();
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    const ir::TokenRange range = program.statements[i].tokens;
    for (std::uint32_t t = range.first; t < range.last; ++t) {
      const ir::Token& token = program.tokens[t];
      if (token.kind != TokenKind::string || !names_block(token.span.in(text))) continue;
      found.unclear.push_back({.statement = i, .why = fmt::format("{} may name a block", token.span.in(text))});
    }
  }
}

}  // namespace

text::Span digits_of(std::string_view text, text::Span span) {
  while (!span.empty() && !is_digit(text[span.begin])) ++span.begin;
  return span;
}

BlockReferences block_references(const ir::Program& program) {
  BlockReferences found = Finder(program).find();
  if (std::ranges::any_of(program.labels, [](const ir::Label& one) { return one.number != ir::kNoIndex; }))
    find_texts(program, found);
  for (const ir::ForeignPart& part : program.foreign_parts)
    found.unclear.push_back({.statement = part.first, .why = "it is in the control's other language"});
  return found;
}

}  // namespace dripfeed::compile
