// A comment ends at ';', '%' and the end of the line on one control or another, and a quote ends a message.
#include "dialects/family/text_value.h"

#include <algorithm>

#include <fmt/format.h>

namespace dripfeed::family {

std::string fault_of_text(std::string_view written) {
  static constexpr std::string_view kEnds = ";%\"";
  const auto may_not_stand = [](char c) { return c < ' ' || c > '~' || kEnds.contains(c); };
  const auto at = std::ranges::find_if(written, may_not_stand);
  if (at == written.end()) return {};
  const auto place = at - written.begin() + 1;
  if (*at < ' ' || *at > '~')
    return fmt::format("character {} of the text is not an ASCII letter, digit or sign", place);
  return fmt::format("character {} of the text, '{}', ends a comment or a message", place, *at);
}

}  // namespace dripfeed::family
