// The answering side of Modbus for registers that are read only: a request PDU to its answer. Source: Modbus
// Application Protocol 1.1b3, section 6 (functions 3 and 4) and 7 (exceptions). Frames are mbap's work.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace dripfeed::modbus {

inline constexpr std::size_t kMaxPdu = 253;
inline constexpr std::size_t kMaxReadRegisters = 125;

enum class Exception : std::uint8_t {
  function = 1,  // not a function of this server; writing is none
  address = 2,   // a register that is not there
  value = 3,     // a quantity or a length that cannot be
  target = 0x0B  // no such unit at this address
};

// What is shown. Called on the server's thread; must not block for long. Registers may change between two calls, never
// within one.
class RegisterView {
 public:
  virtual ~RegisterView() = default;
  virtual bool has_unit(std::uint8_t unit) = 0;
  // Fills `into` with the unit's registers from `first` on; false where one of them is not there.
  virtual bool read(std::uint8_t unit, std::uint16_t first, std::span<std::uint16_t> into) = 0;
};

using Pdu = std::array<std::uint8_t, kMaxPdu>;

// Writes the answer and says how long it is. request: 1 to kMaxPdu bytes. Input and holding registers are the same.
std::size_t answer(std::uint8_t unit, std::span<const std::uint8_t> request, RegisterView& view, Pdu& out);

}  // namespace dripfeed::modbus
