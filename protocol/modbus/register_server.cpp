// Requests to answers. Checks go in the order of the standard: function, then quantity, then address.
#include "protocol/modbus/register_server.h"

namespace dripfeed::modbus {
namespace {

constexpr std::uint8_t kReadHolding = 3;
constexpr std::uint8_t kReadInput = 4;
constexpr std::uint8_t kExceptionBit = 0x80;
constexpr std::size_t kReadRequest = 5;  // function, first register, quantity
constexpr std::size_t kReadHead = 2;     // function, byte count

std::size_t refuse(std::uint8_t function, Exception exception, Pdu& out) {
  out[0] = static_cast<std::uint8_t>(function | kExceptionBit);
  out[1] = static_cast<std::uint8_t>(exception);
  return 2;
}

std::uint16_t word_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] * 256U + bytes[at + 1]);
}

}  // namespace

std::size_t answer(std::uint8_t unit, std::span<const std::uint8_t> request, RegisterView& view, Pdu& out) {
  const std::uint8_t function = request.front();
  if (!view.has_unit(unit)) return refuse(function, Exception::target, out);
  if (function != kReadHolding && function != kReadInput) return refuse(function, Exception::function, out);
  if (request.size() != kReadRequest) return refuse(function, Exception::value, out);
  const std::uint16_t first = word_at(request, 1);
  const std::uint16_t quantity = word_at(request, 3);
  if (quantity == 0 || quantity > kMaxReadRegisters) return refuse(function, Exception::value, out);
  std::array<std::uint16_t, kMaxReadRegisters> registers{};
  const auto wanted = std::span(registers).first(quantity);
  const bool beyond = std::size_t{first} + quantity > 0x10000;
  if (beyond || !view.read(unit, first, wanted)) return refuse(function, Exception::address, out);
  out[0] = function;
  out[1] = static_cast<std::uint8_t>(quantity * 2U);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    out[kReadHead + 2 * i] = static_cast<std::uint8_t>(wanted[i] >> 8U);
    out[kReadHead + 2 * i + 1] = static_cast<std::uint8_t>(wanted[i] & 0xFFU);
  }
  return kReadHead + wanted.size() * 2;
}

}  // namespace dripfeed::modbus
