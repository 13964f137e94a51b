// A statement that is not in the table below has a meaning of its own in the program where it stands.
#include "dialects/compile/translate/called_body.h"

#include <algorithm>
#include <string_view>

#include "dialects/ir/sections.h"
#include "dialects/optimize/accesses.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;
using ir::TokenKind;

// Why a statement of that kind binds its program's text; empty where it does not.
std::string_view binding(StatementKind kind) {
  switch (kind) {
    case StatementKind::go_to: return "it jumps";
    case StatementKind::return_to: return "it returns to a block that it names";
    case StatementKind::subprogram_return: return "it returns before its last block";
    case StatementKind::program_end: return "it ends the program";
    case StatementKind::define: return "it defines variables of its own";
    case StatementKind::declaration: return "it declares programs or data";
    case StatementKind::procedure: return "it has two heads";
    case StatementKind::modal_call:
    case StatementKind::modal_call_end: return "it has a modal call";
    default: return {};
  }
}

class BodyReading {
 public:
  BodyReading(const ir::Program& text, const ir::Section& range) : text_(text), range_(range) { out_.text = &text; }

  std::expected<CalledBody, std::string> take() {
    for (const auto step : {&BodyReading::take_head, &BodyReading::take_return, &BodyReading::look_at_statements,
                            &BodyReading::take_lines})
      if (std::string why = (this->*step)(); !why.empty()) return std::unexpected(std::move(why));
    return out_;
  }

 private:
  [[nodiscard]] const ir::Statement& at(std::uint32_t i) const { return text_.statements[i]; }
  [[nodiscard]] bool is_empty(std::uint32_t i) const { return at(i).kind == StatementKind::empty; }

  std::string take_head() {
    out_.first = range_.first;
    while (out_.first < range_.last && is_empty(out_.first)) ++out_.first;
    if (out_.first == range_.last) return "it has no blocks";
    if (at(out_.first).kind != StatementKind::procedure) return {};
    const ir::Statement& head = at(out_.first);
    const ir::Structure& procedure = text_.structures[head.payload];
    if (procedure.symbol_count > 0) return "it takes arguments";
    if (procedure.saves_modal) return "it restores the modes of its caller";
    std::uint32_t names = 0;
    for (std::uint32_t t = head.tokens.first; t < head.tokens.last; ++t)
      names += text_.tokens[t].kind == TokenKind::name ? 1U : 0U;
    if (names > 2) return "its head states how it is run";
    ++out_.first;
    while (out_.first < range_.last && is_empty(out_.first)) ++out_.first;
    return {};
  }

  std::string take_return() {
    std::uint32_t end = range_.last;
    while (end > out_.first && is_empty(end - 1)) --end;
    if (end == out_.first) return "it has no blocks";
    out_.last = end - 1;
    if (at(out_.last).kind == StatementKind::return_to) return std::string(binding(StatementKind::return_to));
    if (at(out_.last).kind != StatementKind::subprogram_return) {
      for (std::uint32_t i = out_.first; i < end; ++i)
        if (ir::returns(at(i).kind)) return "it does not end at its only return";
      return "it does not return";
    }
    return at(out_.last).skip_level == 0 ? "" : "block skip may leave its return out";
  }

  std::string look_at_statements() {
    for (std::uint32_t i = out_.first; i < out_.last; ++i) {
      if (const std::string_view why = binding(at(i).kind); !why.empty()) return std::string(why);
      const bool is_loop = at(i).kind == StatementKind::while_begin || at(i).kind == StatementKind::loop_begin;
      if (is_loop && text_.structures[at(i).payload].loop_number != 0) out_.has_loop_numbers = true;
    }
    for (const ir::Label& label : text_.labels)
      if (label.statement >= out_.first && label.statement <= out_.last && label.name != ir::StringId::none)
        return "it has labels";
    const std::string found = optimize::obstacle(text_, out_.first, out_.last);
    return found.empty() ? found : "it has " + found;
  }

  std::string take_lines() {
    const std::uint32_t return_line = at(out_.last).line;
    out_.first_line = at(out_.first).line;
    if (out_.first > 0 && at(out_.first - 1).line == out_.first_line)
      return "its first block stands in the line of its head";
    if (out_.last + std::size_t{1} < text_.statements.size() && at(out_.last + 1).line == return_line)
      return "another block stands in the line of its return";
    const bool shares = out_.last > out_.first && at(out_.last - 1).line == return_line && !is_empty(out_.last - 1);
    const text::Span words = at(out_.last).span;
    for (std::uint32_t i = out_.first; shares && i < out_.last; ++i)
      if (at(i).line == return_line && at(i).span.begin < words.end && words.begin < at(i).span.end)
        if (!is_apart(at(i), words)) return "its return stands among other words";
    out_.last_line = shares ? return_line : return_line - 1;
    if (shares) out_.return_words = words;
    out_.returns_by_code = starts_with_address(words) && !(shares && moves(out_.last - 1));
    for (std::uint32_t i = out_.first; i < out_.last; ++i)
      if (!is_empty(i) && (i == out_.first || at(i).line != at(i - 1).line)) ++out_.blocks;
    return {};
  }

  // A block's span may reach over the return; its words must not.
  [[nodiscard]] bool is_apart(const ir::Statement& s, text::Span words) const {
    if (s.kind != StatementKind::block) return false;
    const auto meets = [&](const auto& part) { return part.span.begin < words.end && words.begin < part.span.end; };
    const ir::Block& block = text_.blocks[s.payload];
    return std::ranges::none_of(text_.codes_of(block), meets) && std::ranges::none_of(text_.words_of(block), meets);
  }

  [[nodiscard]] bool starts_with_address(text::Span words) const {
    const auto token =
        std::ranges::lower_bound(text_.tokens, words.begin, {}, [](const ir::Token& t) { return t.span.begin; });
    return token != text_.tokens.end() && token->kind == TokenKind::address;
  }

  [[nodiscard]] bool moves(std::uint32_t i) const {
    if (at(i).kind != StatementKind::block) return false;
    const auto words = text_.words_of(text_.blocks[at(i).payload]);
    return std::ranges::any_of(words, [](const ir::Word& w) { return ir::is_axis(w.address); });
  }

  const ir::Program& text_;
  const ir::Section& range_;
  CalledBody out_;
};

}  // namespace

std::expected<CalledBody, std::string> called_body(const ir::Program& text, const ir::Section& range) {
  return BodyReading(text, range).take();
}

}  // namespace dripfeed::compile
