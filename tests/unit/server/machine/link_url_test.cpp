// Every scheme of a link, and every sentence about a wrong one.
#include "server/machine/link_url.h"

#include <array>

#include <gtest/gtest.h>

namespace dripfeed::machine {
namespace {

TEST(LinkUrl, ReadsASerialLineWithItsOptions) {
  const auto url = parse_link_url("serial:/dev/ttyS0?baud=9600&framing=7E2&flow=xonxoff");
  ASSERT_TRUE(url) << url.error();
  EXPECT_EQ(url->kind, LinkKind::serial);
  EXPECT_EQ(url->path, "/dev/ttyS0");
  EXPECT_EQ(url->options.at("baud"), "9600");
  EXPECT_EQ(url->options.at("framing"), "7E2");
  EXPECT_EQ(url->options.at("flow"), "xonxoff");
  EXPECT_EQ(url->options.size(), 3U);
  EXPECT_EQ(url->text, "serial:/dev/ttyS0?baud=9600&framing=7E2&flow=xonxoff");
}

TEST(LinkUrl, ReadsAPseudoTerminal) {
  const auto url = parse_link_url("pty:/tmp/lathe");
  ASSERT_TRUE(url) << url.error();
  EXPECT_EQ(url->kind, LinkKind::pty);
  EXPECT_EQ(url->path, "/tmp/lathe");
  EXPECT_TRUE(url->options.empty());
}

struct Address {
  std::string_view text;
  LinkKind kind;
  std::string_view host;
  std::uint16_t port;
  int unit;
};

TEST(LinkUrl, ReadsAddresses) {
  const std::array addresses = {
      Address{"tcp://10.0.0.7:4001", LinkKind::tcp, "10.0.0.7", 4001, 1},
      Address{"tcp://box.shop:1?unsent=2", LinkKind::tcp, "box.shop", 1, 1},
      Address{"tcp://[::1]:65535", LinkKind::tcp, "::1", 65535, 1},
      Address{"tcp-listen://:4001", LinkKind::tcp_listen, "", 4001, 1},
      Address{"tcp-listen://192.168.1.2:4001", LinkKind::tcp_listen, "192.168.1.2", 4001, 1},
      Address{"modbus-tcp://plc:502", LinkKind::modbus_tcp, "plc", 502, 1},
      Address{"modbus-tcp://plc:502/0", LinkKind::modbus_tcp, "plc", 502, 0},
      Address{"modbus-tcp://:1502/255", LinkKind::modbus_tcp, "", 1502, 255},
  };
  for (const Address& address : addresses) {
    const auto url = parse_link_url(address.text);
    ASSERT_TRUE(url) << url.error();
    EXPECT_EQ(url->kind, address.kind) << address.text;
    EXPECT_EQ(url->host, address.host) << address.text;
    EXPECT_EQ(url->port, address.port) << address.text;
    EXPECT_EQ(url->unit, address.unit) << address.text;
  }
}

struct Wrong {
  std::string_view text;
  std::string_view reported;  // in the sentence
};

TEST(LinkUrl, SaysWhatIsWrong) {
  const std::array wrongs = {
      Wrong{"", "\"\" is not a link"},
      Wrong{"ftp://host:21", "\"ftp://host:21\" is not a link: it must begin with serial:"},
      Wrong{"/dev/ttyS0", "is not a link"},
      Wrong{"SERIAL:/dev/ttyS0", "is not a link"},
      Wrong{"tcp:host:1", "\"tcp\" must be followed by //"},
      Wrong{"modbus-tcp:/plc:502", "must be followed by //"},
      Wrong{"serial:ttyS0", "\"ttyS0\" is not an absolute path"},
      Wrong{"pty:", "\"\" is not an absolute path"},
      Wrong{"tcp://host", "\"host\" has no port"},
      Wrong{"tcp://host:", "port \"\" is not 1..65535"},
      Wrong{"tcp://host:0", "port \"0\" is not 1..65535"},
      Wrong{"tcp://host:99999", "port \"99999\" is not 1..65535"},
      Wrong{"tcp://host:12x", "port \"12x\" is not 1..65535"},
      Wrong{"tcp://host:-1", "port \"-1\" is not 1..65535"},
      Wrong{"tcp://:4001", "there is no host"},
      Wrong{"tcp://host:1/2", "port \"1/2\" is not 1..65535"},
      Wrong{"modbus-tcp://plc:502/256", "unit \"256\" is not 0..255"},
      Wrong{"modbus-tcp://plc:502/", "unit \"\" is not 0..255"},
      Wrong{"serial:/dev/ttyS0?baud", "option \"baud\" has no value"},
      Wrong{"serial:/dev/ttyS0?baud=", "option \"baud\" has no value"},
      Wrong{"serial:/dev/ttyS0?=1", "unknown option \"\""},
      Wrong{"serial:/dev/ttyS0?speed=9600", "unknown option \"speed\"; known are baud, framing"},
      Wrong{"serial:/dev/ttyS0?baud=1&baud=2", "option \"baud\" is given twice"},
      Wrong{"serial:/dev/ttyS0?baud=1&&unsent=2", "option \"\" has no value"},
  };
  for (const Wrong& wrong : wrongs) {
    const auto url = parse_link_url(wrong.text);
    ASSERT_FALSE(url) << wrong.text;
    EXPECT_NE(url.error().find(wrong.reported), std::string::npos) << wrong.text << " gives: " << url.error();
  }
}

TEST(LinkUrl, OnlyRawSocketsAreBlind) {
  EXPECT_TRUE(is_blind(LinkKind::tcp));
  EXPECT_TRUE(is_blind(LinkKind::tcp_listen));
  EXPECT_FALSE(is_blind(LinkKind::serial));
  EXPECT_FALSE(is_blind(LinkKind::pty));
  EXPECT_FALSE(is_blind(LinkKind::modbus_tcp));
}

TEST(LinkUrl, EachKindHasItsScheme) {
  for (const LinkKind kind : {LinkKind::serial, LinkKind::tcp, LinkKind::tcp_listen, LinkKind::modbus_tcp,
                              LinkKind::modbus_rtu, LinkKind::pty}) {
    const std::string name(name_of(kind));
    const bool has_path = kind == LinkKind::serial || kind == LinkKind::pty || kind == LinkKind::modbus_rtu;
    const auto url = parse_link_url(name + (has_path ? ":/x" : "://h:1"));
    ASSERT_TRUE(url) << url.error();
    EXPECT_EQ(url->kind, kind);
  }
}

}  // namespace
}  // namespace dripfeed::machine
