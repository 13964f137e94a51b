// A line's claim and its record: what survives whoever held it, two names of one line, a device that was changed, and a
// record that a power failure broke.
#include "server/io/line_claim.h"

#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include "server/io/line_record.h"
#include "server/io/serial_identity.h"

namespace dripfeed::io {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class LineClaim : public ::testing::Test {
 protected:
  LineClaim() {
    std::string name = (fs::temp_directory_path() / "dripfeed-claim-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    fs::create_directory(folder_ / "lines");
  }
  ~LineClaim() override { fs::remove_all(folder_); }

  [[nodiscard]] auto claim(const std::string& url) const {
    return claim_line_in(folder_ / "lines", machine::parse_link_url(url).value(), (folder_ / "sys").string());
  }
  // A USB adapter as sysfs shows it, plugged in as `tty`.
  void plug_in(const std::string& tty, const std::string& serial) const {
    const fs::path usb = folder_ / "sys/devices/usb1/1-1" / serial;
    const fs::path port = usb / "1-1:1.0" / tty;
    fs::create_directories(port);
    fs::create_directories(folder_ / "sys/class/tty" / tty);
    std::ofstream(usb / "idVendor") << "0403\n";
    std::ofstream(usb / "idProduct") << "6001\n";
    if (serial != "none") std::ofstream(usb / "serial") << serial << "\n";
    std::ofstream(usb / "1-1:1.0" / "bInterfaceNumber") << "00\n";
    std::ofstream(port / "port_number") << "0\n";
    fs::remove(folder_ / "sys/class/tty" / tty / "device");
    fs::create_directory_symlink(port, folder_ / "sys/class/tty" / tty / "device");
    fs::create_directory(folder_ / "dev");
    std::ofstream(folder_ / "dev" / tty) << "";
  }
  [[nodiscard]] std::string port(const std::string& name) const {
    return "serial:" + (folder_ / "dev" / name).string();
  }

  fs::path folder_;
};

TEST_F(LineClaim, EndsWithoutATrace) {
  auto claimed = claim("tcp://10.0.0.7:4001");
  ASSERT_TRUE(claimed) << claimed.error();
  EXPECT_EQ((*claimed)->torn(), "");
  EXPECT_TRUE((*claimed)->begin("job 1"));
  EXPECT_TRUE((*claimed)->end());
  claimed->reset();
  EXPECT_EQ(claim("tcp://10.0.0.7:4001").value()->torn(), "");
}

TEST_F(LineClaim, WhatWasSendingWhenItsHolderWentIsTorn) {
  {
    const auto claimed = claim("tcp://10.0.0.7:4001").value();
    ASSERT_TRUE(claimed->begin("job 12"));
  }
  const auto again = claim("rfc2217://10.0.0.7:4001?baud=9600").value();  // the same port of the same device server
  EXPECT_THAT(again->torn(), HasSubstr("job 12"));
  EXPECT_THAT(again->torn(), HasSubstr("ended without a report of how"));
  const auto refused = again->begin("job 13");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), again->torn());
  EXPECT_TRUE(again->end()) << "an end of what never began";
  EXPECT_NE(again->torn(), "");
}

TEST_F(LineClaim, ATornLineStaysTornUntilAPersonGivesAReason) {
  {
    const auto claimed = claim("tcp://10.0.0.7:4001").value();
    ASSERT_TRUE(claimed->begin("job 12"));
    ASSERT_TRUE(claimed->tear("peer gone"));
    EXPECT_THAT(claimed->torn(), HasSubstr("broke off inside a block: peer gone"));
    EXPECT_TRUE(claimed->end());
  }
  auto again = claim("tcp://10.0.0.7:4001").value();
  EXPECT_THAT(again->torn(), HasSubstr("broke off inside a block: peer gone"));
  EXPECT_FALSE(again->confirm_reset("  "));
  EXPECT_FALSE(again->begin("job 13"));
  EXPECT_TRUE(again->confirm_reset("RESET pressed, slide clear"));
  EXPECT_EQ(again->torn(), "");
  EXPECT_TRUE(again->begin("job 13"));
  EXPECT_FALSE(again->confirm_reset("while it sends"));
  EXPECT_TRUE(again->end());
  again.reset();
  EXPECT_EQ(claim("tcp://10.0.0.7:4001").value()->torn(), "");
}

