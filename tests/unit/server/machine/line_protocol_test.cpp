// What a line speaks, by name, by URL and by profile; what cannot be together.
#include "server/machine/line_protocol.h"

#include <string>

#include <gtest/gtest.h>

#include "server/machine/profile.h"

namespace dripfeed::machine {
namespace {

LineSettings line_of(const std::string& url) {
  LineSettings line;
  line.link = parse_link_url(url).value();
  return line;
}

TEST(LineProtocol, NamesLeadBack) {
  for (const std::string_view name : line_protocol_names()) {
    const auto protocol = parse_line_protocol(name);
    ASSERT_TRUE(protocol) << name;
    EXPECT_EQ(name_of(*protocol), name);
    const auto packets = packet_protocol_of(*protocol);
    if (packets) {
      EXPECT_EQ(packet::name(*packets), name);
    }
  }
  EXPECT_FALSE(parse_line_protocol("kermit"));
  EXPECT_FALSE(packet_protocol_of(LineProtocol::dc_codes));
  EXPECT_FALSE(packet_protocol_of(LineProtocol::remote_buffer_b));
}

TEST(LineProtocol, AUrlBringsEightBitsAndPlainAsciiAlong) {
  const auto line = effective_line(line_of("pty:/x?protocol=xmodem-1k&baud=19200&answer_s=30"));
  ASSERT_TRUE(line) << line.error();
  EXPECT_EQ(line->protocol, LineProtocol::xmodem_1k);
  EXPECT_EQ(tape_code::format_framing(line->framing), "8N1");
  const auto settings = packet_settings_of(*line);
  ASSERT_TRUE(settings) << settings.error();
  EXPECT_EQ(settings->protocol, packet::Protocol::xmodem_1k);
  EXPECT_EQ(settings->wire.eighth_bit, tape_code::EighthBit::data);
  EXPECT_EQ(settings->char_time.count(), 520'834);  // 10 bits at 19200, rounded up
  EXPECT_EQ(settings->answer_patience, std::chrono::seconds(30));
}

TEST(LineProtocol, AUrlMaySayOtherwise) {
  const auto line = line_of("pty:/x?protocol=3964r&framing=8N2&code=iso&payload=64&counted=yes");
  const auto settings = packet_settings_of(line);
  ASSERT_TRUE(settings) << settings.error();
  EXPECT_EQ(settings->wire.eighth_bit, tape_code::EighthBit::even);
  EXPECT_EQ(settings->payload, 64U);
  EXPECT_TRUE(settings->counted);
  EXPECT_FALSE(settings->answer_patience);
}

TEST(LineProtocol, OnlyYmodemStatesAName) {
  EXPECT_TRUE(sends_name(line_of("pty:/x?protocol=ymodem")));
  EXPECT_FALSE(sends_name(line_of("pty:/x?protocol=xmodem-1k")));
  EXPECT_FALSE(sends_name(line_of("dir:/x")));
  LineSettings by_profile = line_of("pty:/x");
  by_profile.protocol = LineProtocol::ymodem;
  EXPECT_TRUE(sends_name(by_profile));
}

TEST(LineProtocol, WhatCannotBeIsASentence) {
  struct Wrong {
    const char* options;
    const char* word;
  };
  for (const Wrong& wrong :
       {Wrong{"protocol=xmodem&framing=7E2", "8 data bits"}, Wrong{"protocol=xmodem&framing=8E1", "8 data bits"},
        Wrong{"protocol=xmodem&flow=xonxoff", "XON"}, Wrong{"protocol=kermit", "xmodem-crc"},
        Wrong{"protocol=3964r&payload=0", "1024"}, Wrong{"protocol=3964r&counted=2", "yes"},
        Wrong{"protocol=xmodem&answer_s=long", "answer_s"}}) {
    const auto settings = packet_settings_of(line_of(std::string("pty:/x?") + wrong.options));
    ASSERT_FALSE(settings) << wrong.options;
    EXPECT_NE(settings.error().find(wrong.word), std::string::npos) << settings.error();
  }
}

}  // namespace
}  // namespace dripfeed::machine
