// Four decimals at most, as axis words have them.
#include "dialects/family/message_text.h"

#include "dialects/family/evaluate.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

std::string message_text(const BoundFamily& bound, const Step& message) {
  const ir::Program& arena = bound.family->arena;
  constexpr int kDecimals = 4;
  std::string out;
  std::uint32_t word = message.first_word;
  for (const char c : message.text) {
    if (c != kValueMark) {
      out += c;
      continue;
    }
    const ir::ExpressionId value = bound.family->words[word++].value;
    const ir::Expression& e = arena.at(value);
    const auto name =
        e.op == ir::Operator::variable ? bound.texts.find(arena.at(e.variable).symbol) : bound.texts.end();
    if (name != bound.texts.end())
      out += name->second;
    else
      text::append_word_number(out, evaluate(arena, value, bound.values).value, kDecimals, true);
  }
  return out;
}

}  // namespace dripfeed::family