TEST_F(LineClaim, TheSecondLearnsWhoHasTheLine) {
  const auto first = claim("modbus-tcp://PLC:502/1").value();
  const auto second = claim("modbus-tcp://plc:502/1");
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error(), HasSubstr(fmt::format("(pid {})", ::getpid())));
  EXPECT_THAT(second.error(), HasSubstr(", since 2"));
  EXPECT_TRUE(claim("modbus-tcp://plc:502/2")) << "another unit is another line";
}

TEST_F(LineClaim, APortIsOneLineUnderEachOfItsNames) {
  plug_in("ttyUSB0", "none");
  fs::create_symlink(folder_ / "dev/ttyUSB0", folder_ / "dev/by-id");
  const auto first = claim(port("by-id")).value();
  EXPECT_FALSE(claim(port("ttyUSB0")));
  ASSERT_TRUE(first->begin("job 1"));
  ASSERT_TRUE(first->tear("unplugged"));
}

TEST_F(LineClaim, ATornPortIsTornWhereverItIsPluggedInAgain) {
  plug_in("ttyUSB0", "A1");
  {
    const auto first = claim(port("ttyUSB0")).value();
    ASSERT_TRUE(first->begin("job 1"));
    ASSERT_TRUE(first->tear("unplugged"));
  }
  plug_in("ttyUSB1", "A1");
  EXPECT_THAT(claim(port("ttyUSB1")).value()->torn(), HasSubstr("unplugged"));
  // Without a serial number its by-id name is what stays.
  plug_in("ttyUSB2", "none");
  fs::create_symlink(folder_ / "dev/ttyUSB2", folder_ / "dev/by-id");
  {
    const auto first = claim(port("by-id")).value();
    ASSERT_TRUE(first->begin("job 1"));
    ASSERT_TRUE(first->tear("unplugged"));
  }
  plug_in("ttyUSB3", "none");
  fs::remove(folder_ / "dev/by-id");
  fs::create_symlink(folder_ / "dev/ttyUSB3", folder_ / "dev/by-id");
  EXPECT_THAT(claim(port("by-id")).value()->torn(), HasSubstr("unplugged"));
}

TEST_F(LineClaim, AnotherDeviceAtAPortIsRefusedUntilAPersonConfirms) {
  plug_in("ttyUSB0", "A1");
  {
    const auto first = claim(port("ttyUSB0")).value();
    ASSERT_TRUE(first->begin("job 1"));
    ASSERT_TRUE(first->end());
  }
  plug_in("ttyUSB0", "B2");
  const auto second = claim(port("ttyUSB0")).value();
  EXPECT_THAT(second->torn(), HasSubstr("another device is at this port: was USB 0403:6001, serial number A1"));
  EXPECT_THAT(second->torn(), HasSubstr("is USB 0403:6001, serial number B2"));
  EXPECT_FALSE(second->begin("job 2"));
  EXPECT_TRUE(second->confirm_reset("the adapter was replaced"));
  EXPECT_TRUE(second->begin("job 2"));
  EXPECT_TRUE(second->end());
}

TEST_F(LineClaim, ADeviceThatChangesBetweenTwoTransfersIsSeenBeforeTheSecond) {
  plug_in("ttyUSB0", "A1");
  const auto line = claim(port("ttyUSB0")).value();
  ASSERT_TRUE(line->begin("job 1"));
  ASSERT_TRUE(line->end());
  plug_in("ttyUSB0", "B2");
  EXPECT_FALSE(line->begin("job 2"));
  EXPECT_THAT(line->torn(), HasSubstr("another device"));
}

TEST_F(LineClaim, ADeviceThatIsPluggedInLaterAndTornIsSeenBeforeTheFirstByte) {
  plug_in("ttyUSB0", "A1");
  {
    const auto first = claim(port("ttyUSB0")).value();
    ASSERT_TRUE(first->begin("job 1"));
  }
  const auto absent = claim(port("ttyUSB5")).value();
  EXPECT_EQ(absent->torn(), "");
  plug_in("ttyUSB5", "A1");
  EXPECT_FALSE(absent->begin("job 2"));
  EXPECT_THAT(absent->torn(), HasSubstr("job 1"));
}

TEST_F(LineClaim, APseudoTerminalIsItsPathNotItsNumber) {
  const LineNames names = names_of(machine::parse_link_url("pty:/tmp/x/../lathe.tty").value());
  EXPECT_EQ(names.names, std::vector<std::string>{"serial:/tmp/lathe.tty"});
}

