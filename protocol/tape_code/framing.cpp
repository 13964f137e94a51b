// Reading and writing of framings as "7E2".
#include "protocol/tape_code/framing.h"

#include <array>
#include <utility>

namespace dripfeed::tape_code {
namespace {

constexpr std::array<std::pair<FramingError, std::string_view>, 4> kMessages{{
    {FramingError::length, "a framing has three characters, as 7E2"},
    {FramingError::data_bits, "a framing begins with 7 or 8 data bits"},
    {FramingError::parity, "the parity of a framing is N, E or O"},
    {FramingError::stop_bits, "a framing ends with 1 or 2 stop bits"},
}};

}  // namespace

std::expected<Framing, FramingError> parse_framing(std::string_view text) {
  if (text.size() != 3) return std::unexpected(FramingError::length);
  Framing framing;
  if (text[0] != '7' && text[0] != '8') return std::unexpected(FramingError::data_bits);
  framing.data_bits = text[0] - '0';
  switch (text[1]) {
    case 'N':
    case 'n': framing.parity = Parity::none; break;
    case 'E':
    case 'e': framing.parity = Parity::even; break;
    case 'O':
    case 'o': framing.parity = Parity::odd; break;
    default: return std::unexpected(FramingError::parity);
  }
  if (text[2] != '1' && text[2] != '2') return std::unexpected(FramingError::stop_bits);
  framing.stop_bits = text[2] - '0';
  return framing;
}

std::string format_framing(const Framing& framing) {
  constexpr std::array<char, 3> kLetters{'N', 'E', 'O'};
  std::string text;
  text += static_cast<char>('0' + framing.data_bits);
  text += kLetters[static_cast<std::size_t>(framing.parity)];
  text += static_cast<char>('0' + framing.stop_bits);
  return text;
}

std::string_view message(FramingError error) {
  for (const auto& [key, text] : kMessages) {
    if (key == error) return text;
  }
  return {};
}

}  // namespace dripfeed::tape_code
