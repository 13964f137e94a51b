// Sums by addition and exclusive or, the CRC by a table made at compile time.
#include "protocol/packet/check_sums.h"

#include <array>

namespace dripfeed::packet {
namespace {

constexpr std::uint16_t kPolynomial = 0x1021;

constexpr std::array<std::uint16_t, 256> make_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned crc = byte << 8U;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000U) != 0 ? (crc << 1U) ^ kPolynomial : crc << 1U;
    table[byte] = static_cast<std::uint16_t>(crc);
  }
  return table;
}
constexpr std::array<std::uint16_t, 256> kTable = make_table();

}  // namespace

std::uint8_t sum8(std::span<const std::byte> bytes) {
  unsigned sum = 0;
  for (const std::byte byte : bytes) sum += static_cast<unsigned>(byte);
  return static_cast<std::uint8_t>(sum);
}

std::uint16_t crc16(std::span<const std::byte> bytes) {
  unsigned crc = 0;
  for (const std::byte byte : bytes) crc = (crc << 8U & 0xFFFFU) ^ kTable[crc >> 8U ^ static_cast<unsigned>(byte)];
  return static_cast<std::uint16_t>(crc);
}

std::uint8_t xor8(std::span<const std::byte> bytes) {
  unsigned all = 0;
  for (const std::byte byte : bytes) all ^= static_cast<unsigned>(byte);
  return static_cast<std::uint8_t>(all);
}

}  // namespace dripfeed::packet
