// The options of register buses: what is taken, and what is refused before a library makes something else of it.
#include "server/machine/bus_settings.h"

#include <gtest/gtest.h>

namespace dripfeed::machine {
namespace {

std::expected<BusSettings, std::string> settings_of(const std::string& text) {
  const auto url = parse_link_url(text);
  EXPECT_TRUE(url) << (url ? "" : url.error());
  return bus_settings_of(url.value_or(LinkUrl{}));
}

TEST(BusSettings, RtuHasTheStandardsDefaults) {
  const auto plain = settings_of("modbus-rtu:/dev/ttyS1");
  ASSERT_TRUE(plain) << plain.error();
  EXPECT_EQ(plain->baud, 19200U);
  EXPECT_EQ(tape_code::format_framing(plain->framing), "8E1");
  EXPECT_EQ(plain->unit, 1);
  EXPECT_EQ(plain->timeout_ms, 1000U);
  const auto full = settings_of("modbus-rtu:/dev/ttyS1?baud=9600&framing=8N2&unit=17&timeout_ms=250");
  ASSERT_TRUE(full) << full.error();
  EXPECT_EQ(full->baud, 9600U);
  EXPECT_EQ(tape_code::format_framing(full->framing), "8N2");
  EXPECT_EQ(full->unit, 17);
  EXPECT_EQ(full->timeout_ms, 250U);
  const auto tcp = settings_of("modbus-tcp://plc:502/9?timeout_ms=2000");
  ASSERT_TRUE(tcp) << tcp.error();
  EXPECT_EQ(tcp->unit, 9);
  EXPECT_EQ(tcp->timeout_ms, 2000U);
}

TEST(BusSettings, AWrongOneIsNamed) {
  for (const std::string wrong : {"baud=12345", "baud=86400", "baud=x", "framing=7E1", "framing=8X1", "unit=0",
                                  "unit=248", "timeout_ms=0", "timeout_ms=-1", "timeout_ms=600000"}) {
    const auto settings = settings_of("modbus-rtu:/dev/ttyS1?" + wrong);
    ASSERT_FALSE(settings) << wrong;
    EXPECT_NE(settings.error().find(wrong.substr(0, wrong.find('='))), std::string::npos) << settings.error();
  }
}

TEST(BusSettings, OnlyRegistersAreABus) {
  EXPECT_TRUE(is_modbus(LinkKind::modbus_rtu));
  EXPECT_TRUE(is_modbus(LinkKind::modbus_tcp));
  EXPECT_FALSE(is_modbus(LinkKind::serial));
}

}  // namespace
}  // namespace dripfeed::machine