TEST_F(LineClaim, AnAdaptersLastingNameIsTheOneOfItsSerialNumber) {
  plug_in("ttyUSB0", "A1");
  plug_in("ttyUSB1", "B2");
  const fs::path by_id = folder_ / "by-id";
  fs::create_directory(by_id);
  fs::create_symlink("../dev/ttyUSB1", by_id / "usb-B2");
  fs::create_symlink("../dev/gone", by_id / "usb-gone");
  fs::create_symlink("../dev/ttyUSB0", by_id / "usb-A1");
  const auto lasting = [&](const fs::path& path) { return lasting_name(path.string(), by_id.string()); };
  EXPECT_EQ(lasting(folder_ / "dev/ttyUSB0"), (by_id / "usb-A1").string());
  EXPECT_EQ(lasting(folder_ / "dev/ttyUSB1"), (by_id / "usb-B2").string());
  EXPECT_EQ(lasting(by_id / "usb-A1"), "");
  EXPECT_EQ(lasting(folder_ / "dev/ttyUSB7"), "");
  EXPECT_EQ(lasting_name((folder_ / "dev/ttyUSB0").string(), (folder_ / "none").string()), "");
}

// Each byte of both slots in turn: what was acknowledged stays, or nothing is known and the line counts as torn. Never
// an older state that lets more out.
TEST_F(LineClaim, ADamagedRecordNeverClearsALine) {
  const std::string path = (folder_ / "record").string();
  {
    auto file = RecordFile::open(path).value();
    ASSERT_TRUE(file.write({.state = RecordState::clean, .what = "job 1"}));
    ASSERT_TRUE(file.write({.state = RecordState::sending, .what = "job 2"}));
  }
  std::ifstream in(path, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  ASSERT_EQ(whole.size(), 8192U);
  const auto state_with = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    return RecordFile::open(path).value().record().state;
  };
  EXPECT_EQ(state_with(whole), RecordState::sending);
  // The slot of the older change says nothing any more, and its damage is none.
  std::string broken = whole;
  broken[4096 + 40] ^= 1;
  EXPECT_EQ(state_with(broken), RecordState::sending);
  for (std::size_t at = 0; at < 1024; at += 7) {
    std::string both = broken;
    both[at] ^= 1;
    EXPECT_EQ(state_with(both), RecordState::torn) << at;
  }
  EXPECT_EQ(state_with(whole.substr(0, 100)), RecordState::torn);
}

// A power failure inside a write leaves the slot broken and the other one as it was: the change was not acknowledged.
TEST_F(LineClaim, AWriteThatDidNotFinishLeavesWhatWasBefore) {
  const std::string path = (folder_ / "record").string();
  {
    auto file = RecordFile::open(path).value();
    ASSERT_TRUE(file.write({.state = RecordState::sending, .what = "job 2"}));
    ASSERT_TRUE(file.write({.state = RecordState::clean, .what = "job 2"}));
  }
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(500);
  file << "x";
  file.close();
  EXPECT_EQ(RecordFile::open(path).value().record().state, RecordState::sending);
}

TEST_F(LineClaim, LongTextsAreCutAtACharacterAndStayOneLine) {
  const std::string path = (folder_ / "record").string();
  std::string umlauts;
  for (int i = 0; i < 500; ++i) umlauts += "ü";
  ASSERT_TRUE(RecordFile::open(path).value().write({.state = RecordState::torn,
                                                    .line = umlauts,
                                                    .what = "a\nstate clean\n" + umlauts,
                                                    .why = "a" + umlauts,
                                                    .by = umlauts,
                                                    .device = umlauts}));
  const LineRecord read = RecordFile::open(path).value().record();
  EXPECT_EQ(read.state, RecordState::torn);
  EXPECT_EQ(read.why.size(), 239U);
  EXPECT_THAT(read.what, HasSubstr("a state clean "));
}

TEST_F(LineClaim, TheFolderIsTheOneThatTheEnvironmentNames) {
  const fs::path named = folder_ / "a/b";
  ::setenv("DRIPFEED_LINES", named.c_str(), 1);
  const auto made = lines_folder();
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(*made, named);
  EXPECT_TRUE(fs::is_directory(named));
  std::ofstream(folder_ / "file") << "";
  ::setenv("DRIPFEED_LINES", (folder_ / "file").c_str(), 1);
  EXPECT_FALSE(lines_folder());
  ::unsetenv("DRIPFEED_LINES");
}

}  // namespace
}  // namespace dripfeed::io
