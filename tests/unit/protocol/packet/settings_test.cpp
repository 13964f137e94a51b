// Check sums against published values; settings that cannot be kept; names there and back.
#include "protocol/packet/settings.h"

#include <string_view>

#include <gtest/gtest.h>

#include "protocol/packet/check_sums.h"

namespace dripfeed::packet {
namespace {

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

TEST(CheckSums, AreThoseOfThePublications) {
  EXPECT_EQ(crc16(bytes("123456789")), 0x31C3);  // the catalogue's check value of CRC-16/XMODEM
  EXPECT_EQ(crc16({}), 0);
  EXPECT_EQ(sum8(bytes("SYN\x03")), 0xFD);  // B-63322EN: FD SYN ETX
  EXPECT_EQ(sum8(bytes("RDY\x03")), 0xF2);
  // 3964R: 47 30 58 31 10 10 5A 10 03 gives 57.
  EXPECT_EQ(xor8(bytes(std::string_view("\x47\x30\x58\x31\x10\x10\x5A\x10\x03", 9))), 0x57);
}

TEST(PacketSettings, NamesLeadBack) {
  for (std::size_t i = 0; i < kProtocols; ++i) {
    const auto protocol = static_cast<Protocol>(i);
    EXPECT_EQ(parse_protocol(name(protocol)), protocol);
  }
  EXPECT_FALSE(parse_protocol("XMODEM"));
  EXPECT_FALSE(parse_protocol("kermit"));
}

TEST(PacketSettings, WhatCannotBeKeptIsRefused) {
  EXPECT_TRUE(validate({}));
  EXPECT_EQ(validate({.payload = 0}).error(), SettingsFault::payload);
  EXPECT_EQ(validate({.payload = kMaxPayload + 1}).error(), SettingsFault::payload);
  EXPECT_EQ(validate({.char_time = Time(0)}).error(), SettingsFault::char_time);
  Settings settings{.protocol = Protocol::remote_buffer_a, .end_is_cr = true};
  EXPECT_TRUE(validate(settings));
  settings.wire.eob = tape_code::Eob::cr_lf;
  EXPECT_EQ(validate(settings).error(), SettingsFault::end_inside);
  EXPECT_FALSE(message(SettingsFault::end_inside).empty());
}

}  // namespace
}  // namespace dripfeed::packet
