// EIA RS-244 as data: the code of each character, and the few characters that the standard has no code for. Every code
// has an odd number of holes, so parity lies in the byte and a line carries 8 bits without parity (8N1, 8N2). Streams
// are wire_encoder's and wire_decoder's work.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace dripfeed::tape_code {

inline constexpr std::uint8_t kEiaEob = 0x80;  // "CR" of the standard: only channel 8
inline constexpr std::uint8_t kEiaEor = 0x0B;  // "ER", the '%' of ISO
inline constexpr std::uint8_t kEiaDel = 0x7F;  // all channels but 8
inline constexpr std::uint8_t kEiaBlank = 0x00;

// Codes of the characters that RS-244 does not have, one for each of kEiaSpecials; 0: the control takes none. On a
// Fanuc they are parameters: 6010 '*', 6011 '=', 6012 '#', 6013 '[', 6014 ']' (up to 6018, by series: look at the
// machine).
inline constexpr std::string_view kEiaSpecials = "[]#*=:";
struct EiaSpecials {
  std::array<std::uint8_t, kEiaSpecials.size()> codes{};
  friend constexpr bool operator==(const EiaSpecials&, const EiaSpecials&) = default;
};

enum class EiaFault : std::uint8_t {
  parity,  // the code has an even number of holes
  taken,   // the code is another character's
};
// What is wrong with the table and with which character, if anything.
struct EiaRefusal {
  EiaFault fault = EiaFault::parity;
  char character = 0;
};
std::optional<EiaRefusal> validate(const EiaSpecials& specials);
std::string_view message(EiaFault fault);

// The code of a character (LF is the EOB, '%' the EOR); 0 where EIA and the specials have none.
std::uint8_t eia_code(char character, const EiaSpecials& specials);

}  // namespace dripfeed::tape_code
