// The table of RS-244. Source: the standard's track rule (channels 1 2 4 8, 5 = parity, 6 = O, 7 = X, 8 = EOB), checked
// for odd parity and uniqueness by the test; '(' and ')' as a Yasnac's holes 2-4-5 and 2-4-7.
#include "protocol/tape_code/eia.h"

#include <utility>

#include "protocol/tape_code/parity.h"

namespace dripfeed::tape_code {
namespace {

struct EiaRow {
  char character;
  std::uint8_t code;
};
// clang-format off
constexpr std::array kRows = {
    EiaRow{'0', 0x20}, EiaRow{'1', 0x01}, EiaRow{'2', 0x02}, EiaRow{'3', 0x13}, EiaRow{'4', 0x04}, EiaRow{'5', 0x15},
    EiaRow{'6', 0x16}, EiaRow{'7', 0x07}, EiaRow{'8', 0x08}, EiaRow{'9', 0x19},
    EiaRow{'A', 0x61}, EiaRow{'B', 0x62}, EiaRow{'C', 0x73}, EiaRow{'D', 0x64}, EiaRow{'E', 0x75}, EiaRow{'F', 0x76},
    EiaRow{'G', 0x67}, EiaRow{'H', 0x68}, EiaRow{'I', 0x79},
    EiaRow{'J', 0x51}, EiaRow{'K', 0x52}, EiaRow{'L', 0x43}, EiaRow{'M', 0x54}, EiaRow{'N', 0x45}, EiaRow{'O', 0x46},
    EiaRow{'P', 0x57}, EiaRow{'Q', 0x58}, EiaRow{'R', 0x49},
    EiaRow{'S', 0x32}, EiaRow{'T', 0x23}, EiaRow{'U', 0x34}, EiaRow{'V', 0x25}, EiaRow{'W', 0x26}, EiaRow{'X', 0x37},
    EiaRow{'Y', 0x38}, EiaRow{'Z', 0x29},
    EiaRow{'.', 0x6B}, EiaRow{',', 0x3B}, EiaRow{'/', 0x31}, EiaRow{'+', 0x70}, EiaRow{'-', 0x40}, EiaRow{'&', 0x0E},
    EiaRow{'(', 0x1A}, EiaRow{')', 0x4A}, EiaRow{' ', 0x10}, EiaRow{'\t', 0x3E},
    EiaRow{'\n', kEiaEob}, EiaRow{'%', kEiaEor},
};
// clang-format on

// Codes that are no character: DEL, back space, upper and lower case shift.
constexpr std::array<std::uint8_t, 4> kOthers = {kEiaDel, 0x2A, 0x7C, 0x7A};

constexpr std::array<std::pair<EiaFault, std::string_view>, 2> kMessages{{
    {EiaFault::parity, "the code of an EIA character has an odd number of holes"},
    {EiaFault::taken, "the code belongs to another EIA character"},
}};

bool is_standard(std::uint8_t code) {
  for (const EiaRow& row : kRows) {
    if (row.code == code) return true;
  }
  for (const std::uint8_t other : kOthers) {
    if (other == code) return true;
  }
  return false;
}

}  // namespace

std::optional<EiaRefusal> validate(const EiaSpecials& specials) {
  for (std::size_t i = 0; i < specials.codes.size(); ++i) {
    const std::uint8_t code = specials.codes[i];
    if (code == 0) continue;
    if (!odd_ones(code)) return EiaRefusal{.fault = EiaFault::parity, .character = kEiaSpecials[i]};
    bool taken = is_standard(code);
    for (std::size_t other = 0; other < i; ++other) taken = taken || specials.codes[other] == code;
    if (taken) return EiaRefusal{.fault = EiaFault::taken, .character = kEiaSpecials[i]};
  }
  return std::nullopt;
}

std::string_view message(EiaFault fault) {
  for (const auto& [key, text] : kMessages) {
    if (key == fault) return text;
  }
  return {};
}

std::uint8_t eia_code(char character, const EiaSpecials& specials) {
  for (const EiaRow& row : kRows) {
    if (row.character == character) return row.code;
  }
  const std::size_t special = kEiaSpecials.find(character);
  return special == std::string_view::npos ? std::uint8_t{0} : specials.codes[special];
}

}  // namespace dripfeed::tape_code
