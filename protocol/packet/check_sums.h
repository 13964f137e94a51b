// The check sums of the packet protocols.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace dripfeed::packet {

// Low 8 bits of the sum of the bytes: XMODEM, remote buffer.
std::uint8_t sum8(std::span<const std::byte> bytes);
// CRC-16/XMODEM: polynomial 1021, begins with 0, nothing reflected; "123456789" gives 31C3.
std::uint16_t crc16(std::span<const std::byte> bytes);
// Exclusive or of the bytes: 3964R.
std::uint8_t xor8(std::span<const std::byte> bytes);

}  // namespace dripfeed::packet
