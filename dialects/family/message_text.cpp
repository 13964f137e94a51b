// Four decimals at most, as axis words have them.
#include "dialects/family/message_text.h"

#include "dialects/family/evaluate.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

std::string message_text(const Family& family, const Step& message, std::span<const double> values) {
  constexpr int kDecimals = 4;
  std::string out;
  std::uint32_t word = message.first_word;
  for (const char c : message.text) {
    if (c != kValueMark) {
      out += c;
      continue;
    }
    const double value = evaluate(family.arena, family.words[word++].value, values).value;
    text::append_word_number(out, value, kDecimals, true);
  }
  return out;
}

}  // namespace dripfeed::family
