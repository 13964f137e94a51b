// A tty, played by a pseudo-terminal: how it is set, that all eight bits pass, who owns it, and that its end is
// reported once.
#include <algorithm>
#include <array>
#include <atomic>

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include "server/io/serial_port.h"
#include "server/io/serial_speed.h"
#include "tests/unit/server/io/listening.h"

namespace dripfeed::io {
namespace {

using namespace test;

// The far end of a line.
class Pty {
 public:
  Pty() {
    std::array<char, 128> name{};
    int slave = -1;
    EXPECT_EQ(::openpty(&master_, &slave, name.data(), nullptr, nullptr), 0);
    path_ = name.data();
    ::close(slave);
  }
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;
  ~Pty() { hang_up(); }

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] int master() const { return master_; }
  void hang_up() {
    if (master_ >= 0) ::close(master_);
    master_ = -1;
  }
  void send_text(std::string_view text) const {
    ASSERT_EQ(::write(master_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  // Waits for so many bytes.
  [[nodiscard]] std::string hear(std::size_t bytes) const {
    std::string text;
    while (text.size() < bytes) {
      pollfd file{.fd = master_, .events = POLLIN, .revents = 0};
      if (::poll(&file, 1, static_cast<int>(std::chrono::milliseconds(kLongest).count())) != 1) break;
      std::array<char, 4096> buffer{};
      const ssize_t count = ::read(master_, buffer.data(), std::min(buffer.size(), bytes - text.size()));
      if (count <= 0) break;
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int master_ = -1;
  std::string path_;
};

std::string all_bytes() {
  std::string text;
  for (int i = 0; i < 256; ++i) text += static_cast<char>(i);
  return text;
}

machine::LineSettings line_at(const std::string& path, std::uint32_t baud, std::string_view framing) {
  machine::LineSettings line;
  line.link.path = path;
  line.baud = baud;
  line.framing = tape_code::parse_framing(framing).value();
  return line;
}

TEST(SerialPort, HoldsByTheKernelOnlyWhereItIsAskedTo) {
  const Pty pty;
  machine::LineSettings line = line_at(pty.path(), 9600, "7E2");
  line.xoff_by = feed::XoffBy::kernel;
  line.xoff = 0x03;
  line.flow = feed::Flow::both;
  const auto port = open_serial_port(line);
  ASSERT_TRUE(port) << port.error();
  termios settings{};
  ASSERT_EQ(::tcgetattr(*port, &settings), 0);
  EXPECT_EQ(settings.c_iflag & (IXON | ISTRIP | IXOFF), static_cast<tcflag_t>(IXON | ISTRIP));
  EXPECT_EQ(settings.c_cc[VSTOP], 0x03);
  EXPECT_EQ(settings.c_cc[VSTART], 0x11);
  EXPECT_NE(settings.c_cflag & CRTSCTS, 0U);
  ::close(*port);
}

TEST(SerialPort, IsRawAndHoldsItsModemLines) {
  const Pty pty;
  const auto port = open_serial_port(line_at(pty.path(), 4800, "7E2"));
  ASSERT_TRUE(port) << port.error();
  termios settings{};
  ASSERT_EQ(::tcgetattr(pty.master(), &settings), 0) << "a master shows its slave's settings";
  EXPECT_EQ(::cfgetospeed(&settings), static_cast<speed_t>(B4800));
  EXPECT_EQ(::cfgetispeed(&settings), static_cast<speed_t>(B4800));
  EXPECT_EQ(settings.c_iflag & (IXON | IXOFF | IXANY | ICRNL | INLCR | ISTRIP | INPCK | BRKINT | PARMRK), 0U);
  EXPECT_EQ(settings.c_oflag & OPOST, 0U);
  EXPECT_EQ(settings.c_lflag & (ECHO | ICANON | ISIG | IEXTEN), 0U);
  EXPECT_EQ(settings.c_cflag & CSIZE, static_cast<tcflag_t>(CS8)) << "seven bits and parity are made in software";
  EXPECT_EQ(settings.c_cflag & (PARENB | HUPCL | CRTSCTS), 0U);
  EXPECT_NE(settings.c_cflag & CSTOPB, 0U);
  EXPECT_NE(::fcntl(*port, F_GETFL) & O_NONBLOCK, 0);
  EXPECT_NE(::fcntl(*port, F_GETFD) & FD_CLOEXEC, 0);
  EXPECT_EQ(read_unsent(*port), 0U) << "a pseudo-terminal hands over at once";
  EXPECT_FALSE(read_modem_lines(*port)) << "and has no modem lines";
  ::close(*port);
}

TEST(SerialPort, TakesAnyRate) {
  const Pty pty;
  const auto port = open_serial_port(line_at(pty.path(), 86'400, "8N1"));
  ASSERT_TRUE(port) << port.error();
  EXPECT_EQ(set_speed(*port, 12'345), (std::expected<void, std::string>()));
  termios settings{};
  ASSERT_EQ(::tcgetattr(*port, &settings), 0);
  EXPECT_EQ(settings.c_cflag & CBAUD, 0010000U) << "BOTHER: the rate is a number of its own";
  ::close(*port);
}

TEST(SerialPort, RefusesWithAReason) {
  const auto missing = open_serial_port(line_at("/dev/does-not-exist", 9600, "8N1"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error(), "cannot open /dev/does-not-exist: No such file or directory");
  const Pty pty;
  EXPECT_NE(open_serial_port(line_at(pty.path(), 49, "8N1")).error().find("49 baud is not 50..12000000"),
            std::string::npos);
  const auto no_tty = open_serial_port(line_at("/dev/null", 9600, "8N1"));
  ASSERT_FALSE(no_tty);
  EXPECT_NE(no_tty.error().find("it is not a terminal device"), std::string::npos) << no_tty.error();
}

TEST(SerialPort, HasOneOwner) {
  const Pty pty;
  const auto first = open_serial_port(line_at(pty.path(), 9600, "8N1"));
  ASSERT_TRUE(first);
  const auto second = open_serial_port(line_at(pty.path(), 9600, "8N1"));
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().find("another program owns this line"), std::string::npos) << second.error();
  ::close(*first);
  const auto third = open_serial_port(line_at(pty.path(), 9600, "8N1"));
  EXPECT_TRUE(third) << third.error();
  if (third) ::close(*third);
}

class SerialLinkTest : public LinkTest {
 protected:
  void open_pty() {
    ASSERT_EQ(open("pty:" + pty_.path()), "");
    ASSERT_TRUE(heard_.await_ups(1));
  }
  Pty pty_;
};

TEST_F(SerialLinkTest, AllEightBitsPassInBothDirections) {
  open_pty();
  EXPECT_EQ(write(all_bytes()), 256U);
  EXPECT_EQ(pty_.hear(256), all_bytes());
  pty_.send_text(all_bytes());
  ASSERT_TRUE(heard_.await_received(256));
  EXPECT_EQ(heard_.received(), all_bytes()) << "DC1, DC3, CR, NUL and 0xFF are characters like others";
  EXPECT_EQ(unsent(), std::nullopt) << "a pseudo-terminal would say 0 whatever it holds";
  EXPECT_EQ(heard_.losses(), 0);
}

TEST_F(SerialLinkTest, TakesWhatFitsAndReportsWhenThereIsRoom) {
  open_pty();
  const std::string much(1 << 20, 'x');
  const std::size_t taken = write(much);
  ASSERT_LT(taken, much.size());
  EXPECT_EQ(pty_.hear(taken), much.substr(0, taken));
  ASSERT_TRUE(heard_.await_writables(1));
  EXPECT_GT(write("more"), 0U);
}

TEST_F(SerialLinkTest, AHangUpIsReportedOnceAndTheLineCanBeOpenedAgain) {
  open_pty();
  pty_.hang_up();
  ASSERT_TRUE(heard_.await_losses(1));
  EXPECT_NE(heard_.reason(), "");
  static_cast<void>(write("into the void"));
  static_cast<void>(write("and again"));
  close();
  thread_->run([] {});
  EXPECT_EQ(heard_.losses(), 1);
  const Pty next;
  ASSERT_EQ(open("pty:" + next.path()), "");
  ASSERT_TRUE(heard_.await_ups(2));
  EXPECT_EQ(write("hello"), 5U);
  EXPECT_EQ(next.hear(5), "hello");
}

// As a line does: the link goes from inside its own last callback.
TEST_F(SerialLinkTest, MayBeDestroyedWhenItIsLost) {
  heard_.when_lost = [this] { link_.reset(); };
  open_pty();
  pty_.hang_up();
  ASSERT_TRUE(heard_.await_losses(1));
}

TEST_F(SerialLinkTest, AClosedLinkIsSilent) {
  open_pty();
  close();
  pty_.send_text("x");
  pty_.hang_up();
  thread_->run([] {});
  EXPECT_EQ(heard_.received(), "");
  EXPECT_EQ(heard_.losses(), 0);
}

// Posted work comes in its order, and a ticker is called at its deadline, not before.
class Alarm final : public app::Ticker {
 public:
  explicit Alarm(feed::Time at) : at_(at) {}
  void tick(feed::Time now) override {
    EXPECT_GE(now, at_);
    rung_.store(true);
    at_ = feed::Time::max();
  }
  [[nodiscard]] std::optional<feed::Time> deadline() const override {
    return at_ == feed::Time::max() ? std::nullopt : std::optional(at_);
  }
  [[nodiscard]] bool rung() const { return rung_.load(); }

 private:
  feed::Time at_;
  std::atomic<bool> rung_{false};
};

TEST(LinkThread, TicksAtDeadlinesAndWorksInOrder) {
  const auto thread = start_link_thread();
  Alarm alarm(thread->clock().now() + std::chrono::milliseconds(30));
  thread->run([&] { thread->add(alarm); });
  const auto until = thread->clock().now() + kLongest;
  while (!alarm.rung() && thread->clock().now() < until) thread->run([] {});
  EXPECT_TRUE(alarm.rung());
  thread->run([&] { thread->remove(alarm); });
  std::vector<int> order;
  for (int i = 0; i < 100; ++i) thread->post([&order, i] { order.push_back(i); });
  thread->run([] {});
  ASSERT_EQ(order.size(), 100U);
  EXPECT_TRUE(std::ranges::is_sorted(order));
}

}  // namespace
}  // namespace dripfeed::io
