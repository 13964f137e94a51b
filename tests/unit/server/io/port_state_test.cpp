// Ports as sysfs shows them, and locks as /proc/locks does.
#include "server/io/port_state.h"

#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>

#include "server/io/lock_holder.h"

namespace dripfeed::io {
namespace {

namespace fs = std::filesystem;

class PortStateTest : public ::testing::Test {
 protected:
  PortStateTest() {
    std::string name = (fs::temp_directory_path() / "dripfeed-port-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~PortStateTest() override { fs::remove_all(folder_); }
  // /dev/null stands for the port.
  void show(const char* type, const char* clock) const {
    const fs::path of = folder_ / "class/tty/null";
    fs::create_directories(of);
    std::ofstream(of / "type") << type << "\n";
    std::ofstream(of / "uartclk") << clock << "\n";
  }
  fs::path folder_;
};

TEST_F(PortStateTest, WhatTheSystemSaysOfIt) {
  EXPECT_FALSE(look_at_port((folder_ / "none").string()).exists);
  std::ofstream(folder_ / "text") << "x";
  EXPECT_FALSE(look_at_port((folder_ / "text").string()).is_device);
  const PortState adapter = look_at_port("/dev/null", folder_.string());
  EXPECT_TRUE(adapter.exists && adapter.is_device && adapter.may_use && adapter.has_uart);
  EXPECT_FALSE(adapter.base_baud) << "its rates are its own";
  show("4", "1843200");
  EXPECT_EQ(look_at_port("/dev/null", folder_.string()).base_baud, 115'200U);
  show("0", "1843200");
  EXPECT_FALSE(look_at_port("/dev/null", folder_.string()).has_uart) << "a name without hardware";
}

TEST_F(PortStateTest, RatesThatAClockMakes) {
  for (const std::uint32_t baud : {50U, 300U, 4800U, 9600U, 19'200U, 38'400U, 57'600U, 115'200U})
    EXPECT_TRUE(divides_to(115'200, baud)) << baud;
  for (const std::uint32_t baud : {0U, 76'800U, 230'400U, 100'000U}) EXPECT_FALSE(divides_to(115'200, baud)) << baud;
  EXPECT_FALSE(divides_to(1'500'000, 230'400)) << "a seventh is 214286";
}

TEST_F(PortStateTest, WhoHoldsALock) {
  const std::string path = (folder_ / "lock").string();
  EXPECT_FALSE(lock_holder(path));
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  EXPECT_FALSE(lock_holder(path));
  ASSERT_EQ(::flock(file, LOCK_EX), 0);
  EXPECT_EQ(lock_holder(path), ::getpid());
  EXPECT_NE(command_of(::getpid()).find("unit_server_io"), std::string::npos);
  ::close(file);
  EXPECT_FALSE(lock_holder(path));
}

}  // namespace
}  // namespace dripfeed::io
