// A link to a pseudo-terminal: it goes with its maker, a dead maker's is refused and replaced, a living one's is
// neither.
#include "server/io/pty_owner.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/unit/server/io/listening.h"

namespace dripfeed::io {
namespace {

using namespace test;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

class PtyOwnerTest : public ::testing::Test {
 protected:
  PtyOwnerTest() {
    std::string name = (fs::temp_directory_path() / "dripfeed-pty-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    path_ = (folder_ / "lathe.tty").string();
    std::array<char, 128> device{};
    EXPECT_EQ(::openpty(&master_, &slave_, device.data(), nullptr, nullptr), 0);
    device_ = device.data();
  }
  ~PtyOwnerTest() override {
    ::close(master_);
    ::close(slave_);
    fs::remove_all(folder_);
  }
  // A maker in a process of its own, killed once it has made its link.
  void link_and_die() const {
    const pid_t maker = ::fork();
    if (maker == 0) {
      const auto owner = PtyOwner::link(path_, device_);
      ::raise(SIGKILL);
    }
    int status = 0;
    ::waitpid(maker, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_TRUE(fs::is_symlink(path_));
  }
  [[nodiscard]] std::string refusal() const {
    const auto thread = start_link_thread();
    Heard heard;
    std::string why;
    thread->run([&] {
      const auto opened = thread->open(line_of("pty:" + path_), heard);
      if (!opened) why = opened.error();
    });
    return why;
  }

  fs::path folder_;
  std::string path_;
  std::string device_;
  int master_ = -1;
  int slave_ = -1;
};

TEST_F(PtyOwnerTest, TheLinkGoesWithItsMaker) {
  {
    const auto owner = PtyOwner::link(path_, device_);
    ASSERT_TRUE(owner) << owner.error();
    EXPECT_EQ(fs::read_symlink(path_), device_);
    EXPECT_FALSE(is_abandoned(path_));
    EXPECT_EQ(refusal(), "");
    EXPECT_EQ(refusal(), "") << "nothing stays locked after the one that closed";
    const auto second = PtyOwner::link(path_, "/dev/pts/9999");
    ASSERT_FALSE(second);
    EXPECT_THAT(second.error(), HasSubstr("another program that lives made this link"));
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(PtyOwnerTest, ADeadMakersLinkIsNotOpened) {
  link_and_die();
  EXPECT_TRUE(is_abandoned(path_));
  EXPECT_THAT(refusal(), HasSubstr("has ended"));
  const auto next = PtyOwner::link(path_, device_);
  ASSERT_TRUE(next) << next.error();
  EXPECT_EQ(refusal(), "");
}

TEST_F(PtyOwnerTest, ALinkThatLeadsElsewhereIsNotOpened) {
  const auto owner = PtyOwner::link(path_, "/dev/pts/9999");
  ASSERT_TRUE(owner) << owner.error();
  fs::remove(path_);
  fs::create_symlink(device_, path_);
  EXPECT_THAT(refusal(), HasSubstr("another pseudo-terminal than its maker's"));
}

TEST_F(PtyOwnerTest, TheFileOfAnotherIsNotReplaced) {
  std::ofstream(path_) << "a file";
  EXPECT_FALSE(PtyOwner::link(path_, device_));
  EXPECT_TRUE(fs::is_regular_file(path_));
  EXPECT_FALSE(fs::exists(path_ + ".owner"));
}

TEST_F(PtyOwnerTest, ALinkWithoutAMakersFileIsNobodysMatter) {
  fs::create_symlink(device_, path_);
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace dripfeed::io
